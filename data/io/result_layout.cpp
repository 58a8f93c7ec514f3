#include "data/io/result_layout.h"

#include "base/error.h"
#include "data/io/layout_check.h"

namespace thenar {
namespace {

using internal::FoundEntries;
using internal::Holds;
using internal::Layout;
using internal::LayoutRow;

/// Layout of a fit's file, as kinematics_fit/fit.cpp writes it.
const Layout& fit_layout() {
  // z has an entry for each coordinate; covariances are blocks, one for each specimen.
  static const Layout layout{
      {"fit/name", {"coordinate"}, Holds::kTexts},
      {"fit/z", {"coordinate"}, Holds::kFinite},
      {"fit/entry_of_z", {"specimen", "entry"}, Holds::kCount, "covariance"},
      {"fit/covariance", {"specimen", "entry", "entry"}, Holds::kFinite, "covariance"},
      {"fit/cost", {}, Holds::kFinite},
      {"fit/evaluations", {}, Holds::kCount},
      {"fit/seconds", {}, Holds::kFinite},
      {"fit/status", {"1"}, Holds::kTexts},
      {"fit/message", {"1"}, Holds::kTexts},
      {"fit/not_identifiable", {"null_direction"}, Holds::kTexts, "?"},
      {"fit/calibrated_on/experiment", {"seen"}, Holds::kTexts, "seen"},
      {"fit/calibrated_on/specimen", {"seen"}, Holds::kTexts, "seen"},
      {"parameters/name", {"parameter"}, Holds::kTexts},
      {"parameters/unit", {"parameter"}, Holds::kTexts},
      {"parameters/population/value", {"parameter"}, Holds::kFinite},
      {"parameters/population/sd", {"parameter"}, Holds::kFinite},
      {"parameters/specimens/*/value", {"parameter"}, Holds::kFinite},
      {"parameters/specimens/*/sd", {"parameter"}, Holds::kFinite},
      {"predictions/*/posture", {"trial"}, Holds::kTexts},
      {"predictions/*/loads", {"trial"}, Holds::kTexts},
      {"predictions/*/measured", {"trial", "3"}, Holds::kFinite},
      {"predictions/*/predicted", {"trial", "3"}, Holds::kFinite},
      {"predictions/*/relative_error", {}, Holds::kFinite},
      {"predictions/*/start_has_seen_specimen", {}, Holds::kCount, "?"},
      {"provenance/method", {"1"}, Holds::kTexts},
      {"provenance/seed", {}, Holds::kSeed},
  };
  return layout;
}

/// Layout of a motion's file, as api/simulate.cpp writes it.
const Layout& motion_layout() {
  // Tables have one row for each instant; the axes beside it are named by the lists above.
  static const Layout layout{
      {"status", {"1"}, Holds::kTexts},
      {"subject", {"1"}, Holds::kTexts},
      {"digit", {"1"}, Holds::kTexts},
      {"name/joint", {"joint"}, Holds::kTexts},
      {"name/muscle", {"muscle"}, Holds::kTexts},
      {"name/slip", {"slip"}, Holds::kTexts, "slips"},
      {"name/frozen", {"frozen"}, Holds::kTexts, "frozen"},
      {"rungs/frozen_angle", {"frozen"}, Holds::kFinite, "frozen"},
      {"time", {"instant+"}, Holds::kFinite},
      {"angle", {"instant", "joint"}, Holds::kFinite},
      {"speed", {"instant", "joint"}, Holds::kFinite},
      {"excitation", {"instant", "muscle"}, Holds::kFinite},
      {"activation", {"instant", "muscle"}, Holds::kFinite},
      {"tension", {"instant", "muscle"}, Holds::kFinite},
      {"excursion", {"instant", "muscle"}, Holds::kFinite},
      {"fibre", {"instant", "muscle"}, Holds::kFinite, "?"},
      {"slips", {"instant", "slip"}, Holds::kFinite, "slips"},
      {"tip", {"instant", "3"}, Holds::kFinite},
      {"energy", {"instant"}, Holds::kFinite},
      {"work", {"instant"}, Holds::kFinite},
      {"lost", {"instant"}, Holds::kFinite},
      {"energy_error", {}, Holds::kFinite},
      {"turned_over", {}, Holds::kFinite},
      {"stray", {}, Holds::kAny},  // NaN: its digit has no constraint to stray from
      {"tolerance", {}, Holds::kFinite},
  };
  return layout;
}

/// Layout of a scene's file, as api/scenes/simulate_scene.cpp writes it.
/// @param group  of a run: "" of a single one, "runs/*/" of a sweep
Layout scene_layout(const std::string& group) {
  Layout layout{
      // Names of axes come first, since the tables below refer to their lengths.
      {"scene", {"1"}, Holds::kTexts},
      {"name/body", {"body"}, Holds::kTexts},
      {"name/position_entry", {"position_entry"}, Holds::kTexts, "?"},
      {"name/speed_entry", {"speed_entry"}, Holds::kTexts, "?"},
      {"name/element_state_entry", {"element_state_entry"}, Holds::kTexts, "?"},
      {"name/muscle", {"muscle"}, Holds::kTexts, "?"},
      {"name/energy_part", {"3"}, Holds::kTexts, "?"},
      {"name/contact_mode", {"contact_mode"}, Holds::kTexts, "?"},
  };
  // A sweep has the numbers that vary, and one group for each run.
  if (!group.empty()) {
    layout.push_back({"varied", {"number"}, Holds::kTexts});
    layout.push_back({"value", {"run+", "number"}, Holds::kFinite});
    layout.push_back({"runs/*", {"run"}, Holds::kGroups});
  }
  // Tables of one run: motion, muscles, contacts as a list over all instants, and the account.
  const Layout of_run{
      {"time", {"instant+"}, Holds::kFinite},
      {"position", {"instant", "position_entry"}, Holds::kFinite},
      {"speed", {"instant", "speed_entry"}, Holds::kFinite},
      {"energy", {"instant", "3"}, Holds::kFinite},
      {"body_position", {"instant", "body", "3"}, Holds::kFinite},
      {"body_rotation", {"instant", "body", "4"}, Holds::kFinite},
      {"element_state", {"instant", "element_state_entry"}, Holds::kFinite, "?"},
      {"tension", {"instant", "muscle"}, Holds::kFinite, "muscles"},
      {"excitation", {"instant", "muscle"}, Holds::kAny, "muscles"},
      {"activation", {"instant", "muscle"}, Holds::kAny, "muscles"},
      {"excursion", {"instant", "muscle"}, Holds::kFinite, "muscles"},
      {"contact_instant", {"contact"}, Holds::kCount, "contacts"},
      {"contact_body_a", {"contact"}, Holds::kCount, "contacts"},
      {"contact_body_b", {"contact"}, Holds::kCount, "contacts"},
      {"contact_id", {"contact"}, Holds::kFinite, "contacts"},
      {"contact_mode", {"contact"}, Holds::kCount, "contacts"},
      {"contact_gap", {"contact"}, Holds::kFinite, "contacts"},
      {"contact_torsion", {"contact"}, Holds::kFinite, "contacts"},
      {"contact_point", {"contact", "3"}, Holds::kFinite, "contacts"},
      {"contact_normal", {"contact", "3"}, Holds::kFinite, "contacts"},
      {"contact_force", {"contact", "3"}, Holds::kFinite, "contacts"},
      {"contact_area", {"contact"}, Holds::kFinite, "contacts"},
      {"contact_stick", {"contact"}, Holds::kFinite, "contacts"},
      {"status", {"1"}, Holds::kTexts},
      {"steps", {}, Holds::kFinite},
      {"unsolved", {}, Holds::kFinite},
      {"worst_residual", {}, Holds::kAny, "?"},
      {"deepest", {}, Holds::kFinite},
      {"work", {}, Holds::kFinite},
      {"dissipated", {}, Holds::kFinite},
      {"energy_error", {}, Holds::kFinite, "?"},
      {"energy_turned_over", {}, Holds::kFinite, "?"},
      {"name/limit", {"limit"}, Holds::kTexts, "limits"},
      {"limit_beyond", {"limit"}, Holds::kFinite, "limits"},
      {"limit_slides", {"limit"}, Holds::kFinite, "limits"},
      {"name/pair", {"pair"}, Holds::kTexts, "pairs"},
      {"slip", {"pair"}, Holds::kFinite, "pairs"},
  };
  for (LayoutRow row : of_run) {
    row.key = group + row.key;
    layout.push_back(std::move(row));
  }
  return layout;
}

/// Layout of a posterior's file, as posterior/run/posterior_file.cpp writes it. Groups of
/// replicated and prior draws have lengths of their own.
const Layout& posterior_layout() {
  // Draws have the axes chain and draw, as ArviZ expects; prior and replicated draws have their
  // own.
  static const Layout layout{
      {"unconstrained_posterior/x", {"chain+", "draw+", "coordinate"}, Holds::kFinite},
      {"sample_stats/lp", {"chain", "draw"}, Holds::kFinite},
      {"sample_stats/log_prior", {"chain", "draw"}, Holds::kFinite},
      {"sample_stats/log_likelihood", {"chain", "draw"}, Holds::kFinite},
      {"sample_stats/acceptance_rate", {"chain", "draw"}, Holds::kFinite},
      {"sample_stats/step_size", {"chain", "draw"}, Holds::kFinite},
      {"sample_stats/energy", {"chain", "draw"}, Holds::kFinite},
      {"sample_stats/tree_depth", {"chain", "draw"}, Holds::kCount},
      {"sample_stats/n_steps", {"chain", "draw"}, Holds::kCount},
      {"sample_stats/broken", {"chain", "draw"}, Holds::kCount},
      {"sample_stats/diverging", {"chain", "draw"}, Holds::kCount},
      {"sample_stats/group", {"chain"}, Holds::kCount},
      {"sample_stats/temper", {"temperature+"}, Holds::kFinite},
      {"sample_stats/swap_rate", {"ladder", "neighbours"}, Holds::kAny, "?"},
      {"modes/x", {"mode", "coordinate"}, Holds::kFinite},
      {"modes/cost", {"mode"}, Holds::kFinite},
      {"modes/hits", {"mode"}, Holds::kCount},
      {"modes/laplace_mass", {"mode"}, Holds::kAny},
      {"log_likelihood/force", {"chain", "draw", "trial"}, Holds::kAny},
      {"observed_data/force", {"trial", "component"}, Holds::kAny},
      {"constant_data/force_sd", {"trial", "component"}, Holds::kAny},
      {"posterior_predictive/force", {"chain", "replicated+", "trial", "component"}, Holds::kAny},
      {"posterior/*", {"chain", "draw", ".."}, Holds::kFinite},
      {"prior/*", {"prior_chain", "prior_draw", ".."}, Holds::kFinite},
  };
  return layout;
}

/// The layout of the format that a file says it is of; empty: of none that is known.
Layout layout_of(const ResultFile& file) {
  const std::string format = file.text_or_none("format");
  if (format == "thenar fit 1") return fit_layout();
  if (format == "thenar motion 1") return motion_layout();
  if (format != "thenar scene run 1") return {};
  const bool sweep = file.texts.count("varied") > 0 || file.arrays.count("value") > 0;
  return scene_layout(sweep ? "runs/*/" : "");
}

}  // namespace

void check_layout(const ResultFile& file, const std::string& path) {
  FoundEntries found;
  for (const auto& [key, array] : file.arrays) found[key] = {&array.values, array.shape};
  for (const auto& [key, texts] : file.texts) found[key] = {nullptr, {texts.size()}};
  check_entries(found, layout_of(file), path);
}

bool has_layout(const ResultFile& file) { return !layout_of(file).empty(); }

void check_layout(const InferenceFile& file, const std::string& path) {
  const auto format = file.attributes.find("thenar_format");
  if (format == file.attributes.end() || format->second != "thenar posterior 1") return;
  FoundEntries found;
  for (const auto& [group_name, group] : file.groups)
    for (const auto& [name, array] : group.arrays)
      found[group_name + "/" + name] = {&array.values, shape_in(group, array)};
  check_entries(found, posterior_layout(), path);
}

Eigen::VectorXd vector_in(const ResultFile& file, const std::string& key) {
  const Eigen::MatrixXd values = file.matrix(key);
  const std::size_t dimensions = file.arrays.at(key).shape.size();
  require(dimensions == 1, "array '{}': wanted one dimension, got {}", key, dimensions);
  return values.col(0);
}

std::vector<std::size_t> shape_in(const InferenceGroup& group, const InferenceArray& array) {
  std::vector<std::size_t> shape;
  for (const std::string& dimension : array.dimensions) {
    const auto found = group.lengths.find(dimension);
    require(found != group.lengths.end(), "dimension '{}' has no length", dimension);
    shape.push_back(found->second);
  }
  return shape;
}

}  // namespace thenar
