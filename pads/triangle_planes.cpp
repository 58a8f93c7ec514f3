#include "pads/triangle_planes.h"

#include <algorithm>
#include <cmath>

namespace thenar::internal {
namespace {

using Eigen::Vector3d;

constexpr double kSamePlaneTolerance = 1e-7;  // largest difference of normals of equal planes [1]
constexpr double kMinPartShare = 1e-10;       // least share of a triangle that is a part [1]

}  // namespace

TrianglePart whole_triangle() {
  TrianglePart out;
  for (int c = 0; c < 3; ++c) out.add(Vector3d::Unit(c));
  return out;
}

TrianglePart clipped(const TrianglePart& part, const Vector3d& values) {
  TrianglePart out;
  for (std::size_t i = 0; i < part.size; ++i) {
    // Keep corners inside, and add the point where a side crosses.
    const Vector3d &a = part.corners[i], &b = part.corners[(i + 1) % part.size];
    const double at_a = values.dot(a), at_b = values.dot(b);
    if (at_a >= 0) out.add(a);
    if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0))
      out.add(a + at_a / (at_a - at_b) * (b - a));
  }
  return out;
}

double area_share(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  return std::abs((b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0]);
}

double area_share(const TrianglePart& part) {
  double out = 0;
  for (std::size_t i = 1; i + 1 < part.size; ++i)
    out += area_share(part.corners[0], part.corners[i], part.corners[i + 1]);
  return out;
}

void TrianglePlanes::reset(const std::array<TrianglePlane, 3>& corner_planes) {
  planes_.clear();
  for (const TrianglePlane& plane : corner_planes) {
    const bool known = std::any_of(planes_.begin(), planes_.end(), [&](const TrianglePlane& other) {
      return (other.normal - plane.normal).norm() < kSamePlaneTolerance;
    });
    if (!known) planes_.push_back(plane);
  }
}

void TrianglePlanes::update_parts() {
  parts_.assign(planes_.size(), whole_triangle());
  for (std::size_t p = 0; p < planes_.size(); ++p) {
    // Clip to the inside of the object, and to where no other plane has a larger distance.
    parts_[p] = clipped(parts_[p], -planes_[p].values);
    for (std::size_t q = 0; q < planes_.size(); ++q)
      if (q != p) parts_[p] = clipped(parts_[p], planes_[p].values - planes_[q].values);
  }
}

void TrianglePlanes::remove_empty_parts() {
  std::size_t kept = 0;
  for (std::size_t p = 0; p < planes_.size(); ++p) {
    if (area_share(parts_[p]) < kMinPartShare) continue;
    planes_[kept] = planes_[p];
    parts_[kept++] = parts_[p];
  }
  planes_.resize(kept);
}

std::optional<PlaneRidge> TrianglePlanes::ridge(std::size_t p, std::size_t q) const {
  const Vector3d &one = planes_[p].values, more = one - planes_[q].values;
  // Find the ends of the ridge on the triangle's sides.
  std::array<Vector3d, 2> ends;
  std::size_t found = 0;
  for (int i = 0; i < 3 && found < 2; ++i) {
    const int j = (i + 1) % 3;
    if ((more[i] > 0) != (more[j] > 0))
      ends[found++] =
          (more[j] * Vector3d::Unit(i) - more[i] * Vector3d::Unit(j)) / (more[j] - more[i]);
  }
  if (found < 2) return {};
  // Cut the ridge to the inside of the object, and to where no other plane has a larger distance.
  double from = 0, to = 1;
  const auto cut = [&](const Vector3d& values) {
    const double a = values.dot(ends[0]), b = values.dot(ends[1]);
    if (a < 0 && b < 0) to = from;
    if (a < 0 && b >= 0) from = std::max(from, a / (a - b));
    if (a >= 0 && b < 0) to = std::min(to, a / (a - b));
  };
  cut(-one);
  for (std::size_t r = 0; r < planes_.size(); ++r)
    if (r != p && r != q) cut(one - planes_[r].values);
  if (!(to > from)) return {};
  // Place two Gauss points between the ends.
  PlaneRidge out{{},
                 (to - from) * (ends[1] - ends[0]).head<2>().norm(),
                 std::hypot(more[0] - more[2], more[1] - more[2])};
  for (std::size_t k = 0; k < 2; ++k) {
    const double side = k == 0 ? -1.0 : 1.0;
    const double s = 0.5 * (from + to) + side * (to - from) / std::sqrt(12.0);
    out.points[k] = (1 - s) * ends[0] + s * ends[1];
  }
  return out;
}

}  // namespace thenar::internal
