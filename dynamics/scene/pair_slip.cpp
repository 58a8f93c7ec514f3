#include "dynamics/scene/pair_slip.h"

#include <algorithm>
#include <cmath>

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kSamePoint = 1e-5;     // distance up to which points are one contact [m]
constexpr double kLargestTurn = 2;      // between two instants, up to which arcs are told [rad]
constexpr double kStraightTurn = 1e-6;  // of a normal below which chord and arc are one [rad]

Vector3d across(const Vector3d& way, const Vector3d& normal) {
  return way - way.dot(normal) * normal;
}

}  // namespace

double sliding_speed(const SlipInstant& at, const ContactSample& contact) {
  const auto velocity = [&](int body) -> Vector3d {
    const auto i = static_cast<std::size_t>(body);
    return at.velocity[i].linear + at.velocity[i].angular.cross(contact.point - at.centre[i]);
  };
  return across(velocity(contact.a) - velocity(contact.b), contact.normal).norm();
}

namespace {

/// A contact at two instants, and its ways over both bodies.
class ContactWay {
 public:
  ContactWay(const ContactSample& contact, const SlipInstant& from, const SlipInstant& to)
      : contact_(contact),
        from_(from),
        to_(to),
        moved_a_(moved(contact.a)),
        moved_b_(moved(contact.b)) {
    // By its identity; where a pair was out of sight for a moment and given another, by its place.
    for (const ContactSample& next : to.contacts) {
      if (next.a != contact.a || next.b != contact.b) continue;
      const auto went_with = [&](const Pose<double>& body) {
        return (next.point - body * contact.point).norm() < kSamePoint;
      };
      if (next.id == contact.id) {
        next_ = &next;
        break;
      }
      if (next_ == nullptr && (went_with(moved_a_) || went_with(moved_b_))) next_ = &next;
    }
  }

  [[nodiscard]] bool goes_on() const { return next_ != nullptr; }

  /// Sliding way [m].
  [[nodiscard]] double slip() const {
    // Large turns hide the way: the mean of the sliding speeds stands for it.
    const double time = to_.t - from_.t;
    const double turn = std::max(
        {time * turning(from_), time * turning(to_), normal_turn(moved_a_), normal_turn(moved_b_)});
    if (turn > kLargestTurn)
      return time * (sliding_speed(from_, contact_) + sliding_speed(to_, *next_)) / 2;
    return (way_over(moved_a_) - way_over(moved_b_)).norm();
  }

 private:
  /// Motion of a body between the instants.
  [[nodiscard]] Pose<double> moved(int body) const {
    const auto i = static_cast<std::size_t>(body);
    return to_.X_WB[i] * from_.X_WB[i].inverse();
  }

  /// Turn of the normal over a body that moved so [rad].
  [[nodiscard]] double normal_turn(const Pose<double>& body) const {
    const Vector3d normal = body.R * contact_.normal;
    return std::atan2(normal.cross(next_->normal).norm(), normal.dot(next_->normal));
  }

  /// Way of the contact over a body that moved so, across the normal at its end [m].
  [[nodiscard]] Vector3d way_over(const Pose<double>& body) const {
    const Vector3d chord = next_->point - body * contact_.point;
    const Vector3d normal = body.R * contact_.normal;
    const double half = normal_turn(body) / 2;
    if (2 * half < kStraightTurn) return across(chord, next_->normal);
    // Straight on along the axis about which the normal turns, by the arc across it.
    const Vector3d axis = normal.cross(next_->normal).normalized();
    const Vector3d middle = (normal + next_->normal).normalized();
    return chord.dot(axis) * axis +
           chord.dot(axis.cross(middle)) * half / std::sin(half) * axis.cross(next_->normal);
  }

  /// Speed at which the bodies turn against each other [rad/s].
  [[nodiscard]] double turning(const SlipInstant& at) const {
    return (at.velocity[static_cast<std::size_t>(contact_.a)].angular -
            at.velocity[static_cast<std::size_t>(contact_.b)].angular)
        .norm();
  }

  const ContactSample& contact_;
  const SlipInstant &from_, &to_;
  const Pose<double> moved_a_, moved_b_;  // motions of both bodies, world
  const ContactSample* next_ = nullptr;
};

}  // namespace

std::map<std::pair<int, int>, double> slips_between(const SlipInstant& from,
                                                    const SlipInstant& to) {
  std::map<std::pair<int, int>, double> ways;
  for (const ContactSample& contact : from.contacts) {
    const ContactWay way(contact, from, to);
    if (!way.goes_on()) continue;
    double& longest = ways[{contact.a, contact.b}];
    longest = std::max(longest, way.slip());
  }
  return ways;
}

}  // namespace thenar
