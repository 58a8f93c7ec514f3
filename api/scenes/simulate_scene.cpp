#include "api/scenes/simulate_scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <set>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "api/named/data_folders.h"
#include "api/named/files.h"
#include "api/named/hands.h"
#include "api/named/result_origin.h"
#include "api/named/things.h"
#include "api/named/worlds.h"
#include "api/scenes/scene_account.h"
#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "base/parallel_for.h"
#include "base/rung_names.h"
#include "dynamics/compliant/penalty_scene.h"
#include "dynamics/compliant/simbody_scene.h"
#include "dynamics/scene/run_bytes.h"
#include "dynamics/stepping/limit_excess.h"
#include "dynamics/stepping/simulate_scene.h"
#include "sampling/run/communicator.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

constexpr int kDrawnSkin = 1200;  // triangles of the picture of each link of a human hand, at most

std::string scene_file(const SceneRequest& request) {
  std::string file =
      named_file("scene", request.scene, "scenes", ".toml", data_folders(request.data));
  require_kind(file, {"scene"});
  return file;
}

/// Finds the data from which a hand is built, by its file or name.
/// @param path   of tendons of a human hand that states none
/// @param files  receives the files that were read for it
SceneHand hand_of(const SceneSpec& scene, const SceneHandSpec& hand,
                  const std::optional<Path>& path, const std::vector<std::string>& places,
                  FileDigests& files) {
  // The name of a hand, or the path of its file beside the scene, with the version at its end.
  std::string name = hand.placed.file.empty()
                         ? hand.placed.name
                         : (fs::path(scene.folder) / hand.placed.file).string();
  if (!hand.version.empty()) name += ":" + hand.version;
  const HandSource source = at_line(scene.path, hand.line, [&] { return find_hand(name, places); });
  // A robot: options of skins are errors, and the file must hold a robot.
  if (!source.human) {
    if (hand.skin_triangles > 0 || hand.skin_capsules || hand.passive)
      throw DataError(scene.path, hand.line,
                      fmt::format("'{}' is not a human hand with a skin", name));
    Thing thing = read_thing(source.file);
    auto* robot = std::get_if<RobotSpec>(&thing);
    if (robot == nullptr)
      throw DataError(scene.path, hand.line, fmt::format("'{}' is not a robot", source.file));
    files.insert(robot->files.begin(), robot->files.end());
    return std::move(*robot);
  }
  // A human hand: the version, paths and skin of the scene.
  HumanModel human{source.file.empty() ? default_human() : read_subject(source.file),
                   human_version(source.version)};
  human.options.path = source.path.empty() ? path : path_named(source.path);
  human.options.passive = hand.passive.value_or(true) ? source.passive : PassiveMoments::kOff;
  human.options.skin.drawn = kDrawnSkin;
  if (hand.skin_triangles > 0) human.options.skin.triangles = hand.skin_triangles;
  human.options.skin.capsules = hand.skin_capsules.value_or(false);
  if (!source.file.empty()) files.merge(digests_of({source.file}));
  return human;
}

/// Returns true if a file is read as text: descriptions and tables.
bool is_text(const std::string& path) {
  const fs::path extension = fs::path(path).extension();
  return extension == ".toml" || extension == ".csv";
}

/// Texts of the files that are texts.
std::vector<SourceText> texts_of(const std::string& scene, const FileDigests& files) {
  std::vector<SourceText> sources{read_source(scene)};
  const std::string first = fs::path(scene).lexically_normal().string();
  for (const auto& [path, digest] : files)
    if (path != first && is_text(path)) sources.push_back(read_source(path));
  return sources;
}

/// Simulates a scene by whatever method its options name.
SceneRun simulate_by_method(const MovingScene& scene, const SceneOptions& options,
                            const Progress& progress) {
  if (options.method == SteppingMethod::kCompliantSimbody)
    return simulate_simbody_scene(scene, options, progress);
  if (options.method == SteppingMethod::kCompliantSundials)
    return simulate_penalty_scene(scene, options, progress);
  return simulate_scene(scene, options, progress);
}

Status status_of(const SceneResult& scene) {
  if (scene.run.status == SceneStatus::kStopped) return Status::kStopped;
  return refusal_of(scene).empty() ? Status::kSolved : Status::kStalled;
}

/// Simulates, unless that was done, and measures a scene with some numbers changed.
SceneResult simulated(const RequestedScene& read,
                      const std::vector<std::pair<std::string, double>>& numbers,
                      const Progress& progress, std::optional<SceneRun> done = {}) {
  SceneResult out;
  // Copy names and inputs for the provenance of the result.
  out.name = read.spec.name;
  out.description = read.spec.description;
  out.camera = read.spec.camera;
  out.sources = read.open.sources;
  out.files = read.open.files;
  out.varied = numbers;
  out.request = read.request;
  // Change the numbers in a copy, since runs share their input.
  auto built = std::make_shared<BuiltScene>(read.open.built);
  for (const auto& [name, value] : numbers) set_number(*built, name, value);
  out.run = done ? std::move(*done) : simulate_by_method(built->scene, built->options, progress);
  out.measures = measure_run(built->scene, out.run);
  out.built = std::move(built);
  out.outcome.status = status_of(out);
  out.outcome.warnings = scene_warnings(out);
  return out;
}

/// The numbers of one run of a sweep; the last one varies fastest.
std::vector<std::pair<std::string, double>> numbers_of(const std::vector<SceneVariation>& vary,
                                                       std::size_t run) {
  std::vector<std::pair<std::string, double>> numbers(vary.size());
  for (std::size_t k = vary.size(); k-- > 0;) {
    const auto count = static_cast<std::size_t>(vary[k].count);
    numbers[k] = {vary[k].name, vary[k].value(static_cast<int>(run % count))};
    run /= count;
  }
  return numbers;
}

/// Runs in one sweep. @throws InputError if a variation is none, or there are too many
std::size_t count_runs(const std::vector<SceneVariation>& vary) {
  std::size_t runs = 1;
  std::set<std::string> names;
  for (const SceneVariation& each : vary) {
    require(each.count >= 1, "wanted at least one value of '{}', got {}", each.name, each.count);
    require(names.insert(each.name).second, "'{}' varies twice", each.name);
    require(static_cast<std::size_t>(each.count) <= kMaxRuns / runs, "wanted at most {} runs",
            kMaxRuns);
    runs *= static_cast<std::size_t>(each.count);
  }
  return runs;
}

/// Joint progress of several parallel runs.
class SharedProgress {
 public:
  SharedProgress(const Progress& whole, std::size_t runs) : whole_(whole), done_(runs, 0) {}

  [[nodiscard]] Progress of(std::size_t run) {
    Progress part;
    part.stop_requested = [this] { return whole_.stop(); };
    part.report = [this, run](double fraction, const std::string& /*what*/) {
      const std::lock_guard<std::mutex> lock(told_);
      sum_ += fraction - done_[run];
      done_[run] = fraction;
      whole_(sum_ / static_cast<double>(done_.size()), "");
    };
    return part;
  }

 private:
  const Progress& whole_;
  std::mutex told_;
  std::vector<double> done_;
  double sum_ = 0;
};

}  // namespace

bool has_contact_problems(const SceneResult& scene) {
  const SteppingMethod method = scene.built->options.method;
  return method == SteppingMethod::kEvents || method == SteppingMethod::kTimeStepping;
}

bool is_scene(const std::string& name_or_path, const std::string& data) {
  // A name counts as a scene only if no subject has it; a file is looked into.
  std::error_code none;
  if (!fs::exists(name_or_path, none)) {
    const std::vector<std::string> places = data_folders(data);
    return find_in(places, "subjects/" + name_or_path + ".toml").empty() &&
           !find_in(places, "scenes/" + name_or_path + ".toml").empty();
  }
  try {
    return contents_of(name_or_path).kind == "scene";
  } catch (const DataError&) {
    return false;  // the reader reports the error
  }
}

std::vector<SceneHand> hands_of_scene(const SceneSpec& scene, const std::string& data,
                                      FileDigests& files, const std::optional<Path>& path) {
  const std::vector<std::string> places = data_for(scene.folder, data);
  std::vector<SceneHand> hands;
  for (const SceneHandSpec& hand : scene.hands)
    hands.push_back(hand_of(scene, hand, path, places, files));
  return hands;
}

OpenScene open_scene(const SceneSpec& scene, const std::string& data,
                     const std::optional<Path>& path) {
  OpenScene out;
  out.files = scene.files;
  out.built = build_scene(scene, hands_of_scene(scene, data, out.files, path));
  if (!scene.files.empty()) out.sources = texts_of(scene.path, out.files);  // else: not of a file
  return out;
}

RequestedScene open_requested_scene(const SceneRequest& request) {
  return open_requested_scene(read_scene(scene_file(request)), request);
}

RequestedScene open_requested_scene(SceneSpec scene, const SceneRequest& request) {
  // Change what the request states.
  RequestedScene read{std::move(scene), {}, request};
  if (request.on_pins) read.spec.compliances.clear();
  if (!request.pads.empty()) {
    (void)index_of_name(request.pads, pad_rung_names(), "rung of pads");
    require(!read.spec.pads.empty(), "'{}' has no [[pad]]", read.spec.name);
    for (ScenePadSpec& pad : read.spec.pads) pad.rung = request.pads;
  }
  // Options of the request replace those of the file.
  read.open = open_scene(read.spec, request.data, request.path);
  SceneOptions& options = read.open.built.options;
  // Method, duration and tolerance.
  if (!request.method.empty())
    options.method = value_in(kSteppingMethodNames, request.method, "method");
  options.duration = request.seconds.value_or(options.duration);
  options.sample_interval = request.sample.value_or(options.sample_interval);
  options.step_length = request.step.value_or(options.step_length);
  options.tolerance = request.tolerance.value_or(options.tolerance);
  require(options.duration / options.sample_interval <= kMostSamples,
          "wanted at most {:g} samples, got {:g} s in steps of {:g} s", kMostSamples,
          options.duration, options.sample_interval);
  return read;
}

SceneResult simulate_scene(const SceneRequest& request, const Progress& progress) {
  require(request.vary.empty(), "wanted one run, got numbers that vary");
  return simulated(open_requested_scene(request), {}, progress);
}

SceneResult simulate_scene(const SceneSpec& scene, const SceneRequest& request,
                           const Progress& progress) {
  require(request.vary.empty(), "wanted one run, got numbers that vary");
  check_scene_spec(scene);
  return simulated(open_requested_scene(scene, request), {}, progress);
}

namespace {

/// Runs of a sweep; absent ones ran in another process, or did not start.
using SweptRuns = std::vector<std::optional<SceneResult>>;

/// Puts the runs of all processes together on the first. Only motions are sent: each process has
/// read the scene, and measures are made again.
/// @param packed  motions that this process is to send; "" for all others
void gather_runs(const RequestedScene& read, const std::vector<SceneVariation>& vary,
                 const Communicator& ranks, std::vector<std::string> packed, SweptRuns& runs) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    // Motions are sent as bytes; the rank that ran a scene owns its motion.
    const std::size_t owner = i % static_cast<std::size_t>(ranks.size());
    std::vector<std::string> sent = internal::all_gather_bytes(ranks, packed[i]);
    packed[i] = ranks.rank() == 0 ? std::move(sent[owner]) : "";
  }
  collective_call(ranks, [&] {
    parallel_for(runs.size(), [&](std::size_t i) {
      if (!packed[i].empty())
        runs[i] = simulated(read, numbers_of(vary, i), {}, run_from_bytes(packed[i]));
    });
  });
}

/// Fills in the outcome of a sweep from those of its runs, without duplicate warnings.
void tell_outcome(bool stopped, SceneSweepResult& sweep) {
  Outcome& outcome = sweep.outcome;
  outcome.part = "run";
  outcome.done = sweep.runs.size();
  for (const SceneResult& run : sweep.runs) {
    if (run.outcome.status == Status::kStalled) outcome.status = Status::kStalled;
    append_new(outcome.warnings, run.outcome.warnings);
  }
  if (stopped) outcome.status = Status::kStopped;
}

/// Sweeps a scene on all processes together; an exception on one process is thrown on all of them.
SceneSweepResult sweep_together(const SceneRequest& request, const Progress& progress,
                                const Communicator& ranks) {
  const auto rank = static_cast<std::size_t>(ranks.rank());
  const auto size = static_cast<std::size_t>(ranks.size());
  RequestedScene read;
  SceneSweepResult sweep;
  SweptRuns runs;
  std::vector<std::string> packed;
  collective_call(ranks, [&] {
    read = open_requested_scene(request);
    sweep.name = read.spec.name;
    sweep.request = request;
    sweep.files = read.open.files;
    sweep.outcome.asked = count_runs(request.vary);
    // Impossible values are refused before any work.
    for (std::size_t i = 0; i < sweep.outcome.asked; ++i) {
      BuiltScene trial = read.open.built;
      for (const auto& [name, value] : numbers_of(request.vary, i)) set_number(trial, name, value);
    }
  });
  collective_call(ranks, [&] {
    runs.resize(sweep.outcome.asked);
    packed.resize(sweep.outcome.asked);
    // Each process runs every size-th scene, and packs its motions for the first.
    const std::size_t mine = (sweep.outcome.asked + size - 1 - rank) / size;
    SharedProgress shared(progress, std::max<std::size_t>(1, mine));
    parallel_for(mine, [&](std::size_t k) {
      const std::size_t i = rank + k * size;
      if (progress.stop()) return;
      runs[i] = simulated(read, numbers_of(request.vary, i), shared.of(k));
      if (rank > 0) packed[i] = bytes_of(runs[i]->run);
    });
  });
  if (size > 1) gather_runs(read, request.vary, ranks, std::move(packed), runs);
  for (std::optional<SceneResult>& run : runs)
    if (run) sweep.runs.push_back(std::move(*run));
  tell_outcome(progress.stop(), sweep);
  return sweep;
}

}  // namespace

std::optional<SceneSweepResult> sweep_scene(const SceneRequest& request, const Progress& progress) {
  return result_of_first_rank([&](const Communicator& ranks) {
    Progress told = progress;
    if (ranks.rank() > 0) told.report = nullptr;
    return sweep_together(request, told, ranks);
  });
}

// Files of runs.

namespace {

/// An array of three dimensions, filled by at(i, j, k).
template <typename At>
ResultArray cube(std::size_t a, std::size_t b, std::size_t c, const std::string& unit,
                 const std::vector<std::string>& labels, const At& at) {
  ResultArray array{{}, {a, b, c}, unit, labels};
  array.values.reserve(a * b * c);
  for (std::size_t i = 0; i < a; ++i)
    for (std::size_t j = 0; j < b; ++j)
      for (std::size_t k = 0; k < c; ++k) array.values.push_back(at(i, j, k));
  return array;
}

/// Names of the entries of positions or of speeds.
std::vector<std::string> entry_names(const Mechanism& mechanism, bool positions) {
  // Coordinates of joints have their own names.
  const MechanismLayout layout = layout_of(mechanism);
  std::vector<std::string> names(static_cast<std::size_t>(positions ? layout.q : layout.v));
  for (std::size_t c = 0; c < mechanism.coordinates.size(); ++c)
    names[static_cast<std::size_t>(positions ? layout.coordinate_q[c] : layout.coordinate_v[c])] =
        mechanism.coordinates[c].name;
  // Poses are a quaternion and a place, speeds a spin and a velocity.
  static const std::vector<std::string> kPose{"qw", "qx", "qy", "qz", "x", "y", "z"};
  static const std::vector<std::string> kTwist{"wx", "wy", "wz", "vx", "vy", "vz"};
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const JointKind kind = mechanism.joints[i].kind;
    if (kind != JointKind::kBall && kind != JointKind::kFree) continue;
    const auto first = static_cast<std::size_t>(positions ? layout.first_q[i] : layout.first_v[i]);
    const std::vector<std::string>& parts = positions ? kPose : kTwist;
    const std::size_t count = parts.size() - (kind == JointKind::kBall ? 3 : 0);
    for (std::size_t k = 0; k < count; ++k)
      names[first + k] = mechanism.bodies[i].name + "/" + parts[k];
  }
  return names;
}

/// Positions, speeds, poses and energies of every instant.
void add_instants(const SceneResult& scene, const std::string& group, ResultFile& file) {
  const std::vector<SceneSample>& samples = scene.run.samples;
  const std::vector<std::vector<Pose<double>>>& X = scene.measures.X_WB;
  // Fill the tables row by row.
  const auto count = static_cast<Eigen::Index>(samples.size());
  const std::size_t bodies = scene.built->scene.mechanism.bodies.size();
  Eigen::VectorXd time(count);
  Eigen::MatrixXd q(count, scene.built->scene.q.size()), v(count, scene.built->scene.v.size());
  Eigen::MatrixXd energy(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const SceneSample& sample = samples[static_cast<std::size_t>(i)];
    time[i] = sample.t;
    q.row(i) = sample.q;
    v.row(i) = sample.v;
    energy.row(i) << sample.energy.kinetic, sample.energy.weight, sample.energy.springs;
  }
  // Name the axes of each table, as netCDF does.
  file.add(group + "time", time, "s", {"instant"});
  file.add(group + "position", q, "SI", {"instant", "position_entry"});
  file.add(group + "speed", v, "SI", {"instant", "speed_entry"});
  file.add(group + "energy", energy, "J", {"instant", "energy_part"});
  file.arrays[group + "body_position"] =
      cube(samples.size(), bodies, 3, "m", {"instant", "body", "axis"},
           [&](std::size_t i, std::size_t b, std::size_t k) {
             return X[i][b].p[static_cast<Eigen::Index>(k)];
           });
  file.arrays[group + "body_rotation"] =
      cube(samples.size(), bodies, 4, "1", {"instant", "body", "quaternion"},
           [&](std::size_t i, std::size_t b, std::size_t k) {
             const Eigen::Quaterniond turn(X[i][b].R);
             const double wxyz[] = {turn.w(), turn.x(), turn.y(), turn.z()};
             return wxyz[k];
           });
}

/// States of elements, and what muscles do at every instant.
void add_elements(const SceneResult& scene, const std::string& group, ResultFile& file) {
  const std::vector<SceneSample>& samples = scene.run.samples;
  // Elements such as muscles and pads may have states of their own.
  if (samples.front().z.size() == 0) return;
  const auto count = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXd z(count, samples.front().z.size());
  for (Eigen::Index i = 0; i < count; ++i) z.row(i) = samples[static_cast<std::size_t>(i)].z;
  file.add(group + "element_state", z, "SI", {"instant", "element_state_entry"});
  const std::vector<PullMeasure>& muscles = scene.measures.pulls.muscles;
  if (muscles.empty()) return;
  const auto add = [&](const char* key, const char* unit, Eigen::VectorXd PullMeasure::*of) {
    Eigen::MatrixXd table(count, static_cast<Eigen::Index>(muscles.size()));
    for (std::size_t m = 0; m < muscles.size(); ++m)
      table.col(static_cast<Eigen::Index>(m)) = muscles[m].*of;
    file.add(group + key, table, unit, {"instant", "muscle"});
  };
  add("tension", "N", &PullMeasure::tension);
  add("excitation", "1", &PullMeasure::excitation);
  add("activation", "1", &PullMeasure::activation);
  add("excursion", "m", &PullMeasure::excursion);
}

/// Contacts of all instants, one below the other.
void add_contacts(const SceneResult& scene, const std::string& group, ResultFile& file) {
  // List all contacts and their instants; a run without contacts has no such tables.
  std::vector<double> instants;
  std::vector<const ContactSample*> contacts;
  for (std::size_t i = 0; i < scene.run.samples.size(); ++i)
    for (const ContactSample& contact : scene.run.samples[i].contacts) {
      instants.push_back(static_cast<double>(i));
      contacts.push_back(&contact);
    }
  if (contacts.empty()) return;
  // Write one column for each number, and a table for each vector.
  const auto count = static_cast<Eigen::Index>(contacts.size());
  const auto add = [&](const char* key, const char* unit, auto ContactSample::*number) {
    Eigen::VectorXd column(count);
    for (Eigen::Index k = 0; k < count; ++k) column[k] = static_cast<double>(contacts[k]->*number);
    file.add(group + key, column, unit, {"contact"});
  };
  const auto add_vectors = [&](const char* key, const char* unit,
                               Eigen::Vector3d ContactSample::*vector) {
    Eigen::MatrixXd table(count, 3);
    for (Eigen::Index k = 0; k < count; ++k) table.row(k) = contacts[k]->*vector;
    file.add(group + key, table, unit, {"contact", "axis"});
  };
  const Eigen::VectorXd instant = Eigen::Map<const Eigen::VectorXd>(instants.data(), count);
  file.add(group + "contact_instant", instant, "1", {"contact"});
  add("contact_body_a", "1", &ContactSample::a);
  add("contact_body_b", "1", &ContactSample::b);
  add("contact_id", "1", &ContactSample::id);
  add("contact_mode", "1", &ContactSample::mode);
  add("contact_gap", "m", &ContactSample::gap);
  add("contact_torsion", "N m", &ContactSample::torsion);
  add_vectors("contact_point", "m", &ContactSample::point);
  add_vectors("contact_normal", "1", &ContactSample::normal);
  add_vectors("contact_force", "N", &ContactSample::force);
  add("contact_area", "m^2", &ContactSample::area);
  add("contact_stick", "1", &ContactSample::stick);
}

/// Energy that does not balance, and joints that went beyond their limits.
void add_account(const SceneResult& scene, const std::string& group, ResultFile& file) {
  // Keep the worst balance of energy, beside the energy that was turned over.
  if (const std::optional<FlowBalance>& worst = scene.measures.worst;
      worst && std::isfinite(worst->relative_error())) {
    file.add(group + "energy_error", worst->error, "J");
    file.add(group + "energy_turned_over", worst->turned_over, "J");
  }
  std::vector<std::string> names;
  std::vector<double> beyond, slides;
  for (const PassedLimit& limit : limits_passed(scene)) {
    names.push_back(limit.joint);
    beyond.push_back(limit.excess);
    slides.push_back(limit.slides ? 1 : 0);
  }
  if (names.empty()) return;
  const auto column = [](const std::vector<double>& values) {
    return Eigen::VectorXd(
        Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
  };
  file.add(group + "name/limit", names);
  file.add(group + "limit_beyond", column(beyond), "SI", {"limit"});
  file.add(group + "limit_slides", column(slides), "1", {"limit"});
}

/// Adds the outcome of a run: status, cost, energies and slip of pairs.
void add_outcome(const SceneResult& scene, const std::string& group, ResultFile& file) {
  // Write the status and the cost of the run.
  const SceneCost& cost = scene.run.cost;
  file.add(group + "status", name_of(scene.run.status));
  if (!scene.run.message.empty()) file.add(group + "reason", scene.run.message);
  file.add(group + "steps", static_cast<double>(cost.steps), "1");
  file.add(group + "unsolved", static_cast<double>(cost.unsolved), "1");
  if (has_contact_problems(scene)) file.add(group + "worst_residual", cost.worst_residual, "1");
  file.add(group + "deepest", cost.max_penetration, "m");
  file.add(group + "work", scene.measures.work, "J");
  file.add(group + "dissipated", scene.measures.dissipated, "J");
  add_account(scene, group, file);
  // Slip of each pair of bodies that touched.
  std::vector<std::string> names;
  Eigen::VectorXd slip(static_cast<Eigen::Index>(scene.measures.pairs.size()));
  const std::vector<MechanismBody>& bodies = scene.built->scene.mechanism.bodies;
  for (std::size_t k = 0; k < scene.measures.pairs.size(); ++k) {
    const PairMeasure& pair = scene.measures.pairs[k];
    names.push_back(bodies[static_cast<std::size_t>(pair.a)].name + " - " +
                    bodies[static_cast<std::size_t>(pair.b)].name);
    slip[static_cast<Eigen::Index>(k)] = pair.slip;
  }
  if (names.empty()) return;
  file.add(group + "name/pair", names);
  file.add(group + "slip", slip, "m", {"pair"});
}

/// Adds the names and settings that all runs of a scene share.
void add_names(const SceneResult& scene, ResultFile& file) {
  // Write names of bodies, coordinates and states beside the tables that they label.
  const Mechanism& mechanism = scene.built->scene.mechanism;
  file.add("format", kSceneRunFormat);
  file.add("scene", scene.name);
  file.add("name/body", names_of(mechanism.bodies));
  const auto add_some = [&](const char* key, const std::vector<std::string>& names) {
    if (!names.empty()) file.add(key, names);
  };
  add_some("name/position_entry", entry_names(mechanism, true));
  add_some("name/speed_entry", entry_names(mechanism, false));
  add_some("name/element_state_entry", element_state_names(scene.built->scene.elements));
  add_some("name/muscle", names_of(scene.measures.pulls.muscles));
  file.add("name/energy_part", std::vector<std::string>{"kinetic", "weight", "springs"});
  file.add("name/contact_mode", names_in(kContactModeNames));
  // The method and paths are needed to build the scene again.
  file.add("method", name_in(kSteppingMethodNames, scene.built->options.method));
  file.add("rungs/path", asked_paths(scene.request.path));
}

/// Adds the tables of one run. @param group  before their names
void add_run(const SceneResult& scene, const std::string& group, ResultFile& file) {
  add_instants(scene, group, file);
  add_elements(scene, group, file);
  add_contacts(scene, group, file);
  add_outcome(scene, group, file);
}

}  // namespace

void write_scene_run(const SceneResult& scene, const std::string& path, const RunRecord& run) {
  require(!scene.sources.empty(), "scene '{}' has no file, by which its run could be read again",
          scene.name);
  ResultFile file;
  add_names(scene, file);
  add_run(scene, "", file);
  add_origin(scene.sources, run, file);
  write_result(file, path);
}

void write_scene_sweep(const SceneSweepResult& sweep, const std::string& path,
                       const RunRecord& run) {
  // All runs share the names of the first, as only numbers vary.
  require(!sweep.runs.empty(), "no run was made: nothing to write");
  ResultFile file;
  add_names(sweep.runs.front(), file);
  const std::vector<std::string> varied = names_of(sweep.request.vary);
  file.add("varied", varied);
  Eigen::MatrixXd values(static_cast<Eigen::Index>(sweep.runs.size()),
                         static_cast<Eigen::Index>(varied.size()));
  // Each run has a group of its own, with the numbers that it was made with.
  for (std::size_t i = 0; i < sweep.runs.size(); ++i) {
    const SceneResult& scene = sweep.runs[i];
    for (std::size_t k = 0; k < varied.size(); ++k)
      values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = scene.varied[k].second;
    add_run(scene, fmt::format("runs/{}/", i + 1), file);
  }
  file.add("value", values, "SI", {"run", "number"});
  add_origin(sweep.runs.front().sources, run, file);
  write_result(file, path);
}

}  // namespace thenar
