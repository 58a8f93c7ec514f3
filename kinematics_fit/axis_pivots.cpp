#include "kinematics_fit/axis_pivots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kFar = 0.01;  // from the middle of the tendons, about a finger's radius [m]

/// Segments that a joint moves.
std::set<std::string> moved_by(const Subject& subject, const JointAxis& joint) {
  std::set<std::string> moved{joint.child};
  for (const JointAxis& next : subject.joints)  // in order from the wrist to the tips
    if (moved.count(next.parent) > 0) moved.insert(next.child);
  return moved;
}

/// How far along the axis, from its point, the run from a to b passes it [m]; NaN of one parallel
/// to it.
double passing(const JointAxis& joint, const Vector3d& a, const Vector3d& b) {
  const Vector3d run = b - a;
  const Vector3d across = run - run.dot(joint.direction) * joint.direction;
  if (across.squaredNorm() < 1e-6 * run.squaredNorm())
    return std::numeric_limits<double>::quiet_NaN();
  // The place on the run that is nearest to the axis.
  const double part = std::clamp((joint.point - a).dot(across) / across.squaredNorm(), 0.0, 1.0);
  return (a + part * run - joint.point).dot(joint.direction);
}

}  // namespace

Subject with_points_at_tendons(Subject subject) {
  for (JointAxis& joint : subject.joints) {
    const std::set<std::string> moved = moved_by(subject, joint);
    double lowest = HUGE_VAL, highest = -HUGE_VAL;
    for (const Strand& strand : subject.strands) {
      // Points of the path, without the surfaces between them.
      const PathPoint* before = nullptr;
      for (const PathPoint& point : strand.path) {
        if (!point.surface.empty() || !point.rides_on.empty()) continue;
        if (before != nullptr && moved.count(before->segment) != moved.count(point.segment)) {
          const double along = passing(joint, before->p, point.p);
          lowest = std::fmin(lowest, along);
          highest = std::fmax(highest, along);
        }
        before = &point;
      }
    }
    const double middle = (lowest + highest) / 2;
    if (lowest <= highest && std::abs(middle) > kFar) joint.point += middle * joint.direction;
  }
  return subject;
}

}  // namespace thenar
