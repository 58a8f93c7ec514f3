#pragma once

/// Corners, edges and faces of two polyhedra that are near each other.

#include <array>
#include <vector>

#include "base/spatial.h"
#include "geometry/manifold/polyhedron.h"
#include "geometry/shape.h"

namespace thenar {

/// Features with which two polyhedra A and B may touch. They are found at one pose: all features
/// within `reach` there, and all corners deeper in the other body. So they include all features
/// nearer than a margin while the bodies have moved by no more than reach - margin.
struct NearFeatures {
  bool found = false;
  Pose<double> X_BA{};                    // where it was found
  double reach = 0;                       // [m]
  std::vector<int> corners_a, corners_b;  // of Polyhedron::corners, rising
  std::vector<std::array<int, 2>> edges;  // of Polyhedron::edges (A, B)
  std::vector<int> faces_b;               // of Polyhedron::faces
  std::vector<std::array<int, 2>> stack;  // of nodes to look at, kept for its memory
};

namespace internal {

/// Adds the corners of a body, in the frame of a shape, that are deeper in it than a depth.
/// @param depth  >= 0 [m]
void add_deep_corners(const Polyhedron& body, const Pose<double>& X_SP, const Shape& shape,
                      double depth, std::vector<int>& corners);

/// Finds the features of two polyhedra within a reach of each other, by their trees of balls.
void find_near(const Polyhedron& a, const Polyhedron& b, const Pose<double>& X_BA, double reach,
               NearFeatures& near);

/// Finds the faces of B within a reach of a segment; as `faces_b`, of a rounded A.
/// @param from, to  its ends [m] (3)
void find_near_faces(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Polyhedron& b,
                     double reach, NearFeatures& near);

/// The nearest points of two segments  from + s way,  s in [0, 1].
struct SegmentPlaces {
  double s, t;
};
[[nodiscard]] SegmentPlaces nearest_on_segments(const Eigen::Vector3d& from_a,
                                                const Eigen::Vector3d& way_a,
                                                const Eigen::Vector3d& from_b,
                                                const Eigen::Vector3d& way_b);

}  // namespace internal

}  // namespace thenar
