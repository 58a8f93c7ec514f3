#include "report/answers/grasp.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/rung_names.h"
#include "data/io/robot/import_robot.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/limits/force_set.h"
#include "grasp/quality/grasp_matrix.h"
#include "grasp/quality/wrench_set_mesh.h"
#include "hand/passive_moment.h"
#include "report/answers/grasp_measures.h"
#include "report/answers/grasp_words.h"
#include "report/answers/passive_words.h"

namespace thenar {
namespace {

// Largest clearance of a contact that is named as the reason of a stop [m]
constexpr double kTouchClearance = 2e-4;

const LinkSurface& surface_of(const GraspResult& result, const HandContact& contact) {
  return nth(result.collision_hand.hand->surfaces(), contact.surface);
}

// ---- text

/// One number where both bounds show as the same.
std::string bounds_text(const Epsilon& e) {
  const std::string lower = fmt::format("{:.6g}", epsilon_or_zero(e.lower));
  const std::string upper = fmt::format("{:.6g}", epsilon_or_zero(e.upper));
  return lower == upper ? lower : fmt::format("between {} and {}", lower, upper);
}

std::string line(const std::string& name, const std::string& words) {
  return fmt::format("  {:<34}{}\n", name, words);
}

std::string quality_text(const Epsilon& e) {
  std::string text = line("force closure", e.force_closure ? "yes" : "no");
  text += line("epsilon", bounds_text(e) + (e.converged ? "" : " (gave up early)"));
  if (e.has_missing_direction)
    text += line("no wrench along", direction_words(e.missing_direction));
  return text + line(e.has_missing_direction ? "does not withstand" : "weakest against",
                     direction_words(e.worst_wrench));
}

/// Returns the part of a warning that is the same for all warnings of its kind.
std::string kind_of(const std::string& warning) {
  return warning.substr(0, warning.find_first_of(",:"));
}

std::string measures_text(const std::vector<MeasureRow>& rows) {
  std::string text;
  for (const MeasureRow& each : rows)
    text += line(each.name, each.value + (each.note.empty() ? "" : " (" + each.note + ")"));
  return text;
}

std::string starts_text(const GraspResult& result) {
  std::vector<std::string> parts;
  for (const auto& [outcome, name] : kGraspOutcomeNames)
    if (const int count = nth(result.outcomes, outcome); count > 0)
      parts.push_back(fmt::format("{} {}", count, name));
  return line("random starts",
              fmt::format("{} of seed {}: {}; {} with force closure", result.started(),
                          result.request.seed, fmt::join(parts, ", "), result.closures));
}

/// Returns a table of the contacts; hard points transmit no torsion and show "-" instead of zero.
std::string contacts_text(const GraspResult& result) {
  const bool soft = result.setting.hand.named.contact != ContactModel::kHardPoint;
  Table table{{"surface", "x_mm", "y_mm", "z_mm", "nx", "ny", "nz", "friction", "torsion_mm"}};
  for (const HandContact& found : result.grasp.contacts) {
    const Contact& c = found.contact;
    table.add_parts({{surface_of(result, found).name},
                     cells(Eigen::Vector3d(1000 * c.p), 2),
                     cells(c.n, 3),
                     {shown(c.friction, 2), soft ? shown(1000 * c.torsion, 2) : "-"}});
  }
  return titled(fmt::format("Contacts in the object's frame ({})",
                            soft ? "soft fingers: torsion is the largest torque about the normal "
                                   "per normal force"
                                 : "hard points: torsion about the normal is not modelled"),
                table);
}

std::string joints_text(const GraspResult& result) {
  Table joints{{"coordinate", "value", "stopped by"}};
  for (const JointRow& row : joint_rows(result)) joints.add({row.name, row.shown, row.reason});
  return joints.rows.empty() ? "" : "\n" + aligned(joints);
}

// ---- fields

std::vector<Fields> coordinate_fields(const GraspResult& result) {
  return fields_of_each(joint_rows(result), [](const JointRow& row) {
    return Fields{{"coordinate", row.name},
                  {"kind", row.slides ? "slides" : "turns"},
                  {"value", row.slides ? units::kMetreBare : units::kRadianBare, row.value},
                  {"stopped_by", row.stopped_by},
                  {"why", row.reason}};
  });
}

std::vector<Fields> contact_fields(const GraspResult& result) {
  return fields_of_each(result.grasp.contacts, [&](const HandContact& found) {
    const LinkSurface& surface = surface_of(result, found);
    return Fields{{"surface", surface.name},
                  {"digit", surface.digit},
                  {"position", units::kMetre, found.contact.p},
                  {"normal", units::kOne, found.contact.n},
                  {"friction", found.contact.friction},
                  {"torsion", units::kMetre, found.contact.torsion},
                  {"patch", found.contact.patch}};
  });
}

/// The grasp matrix with what its rows and columns are.
Fields matrix_fields(const GraspResult& result) {
  const GraspBody& object = result.setting.setup.object;
  const std::vector<Contact> contacts = contacts_without_hand(result.grasp.contacts);
  const Eigen::Matrix<double, 6, Eigen::Dynamic> G =
      grasp_matrix(contacts, object.com, object.torque_scale);
  std::vector<std::string> columns;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const std::string whose = fmt::format("contact {}: ", i + 1);
    columns.push_back(whose + "normal");
    if (contacts[i].friction > 0) {
      columns.push_back(whose + "first tangent");
      columns.push_back(whose + "second tangent");
    }
    if (contacts[i].torsion > 0) columns.push_back(whose + "torque about the normal / scale");
  }
  Fields fields{{"rows", OrderedJson{"fx", "fy", "fz", "tx / scale", "ty / scale", "tz / scale"}},
                {"columns", columns},
                {"matrix", units::kOne, G}};
  fields.append(fields_of(grasp_matrix_measures(G)));
  return fields;
}

Fields quality_fields(const Epsilon& e) {
  OrderedJson missing, missing_words;
  if (e.has_missing_direction) {
    missing = to_json(e.missing_direction.vector());
    missing_words = direction_words(e.missing_direction);
  }
  return {{"epsilon", Fields{{"lower", e.lower}, {"upper", e.upper}}},
          {"force_closure", e.force_closure},
          {"rank", e.rank},
          {"missing_direction", missing},
          {"missing_direction_words", missing_words},
          {"worst_wrench", units::kOne, e.worst_wrench.vector()},
          {"worst_wrench_words", direction_words(e.worst_wrench)},
          {"converged", e.converged}};
}

Fields start_fields(const GraspResult& result) {
  OrderedJson outcomes = OrderedJson::object();
  for (const auto& [outcome, name] : kGraspOutcomeNames)
    outcomes[name] = nth(result.outcomes, outcome);
  return {{"count", result.started()},
          {"seed", result.request.seed},
          {"best", result.best.value_or(-1)},
          {"outcomes", outcomes},
          {"force_closures", result.closures}};
}

/// The wrench set as meshes: projections onto forces and onto torques, and the slices where the
/// others are zero; null where one is not bounded, or is without the origin.
Fields wrench_set_fields(const GraspResult& result) {
  const ForceSet forces = unit_forces(result.wrenches, result.request.limit);
  const auto mesh = [&](const char* name, int first, PictureKind kind) {
    const WrenchSetMesh picture = wrench_set_mesh(forces, {first, first + 1, first + 2}, kind);
    if (picture.failed > 0) return Field(name, nullptr);
    return Field(name, Fields{{"vertices", units::kNewton, picture.mesh.vertices.transpose()},
                              {"triangles", units::kOne, picture.mesh.triangles.transpose()}});
  };
  return {mesh("forces", 0, PictureKind::kProjection),
          mesh("forces_without_torque", 0, PictureKind::kSlice),
          mesh("torques_over_reach", 3, PictureKind::kProjection),
          mesh("torques_over_reach_without_force", 3, PictureKind::kSlice)};
}

/// -0 is no answer.
void drop_signs_of_zeros(OrderedJson& json) {
  // Process the fields, their parts and so on.
  std::vector<OrderedJson*> values{&json};
  while (!values.empty()) {
    OrderedJson& value = *values.back();
    values.pop_back();
    if (value.is_structured())
      for (OrderedJson& part : value) values.push_back(&part);
    else if (value.is_number_float() && value.get<double>() == 0)
      value = 0.0;
  }
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the fields
Fields without_signs_of_zeros(const Fields& fields) {
  Fields plain;
  for (const Field& each : fields.all()) {
    Field& field = plain.add(each);
    for (Fields& part : field.parts) part = without_signs_of_zeros(part);
    drop_signs_of_zeros(field.value);
  }
  return plain;
}

}  // namespace

std::vector<JointRow> joint_rows(const GraspResult& result) {
  const ClosedHand& closed = result.grasp.closed;
  if (closed.stopped.empty()) return {};
  const Hand& hand = *result.collision_hand.hand;
  const PosedCollisionHand posed{result.collision_hand, result.grasp.approached.X_WH,
                                 hand.pose(closed.q)};
  const std::vector<std::string> why = stop_words(
      result.collision_hand, closed, find_touching(posed, result.setting.setup, kTouchClearance));
  std::vector<JointRow> rows;
  for (std::size_t c = 0; c < why.size(); ++c) {
    const auto i = static_cast<int>(c);
    const bool sliding = slides(hand, closed.q, i);
    rows.push_back({hand.layout().coordinates[c], sliding, closed.q[i],
                    value_words(closed.q[i], sliding), name_of(closed.stopped[c]), why[c]});
  }
  return rows;
}

std::string explanation(const GraspResult& result) {
  std::string words = describe_outcome(result.grasp);
  if (result.grasp.outcome != GraspOutcome::kEmpty || result.start.approach_distance > 0)
    return words;
  return words + (result.setting.hand.parts.size() > 1
                      ? "; it stays at its carrier: other angles of the arm may help"
                      : "; it closed in place: `thenar grasp` approaches the object first");
}

std::string contact_model_of(const GraspResult& result) {
  return result.setting.hand.named.contact == ContactModel::kHardPoint ? "hard point"
                                                                       : "soft finger";
}

std::vector<std::string> folded(const std::vector<std::string>& warnings) {
  std::vector<std::string> kinds, lines;
  std::vector<int> counts;
  for (const std::string& warning : warnings) {
    const auto found = std::find(kinds.begin(), kinds.end(), kind_of(warning));
    if (found != kinds.end()) {
      ++nth(counts, found - kinds.begin());
      continue;
    }
    kinds.push_back(kind_of(warning));
    lines.push_back(warning);
    counts.push_back(1);
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (counts[i] > 1) lines[i] += fmt::format(" (and {} more of the kind)", counts[i] - 1);
  return lines;
}

std::string text_of(const GraspResult& result) {
  std::string text = fmt::format("{} and {}: {}\n", result.setting.hand.named.name,
                                 result.setting.setup.object.name, explanation(result));
  // Put warnings that change the question before the numbers.
  std::vector<std::string> warnings = folded(result.outcome.warnings);
  const auto light = std::stable_partition(warnings.begin(), warnings.end(), is_serious);
  const auto add_warning = [&](const std::string& warning) {
    text += fmt::format("warning: {}\n", warning);
  };
  std::for_each(warnings.begin(), light, add_warning);
  if (result.request.starts > 0) text += starts_text(result);
  if (result.grasp.outcome == GraspOutcome::kGrasped) text += quality_text(result.grasp.quality);
  if (result.measures) text += "\n" + measures_text(measure_rows(*result.measures));
  if (result.robustness) text += measures_text(robustness_rows(result));
  text += joints_text(result);
  if (const auto& bones = result.setting.hand.named.skeleton; bones && has_passive(*bones))
    text += "passive moments of joints are counted\n";
  if (!result.grasp.contacts.empty()) text += "\n" + contacts_text(result);
  std::for_each(light, warnings.end(), add_warning);
  return text;
}

std::string text_of(const CloseResult& result) { return text_of(result.grasp); }

Fields fields_of(const GraspResult& result) {
  const Grasp& grasp = result.grasp;
  const NamedHand& hand = result.setting.hand.named;
  // Distinguish force closure from mere contact by the outcome.
  const Pose<double>& X = grasp.approached.X_WH;
  Fields fields{
      {"world", result.setting.path},
      {"hand", hand.name},
      // Robots have none.
      {"tendon_paths", hand.path == Path::kNone ? OrderedJson() : OrderedJson(name_of(hand.path))},
      {"object", result.setting.setup.object.name},
      {"outcome", grasp.outcome == GraspOutcome::kGrasped && !grasp.quality.force_closure
                      ? "touched"
                      : name_of(grasp.outcome)},
      {"explanation", explanation(result)}};
  // Without contacts there is nothing to measure.
  if (grasp.outcome == GraspOutcome::kGrasped) {
    fields.add("centre_of_mass", units::kMetre, result.setting.setup.object.com);
    fields.add("torque_scale", units::kMetre, result.setting.setup.object.torque_scale);
    fields.append(quality_fields(grasp.quality));
    if (result.measures) fields.append(fields_of(*result.measures));
    fields.add(result.robustness ? Field("robustness", robustness_fields(result))
                                 : Field("robustness", nullptr));
    if (result.request.wrench_meshes) fields.add("wrench_set", wrench_set_fields(result));
    fields.add("contact_model", contact_model_of(result));
    fields.add("contacts", contact_fields(result));
    fields.add("grasp_matrix", matrix_fields(result));
  }
  fields.add("hand_pose", Fields{{"position", units::kMetre, X.p}, {"rotation", units::kOne, X.R}});
  fields.add("coordinates", coordinate_fields(result));
  if (const auto& bones = hand.skeleton; bones && grasp.closed.q.size() > 0)
    add_passive(*bones, grasp.closed.q, fields);
  if (result.request.starts > 0) fields.add("starts", start_fields(result));
  fields.add("warnings", result.outcome.warnings);
  fields.add("complete", !result.outcome.stopped());
  fields.add("cpu", units::kCpuSecond, result.cpu);
  return without_signs_of_zeros(fields);
}

Fields fields_of(const CloseResult& result) { return fields_of(result.grasp); }

Table table_of(const GraspResult& result) {
  Table table{{"surface", "digit", "x_mm", "y_mm", "z_mm", "nx", "ny", "nz", "friction",
               "torsion_mm", "patch"}};
  for (const HandContact& found : result.grasp.contacts) {
    const Contact& c = found.contact;
    const LinkSurface& surface = surface_of(result, found);
    table.add_parts({{surface.name, surface.digit},
                     cells(Eigen::Vector3d(1000 * c.p), 4),
                     cells(c.n, 6),
                     {shown(c.friction, 4), shown(1000 * c.torsion, 4), std::to_string(c.patch)}});
  }
  return table;
}

Table table_of(const CloseResult& result) {
  Table table{{"coordinate", "kind", "value_rad_or_m", "stopped_by", "why"}};
  for (const JointRow& row : joint_rows(result.grasp))
    table.add({row.name, row.slides ? "slides" : "turns", shown(row.value, 6), row.stopped_by,
               row.reason});
  return table;
}

}  // namespace thenar
