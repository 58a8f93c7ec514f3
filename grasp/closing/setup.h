#pragma once

/// Setup of a grasp: the object and the obstacles.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "data/io/world/materials.h"
#include "data/io/world/world.h"
#include "geometry/solid.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// Bounding box of a body, in the frame of its mesh.
struct BodyBox {
  Eigen::Matrix3d axes{Eigen::Matrix3d::Identity()};  // columns, right-handed, longest first (3, 3)
  Eigen::Vector3d half{0, 0, 0};  // half sides along the axes, descending [m] (3)
};

/// Returns the smaller of two bounding boxes of a body: along its frame, and along its principal
/// axes of inertia at uniform density. The second must be smaller by 1 % of the volume, so that
/// bodies without distinct principal axes, like balls and cubes, keep their frame.
[[nodiscard]] BodyBox body_box(const TriangleMesh& picture);

/// A body at its pose, with the geometry that contacts need.
struct GraspBody {
  std::string name;
  std::string material;
  Solid solid;        // body frame
  Pose<double> X_WB;  // pose of the body in the world
  Eigen::Vector3d com{0, 0,
                      0};   // centre of mass, or of volume if it is unknown, body frame [m] (3)
  double torque_scale = 0;  // maximum distance of the surface from com [m]
  BodyBox box;              // body frame
};

/// Object to grasp, the obstacles around it, and all materials.
struct GraspSetup {
  GraspBody object;
  std::vector<GraspBody> obstacles;
  Materials materials;
};

/// Builds the solid of one body. @throws InputError as build_solid() does.
[[nodiscard]] GraspBody build_body(const PlacedBody& placed);

/// Builds a setup around one dynamic body of a world; the other bodies are obstacles.
/// @param object  its name; empty: the only dynamic body
/// @throws InputError if there is no such body, if it is an obstacle, or if none is named and not
///         exactly one is dynamic.
[[nodiscard]] GraspSetup build_setup(const WorldSpec& world, const std::string& object = "");

}  // namespace thenar
