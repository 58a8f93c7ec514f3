#include "pads/pressed_face.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>

#include "base/lists.h"
#include "pads/triangle_planes.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;
using Row = Eigen::Matrix<double, 12, 1>;    // one entry for each coordinate of a face's corners
using Shapes = Eigen::Matrix<double, 4, 3>;  // shape functions of the face at a triangle's corners

constexpr int kSideParts = 4;  // parts into which a side of a face is divided
// Least turn of the normals over a triangle for which planes are used [1]
constexpr double kPlaneTurn = 3e-3;
// Largest excess of a plane over a convex object, due to rounding [m]
constexpr double kConvexRounding = 1e-9;
// Least excess of the distance over all known planes that shows a further plane [m]
constexpr double kPlaneExcess = 1e-13;
constexpr double kSharpTurn = 0.1;  // least turn of the normals over a triangle at an edge [1]
// Largest deviation of the middle normal over the turn; at an edge it is one half [1]
constexpr double kEvenTurnShare = 0.25;
// Largest cosine of the angle between a triangle's normal and a vector in its plane [1]
constexpr double kInPlaneCosine = 1e-6;
constexpr int kMaxSplits = 4;         // subdivisions of a triangle over curved edges
constexpr int kMaxPlaneSearches = 4;  // searches for further planes of a triangle

using Plane = internal::TrianglePlane;
using internal::area_share;
using internal::clipped;
using internal::for_each_gauss_point;
using internal::TrianglePart;
using internal::whole_triangle;

/// Point on a face, and the object's surface near it, in the body's frame.
struct Sample {
  Vector4d shape;
  Vector3d place, normal;
  double distance = 0;
};
using Triangle = std::array<Sample, 3>;

/// Sum of the springs over the triangles of a face.
class FacePress {
 public:
  FacePress(const FaceCorners& corners, const Vector4d& stiffness, double area, const Shape& object,
            const Pose<double>& X_PO)
      : corners_(corners),
        stiffness_(stiffness * area / (2 * kSideParts * kSideParts)),
        object_(object),
        X_PO_(X_PO),
        X_OP_(X_PO.inverse()) {}

  PressedFace press() {
    // Skip a face whose middle is farther from the object than from its corners.
    const Sample middle = sample(face_shape(0.5, 0.5));
    if (middle.distance > (corners_.colwise() - middle.place).colwise().norm().maxCoeff())
      return std::move(out_);
    // Grid of places with the object's nearest points.
    std::array<std::array<Sample, kSideParts + 1>, kSideParts + 1> at;
    for (std::size_t i = 0; i <= kSideParts; ++i)
      for (std::size_t j = 0; j <= kSideParts; ++j)
        at[i][j] = sample(
            face_shape(static_cast<double>(i) / kSideParts, static_cast<double>(j) / kSideParts));
    // Divide into triangles; diagonals alternate, so that no direction is preferred.
    for (std::size_t i = 0; i < kSideParts; ++i)
      for (std::size_t j = 0; j < kSideParts; ++j) {
        const Sample &a = at[i][j], &b = at[i + 1][j], &c = at[i][j + 1], &d = at[i + 1][j + 1];
        const bool rises = (i + j) % 2 == 0;
        add_triangle(rises ? Triangle{a, b, d} : Triangle{a, b, c});
        add_triangle(rises ? Triangle{a, d, c} : Triangle{b, d, c});
      }
    return std::move(out_);
  }

 private:
  [[nodiscard]] Sample sample(const Vector4d& shape) const {
    const Vector3d place = corners_ * shape;
    const NearestSurface near = object_.nearest(X_OP_ * place);
    return {shape, place, X_PO_.R * near.normal, near.distance};
  }

  /// Adds the springs of a triangle. @param cuts  subdivisions that created it
  void add_triangle(const Triangle& at, int cuts = 0) {
    // Skip a triangle that is farther from the object than its size.
    const double reach =
        std::max((at[1].place - at[0].place).norm(), (at[2].place - at[0].place).norm());
    if (at[0].distance > reach) return;
    for (Eigen::Index c = 0; c < 3; ++c) corner_shapes_.col(c) = at[c].shape;
    triangle_stiffness_ = std::pow(0.25, cuts) * stiffness_.dot(corner_shapes_.rowwise().mean());
    // Compute the object's planes at the corners, the turn of normals between them, and the excess
    // of a plane over the object, which only a concave object allows.
    double turn = 0, excess = 0;
    std::array<Plane, 3> planes;
    for (std::size_t p = 0; p < 3; ++p) {
      planes[p] = plane_at(at, at[p].place, at[p].normal, at[p].distance);
      for (std::size_t c = 0; c < 3; ++c) {
        turn = std::max(turn, (at[p].normal - at[c].normal).norm());
        excess = std::max(excess, planes[p].values[c] - at[c].distance);
      }
    }
    // Skip a triangle that is wholly outside one plane of a convex object.
    const bool is_convex = excess < kConvexRounding;
    if (is_convex &&
        any_of(planes, [](const Plane& plane) { return plane.values.minCoeff() >= 0; }))
      return;
    // Use planes at straight edges, a linear depth on smooth objects, a subdivision elsewhere.
    if (turn > kPlaneTurn && is_convex && find_planes(at, planes))
      add_plane_springs();
    else if (turn < kSharpTurn || cuts == kMaxSplits)
      add_linear_springs(at, turn < kSharpTurn || has_smooth_normals(at));
    else
      subdivide(at, cuts + 1);
  }

  void subdivide(const Triangle& at, int cuts) {
    const auto between = [&](std::size_t a, std::size_t b) {
      return sample(Vector4d((at[a].shape + at[b].shape) / 2));
    };
    const Sample ab = between(0, 1), bc = between(1, 2), ca = between(2, 0);
    for (const Triangle& quarter : {Triangle{at[0], ab, ca}, Triangle{ab, at[1], bc},
                                    Triangle{ca, bc, at[2]}, Triangle{bc, ca, ab}})
      add_triangle(quarter, cuts);
  }

  static Plane plane_at(const Triangle& at, const Vector3d& place, const Vector3d& normal,
                        double distance) {
    Plane out{Vector3d::Constant(distance), normal};
    for (Eigen::Index c = 0; c < 3; ++c) out.values[c] += normal.dot(at[c].place - place);
    return out;
  }

  /// Returns whether normals turn evenly along the side where they turn most: no edge of the object
  /// lies over the triangle.
  [[nodiscard]] bool has_smooth_normals(const Triangle& at) const {
    std::size_t most = 0;
    const auto turn = [&](std::size_t side) {
      return (at[(side + 1) % 3].normal - at[side].normal).norm();
    };
    for (std::size_t side = 1; side < 3; ++side)
      if (turn(side) > turn(most)) most = side;
    const Sample &from = at[most], &to = at[(most + 1) % 3];
    const Vector3d middle = sample(Vector4d((from.shape + to.shape) / 2)).normal;
    return (middle - (from.normal + to.normal) / 2).norm() < kEvenTurnShare * turn(most);
  }

  /// Returns the inverse of two sides of a triangle and a normal of the first side's length; or the
  /// pseudoinverse if the normal lies in the triangle's plane, as below the wall of a box on flat
  /// skin.
  [[nodiscard]] static Eigen::Matrix3d side_inverse(const Eigen::Matrix3d& sides) {
    const Vector3d area = sides.col(0).cross(Vector3d(sides.col(1)));
    if (std::abs(area.dot(sides.col(2))) > kInPlaneCosine * area.norm() * sides.col(2).norm())
      return sides.inverse();
    Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix3d> parts;
    parts.setThreshold(kInPlaneCosine);
    return parts.compute(sides).pseudoInverse();
  }

  /// Adds springs whose depth is linear over the triangle.
  /// @param smooth  whether normals turn evenly, so that their turn is part of the stiffness
  void add_linear_springs(const Triangle& at, bool smooth) {
    // Clip the triangle to positive depth, and press along the interpolated normals.
    const Vector3d depth(-at[0].distance, -at[1].distance, -at[2].distance);
    const Vector3d normal = (at[0].normal + at[1].normal + at[2].normal).stableNormalized();
    const TrianglePart part = clipped(whole_triangle(), depth);
    add_part_springs(part, depth, normal, [&](const Vector3d& b) {
      FaceCorners slope = FaceCorners::Zero();
      for (std::size_t c = 0; c < 3; ++c) slope += b[c] * at[c].normal * at[c].shape.transpose();
      return slope;
    });
    if (!smooth || part.size < 3) return;
    // Compute the curvature of the distance: normals change along the sides, not along themselves.
    Eigen::Matrix3d sides, turns = Eigen::Matrix3d::Zero();
    for (Eigen::Index k = 0; k < 2; ++k) {
      const Sample& to = at[static_cast<std::size_t>(k) + 1];
      sides.col(k) = to.place - at[0].place;
      turns.col(k) = to.normal - at[0].normal;
    }
    sides.col(2) = sides.col(0).norm() * normal;
    const Eigen::Matrix3d slope = turns * side_inverse(sides);
    const Eigen::Matrix3d curvature = (slope + slope.transpose()) / 2;
    // Sum the forces on the distances of the triangle's corners.
    Vector3d forces(0, 0, 0);
    for_each_gauss_point(part, [&](const Vector3d& b, double share) {
      forces += triangle_stiffness_ * share * depth.dot(b) * b;
    });
    for (std::size_t c = 0; c < 3; ++c)
      for (Eigen::Index i = 0; i < 4; ++i)
        for (Eigen::Index j = 0; j < 4; ++j)
          out_.stiffness.block<3, 3>(3 * i, 3 * j) -=
              forces[c] * at[c].shape[i] * at[c].shape[j] * curvature;
  }

  /// Finds planes whose largest distance equals that of the object all over the part of the
  /// triangle that is inside, and their parts. @return false if there are none, as for a curved
  /// object
  bool find_planes(const Triangle& at, const std::array<Plane, 3>& corner_planes) {
    planes_.reset(corner_planes);
    // Add planes of the object until their distances agree.
    for (int search = 0; search <= kMaxPlaneSearches; ++search) {
      planes_.update_parts();
      if (!add_farthest_plane(at)) return true;
    }
    return false;
  }

  /// Adds springs with the depth below the plane of the largest distance.
  void add_plane_springs() {
    planes_.remove_empty_parts();
    // Add the springs below each plane, then the ridge of each pair.
    for (std::size_t p = 0; p < planes_.size(); ++p) {
      const Plane& plane = planes_.plane(p);
      add_part_springs(planes_.part(p), -plane.values, plane.normal, [&](const Vector3d& b) {
        return FaceCorners(plane.normal * (corner_shapes_ * b).transpose());
      });
      for (std::size_t q = 0; q < p; ++q) add_ridge_stiffness(p, q);
    }
  }

  /// Adds the object's plane where its distance exceeds those of the known planes most: at a corner
  /// of a part, because the excess is convex. @return whether there is one
  bool add_farthest_plane(const Triangle& at) {
    double most = kPlaneExcess;
    std::optional<Plane> found;
    for (std::size_t p = 0; p < planes_.size(); ++p)
      for (std::size_t i = 0; i < planes_.part(p).size; ++i) {
        // Compare the true distance with the plane's at a corner of its part.
        const Vector3d& b = planes_.part(p).corners[i];
        const Vector3d place = b[0] * at[0].place + b[1] * at[1].place + b[2] * at[2].place;
        const NearestSurface near = object_.nearest(X_OP_ * place);
        const double beyond = near.distance - planes_.plane(p).values.dot(b);
        if (beyond <= most) continue;
        most = beyond;
        found = plane_at(at, place, X_PO_.R * near.normal, near.distance);
      }
    if (found) planes_.add(*found);
    return found.has_value();
  }

  /// Adds springs over a part of the triangle, where depth is linear.
  /// @param slope_at  of the distance there by the face's corners
  template <class SlopeAt>
  void add_part_springs(const TrianglePart& part, const Vector3d& depth, const Vector3d& normal,
                        const SlopeAt& slope_at) {
    if (area_share(part) <= 0) return;
    // Update the largest depth, and record the middle of the part.
    Vector3d mean(0, 0, 0);
    for (std::size_t i = 0; i < part.size; ++i) {
      out_.deepest = std::max(out_.deepest, depth.dot(part.corners[i]));
      mean += part.corners[i] / static_cast<double>(part.size);
    }
    out_.points.push_back({corner_shapes_ * mean, normal});
    // Integrate the energy k depth^2 / 2, its slope and its stiffness.
    for_each_gauss_point(part, [&](const Vector3d& b, double share) {
      const double here = depth.dot(b), k = triangle_stiffness_ * share;
      const FaceCorners slope = slope_at(b);
      const Row row = slope.reshaped();
      out_.energy += 0.5 * k * here * here;
      out_.push += k * here * slope;
      out_.stiffness += k * row * row.transpose();
    });
  }

  /// Adds the stiffness of the ridge between two planes.
  void add_ridge_stiffness(std::size_t p, std::size_t q) {
    const std::optional<internal::PlaneRidge> ridge = planes_.ridge(p, q);
    if (!ridge) return;
    const Vector3d turn = planes_.plane(p).normal - planes_.plane(q).normal;
    for (const Vector3d& b : ridge->points) {
      const double distance = planes_.plane(p).values.dot(b);  // < 0
      const Row row = FaceCorners(turn * (corner_shapes_ * b).transpose()).reshaped();
      out_.stiffness += triangle_stiffness_ * distance * ridge->length / ridge->difference_slope *
                        row * row.transpose();
    }
  }

  const FaceCorners& corners_;
  Vector4d stiffness_;  // of a triangle's springs, by corners of the face [N/m] (4)
  const Shape& object_;
  Pose<double> X_PO_, X_OP_;
  PressedFace out_;
  // Data of the present triangle: shape functions at its corners, stiffness of its springs.
  Shapes corner_shapes_;
  double triangle_stiffness_ = 0;  // [N/m]
  internal::TrianglePlanes planes_;
};

}  // namespace

Vector4d face_shape(double x, double y) {
  return {(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y};
}

PressedFace press_face(const FaceCorners& corners, const Vector4d& stiffness, double area,
                       const Shape& object, const Pose<double>& X_PO) {
  return FacePress(corners, stiffness, area, object, X_PO).press();
}

}  // namespace thenar
