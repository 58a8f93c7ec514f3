#pragma once

/// Moving scenes as live pictures: bodies, joints, tendons, forces that act, contacts.

#include <optional>
#include <vector>

#include "dynamics/scene/build_scene.h"
#include "live/live_picture.h"
#include "live/scene_tendons.h"

namespace thenar {

/// Correspondence between the parts of a scene and those of its picture.
struct ScenePicture {
  LiveShape shape;
  std::vector<int> body_of;     // of shape's bodies: body of the mechanism
  std::vector<int> shown_as;    // of the mechanism's bodies: body of the shape; -1: not shown
  std::vector<int> joint_of;    // of shape's joints: joint of the mechanism
  std::vector<bool> leads;      // of shape's joints: it is called after its coordinate
  std::vector<bool> is_moment;  // of shape's arrows, one of each force of the scene
  SceneTendons tendons;         // shape's lines
};

/// The picture of a scene. Bodies without a surface are left out, but for those that carry a joint.
/// The first joint that a coordinate moves is called after it, and its value is the coordinate's;
/// other joints of that coordinate are led by it. Joints that no coordinate moves (balls, free
/// bodies) are none. Forces of the scene are arrows, tendons that are pulled are lines.
[[nodiscard]] ScenePicture scene_picture(const BuiltScene& built,
                                         const std::optional<Camera>& camera);

/// State of a scene at an instant, as far as a picture shows it.
struct SceneView {
  double t = 0;                                // [s]
  const Eigen::VectorXd& q;                    // positions (q)
  const std::vector<Pose<double>>& X_WB;       // (bodies of the mechanism)
  const std::vector<ContactSample>& contacts;  //
  const Eigen::VectorXd& tension;              // of SceneTendons::muscles() [N] (muscles)
};

/// The instant of a picture.
[[nodiscard]] LiveInstant scene_instant(const ScenePicture& picture, const MovingScene& scene,
                                        const MechanismLayout& layout, const SceneView& view);

/// Ranges of all coordinates: of human hands those of their stops, of all others those in which
/// every joint that they move is within its limits; where there are none, half a turn either way,
/// or 1 m. [rad] or [m] (coordinates)
struct CoordinateRange {
  double lower, upper;
};
[[nodiscard]] std::vector<CoordinateRange> coordinate_ranges(const MovingScene& scene);

}  // namespace thenar
