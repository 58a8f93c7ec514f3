#pragma once

/// One grasp as sections of a report.

#include <string>
#include <vector>

#include "grasp/closing/grasp.h"
#include "report/answers/grasp_words.h"
#include "report/scene/hand_picture.h"

namespace thenar {

/// A measure in words.
struct MeasureRow {
  std::string name, value;
  std::string note;  // why there is none, or how it was found; may be empty
};

/// What a page tells of a grasp.
struct GraspStory {
  const HandPicture& picture;  // the hand where it ended
  const CollisionHand& hand;
  const Scene& scene;
  const Grasp& grasp;
  WrenchSet wrenches;               // of the contacts, as they were measured
  ForceNorm limit;                  // of contact forces
  Eigen::Vector3d eye{1, -1, 0.7};  // direction the picture is taken from, world frame (3)
  std::vector<std::string> warnings;
  std::vector<MeasureRow> measures;    // what the hand can do, beside epsilon
  std::vector<MeasureRow> robustness;  // how sure that is
};

/// Sections: picture, quality, measures, wrenches, contacts, joints, warnings; those there is
/// something for.
[[nodiscard]] Json grasp_page(const GraspStory& story, MeshTable& meshes);

/// The picture alone: hand, object, obstacles, contacts.
[[nodiscard]] Json grasp_layers(const HandPicture& picture, const Scene& scene,
                                const std::vector<HandContact>& contacts, MeshTable& meshes);

}  // namespace thenar
