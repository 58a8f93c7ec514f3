#include <fmt/format.h>

#include "apps/grasp_measures.h"
#include "apps/grasp_output.h"
#include "apps/grasp_report.h"
#include "apps/grasp_robustness.h"
#include "grasp/quality/wrench_set_mesh.h"
#include "report/answers/grasp_words.h"
#include "report/json.h"

namespace thenar {
namespace {

OrderedJson stopped_json(const GraspQuestion& question, const CollisionHand& touching,
                         const std::vector<JointRow>& rows) {
  OrderedJson list = OrderedJson::array();
  const HandLayout& layout = question.hand.named.hand->layout();
  for (std::size_t c = 0; c < rows.size(); ++c)
    list.push_back(
        {{"coordinate", layout.coordinates[c]},
         {"kind",
          slides(*touching.hand, question.hand.q, static_cast<int>(c)) ? "slides" : "turns"},
         {"value", rows[c].value},
         {"stopped_by", rows[c].stopped_by},
         {"why", rows[c].why}});
  return list;
}

OrderedJson contacts_json(const CollisionHand& touching, const std::vector<HandContact>& contacts) {
  OrderedJson list = OrderedJson::array();
  for (const HandContact& found : contacts) {
    const LinkSurface& surface = touching.hand->surfaces()[static_cast<std::size_t>(found.surface)];
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

OrderedJson starts_json(const GraspQuestion& question, const GraspAnswer& answer) {
  OrderedJson outcomes = OrderedJson::object();
  for (std::size_t i = 0; i < kOutcomes.size(); ++i)
    outcomes[name_of(kOutcomes[i])] = answer.outcomes[i];
  return {{"count", answer.started()},
          {"seed", question.seed},
          {"best", answer.best},
          {"outcomes", outcomes},
          {"force_closures", answer.closures}};
}

OrderedJson mesh_json(const WrenchSetMesh& picture) {
  if (picture.failed > 0) return nullptr;  // unbounded, or without the origin
  return {{"vertices_N", to_json(Eigen::MatrixXd(picture.mesh.vertices.transpose()))},
          {"triangles", to_json(Eigen::MatrixXi(picture.mesh.triangles.transpose()))}};
}

/// Projections onto forces and onto torques, and the slices where the others are zero.
OrderedJson wrench_set_json(const WrenchSet& wrenches, ForceNorm limit) {
  const ForceSet forces = unit_forces(wrenches, limit);
  const auto mesh = [&](int first, PictureKind kind) {
    return mesh_json(wrench_set_mesh(forces, {first, first + 1, first + 2}, kind));
  };
  return {{"forces", mesh(0, PictureKind::kProjection)},
          {"forces_without_torque", mesh(0, PictureKind::kSlice)},
          {"torques_over_reach", mesh(3, PictureKind::kProjection)},
          {"torques_over_reach_without_force", mesh(3, PictureKind::kSlice)}};
}

/// -0 is no answer.
void drop_signs_of_zeros(OrderedJson& json) {
  if (json.is_structured())
    for (OrderedJson& each : json) drop_signs_of_zeros(each);
  else if (json.is_number_float() && json.get<double>() == 0)
    json = 0.0;
}

}  // namespace

OrderedJson grasp_json(const GraspQuestion& question, const CollisionHand& touching,
                       const GraspAnswer& answer, bool pictures) {
  const Grasp& grasp = answer.grasp;
  const Pose<double>& X = grasp.approached.X_WH;
  OrderedJson json{
      {"world", question.path},
      {"hand", question.hand.named.name},
      {"object", question.scene.object.name},
      {"outcome", grasp.outcome == GraspOutcome::kGrasped && !grasp.quality.force_closure
                      ? "touched"
                      : name_of(grasp.outcome)},
      {"explanation", explanation(question, answer)}};
  if (grasp.outcome == GraspOutcome::kGrasped) {
    json.update(quality_json(grasp.quality));
    if (answer.measures) json.update(measures_json(*answer.measures));
    json["robustness"] =
        answer.robustness ? robustness_json(*answer.robustness) : OrderedJson(nullptr);
    if (pictures) json["wrench_set"] = wrench_set_json(answer.wrenches, question.limit);
    json["contacts"] = contacts_json(touching, grasp.contacts);
  }
  json["hand_pose"] = {{"position_m", to_json(X.p)}, {"rotation", to_json(X.R)}};
  json["coordinates"] = stopped_json(question, touching, joint_rows(question, touching, answer));
  if (question.starts > 0) json["starts"] = starts_json(question, answer);
  json["warnings"] = warnings_of(question, answer);
  json["cpu_s"] = answer.cpu;
  drop_signs_of_zeros(json);
  return json;
}

}  // namespace thenar
