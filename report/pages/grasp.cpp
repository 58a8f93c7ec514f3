#include "report/pages/grasp.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.h"
#include "report/pages/wrench_blocks.h"

namespace thenar {
namespace {

constexpr double kRounding = 5e-4;  // of a coordinate [mm], or of a unit vector [1]
constexpr double kTouches = 2e-4;   // gap up to which a stop is told with what it touches [m]

Json outcome_banner(const GraspStory& story) {
  const Grasp& grasp = story.grasp;
  const bool ok = grasp.outcome == GraspOutcome::kGrasped && grasp.quality.force_closure;
  return {{"type", "banner"}, {"ok", ok}, {"title", outcome_words(grasp)}};
}

Json picture_section(const GraspStory& story, MeshTable& meshes) {
  return section("picture", "The grasp", "",
                 Json::array({outcome_banner(story),
                              picture_block("The hand where it ended. Arrows are normals of "
                                            "contacts, into the object; cones hold the forces "
                                            "that do not slip.",
                                            story.eye,
                                            grasp_layers(story.picture, story.scene,
                                                         story.grasp.contacts, meshes))}));
}

Json warning_section(const GraspStory& story) {
  Json rows = Json::array();
  for (const std::string& warning : story.warnings) rows.push_back(Json::array({warning}));
  return section(
      "warnings", "What to know of the hand", "",
      Json::array({table_block("Assumptions and omissions.", {{"what", "", -1}}, rows)}));
}

/// A table, and what is to be said of its rows below it: notes are too long for columns.
Json measure_blocks(const std::string& caption, const std::vector<MeasureRow>& measures) {
  Json rows = Json::array(), notes = Json::array();
  for (const MeasureRow& each : measures) {
    rows.push_back({each.name, each.value});
    if (!each.note.empty()) notes.push_back(text_block(each.name + ": " + each.note + "."));
  }
  return joined(Json::array({table_block(caption, {{"measure", "", -1}, {"value", "", -1}}, rows)}),
                notes);
}

Json measure_section(const GraspStory& story) {
  Json blocks =
      measure_blocks("Loads and motions of the object, in its frame and about its centre of mass.",
                     story.measures);
  if (!story.robustness.empty())
    blocks = joined(blocks, measure_blocks("Monte Carlo: how sure it is.", story.robustness));
  return section("measures", "What the hand can do with it",
                 "Squeeze is the sum of normal forces. As driven: within what motors or tendons "
                 "can make at this posture.",
                 blocks);
}

/// Rounding is no number to read.
double tidy(double x) { return std::abs(x) < kRounding ? 0 : x; }

Json contact_section(const GraspStory& story) {
  Json rows = Json::array();
  for (const HandContact& found : story.grasp.contacts) {
    const Contact& c = found.contact;
    const LinkSurface& surface =
        story.hand.hand->surfaces()[static_cast<std::size_t>(found.surface)];
    rows.push_back({surface.name, surface.digit, tidy(1000 * c.p.x()), tidy(1000 * c.p.y()),
                    tidy(1000 * c.p.z()), tidy(c.n.x()), tidy(c.n.y()), tidy(c.n.z()), c.friction,
                    1000 * c.torsion});
  }
  return section(
      "contacts", "Contacts",
      "Positions and normals (into the object) in the object's frame; a region of contact is the "
      "few points that span it. Torsion is the torque about the normal per normal force.",
      Json::array({table_block(
          fmt::format("{} with {}.",
                      rows.size() == 1 ? "One contact" : fmt::format("{} contacts", rows.size()),
                      story.scene.object.name),
          {{"surface", "", -1},
           {"digit", "", -1},
           {"x", "mm", 2},
           {"y", "mm", 2},
           {"z", "mm", 2},
           {"n x", "", 3},
           {"n y", "", 3},
           {"n z", "", 3},
           {"friction", "", 2},
           {"torsion", "mm", 2}},
          rows)}));
}

Json joint_section(const GraspStory& story) {
  const Hand& hand = *story.hand.hand;
  const ClosedHand& closed = story.grasp.closed;
  const PosedCollisionHand posed{story.hand, story.grasp.approached.X_WH, hand.pose(closed.q)};
  const std::vector<std::string> words =
      stop_words(story.hand, closed, find_touching(posed, story.scene, kTouches));
  Json rows = Json::array();
  for (std::size_t c = 0; c < words.size(); ++c) {
    const auto i = static_cast<int>(c);
    rows.push_back({hand.layout().coordinates[c],
                    value_words(closed.q[i], slides(hand, closed.q, i)), words[c]});
  }
  return section("joints", "What stopped every joint", "",
                 Json::array({table_block(
                     "Coordinates of the hand when it came to rest.",
                     {{"coordinate", "", -1}, {"value", "", -1}, {"stopped by", "", -1}}, rows)}));
}

}  // namespace

Json grasp_layers(const HandPicture& picture, const Scene& scene,
                  const std::vector<HandContact>& contacts, MeshTable& meshes) {
  return joined(joined(hand_layers(picture, meshes), scene_layers(scene, meshes)),
                contact_layers(contacts, scene.object.X_WB, scene.object.reach));
}

Json grasp_page(const GraspStory& story, MeshTable& meshes) {
  Json sections = Json::array({picture_section(story, meshes)});
  const bool grasped = story.grasp.outcome == GraspOutcome::kGrasped;
  if (grasped) sections.push_back(quality_section(story));
  if (!story.measures.empty()) sections.push_back(measure_section(story));
  if (grasped) sections.push_back(wrench_section(story, meshes));
  if (grasped) sections.push_back(contact_section(story));
  if (!story.grasp.closed.stopped.empty()) sections.push_back(joint_section(story));
  if (!story.warnings.empty()) sections.push_back(warning_section(story));
  return sections;
}

}  // namespace thenar
