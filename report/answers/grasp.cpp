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

// Clearance up to which a stop is told with what it touches [m]
constexpr double kTouchClearance = 2e-4;

const LinkSurface& surface_of(const GraspResult& result, const HandContact& contact) {
  return result.collision_hand.hand->surfaces()[static_cast<std::size_t>(contact.surface)];
}

// ---- text

/// One number where both bounds show as the same.
std::string bounds_text(const Epsilon& e) {
  const std::string lower = fmt::format("{:.6g}", without_rounding(e.lower));
  const std::string upper = fmt::format("{:.6g}", without_rounding(e.upper));
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
  for (std::size_t i = 0; i < kOutcomes.size(); ++i)
    if (result.outcomes[i] > 0)
      parts.push_back(fmt::format("{} {}", result.outcomes[i], name_of(kOutcomes[i])));
  return line("random starts",
              fmt::format("{} of seed {}: {}; {} with force closure", result.started(),
                          result.request.seed, fmt::join(parts, ", "), result.closures));
}

/// Returns a table of the contacts; hard points transmit no torsion and show "-" instead of zero.
std::string contacts_text(const GraspResult& result) {
  const bool soft = result.setting.hand.named.contact != ContactModel::kHardPoint;
  Table table{{"surface", "x_mm", "y_mm", "z_mm", "nx", "ny", "nz", "friction", "torsion_mm"}, {}};
  for (const HandContact& found : result.grasp.contacts) {
    const Contact& c = found.contact;
    table.rows.push_back(row({{surface_of(result, found).name},
                              cells(Eigen::Vector3d(1000 * c.p), 2),
                              cells(c.n, 3),
                              {shown(c.friction, 2), soft ? shown(1000 * c.torsion, 2) : "-"}}));
  }
  return titled(fmt::format("Contacts in the object's frame ({})",
                            soft ? "soft fingers: torsion is the largest torque about the normal "
                                   "per normal force"
                                 : "hard points: torsion about the normal is not modelled"),
                table);
}

std::string joints_text(const GraspResult& result) {
  Table joints{{"coordinate", "value", "stopped by"}, {}};
  for (const JointRow& row : joint_rows(result))
    joints.rows.push_back({row.name, row.shown, row.why});
  return joints.rows.empty() ? "" : "\n" + aligned(joints);
}

// ---- JSON

OrderedJson coordinates_json(const GraspResult& result) {
  OrderedJson list = OrderedJson::array();
  for (const JointRow& row : joint_rows(result))
    list.push_back({{"coordinate", row.name},
                    {"kind", row.slides ? "slides" : "turns"},
                    {"value", row.value},
                    {"stopped_by", row.stopped_by},
                    {"why", row.why}});
  return list;
}

OrderedJson contacts_json(const GraspResult& result) {
  OrderedJson list = OrderedJson::array();
  for (const HandContact& found : result.grasp.contacts) {
    const LinkSurface& surface = surface_of(result, found);
    list.push_back({{"surface", surface.name},
                    {"digit", surface.digit},
                    {"position_m", to_json(found.contact.p)},
                    {"normal", to_json(found.contact.n)},
                    {"friction", found.contact.friction},
                    {"torsion_m", found.contact.torsion},
                    {"patch", found.contact.patch}});
  }
  return list;
}

/// The grasp matrix with what its rows and columns are.
OrderedJson matrix_json(const GraspResult& result) {
  const GraspBody& object = result.setting.setup.object;
  const std::vector<Contact> contacts = contacts_without_hand(result.grasp.contacts);
  const Eigen::Matrix<double, 6, Eigen::Dynamic> G =
      grasp_matrix(contacts, object.com, object.torque_scale);
  OrderedJson columns = OrderedJson::array();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const std::string whose = fmt::format("contact {}: ", i + 1);
    columns.push_back(whose + "normal");
    if (contacts[i].friction > 0) {
      columns.push_back(whose + "first tangent");
      columns.push_back(whose + "second tangent");
    }
    if (contacts[i].torsion > 0) columns.push_back(whose + "torque about the normal / scale");
  }
  const GraspMatrixMeasures measures = grasp_matrix_measures(G);
  return {{"rows", {"fx", "fy", "fz", "tx / scale", "ty / scale", "tz / scale"}},
          {"columns", columns},
          {"matrix", to_json(Eigen::MatrixXd(G))},
          {"rank", measures.rank},
          {"least_singular_value", measures.min_singular_value},
          {"isotropy", measures.isotropy},
          {"volume", measures.volume},
          {"internal_forces", measures.internal_forces}};
}

OrderedJson quality_json(const Epsilon& e) {
  OrderedJson missing;
  if (e.has_missing_direction) missing = to_json(e.missing_direction);
  return {{"epsilon", {{"lower", e.lower}, {"upper", e.upper}}},
          {"force_closure", e.force_closure},
          {"rank", e.rank},
          {"missing_direction", missing},
          {"missing_direction_words", e.has_missing_direction
                                          ? OrderedJson(direction_words(e.missing_direction))
                                          : OrderedJson(nullptr)},
          {"worst_wrench", to_json(e.worst_wrench)},
          {"worst_wrench_words", direction_words(e.worst_wrench)},
          {"converged", e.converged}};
}

OrderedJson starts_json(const GraspResult& result) {
  OrderedJson outcomes = OrderedJson::object();
  for (std::size_t i = 0; i < kOutcomes.size(); ++i)
    outcomes[name_of(kOutcomes[i])] = result.outcomes[i];
  return {{"count", result.started()},
          {"seed", result.request.seed},
          {"best", result.best},
          {"outcomes", outcomes},
          {"force_closures", result.closures}};
}

OrderedJson mesh_json(const WrenchSetMesh& picture) {
  if (picture.failed > 0) return nullptr;  // unbounded, or without the origin
  return {{"vertices_N", to_json(Eigen::MatrixXd(picture.mesh.vertices.transpose()))},
          {"triangles", to_json(Eigen::MatrixXi(picture.mesh.triangles.transpose()))}};
}

/// Rung of the tendon paths of a human hand; null of a robot.
OrderedJson paths_json(const NamedHand& hand) {
  return hand.path == Path::kNone ? OrderedJson(nullptr) : OrderedJson(name_of(hand.path));
}

/// -0 is no answer.
void drop_signs_of_zeros(OrderedJson& json) {
  // The whole, its parts and theirs.
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
  std::string words = outcome_words(result.grasp);
  if (result.grasp.outcome != GraspOutcome::kEmpty || result.start.approach_distance > 0)
    return words;
  return words + (result.setting.hand.parts.size() > 1
                      ? "; it stays where what carries it stands: other angles of the arm may help"
                      : "; it closed where it stands: `thenar grasp` goes at the object first");
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
      ++counts[static_cast<std::size_t>(found - kinds.begin())];
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
  // What makes it the answer to another question stands before the numbers.
  std::vector<std::string> warnings = folded(result.warnings);
  const auto light = std::stable_partition(warnings.begin(), warnings.end(), is_grave);
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

OrderedJson json_of(const GraspResult& result) {
  const Grasp& grasp = result.grasp;
  const Pose<double>& X = grasp.approached.X_WH;
  OrderedJson json{
      {"world", result.setting.path},
      {"hand", result.setting.hand.named.name},
      {"tendon_paths", paths_json(result.setting.hand.named)},
      {"object", result.setting.setup.object.name},
      {"outcome", grasp.outcome == GraspOutcome::kGrasped && !grasp.quality.force_closure
                      ? "touched"
                      : name_of(grasp.outcome)},
      {"explanation", explanation(result)}};
  if (grasp.outcome == GraspOutcome::kGrasped) {
    json["centre_of_mass_m"] = to_json(result.setting.setup.object.com);
    json["torque_scale_m"] = result.setting.setup.object.torque_scale;
    json.update(quality_json(grasp.quality));
    if (result.measures) json.update(measures_json(*result.measures));
    json["robustness"] = result.robustness ? robustness_json(result) : OrderedJson(nullptr);
    if (result.request.wrench_meshes) json["wrench_set"] = wrench_set_json(result);
    json["contact_model"] = contact_model_of(result);
    json["contacts"] = contacts_json(result);
    json["grasp_matrix"] = matrix_json(result);
  }
  json["hand_pose"] = {{"position_m", to_json(X.p)}, {"rotation", to_json(X.R)}};
  json["coordinates"] = coordinates_json(result);
  if (const auto& bones = result.setting.hand.named.skeleton; bones && grasp.closed.q.size() > 0)
    add_passive(*bones, grasp.closed.q, json);
  if (result.request.starts > 0) json["starts"] = starts_json(result);
  json["warnings"] = result.warnings;
  json["complete"] = result.complete;
  json["cpu_s"] = result.cpu;
  drop_signs_of_zeros(json);
  return json;
}

OrderedJson json_of(const CloseResult& result) { return json_of(result.grasp); }

Table table_of(const GraspResult& result) {
  Table table{{"surface", "digit", "x_mm", "y_mm", "z_mm", "nx", "ny", "nz", "friction",
               "torsion_mm", "patch"},
              {}};
  for (const HandContact& found : result.grasp.contacts) {
    const Contact& c = found.contact;
    const LinkSurface& surface = surface_of(result, found);
    table.rows.push_back(
        row({{surface.name, surface.digit},
             cells(Eigen::Vector3d(1000 * c.p), 4),
             cells(c.n, 6),
             {shown(c.friction, 4), shown(1000 * c.torsion, 4), std::to_string(c.patch)}}));
  }
  return table;
}

Table table_of(const CloseResult& result) {
  Table table{{"coordinate", "kind", "value_rad_or_m", "stopped_by", "why"}, {}};
  for (const JointRow& row : joint_rows(result.grasp))
    table.rows.push_back(
        {row.name, row.slides ? "slides" : "turns", shown(row.value, 6), row.stopped_by, row.why});
  return table;
}

OrderedJson wrench_set_json(const GraspResult& result) {
  const ForceSet forces = unit_forces(result.wrenches, result.request.limit);
  const auto mesh = [&](int first, PictureKind kind) {
    return mesh_json(wrench_set_mesh(forces, {first, first + 1, first + 2}, kind));
  };
  return {{"forces", mesh(0, PictureKind::kProjection)},
          {"forces_without_torque", mesh(0, PictureKind::kSlice)},
          {"torques_over_reach", mesh(3, PictureKind::kProjection)},
          {"torques_over_reach_without_force", mesh(3, PictureKind::kSlice)}};
}

}  // namespace thenar
