#pragma once

/// What a hand meets: the object to be grasped, and what stands in the way.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "data/io/world/materials.h"
#include "data/io/world/world.h"
#include "geometry/solid.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

// The box around a body: which way it is long.

/// In the frame of its mesh.
struct BodyBox {
  Eigen::Matrix3d axes{Eigen::Matrix3d::Identity()};  // columns, right-handed, longest first (3, 3)
  Eigen::Vector3d half{0, 0, 0};                      // of its sides along them, descending [m] (3)
};

/// The smaller of two boxes around a body's picture: one along its frame, one along its principal
/// axes of inertia at uniform density. Bodies whose principal axes are no axes at all, balls and
/// cubes, keep their frame: the other must be smaller by 1 % of the volume.
[[nodiscard]] BodyBox body_box(const TriangleMesh& picture);

/// A body in its place, ready for contacts.
struct SceneBody {
  std::string name;
  std::string material;
  Solid solid;                   // body frame
  Pose<double> X_WB;             //
  Eigen::Vector3d com{0, 0, 0};  // of mass, of volume if that is unknown, body frame [m] (3)
  double reach = 0;              // of the surface from com: the usual torque scale [m]
  BodyBox box;                   // body frame
};

struct Scene {
  SceneBody object;
  std::vector<SceneBody> obstacles;
  Materials materials;
};

/// One body, its solid built. @throws InputError as build_solid() does.
[[nodiscard]] SceneBody build_body(const PlacedBody& placed);

/// A world around one of its dynamic bodies; the other bodies are obstacles.
/// @param object  its name; empty: the only dynamic body
/// @throws InputError if there is no such body, if it is an obstacle, or if none is named and not
///         one is dynamic.
[[nodiscard]] Scene build_scene(const WorldSpec& world, const std::string& object = "");

}  // namespace thenar
