#pragma once

/// Corners, edges and faces of two polyhedra that are near each other.

#include <array>
#include <vector>

#include "base/spatial.h"
#include "geometry/manifold/polyhedron.h"
#include "geometry/shape.h"

namespace thenar {

/// Features with which two polyhedra A and B may touch. They are found at one pose: all features
/// within `reach`, and all deeper corners. They include all features nearer than a margin while the
/// bodies have moved by at most reach - margin.
struct NearFeatures {
  bool found = false;
  Pose<double> X_BA{};                    // pose at which they were found
  double reach = 0;                       // maximum distance of the features [m]
  std::vector<int> corners_a, corners_b;  // entries of Polyhedron::corners, ascending
  std::vector<std::array<int, 2>> edges;  // entries of Polyhedron::edges (A, B)
  std::vector<int> faces_b;               // entries of Polyhedron::faces
  std::vector<std::array<int, 2>> stack;  // buffer of tree nodes to visit
};

namespace internal {

/// Adds the corners of a body that are deeper in a shape than a depth.
/// @param X_SP  pose of the body in the frame of the shape;  @param depth  >= 0 [m]
void add_deep_corners(const Polyhedron& body, const Pose<double>& X_SP, const Shape& shape,
                      double depth, std::vector<int>& corners);

/// Finds the features of two polyhedra within a distance of each other, by their trees of balls.
void find_near_features(const Polyhedron& a, const Polyhedron& b, const Pose<double>& X_BA,
                        double reach, NearFeatures& near);

/// Finds the faces of B within a distance of a segment, as `faces_b`, for a rounded A.
/// @param from, to  its ends [m] (3)
void find_near_faces(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Polyhedron& b,
                     double reach, NearFeatures& near);

/// Parameters s and t in [0, 1] of the nearest points of two segments  from + s axis.
struct SegmentParameters {
  double s, t;
};
/// Finds the nearest points of two segments.
[[nodiscard]] SegmentParameters nearest_on_segments(const Eigen::Vector3d& from_a,
                                                    const Eigen::Vector3d& way_a,
                                                    const Eigen::Vector3d& from_b,
                                                    const Eigen::Vector3d& way_b);

}  // namespace internal

}  // namespace thenar
