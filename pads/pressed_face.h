#pragma once

/// Springs spread over a face that lies partly inside a rigid object.

#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/shape.h"

namespace thenar {

/// Positions or forces of a face's corners, at (0, 0), (1, 0), (0, 1), (1, 1) (3, 4).
using FaceCorners = Eigen::Matrix<double, 3, 4>;

/// Returns the bilinear shape functions of a face's corners [1] (4). @param x, y  from 0 to 1 [1]
[[nodiscard]] Eigen::Vector4d face_shape(double x, double y);

/// Energy, forces and stiffness of springs over a face. Each spring presses along the object's
/// normal.
struct PressedFace {
  /// A point inside the object.
  struct Point {
    Eigen::Vector4d shape;   // shape functions of the corners there [1] (4)
    Eigen::Vector3d normal;  // normal of the object in the body's frame, unit (3)
  };
  double energy = 0;                       // integral of 1/2 k depth^2 [J]
  double deepest = 0;                      // largest depth [m]
  FaceCorners push = FaceCorners::Zero();  // forces on the corners, -d energy / d position [N]
  // Derivative of -push by the positions of the corners [N/m] (12, 12)
  Eigen::Matrix<double, 12, 12> stiffness = Eigen::Matrix<double, 12, 12>::Zero();
  std::vector<Point> points;  // one in each part of the face that is inside
};

/// Computes the springs over a bilinear face, divided into 2 x 4 x 4 triangles.
///
/// Convex object with straight edges: the depth over a triangle is the least of the depths below
/// the planes of the object's sides. The integral is exact: polygons clip the triangle into parts,
/// one for each plane. The energy then has a continuous slope as edges move over the skin, whereas
/// forces at fixed points would make the skin catch at each point. The planes are those at the
/// corners of the triangle, and further ones where the distance exceeds all known planes. The
/// motion of an edge changes the plane of the skin below, which adds to the stiffness, along a
/// ridge between planes p and q,
///   - integral of k depth (n_p - n_q)(n_p - n_q)' / |grad (d_p - d_q)|.
/// Smooth object: the depth is linear between the corners. Where the normals turn evenly, the
/// stiffness includes the curvature of the distance.
/// Curved or concave edges: the depth is linear over triangles subdivided up to four times; the
/// stiffness includes neither term.
/// @param stiffness  stiffness per area at the corners [N/m^3] (4)
/// @param area  area of the face [m^2]
[[nodiscard]] PressedFace press_face(const FaceCorners& corners, const Eigen::Vector4d& stiffness,
                                     double area, const Shape& object, const Pose<double>& X_PO);

}  // namespace thenar
