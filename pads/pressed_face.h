#pragma once

/// Springs spread over a face that lies inside a rigid object in part.

#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/shape.h"

namespace thenar {

/// Places or forces of a face's corners, at (0, 0), (1, 0), (0, 1), (1, 1) (3, 4).
using FaceCorners = Eigen::Matrix<double, 3, 4>;

/// Shape functions of a face's corners [1] (4). @param x, y  from 0 to 1
[[nodiscard]] Eigen::Vector4d face_shape(double x, double y);

/// Energy, forces and stiffness of springs over a face. Each spring presses along the object's
/// normal.
struct PressedFace {
  /// A point inside the object.
  struct Point {
    Eigen::Vector4d shape;   // functions of the corners there [1]
    Eigen::Vector3d normal;  // of the object, unit, body's frame
  };
  double energy = 0;                       // integral of 1/2 k depth^2 [J]
  double deepest = 0;                      // [m]
  FaceCorners push = FaceCorners::Zero();  // on the corners, less the energy's slope [N]
  Eigen::Matrix<double, 12, 12> stiffness = Eigen::Matrix<double, 12, 12>::Zero();  // by corners
  std::vector<Point> points;  // one in each part of the face that is inside
};

/// Springs over a bilinear face, cut in 2 x 4 x 4 triangles.
///
/// Over a triangle the depth in a convex object with edges is the least of those below the planes
/// of its sides, and the integral is taken exactly, part by part, by clipping polygons. So the
/// energy has a continuous slope as edges move over the skin, and nothing catches: with forces at
/// fixed points, each is a notch. Planes are those at the corners, and at corners of parts where
/// the object proves to be farther than all of them. As an edge moves, skin turns from one side to
/// the other: the stiffness has, along a ridge between planes p and q,
///   - integral of k depth (n_p - n_q)(n_p - n_q)' / |grad (d_p - d_q)|.
/// Where normals hardly turn the depth is linear between corners, and as they turn evenly, over a
/// curved object, so do the forces: the stiffness has the curvature of the distance. Along edges
/// that are curved or not convex the depth is linear over triangles that were cut in four up to
/// four times; there the stiffness has neither.
/// @param stiffness  at the corners [N/m^3] (4);  @param area  [m^2]
[[nodiscard]] PressedFace press_face(const FaceCorners& corners, const Eigen::Vector4d& stiffness,
                                     double area, const Shape& object, const Pose<double>& X_PO);

}  // namespace thenar
