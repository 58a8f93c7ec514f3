#include "data/io/experiment.h"

#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "base/lists.h"
#include "base/nearest_name.h"
#include "data/io/toml_table.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

// sd of a component that is not fitted [N]
constexpr double kNotFitted = std::numeric_limits<double>::infinity();

/// Conversion of a hung weight to a tendon tension.
struct Pulley {
  double gravity = 9.80665;  // standard gravity [m/s^2]
  double efficiency = 1;     // tension after the pulley / weight before it [1]
};

/// Direction of the digit in words, as signed (proximal, dorsal, radial).
Eigen::RowVector3i signed_axis(TomlTable& table, const std::string& word, const std::string& key) {
  static const std::map<std::string, Eigen::RowVector3i> words{
      {"proximal", {1, 0, 0}}, {"distal", {-1, 0, 0}}, {"dorsal", {0, 1, 0}},
      {"palmar", {0, -1, 0}},  {"radial", {0, 0, 1}},  {"ulnar", {0, 0, -1}}};
  const bool negative = !word.empty() && word[0] == '-';
  const auto found = words.find(negative ? word.substr(1) : word);
  if (found == words.end())
    table.fail(fmt::format("wanted {}'{}' to be one of proximal, distal, dorsal, palmar, radial, "
                           "ulnar or its negative, got '{}'",
                           key == "components" ? "each of " : "", key, word),
               key);
  return negative ? Eigen::RowVector3i(-found->second) : found->second;
}

/// Positions in a row of the components of a fitted force.
struct ReadComponents {
  int stated = 3;                 // numbers in a row [1]
  std::vector<int> fitted;        // their places in it, in order
  std::optional<ForceSite> site;  // of rows that state none
};

/// The component that [force] states as not modelled; -1: none.
int read_not_modelled(TomlTable& table, const Experiment& experiment) {
  if (!table.has("not_modelled")) return -1;
  const Eigen::RowVector3i across = signed_axis(table, table.text("not_modelled"), "not_modelled");
  if (across.z() == 0)
    table.fail(
        "wanted 'not_modelled' to be the component across the plane of flexion, radial or "
        "ulnar",
        "not_modelled");
  for (int i = 0; i < experiment.components; ++i)
    if (experiment.axes_of_digit.row(i) == across || experiment.axes_of_digit.row(i) == -across)
      return i;
  table.fail("'not_modelled' names none of 'components'", "not_modelled");
}

/// The load cell's place that [force] or a row states. @param from  where it says nothing of its
/// own
std::optional<ForceSite> read_site(TomlTable& table, const std::optional<ForceSite>& from) {
  if (!table.has("at")) {
    for (const char* key : {"at_fraction", "tendons_leave"})
      if (table.has(key)) table.fail(fmt::format("'{}' needs 'at', a segment", key), key);
    if (table.has(Dimension::kLength, "at")) table.fail("'at_mm' needs 'at', a segment");
    return from;
  }
  ForceSite site;
  site.at = table.text("at");
  site.axes = table.text_or("segment", site.at);
  if (table.has("at_fraction"))
    site.fraction = table.number(Dimension::kNumber, "at_fraction", Range::kFraction);
  if (table.has(Dimension::kLength, "at")) {
    if (table.has("at_fraction")) table.fail("wanted 'at_mm' or 'at_fraction', got both", "at");
    site.point = table.vector(Dimension::kLength, "at");
  }
  if (table.has("tendons_leave")) site.leave = table.choice("tendons_leave", kTendonExitNames);
  return site;
}

/// Axes of the components, of which two or three are fitted.
ReadComponents read_force_axes(TomlTable& table, Experiment& experiment) {
  experiment.force_segment = table.text("segment");
  const std::vector<std::string> words = table.texts("components");
  if (words.size() != 2 && words.size() != 3)
    table.fail(
        fmt::format("wanted 3 'components', or 2 in the plane of flexion, got {}", words.size()),
        "components");
  // Independent components, of two none across the plane of flexion.
  experiment.components = static_cast<int>(words.size());
  Eigen::Matrix3i axes = Eigen::Matrix3i::Zero();
  for (int i = 0; i < experiment.components; ++i)
    axes.row(i) = signed_axis(table, words[i], "components");
  if (experiment.components == 2 && axes.col(2).any())
    table.fail(
        "wanted 2 'components' in the plane of flexion: one proximal or distal, one dorsal "
        "or palmar",
        "components");
  if (Eigen::FullPivLU<Eigen::Matrix3d>(axes.cast<double>()).rank() != experiment.components)
    table.fail(fmt::format("wanted 'components' along {} different directions",
                           experiment.components == 2 ? "two" : "three"),
               "components");
  experiment.axes_of_digit = axes;

  // Those that are fitted come first, without the one that is not modelled.
  const int left_out = read_not_modelled(table, experiment);
  ReadComponents read{experiment.components, {}, read_site(table, {})};
  for (int i = 0; i < read.stated; ++i)
    if (i != left_out) read.fitted.push_back(i);
  experiment.components = static_cast<int>(read.fitted.size());
  experiment.axes_of_digit.setZero();
  for (int i = 0; i < experiment.components; ++i)
    experiment.axes_of_digit.row(i) = axes.row(read.fitted[i]);
  table.done();
  return read;
}

Pulley read_protocol(TomlTable& table, Experiment& experiment) {
  experiment.hold = table.choice("hold", kTipConstraintNames);
  Pulley pulley;
  pulley.gravity =
      table.number_or(Dimension::kAcceleration, "gravity", pulley.gravity, Range::kPositive);
  pulley.efficiency =
      table.number_or(Dimension::kNumber, "pulley_efficiency", pulley.efficiency, Range::kFraction);
  table.done();
  return pulley;
}

void read_noise(TomlTable& table, Experiment& experiment) {
  experiment.sd_relative = table.number_or(Dimension::kNumber, "relative", 0, Range::kNotNegative);
  experiment.sd_floor = table.number_or(Dimension::kForce, "floor", 0, Range::kNotNegative);
  if (experiment.sd_floor == 0)
    table.fail("[noise] needs 'floor_N' > 0: a force of zero is not known exactly");
  table.done();
}

PostureRecord read_posture(TomlTable& table, const Experiment& experiment) {
  PostureRecord posture{table.text("name"), table.named(Dimension::kAngle, "angles")};
  // Names of postures are unique.
  if (find_named(experiment.postures, posture.name) != nullptr)
    table.fail(fmt::format("posture '{}' is given twice", posture.name), "name");
  return posture;
}

/// Tensions [N], as stated or from hung weights behind the pulley.
std::map<std::string, double> read_tensions(TomlTable& table, const Pulley& pulley) {
  const bool weights = table.has(Dimension::kMass, "load");
  if (!weights && !table.has(Dimension::kForce, "tension"))
    table.fail("a trial needs 'load_g' or 'tension_N'");
  std::map<std::string, double> result =
      weights ? table.named(Dimension::kMass, "load") : table.named(Dimension::kForce, "tension");
  // Tendons only pull.
  for (auto& [muscle, pull] : result) {
    if (pull < 0)
      table.fail(fmt::format("tendon '{}' cannot push, got {:.6g} {}", muscle, pull,
                             weights ? "kg" : "N"));
    if (weights) pull *= pulley.gravity * pulley.efficiency;
  }
  return result;
}

std::string read_known_posture(TomlTable& table, const Experiment& experiment) {
  std::string name = table.text("posture");
  if (find_named(experiment.postures, name) == nullptr)
    table.fail(fmt::format("posture '{}' is not defined{}", name,
                           did_you_mean(name, names_of(experiment.postures))));
  return name;
}

/// The fitted components of a row's vector, `others` in place of the rest [N].
Vector3d read_components(TomlTable& table, const std::string& key, const ReadComponents& read,
                         Range range, double others) {
  const std::vector<double> stated = table.numbers(Dimension::kForce, key, read.stated, range);
  Vector3d v = Vector3d::Constant(others);
  for (std::size_t i = 0; i < read.fitted.size(); ++i) v[i] = stated[read.fitted[i]];
  return v;
}

Vector3d read_force(TomlTable& table, const ReadComponents& read) {
  return read_components(table, "force", read, Range::kAny, 0);
}

Vector3d read_sd(TomlTable& table, const ReadComponents& read) {
  return read_components(table, "sd", read, Range::kPositive, kNotFitted);
}

Trial read_trial(TomlTable& table, const Experiment& experiment, const ReadComponents& read,
                 const Pulley& pulley) {
  Trial trial;
  // What was done: posture and loads.
  trial.posture = read_known_posture(table, experiment);
  trial.tension = read_tensions(table, pulley);
  // What was measured, and where; its uncertainty is stated here or for the whole file.
  trial.site = read_site(table, read.site);
  trial.force = read_force(table, read);
  if (table.has(Dimension::kMoment, "moment"))
    trial.moment = table.vector(Dimension::kMoment, "moment");
  if (table.has(Dimension::kForce, "sd"))
    trial.sd = read_sd(table, read);
  else if (experiment.sd_floor == 0)
    table.fail("a trial needs 'sd_N', or the file a [noise] table");
  return trial;
}

/// One standard deviation for all muscles of the row, except for muscles with their own.
std::map<std::string, double> read_activation_sd(TomlTable& table, const ActivationRow& row) {
  std::map<std::string, double> sd =
      table.named(Dimension::kNumber, "activation_sd_of", Range::kNotNegative);
  for (const auto& own : sd)
    if (row.activation.count(own.first) == 0)
      table.fail(
          fmt::format("'activation_sd_of' names muscle '{}', 'activation' does not", own.first),
          "activation_sd_of");
  // The common value is needed unless every muscle has its own.
  if (sd.size() == row.activation.size() && !table.has("activation_sd")) return sd;
  const double all = table.number(Dimension::kNumber, "activation_sd", Range::kNotNegative);
  for (const auto& muscle : row.activation) sd.emplace(muscle.first, all);
  return sd;
}

ActivationRow read_activation(TomlTable& table, const Experiment& experiment,
                              const ReadComponents& read) {
  ActivationRow row;
  // Task: posture and activations.
  row.posture = read_known_posture(table, experiment);
  row.activation = table.named(Dimension::kNumber, "activation", Range::kFraction);
  if (row.activation.empty()) table.fail("wanted 'activation' of at least one muscle: {FPL = 0.3}");
  row.sd = read_activation_sd(table, row);
  // Measured force, with its uncertainty.
  row.force = read_force(table, read);
  if (table.has(Dimension::kForce, "sd"))
    row.force_sd = read_sd(table, read);
  else if (experiment.sd_floor == 0)
    table.fail("an activation row needs 'sd_N', or the file a [noise] table");
  return row;
}

std::map<std::string, double> read_outside(TomlTable& table) {
  std::map<std::string, double> length =
      table.named(Dimension::kLength, "length", Range::kPositive);
  if (length.empty())
    table.fail("[outside] needs the 'length_mm' of at least one segment: {PP3 = 45.1}");
  table.done();
  return length;
}

void read_trials(TomlTable& top, const Pulley& pulley, const ReadComponents& read,
                 Experiment& experiment) {
  TomlTable trials =
      needed_table(top, "trials", "the file needs [trials]: its 'rows' are the loads and forces");
  read_each(trials, "rows", experiment.trials, read_trial, experiment, read, pulley);
  if (experiment.trials.empty())
    trials.fail("wanted at least one trial in 'rows', got none", "rows");
  trials.done();
}

void read_header(TomlTable& top, Experiment& experiment) {
  experiment.name = top.text("name");
  experiment.specimen = top.text_or("specimen", experiment.name);
  experiment.species = top.text_or("species", "human");
  experiment.description = top.text_or("description", "");
  experiment.digit = top.text("digit");
  experiment.source = top.source();
  if (experiment.source.empty()) top.fail("the top level needs 'source' (a citation key)");
}

Vector3d noise_sd(const Experiment& experiment, const Vector3d& force) {
  const double relative = experiment.sd_relative * force.norm();
  Vector3d sd = Vector3d::Constant(std::hypot(experiment.sd_floor, relative));
  sd.tail(3 - experiment.components).setConstant(kNotFitted);
  return sd;
}

}  // namespace

bool operator==(const ForceSite& a, const ForceSite& b) {
  return a.at == b.at && a.axes == b.axes && a.fraction == b.fraction && a.point == b.point &&
         a.leave == b.leave;
}

Experiment parse_experiment(const std::string& text, const std::string& path) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  Experiment experiment;
  read_header(top, experiment);
  if (std::optional<TomlTable> outside = top.table("outside"))
    experiment.outside_length = read_outside(*outside);

  // Protocol: how the tip was held, in which axes its force was read, and how accurately.
  TomlTable protocol =
      needed_table(top, "protocol", "the file needs [protocol]: how the fingertip was held");
  const Pulley pulley = read_protocol(protocol, experiment);
  TomlTable force =
      needed_table(top, "force", "the file needs [force]: the segment and the axes of the forces");
  const ReadComponents read = read_force_axes(force, experiment);
  if (std::optional<TomlTable> noise = top.table("noise")) read_noise(*noise, experiment);

  // Postures and trials, or activations in place of trials.
  read_each(top, "posture", experiment.postures, read_posture, experiment);
  if (read.site && top.has("activation"))
    top.fail("an [[activation]] is of the tip; state 'at' in the rows of [trials]", "activation");
  read_each(top, "activation", experiment.activations, read_activation, experiment, read);
  if (experiment.activations.empty() || top.has("trials"))
    read_trials(top, pulley, read, experiment);
  top.done();
  return experiment;
}

Experiment read_experiment(const std::string& path) {
  return parse_experiment(read_text_file(path), path);
}

Vector3d force_sd(const Experiment& experiment, const Trial& trial) {
  return trial.sd ? *trial.sd : noise_sd(experiment, trial.force);
}

Vector3d force_sd(const Experiment& experiment, const ActivationRow& row) {
  return row.force_sd ? *row.force_sd : noise_sd(experiment, row.force);
}

}  // namespace thenar
