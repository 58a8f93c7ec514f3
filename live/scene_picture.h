#pragma once

/// Live pictures of moving scenes: bodies, joints, tendons, applied forces, contacts.

#include <optional>
#include <vector>

#include "dynamics/scene/build_scene.h"
#include "live/live_picture.h"
#include "live/scene_tendons.h"

namespace thenar {

/// Correspondence between the parts of a scene and those of its picture.
struct ScenePicture {
  LiveShape shape;
  std::vector<int> body_of;        // body of the mechanism (bodies of the shape)
  std::vector<int> shape_body_of;  // body of the shape; -1: not shown (bodies of the mechanism)
  std::vector<int> joint_of;       // joint of the mechanism (joints of the shape)
  std::vector<bool> leads;      // true: has the coordinate's name and value (joints of the shape)
  std::vector<bool> is_moment;  // true: a moment, false: a force (arrows of the shape)
  SceneTendons tendons;         // tendons behind the lines of the shape
};

/// Builds the picture of a scene. Bodies without a surface are left out, unless a joint moves them.
/// One joint of each coordinate has the coordinate's name and value: the first that moves with
/// ratio 1, else the first. The other joints of the coordinate are led by it. Ball and free joints
/// are left out. Forces of the scene become arrows, loaded tendons become lines.
[[nodiscard]] ScenePicture scene_picture(const BuiltScene& built,
                                         const std::optional<Camera>& camera);

/// State of a scene at an instant, as needed for a picture.
struct SceneView {
  double t = 0;                                // time [s]
  const Eigen::VectorXd& q;                    // positions (q)
  const std::vector<Pose<double>>& X_WB;       // poses (bodies of the mechanism)
  const std::vector<ContactSample>& contacts;  // contacts at this instant
  const Eigen::VectorXd& tension;              // tensions of SceneTendons::muscles() [N] (muscles)
};

/// Computes the moving parts of a picture.
[[nodiscard]] LiveInstant scene_instant(const ScenePicture& picture, const MovingScene& scene,
                                        const MechanismLayout& layout, const SceneView& view);

/// Range of a coordinate [rad] or [m].
struct CoordinateRange {
  double lower, upper;
};
/// Returns the ranges of all coordinates (coordinates): those of the joint stops of human hands,
/// else those in which every joint of the coordinate is within its limits. Unlimited coordinates
/// get half a turn, or 1 m, to either side.
[[nodiscard]] std::vector<CoordinateRange> coordinate_ranges(const MovingScene& scene);

}  // namespace thenar
