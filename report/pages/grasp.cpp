#include "report/pages/grasp.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "base/words.h"
#include "data/io/robot/import_robot.h"
#include "grasp/closing/describe_grasp.h"
#include "report/answers/grasp.h"
#include "report/answers/grasp_measures.h"
#include "report/blocks.h"
#include "report/pages/wrench_blocks.h"
#include "report/picture/grasp_view.h"
#include "report/provenance.h"

namespace thenar {
namespace {

// Rounding of a coordinate [mm], or of an entry of a unit vector [1]
constexpr double kTableRounding = 5e-4;

Json outcome_banner(const GraspResult& result) {
  const Grasp& grasp = result.grasp;
  const bool ok = grasp.outcome == GraspOutcome::kGrasped && grasp.quality.force_closure;
  std::vector<std::string> grave;
  std::copy_if(result.outcome.warnings.begin(), result.outcome.warnings.end(),
               std::back_inserter(grave), is_serious);
  return banner_block(describe_outcome(grasp), grave, ok && grave.empty());
}

Json picture_section(const GraspResult& result, MeshTable& meshes) {
  const WorldHand& hand = result.setting.hand;
  const HandPicture picture{*hand.named.hand, result.grasp.closed.q, result.grasp.approached.X_WH,
                            hand.named.patches, hand.carrier_surfaces};
  const GraspSetup& setup = result.setting.setup;
  const Camera& camera = result.setting.world.camera;
  const Eigen::Vector3d eye =
      view_of_contacts(picture, setup, result.grasp.contacts,
                       {camera.eye - camera.target, Eigen::Vector3d::UnitZ()});
  return section(
      "picture", "The grasp", "",
      Json::array(
          {outcome_banner(result),
           picture_block("The hand where it ended. Arrows are normals of contacts, into the "
                         "object; cones hold the forces that do not slip.",
                         eye, grasp_layers(picture, setup, result.grasp.contacts, meshes))}));
}

Json warning_section(const GraspResult& result) {
  const auto row = [](const std::string& warning) { return Json::array({warning}); };
  return section(
      "warnings", "Assumptions", "",
      Json::array({table_block("What was assumed of the hand and its object, or left out.",
                               {"assumption"}, list_of_each(result.outcome.warnings, row))}));
}

/// Returns a table with the notes of its rows below it, which are too long for columns.
Json measure_blocks(const std::string& caption, const std::vector<MeasureRow>& measures) {
  Json rows = Json::array(), notes = Json::array();
  for (const MeasureRow& each : measures) {
    rows.push_back({each.name, each.value});
    if (!each.note.empty()) notes.push_back(text_block(each.name + ": " + each.note + "."));
  }
  return joined(Json::array({table_block(caption, {"measure", "value"}, rows)}), notes);
}

Json measure_section(const GraspResult& result) {
  // Add measures of the grasp, then its robustness if requested.
  Json blocks = measure_blocks(
      "Loads and motions of the object, in its own frame and about its centre of mass.",
      measure_rows(*result.measures));
  if (result.robustness)
    blocks = joined(blocks, measure_blocks("Robustness (Monte Carlo): how often contacts or a pose "
                                           "that are a little off still close by force.",
                                           robustness_rows(result)));
  return section(
      "measures", "Loads and motions",
      "Grasp force is the sum of normal forces. Efforts are the torques of motors, or "
      "tensions of tendons, that the hand can make in this posture; its limits are these "
      "and rigid structure: palm, joint limits, locks and drives that cannot be driven "
      "back.",
      blocks);
}

/// Rounding is no number to read.
double tidy(double x) { return std::abs(x) < kTableRounding ? 0 : x; }

/// Returns the meaning of the last column of the contacts.
std::string torsion_words(const GraspResult& result) {
  return contact_model_of(result) == "hard point"
             ? "The contacts are hard points: torsion, a torque about the normal, is not modelled."
             : "The contacts are soft fingers: torsion is the largest torque about the normal per "
               "normal force.";
}

Json contact_section(const GraspResult& result) {
  // Places in mm and normals in the object's frame, rounded so that -0 does not show.
  const bool soft = contact_model_of(result) != "hard point";
  Json rows = Json::array();
  for (const HandContact& found : result.grasp.contacts) {
    const Contact& c = found.contact;
    const LinkSurface& surface = nth(result.collision_hand.hand->surfaces(), found.surface);
    rows.push_back({surface.name, surface.digit, tidy(1000 * c.p.x()), tidy(1000 * c.p.y()),
                    tidy(1000 * c.p.z()), tidy(c.n.x()), tidy(c.n.y()), tidy(c.n.z()), c.friction,
                    soft ? Json(1000 * c.torsion) : Json("-")});
  }
  return section(
      "contacts", "Contacts",
      "Positions and normals (into the object) in the object's frame; a region of contact is the "
      "few points that span it. " +
          torsion_words(result),
      Json::array({table_block(fmt::format("{} with {}.", counted(rows.size(), "contact"),
                                           result.setting.setup.object.name),
                               {"surface", "digit", "x [mm]:2", "y [mm]:2", "z [mm]:2", "n x:3",
                                "n y:3", "n z:3", "friction:2", "torsion [mm]:2"},
                               rows)}));
}

Json joint_section(const GraspResult& result) {
  Json rows = Json::array();
  for (const JointRow& row : joint_rows(result)) rows.push_back({row.name, row.shown, row.reason});
  return section("joints", "What stopped every joint", "",
                 Json::array({table_block("Coordinates of the hand when it came to rest.",
                                          {"coordinate", "value", "stopped by"}, rows)}));
}

Json sections_of(const GraspResult& result, MeshTable& meshes) {
  Json sections = Json::array({picture_section(result, meshes)});
  const bool grasped = result.grasp.outcome == GraspOutcome::kGrasped;
  if (grasped) sections.push_back(quality_section(result));
  if (result.measures) sections.push_back(measure_section(result));
  if (grasped) sections.push_back(wrench_section(result, meshes));
  if (grasped) sections.push_back(contact_section(result));
  if (!result.grasp.closed.stopped.empty()) sections.push_back(joint_section(result));
  if (!result.outcome.warnings.empty()) sections.push_back(warning_section(result));
  return sections;
}

}  // namespace

Json grasp_layers(const HandPicture& picture, const GraspSetup& setup,
                  const std::vector<HandContact>& contacts, MeshTable& meshes) {
  return joined(joined(hand_layers(picture, meshes), setup_layers(setup, meshes)),
                contact_layers(contacts, setup.object.X_WB, setup.object.torque_scale));
}

Json page_of(const GraspResult& result) {
  MeshTable meshes;
  // Question, answer and end of the grasp, then its sections.
  const std::string &hand = result.setting.hand.named.name,
                    &object = result.setting.setup.object.name;
  const Epsilon& quality = result.grasp.quality;
  const bool closed = result.grasp.outcome == GraspOutcome::kGrasped;
  const Json sections = sections_of(result, meshes);
  Json provenance = provenance_json(result.setting.files);
  if (result.request.starts > 0 || result.robustness)
    provenance["seed"] = std::to_string(result.request.seed);
  return {
      {"title", fmt::format("{} and {}", hand, object)},
      {"subtitle", result.setting.world.description},
      {"opening",
       opening_json(
           fmt::format("Can {} hold {}, and against which disturbances?", hand, object),
           fmt::format("The hand was closed in {}; {} contacts were found.",
                       result.setting.world.name, result.grasp.contacts.size()),
           fmt::format("Result: {}.", explanation(result)) +
               (closed ? fmt::format(" Epsilon is {:.4g} to {:.4g}.", quality.lower, quality.upper)
                       : ""))},
      {"provenance", provenance},
      {"meshes", meshes.json()},
      {"sections", sections}};
}

Json page_of(const CloseResult& result) { return page_of(result.grasp); }

}  // namespace thenar
