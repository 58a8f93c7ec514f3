#include "live/live_picture.h"

#include <cmath>
#include <numeric>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

void require_count(std::size_t got, std::size_t wanted, const char* what) {
  require(got == wanted, "wanted {} {} in an instant, got {}", wanted, what, got);
}

bool is_finite(const LiveInstant& instant) {
  // Check every number except tensions: a single NaN would blank the whole picture.
  const auto poses = [](const Pose<double>& X) { return X.R.allFinite() && X.p.allFinite(); };
  const auto points = [](const Eigen::Vector3d& p) { return p.allFinite(); };
  const auto values = [](double value) { return std::isfinite(value); };
  const auto vectors = [](const LiveVector& each) {
    return each.from.allFinite() && each.vector.allFinite();
  };
  const auto contacts = [](const LiveContact& each) {
    return each.point.allFinite() && each.normal.allFinite() && each.force.allFinite() &&
           std::isfinite(each.friction);
  };
  return std::isfinite(instant.time) && all_of(instant.bodies, poses) &&
         all_of(instant.joints, values) && all_of(instant.line_points, points) &&
         all_of(instant.arrows, vectors) && all_of(instant.contacts, contacts);
}

}  // namespace

std::shared_ptr<const TriangleMesh> picture_of_solid(const std::shared_ptr<const Solid>& solid) {
  return {solid, &solid->visual};
}

double crease_of(const std::string& material) {
  const bool smooth = material == "skin" || material == "fingertip" || material == "bone";
  return smooth ? -1 : 35;
}

void check_instant(const LiveShape& shape, const LiveInstant& instant) {
  // Compare the numbers of entries.
  const auto points = static_cast<std::size_t>(
      std::accumulate(shape.lines.begin(), shape.lines.end(), 0,
                      [](int sum, const LiveLine& line) { return sum + line.points; }));
  require_count(instant.bodies.size(), shape.bodies.size(), "poses of bodies");
  require_count(instant.joints.size(), shape.joints.size(), "values of joints");
  require_count(instant.line_points.size(), points, "points of lines");
  require_count(instant.tensions.size(), shape.lines.size(), "tensions of lines");
  require_count(instant.arrows.size(), shape.arrows.size(), "arrows");
  // Check the body indices of contacts, and that all numbers are finite.
  const int bodies = static_cast<int>(shape.bodies.size());
  for (const LiveContact& contact : instant.contacts)
    require(contact.a < bodies && contact.b < bodies && contact.a >= -1 && contact.b >= -1,
            "wanted a contact of two of {} bodies, got {} and {}", bodies, contact.a, contact.b);
  require(is_finite(instant), "an instant has numbers that are not finite");
}

}  // namespace thenar
