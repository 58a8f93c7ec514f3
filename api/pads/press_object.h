#pragma once

/// Rigid objects that press on a pad, by name or file.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/provenance.h"
#include "base/spatial.h"
#include "geometry/shape.h"
#include "geometry/triangle_mesh.h"
#include "pads/pad_shape.h"

namespace thenar {

/// Options of an object that presses a pad.
struct PressObjectRequest {
  std::string name = "plane";    // "plane", "sphere", "cylinder", "edge", or a mesh file
  std::optional<double> radius;  // radius of a sphere, a cylinder or an edge's rounding [m];
                                 // absent: 10 mm, of an edge 0.5 mm
  double scale = 1e-3;           // length of one unit of a mesh file [m]
};

/// Rigid object. Its frame has z towards the pad and the top of the object in the plane z = 0; the
/// axis of a cylinder and the ridge of an edge are parallel to y, seen from above through the
/// origin. A mesh keeps its axes, with the middle of the top of its bounding box at the origin.
struct PressObject {
  std::string name;                    // "sphere of 10 mm", or the file
  std::shared_ptr<const Shape> shape;  // plane: a block of 1 m; cylinder and edge are as long
  TriangleMesh picture;                // part of its surface near the pad
  FileDigests files;                   // digest of a mesh file; else empty
};

/// Returns the names of the built-in objects.
[[nodiscard]] const std::vector<std::string>& press_object_names();

/// Finds or reads an object. @param size  size of the pad, which the picture of the object exceeds
/// [m]
/// @throws InputError for a name that is neither known nor a file, a radius or scale that is not
/// positive, one given to an object that has none, or a mesh that bounds no solid; DataError for a
///         wrong file.
[[nodiscard]] PressObject open_press_object(const PressObjectRequest& request, double size);

/// Pose at which an object just touches a pad, and the direction of its motion.
struct PadTouch {
  Pose<double> X_PO;      // pose of the object in the pad's frame
  Eigen::Vector3d along;  // direction of the object's motion into the pad, unit, pad's frame (3)
};

/// Computes the pose at which a rotated object first touches the skin.
///
/// At angle 0 the object moves perpendicularly on to the palmar side; a positive angle lifts the
/// finger's proximal end, so that the distal part is touched: along = -(sin(angle), 0, cos(angle)).
/// The object is aimed at the point of the skin that is farthest against that direction. The skin
/// is sampled at about a hundredth of the pad's length.
/// @param angle  within 60 deg either way [rad];  @param turn  rotation of the object about `along`
///         [rad]
/// @throws InputError if an angle is out of range, or the object misses the pad.
[[nodiscard]] PadTouch touch_pad(const PadShape& shape, const Shape& object, double angle,
                                 double turn);

}  // namespace thenar
