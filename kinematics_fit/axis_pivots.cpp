#include "kinematics_fit/axis_pivots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace thenar {
namespace {

using Eigen::Vector3d;

// Largest distance of a point from the middle of the tendons, about a finger's radius [m]
constexpr double kMaxTendonDistance = 0.01;
// Largest distance of a point from the place nearest to the adjacent axes, which locate it less
// well than tendons [m]
constexpr double kMaxAxisDistance = 0.015;
// Smallest sine of the angle between axes that are not parallel [1]
constexpr double kMinAxisSine = 0.5;

/// Returns the segments that a joint moves.
std::set<std::string> moved_by(const Subject& subject, const JointAxis& joint) {
  std::set<std::string> moved{joint.child};
  for (const JointAxis& next : subject.joints)  // in order from the wrist to the tips
    if (moved.count(next.parent) > 0) moved.insert(next.child);
  return moved;
}

/// Returns the position along the axis, from its point, at which the run from a to b passes it [m];
/// NaN for a run parallel to the axis.
double crossing_position(const JointAxis& joint, const Vector3d& a, const Vector3d& b) {
  const Vector3d run = b - a;
  const Vector3d across = run - run.dot(joint.direction) * joint.direction;
  if (across.squaredNorm() < 1e-6 * run.squaredNorm())
    return std::numeric_limits<double>::quiet_NaN();
  // Find the place on the run that is nearest to the axis.
  const double part = std::clamp((joint.point - a).dot(across) / across.squaredNorm(), 0.0, 1.0);
  return (a + part * run - joint.point).dot(joint.direction);
}

/// Returns the middle of the tendons that cross an axis, as a position along the axis from its
/// point [m]; nothing if no path crosses it.
std::optional<double> middle_of_tendons(const Subject& subject, const JointAxis& joint) {
  const std::set<std::string> moved = moved_by(subject, joint);
  double lowest = HUGE_VAL, highest = -HUGE_VAL;
  for (const Strand& strand : subject.strands) {
    // Visit the points of the path, without the surfaces between them.
    const PathPoint* before = nullptr;
    for (const PathPoint& point : strand.path) {
      if (!point.surface.empty() || !point.rides_on.empty()) continue;
      if (before != nullptr && moved.count(before->segment) != moved.count(point.segment)) {
        const double along = crossing_position(joint, before->p, point.p);
        lowest = std::fmin(lowest, along);
        highest = std::fmax(highest, along);
      }
      before = &point;
    }
  }
  if (!(lowest <= highest)) return std::nullopt;
  return (lowest + highest) / 2;
}

/// Returns the position along joint i of a chain, from its point, that is nearest to the adjacent
/// axes in least squares [m]; nearest to the tip if they are about parallel to it. The result does
/// not depend on where the stated points lie along their axes.
double position_nearest_to_axes(const std::vector<const JointAxis*>& chain, std::size_t i,
                                const Vector3d& tip) {
  const JointAxis& joint = *chain[i];
  double square = 0, product = 0;
  for (const std::size_t next : {i - 1, i + 1}) {  // i - 1 of the tip's is beyond the end
    if (next >= chain.size()) continue;
    const Vector3d& other = chain[next]->direction;
    const auto across = [&](const Vector3d& v) -> Vector3d { return v - v.dot(other) * other; };
    const Vector3d transverse = across(joint.direction);
    if (transverse.norm() < kMinAxisSine) continue;
    square += transverse.squaredNorm();
    product += transverse.dot(across(chain[next]->point - joint.point));
  }
  return square > 0 ? product / square : (tip - joint.point).dot(joint.direction);
}

}  // namespace

Subject with_points_at_tendons(Subject subject, const std::string& digit) {
  // Compute shifts from the adjacent axes, by the points as stated, before any of them moves.
  std::map<std::string, double> shifts;
  for (const Digit& each : subject.digits) {
    if (each.name != digit) continue;
    const std::vector<const JointAxis*> chain = joints_to(subject, each.tip_segment);
    for (std::size_t i = 0; i < chain.size(); ++i)
      if (const double shift = position_nearest_to_axes(chain, i, each.tip);
          std::abs(shift) > kMaxAxisDistance)
        shifts[chain[i]->name] = shift;
  }
  // Let tendons, which locate a point better, override the axes.
  for (const JointAxis& joint : subject.joints)
    if (const std::optional<double> middle = middle_of_tendons(subject, joint))
      shifts[joint.name] = std::abs(*middle) > kMaxTendonDistance ? *middle : 0;
  // Move the points along their axes.
  for (JointAxis& joint : subject.joints)
    if (const auto shift = shifts.find(joint.name); shift != shifts.end() && shift->second != 0)
      joint.point += shift->second * joint.direction;
  return subject;
}

}  // namespace thenar
