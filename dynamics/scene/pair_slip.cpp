#include "dynamics/scene/pair_slip.h"

#include <algorithm>
#include <cmath>

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kSamePoint = 1e-5;       // largest distance of two points of one contact [m]
constexpr double kMaxRotation = 2;        // largest rotation for which arcs are used [rad]
constexpr double kMinArcRotation = 1e-6;  // smallest rotation where arc and chord differ [rad]

Vector3d tangential(const Vector3d& v, const Vector3d& normal) {
  return v - v.dot(normal) * normal;
}

/// Path of one contact over both of its bodies between two instants.
class ContactPath {
 public:
  ContactPath(const ContactSample& contact, const SlipInstant& from, const SlipInstant& to)
      : contact_(contact),
        from_(from),
        to_(to),
        moved_a_(moved(contact.a)),
        moved_b_(moved(contact.b)) {
    // Find the contact at the second instant by its id; otherwise by its point, as a pair that
    // separated for a moment gets new ids.
    for (const ContactSample& next : to.contacts) {
      if (next.a != contact.a || next.b != contact.b) continue;
      const auto moved_with = [&](const Pose<double>& body) {
        return (next.point - body * contact.point).norm() < kSamePoint;
      };
      if (next.id == contact.id) {
        next_ = &next;
        break;
      }
      if (next_ == nullptr && (moved_with(moved_a_) || moved_with(moved_b_))) next_ = &next;
    }
  }

  /// Returns true if the contact still exists at the second instant.
  [[nodiscard]] bool persists() const { return next_ != nullptr; }

  /// Returns the sliding distance [m].
  [[nodiscard]] double slip() const {
    // After a large rotation, use the mean sliding speed.
    const double time = to_.t - from_.t;
    const double rotation = std::max({time * relative_spin(from_), time * relative_spin(to_),
                                      normal_rotation(moved_a_), normal_rotation(moved_b_)});
    if (rotation > kMaxRotation)
      return time * (sliding_speed(from_, contact_) + sliding_speed(to_, *next_)) / 2;
    return (path_over(moved_a_) - path_over(moved_b_)).norm();
  }

 private:
  /// Returns the motion of a body between the instants, in the world.
  [[nodiscard]] Pose<double> moved(int body) const {
    return to_.X_WB[body] * from_.X_WB[body].inverse();
  }

  /// Returns the rotation of the contact normal relative to a body with this motion [rad].
  [[nodiscard]] double normal_rotation(const Pose<double>& body) const {
    const Vector3d normal = body.R * contact_.normal;
    return std::atan2(normal.cross(next_->normal).norm(), normal.dot(next_->normal));
  }

  /// Returns the path of the contact over a body with this motion, tangential to the contact at the
  /// second instant [m].
  [[nodiscard]] Vector3d path_over(const Pose<double>& body) const {
    const Vector3d chord = next_->point - body * contact_.point;
    const Vector3d normal = body.R * contact_.normal;
    const double half = normal_rotation(body) / 2;
    if (2 * half < kMinArcRotation) return tangential(chord, next_->normal);
    // Chord along the rotation axis of the normal, arc tangential it.
    const Vector3d axis = normal.cross(next_->normal).normalized();
    const Vector3d middle = (normal + next_->normal).normalized();
    return chord.dot(axis) * axis +
           chord.dot(axis.cross(middle)) * half / std::sin(half) * axis.cross(next_->normal);
  }

  /// Returns the relative angular speed of the bodies [rad/s].
  [[nodiscard]] double relative_spin(const SlipInstant& at) const {
    return (at.velocity[contact_.a].angular - at.velocity[contact_.b].angular).norm();
  }

  const ContactSample& contact_;
  const SlipInstant &from_, &to_;
  const Pose<double> moved_a_, moved_b_;  // motions of both bodies, world
  const ContactSample* next_ = nullptr;
};

}  // namespace

double sliding_speed(const SlipInstant& at, const ContactSample& contact) {
  const auto velocity = [&](int body) -> Vector3d {
    return at.velocity[body].linear +
           at.velocity[body].angular.cross(contact.point - at.centre[body]);
  };
  return tangential(velocity(contact.a) - velocity(contact.b), contact.normal).norm();
}

std::map<std::pair<int, int>, double> slips_between(const SlipInstant& from,
                                                    const SlipInstant& to) {
  std::map<std::pair<int, int>, double> slips;
  for (const ContactSample& contact : from.contacts) {
    const ContactPath path(contact, from, to);
    if (!path.persists()) continue;
    double& largest = slips[{contact.a, contact.b}];
    largest = std::max(largest, path.slip());
  }
  return slips;
}

}  // namespace thenar
