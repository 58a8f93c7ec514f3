#include "report/answers/grasp_measures.h"

#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/units.h"
#include "base/words.h"
#include "grasp/closing/describe_grasp.h"
#include "report/answers/grasp_words.h"
#include "report/table.h"

namespace thenar {
namespace {

/// Adds a measure under a key with its unit, even where it has parts.
/// @param to  a number or fields of the value
template <typename Value, typename To>
void put(Fields& fields, Fields& reasons, const std::string& key, const FieldUnit& unit,
         const Measured<Value>& measured, const To& to) {
  Field& field = measured.value ? fields.add(key, to(*measured.value)) : fields.add(key, nullptr);
  field.unit = unit;
  if (!measured.message.empty()) reasons.add(key, unit, OrderedJson(measured.message));
}

Fields ball_fields(const InscribedBall& ball) {
  return {{"lower", ball.lower},
          {"upper", ball.upper},
          {"residual", ball.residual},
          {"worst_load", units::kOne, ball.worst_load.vector()},
          {"worst_load_words", direction_words(ball.worst_load)}};
}

Fields stiffness_fields(const GraspStiffness& stiffness) {
  return {{"least", stiffness.min_eigenvalue},
          {"softest", units::kOne, stiffness.softest.vector()},
          {"softest_words", describe_motion(stiffness.softest)},
          {"pad_force", units::kNewton, kPadForce},
          {"matrix", units::kOne, stiffness.K}};
}

template <typename Value, typename Words>
void add_row(std::vector<MeasureRow>& rows, const std::string& name,
             const Measured<Value>& measured, const Words& words) {
  rows.push_back({name, measured.value ? words(*measured.value) : "no value", measured.message});
}

std::string short_volume_words(const Volume& v) {
  if (!v.complete) return fmt::format("at least {:.4g}", v.lower);
  return v.lower == v.upper
             ? fmt::format("{:.4g}", v.lower)
             : fmt::format("about {:.4g}, {:.4g} to {:.4g}", v.estimate, v.lower, v.upper);
}

constexpr double kSameLoad = 1e-3;  // relative difference below which two loads are told as one [1]

/// Returns a note about what the number in add_load_row() leaves out; "" if nothing.
std::string load_note(const SupportedLoad& load, const std::string& unit) {
  if (!load.active) return "with what structure carries; by efforts alone it is not known";
  if (load.with_structure - *load.active <= kSameLoad * load.with_structure) return "";
  return fmt::format("by efforts and friction; {}{} with rigid structure of unknown strength",
                     shown(load.with_structure), unit);
}

void add_load_row(std::vector<MeasureRow>& rows, const std::string& name,
                  const Measured<SupportedLoad>& load, const std::string& unit,
                  const std::string& directions = "") {
  MeasureRow row{name, "no value", load.message};
  if (load.value) {
    // Show the load that efforts support, if known: no source states the strength of structure.
    row.value = shown(load.value->active.value_or(load.value->with_structure)) + unit + directions;
    const std::string note = load_note(*load.value, unit);
    row.note += (row.note.empty() || note.empty() ? "" : "; ") + note;
  }
  rows.push_back(row);
}

/// Puts both numbers of a load.
void put_load(Fields& fields, Fields& reasons, const std::string& key, const FieldUnit& unit,
              const Measured<SupportedLoad>& load) {
  put(fields, reasons, key, unit, load,
      [](const SupportedLoad& found) { return found.with_structure; });
  fields.add(key + "_by_efforts", unit, load.value ? load.value->active : std::nullopt);
}

Fields motion_fields(const ObjectMotion& motion) {
  const Manipulability& m = motion.manipulability;
  return {{"unit", motion.unit},   {"drives", motion.drives},
          {"rank", m.rank},        {"singular_values", units::kOne, motion.speeds},
          {"volume", m.volume},    {"least", m.min_singular_value},
          {"isotropy", m.isotropy}};
}

std::string mobility_words(const ObjectMotion& motion) {
  const Manipulability& m = motion.manipulability;
  const std::string drives = counted(static_cast<std::size_t>(motion.drives), "drive");
  if (m.rank == 0) return fmt::format("none: {} cannot move it unless a contact slips", drives);
  if (m.rank < 6)
    return fmt::format("in {} of 6 directions by {}, at most {:.3g} {}", m.rank, drives,
                       motion.speeds[0], motion.unit);
  return fmt::format("in every direction, at least {:.3g} {}, isotropy {:.3g}",
                     m.min_singular_value, motion.unit, m.isotropy);
}

/// Null where a miss has part in a quantile.
Fields share_fields(const Robustness& found) {
  return {{"closure", found.closure},
          {"closure_lower", found.closure_lower},
          {"closure_upper", found.closure_upper},
          {"misses", found.misses},
          {"epsilon_5_percent", found.quantile(0.05)},
          {"epsilon_median", found.quantile(0.5)},
          {"epsilon_95_percent", found.quantile(0.95)}};
}

std::string share_words(const Robustness& found) {
  const double median = found.quantile(0.5);
  std::string words =
      fmt::format("force closure in {:.0f} % ({:.0f} to {:.0f} %), median epsilon {}",
                  100 * found.closure, 100 * found.closure_lower, 100 * found.closure_upper,
                  std::isfinite(median) ? fmt::format("{:.3g}", epsilon_or_zero(median))
                                        : "none: the hand misses");
  if (found.misses > 0)
    words += fmt::format(", {} of {} draws miss", found.misses, found.epsilon.size());
  return words;
}

}  // namespace

Fields fields_of(const GraspMeasures& m) {
  const auto same = [](double value) { return value; };
  Fields reasons;
  Fields fields{{"volume", m.volume.complete ? OrderedJson(m.volume.estimate) : OrderedJson()},
                {"volume_bounds", Fields{{"lower", m.volume.lower}, {"upper", m.volume.upper}}},
                {"volume_complete", m.volume.complete}};
  put(fields, reasons, "actuated_epsilon", units::kNewton, m.actuated, ball_fields);
  put(fields, reasons, "weight", units::kNewton, m.weight, same);
  put(fields, reasons, "hold", units::kNewton, m.hold, same);
  put(fields, reasons, "hold_actuated", units::kNewton, m.hold_actuated, same);
  put_load(fields, reasons, "times_weight", units::kOne, m.times_weight);
  put_load(fields, reasons, "pull", units::kNewton, m.pull);
  put_load(fields, reasons, "turn", units::kNewtonMetre, m.turn);
  put(fields, reasons, "stiffness", units::kNewtonPerMetre, m.stiffness, stiffness_fields);
  put(fields, reasons, "manipulability", units::kOne, m.manipulability, motion_fields);
  if (!m.volume.complete) reasons.add("volume", "too many facets or faces");
  fields.add("friction_edges", m.edges);
  fields.add("true_cones", m.edges > 0 ? "all but epsilon, volume, robustness, wrench_set" : "all");
  fields.add("reasons", std::move(reasons));
  return fields;
}

Fields fields_of(const GraspMatrixMeasures& m) {
  return {{"rank", m.rank},
          {"least_singular_value", m.min_singular_value},
          {"isotropy", m.isotropy},
          {"volume", m.volume},
          {"internal_forces", m.internal_forces}};
}

std::vector<MeasureRow> measure_rows(const GraspMeasures& m) {
  const auto newton = [](double value) { return fmt::format("{} N", shown(value)); };
  // From the wrench set to loads of the object, then stiffness and mobility.
  std::vector<MeasureRow> rows;
  rows.push_back({"volume of the wrench set", short_volume_words(m.volume) + " unit forces^6", ""});
  add_row(rows, "epsilon within the hand's limits", m.actuated, [](const InscribedBall& ball) {
    const std::string worst = direction_words(ball.worst_load);
    return ball.upper == 0
               ? fmt::format("0 N, nothing withstands {}", worst)
               : fmt::format("{:.4g} to {:.4g} N, least against {}", ball.lower, ball.upper, worst);
  });
  add_row(rows, "weight of the object", m.weight, newton);
  add_row(rows, "minimum grasp force to hold it", m.hold, newton);
  add_row(rows, "the same, within these limits", m.hold_actuated, newton);
  add_load_row(rows, "multiple of its weight supported", m.times_weight, "",
               ", along its weakest axis");
  add_load_row(rows, "supports a pull along z", m.pull, " N");
  add_load_row(rows, "supports a torque about z", m.turn, " N m");
  add_row(rows, "least stiffness of contacts", m.stiffness, [](const GraspStiffness& stiffness) {
    return fmt::format("{:.4g} N/m, {}", stiffness.min_eigenvalue,
                       describe_motion(stiffness.softest));
  });
  add_row(rows, "in-hand motion without slip", m.manipulability, mobility_words);
  if (m.edges > 0)
    rows.push_back({"friction", fmt::format("pyramids of {} edges", m.edges),
                    "in epsilon, volume and robustness; all other measures have true cones"});
  return rows;
}

Fields robustness_fields(const GraspResult& result) {
  const RobustnessRequest& asked = result.request.robustness;
  Fields contacts = share_fields(result.robustness->contacts),
         pose = share_fields(result.robustness->pose);
  contacts.append({{"friction_sd_of_log", asked.contacts.friction},
                   {"place_sd", units::kMetre, asked.contacts.position},
                   {"tilt_sd", units::kRadian, asked.contacts.tilt}});
  pose.append({{"place_sd", units::kMetre, asked.place}, {"turn_sd", units::kRadian, asked.turn}});
  return {{"draws", asked.draws},
          {"seed", result.request.seed},
          {"contacts", std::move(contacts)},
          {"pose", std::move(pose)}};
}

std::vector<MeasureRow> robustness_rows(const GraspResult& result) {
  const RobustnessRequest& asked = result.request.robustness;
  return {
      {"robustness to contacts", share_words(result.robustness->contacts),
       fmt::format("{} draws of seed {}; standard deviations: friction {:.0f} %, positions {:.1f} "
                   "mm, normals {:.1f} deg",
                   asked.draws, result.request.seed, 100 * asked.contacts.friction,
                   1000 * asked.contacts.position, asked.contacts.tilt / kDegree)},
      {"robustness to the object's pose", share_words(result.robustness->pose),
       fmt::format("{} draws of seed {}; standard deviations: {:.1f} mm and {:.1f} deg an axis; "
                   "grasped again. Jaws centre the object, but do not turn it flush, so that "
                   "flat faces meet along edges or at corners",
                   asked.draws, result.request.seed, 1000 * asked.place, asked.turn / kDegree)}};
}

}  // namespace thenar
