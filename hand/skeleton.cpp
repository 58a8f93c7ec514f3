#include "hand/skeleton.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "base/units.h"
#include "hand/passive_moment.h"

namespace thenar {
namespace {

/// Returns whether a digit is among those to keep.
bool keeps(const std::vector<std::string>& digits, const Digit& digit) {
  return digits.empty() || contains(digits, digit.name);
}

/// Returns the segments between the tips of the kept digits and the base.
std::set<std::string> kept_segments(const Subject& subject,
                                    const std::vector<std::string>& digits) {
  std::set<std::string> kept;
  // Walk from the tips towards the base.
  for (const Digit& digit : subject.digits)
    if (keeps(digits, digit)) kept.insert(digit.tip_segment);
  for (auto joint = subject.joints.rbegin(); joint != subject.joints.rend(); ++joint)
    if (kept.count(joint->child) > 0) kept.insert(joint->parent);
  return kept;
}

/// Checks the options.
void require_known(const Subject& subject, const SkeletonOptions& options) {
  // Check that the digits exist.
  for (const std::string& name : options.digits)
    require(find_named(subject.digits, name) != nullptr,
            "subject '{}' has no digit '{}'; there are {}", subject.name, name,
            listed(names_of(subject.digits)));
  // Check that frozen joints exist, with angles within their limits.
  for (const auto& [name, angle] : options.frozen) {
    const JointAxis* joint = find_named(subject.joints, name);
    require(joint != nullptr, "subject '{}' has no joint '{}' to freeze", subject.name, name);
    require(angle >= joint->lower && angle <= joint->upper,
            "joint '{}' cannot be frozen at {} rad, outside its limits {} .. {}", name, angle,
            joint->lower, joint->upper);
  }
}

/// Returns the digits that a joint moves.
std::vector<Digit> digits_moved(const Subject& subject, const std::string& joint) {
  std::vector<Digit> moved;
  if (const JointAxis* mover = find_named(subject.joints, joint))
    for (const Digit& digit : subject.digits)
      if (kept_segments(subject, {digit.name}).count(mover->child) > 0) moved.push_back(digit);
  return moved;
}

/// Builder of a skeleton, joint by joint from the wrist outwards.
class SkeletonBuilder {
 public:
  SkeletonBuilder(const Subject& subject, const SkeletonOptions& options)
      : subject_(subject), options_(options), kept_(kept_segments(subject, options.digits)) {
    // Add the base, then joints from the wrist outwards.
    skeleton_.link_of_segment[subject.base] = -1;
    skeleton_.segment_at[subject.base] = {};
    for (const JointAxis& joint : subject.joints)
      if (kept_.count(joint.child) > 0) add(joint);
    // Add masses and tips to the links.
    for (const Segment& segment : subject.segments) add_mass(segment);
    for (const Digit& digit : subject.digits)
      if (keeps(options.digits, digit)) add_tip(digit);
  }

  Skeleton take() { return std::move(skeleton_); }

 private:
  /// Adds a joint: a hinge, or a weld if it is frozen.
  void add(const JointAxis& joint) {
    // Attach a second joint between the same segments to the first.
    const bool follows = skeleton_.link_of_segment.count(joint.child) > 0;
    const std::string& from = follows ? joint.child : joint.parent;
    const std::string& carrier = carrier_.emplace(joint.child, joint.parent).first->second;
    require(carrier == joint.parent,
            "joint '{}' moves segment '{}' from '{}', an earlier joint from '{}'", joint.name,
            joint.child, joint.parent, carrier);
    require(skeleton_.link_of_segment.count(from) > 0,
            "joint '{}' hangs on segment '{}', which no earlier joint reaches", joint.name, from);
    // Compute the axis at the reference posture, displaced by frozen joints.
    const int parent = skeleton_.link_of_segment.at(from);
    const Pose<double> at = skeleton_.segment_at.at(from);
    const Eigen::Vector3d direction = at.R * joint.direction, point = at * joint.point;

    // Weld the segments of a frozen joint, or add a hinge.
    if (const auto angle = frozen_angle(joint)) {
      skeleton_.link_of_segment[joint.child] = parent;
      skeleton_.segment_at[joint.child] = screw_motion(direction, point, *angle) * at;
    } else {
      skeleton_.link_of_segment[joint.child] = add_hinge(joint, parent, direction, point);
      skeleton_.segment_at[joint.child] = at;
    }
  }

  /// Returns the angle of a frozen joint, and stores it.
  std::optional<double> frozen_angle(const JointAxis& joint) {
    // Find the angle by name, or from a frozen leader.
    const auto asked = options_.frozen.find(joint.name);
    std::optional<double> angle;
    if (asked != options_.frozen.end()) {
      angle = asked->second;
    } else if (joint.coupling && skeleton_.frozen.count(joint.coupling->leader) > 0) {
      angle =
          joint.coupling->ratio * skeleton_.frozen[joint.coupling->leader] + joint.coupling->offset;
    }
    if (angle) skeleton_.frozen[joint.name] = *angle;
    return angle;
  }

  /// Adds a hinge and returns its link.
  int add_hinge(const JointAxis& joint, int parent, const Eigen::Vector3d& direction,
                const Eigen::Vector3d& point) {
    int coordinate = skeleton_.coordinates();
    double ratio = 1, offset = 0;
    // Use the leader's coordinate for a follower, a new one for another joint.
    if (joint.coupling) {
      coordinate = coordinate_of(joint.coupling->leader, joint.name);
      ratio = joint.coupling->ratio;
      offset = joint.coupling->offset;
      add_passive(skeleton_.limits[coordinate], joint, *joint.coupling);
      narrow_range(skeleton_.limits[coordinate], joint, *joint.coupling);
    } else {
      skeleton_.coordinate_names.push_back(joint.name);
      skeleton_.limits.push_back(
          {joint.lower, joint.upper, joint.rest, joint.stiffness, joint.damping});
    }
    if (joint.flexing.moment > 0 || joint.extending.moment > 0)
      skeleton_.limits[static_cast<std::size_t>(coordinate)].ends.push_back(
          {ratio, offset, joint.rest, joint.flexing, joint.extending});
    // Append the hinge; its mass is added later.
    skeleton_.hinge_names.push_back(joint.name);
    skeleton_.tree.push_back({parent, coordinate, ratio, offset, direction, point});
    skeleton_.masses.emplace_back();
    return static_cast<int>(skeleton_.tree.size()) - 1;
  }

  /// Adds spring and damper of a follower to its leader's coordinate.
  static void add_passive(CoordinateLimits& leader, const JointAxis& joint, const Coupling& by) {
    // Combine two springs into one, with the weighted mean of their rest angles.
    const double stiffness = by.ratio * by.ratio * joint.stiffness;
    const double moment =
        leader.stiffness * leader.rest + by.ratio * joint.stiffness * (joint.rest - by.offset);
    leader.stiffness += stiffness;
    leader.damping += by.ratio * by.ratio * joint.damping;
    if (leader.stiffness > 0) leader.rest = moment / leader.stiffness;
  }

  /// Narrows the range of a leader to the range that its follower allows; a follower without a
  /// range has no effect.
  static void narrow_range(CoordinateLimits& leader, const JointAxis& joint, const Coupling& by) {
    if (by.ratio == 0 || joint.upper - joint.lower > 2 * kPi - 1e-9) return;
    // Convert the follower's range to the leader's coordinate.
    double lower = (joint.lower - by.offset) / by.ratio,
           upper = (joint.upper - by.offset) / by.ratio;
    if (lower > upper) std::swap(lower, upper);
    lower = std::max(lower, leader.lower);
    upper = std::min(upper, leader.upper);
    require(lower <= upper,
            "joint '{}' has the range {} .. {} rad, which it never has while it "
            "follows '{}' in its range {} .. {} rad",
            joint.name, joint.lower, joint.upper, by.leader, leader.lower, leader.upper);
    leader.lower = lower;
    leader.upper = upper;
  }

  /// Throws if the leader moves digits, but none that is kept.
  void require_kept(const std::string& leader, const std::string& follower) const {
    const std::vector<Digit> digits = digits_moved(subject_, leader);
    require(
        digits.empty() || any_of(digits, [&](const Digit& d) { return keeps(options_.digits, d); }),
        "joint '{}' is coupled to '{}' of a digit left out: keep digit '{}', too", follower, leader,
        digits.empty() ? "" : digits.front().name);
  }

  /// Returns the coordinate of a leader.
  [[nodiscard]] int coordinate_of(const std::string& leader, const std::string& follower) const {
    const int place = place_in(skeleton_.coordinate_names, leader);
    if (place < 0) require_kept(leader, follower);
    require(place >= 0, "joint '{}' is coupled to '{}', which is not a free joint before it",
            follower, leader);
    return place;
  }

  /// Adds the mass of a segment to its link.
  void add_mass(const Segment& segment) {
    const auto link = skeleton_.link_of_segment.find(segment.name);
    if (link == skeleton_.link_of_segment.end() || link->second < 0) return;
    LinkMass& mass = skeleton_.masses[link->second];
    mass = combine(mass, displace(skeleton_.segment_at.at(segment.name), segment_mass(segment)));
  }

  /// Adds the tip of a digit.
  void add_tip(const Digit& digit) {
    const auto link = skeleton_.link_of_segment.find(digit.tip_segment);
    if (link == skeleton_.link_of_segment.end()) return;
    const Pose<double>& at = skeleton_.segment_at.at(digit.tip_segment);
    Eigen::Matrix3d axes;
    axes << digit.proximal, digit.dorsal, digit.radial;
    skeleton_.tips.push_back({digit.name, link->second, at * digit.tip, at.R * axes});
  }

  const Subject& subject_;
  const SkeletonOptions& options_;
  std::set<std::string> kept_;
  std::map<std::string, std::string> carrier_;  // segment -> the parent segment of its joints
  Skeleton skeleton_;
};

}  // namespace

Skeleton build_skeleton(const Subject& subject, const SkeletonOptions& options) {
  require_known(subject, options);
  return SkeletonBuilder(subject, options).take();
}

std::vector<std::string> shared_joints(const Subject& subject) {
  std::vector<std::string> shared;
  for (const JointAxis& joint : subject.joints) {
    const auto moves = [&](const Digit& digit) {
      return kept_segments(subject, {digit.name}).count(joint.child) > 0;
    };
    if (std::count_if(subject.digits.begin(), subject.digits.end(), moves) > 1)
      shared.push_back(joint.name);
  }
  return shared;
}

Eigen::VectorXd posture(const Skeleton& skeleton, const std::map<std::string, double>& angles) {
  Eigen::VectorXd q = Eigen::VectorXd::Zero(skeleton.coordinates());
  const auto& names = skeleton.coordinate_names;
  for (const auto& [name, angle] : angles) {
    const int place = place_in(names, name);
    require(place >= 0, "no joint '{}' to pose; there are {}", name, listed(names));
    require(std::isfinite(angle), "angle of joint '{}' must be finite, got {}", name, angle);
    q[place] = angle;
  }
  return q;
}

const SkeletonTip& tip(const Skeleton& skeleton, const std::string& digit) {
  for (const SkeletonTip& candidate : skeleton.tips)
    if (candidate.digit == digit) return candidate;
  throw InputError(fmt::format("no digit '{}'; there are {}", digit,
                               listed(transformed(skeleton.tips, &SkeletonTip::digit))));
}

Eigen::VectorXd passive_torque(const Skeleton& skeleton,
                               const Eigen::Ref<const Eigen::VectorXd>& q) {
  Eigen::VectorXd tau(skeleton.coordinates());
  for (int i = 0; i < skeleton.coordinates(); ++i)
    tau[i] = passive_moment(skeleton.limits[static_cast<std::size_t>(i)], q[i]);
  return tau;
}

namespace {

/// Computes the mass of a solid capsule: a cylinder of length h with two half balls. The transverse
/// moment adds the parallel-axis terms of the half balls, whose centres lie 3/8 r beyond the
/// cylinder.
LinkMass capsule(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double r) {
  // Compute the masses of cylinder and half balls.
  const double h = (b - a).norm();
  const double cylinder = kHandDensity * kPi * r * r * h;
  const double balls = kHandDensity * 4.0 / 3.0 * kPi * r * r * r;
  // Compute the moments along and across the axis.
  const double along = cylinder * r * r / 2 + balls * 2 * r * r / 5;
  const double across =
      cylinder * (h * h / 12 + r * r / 4) + balls * (2 * r * r / 5 + h * h / 4 + 3 * h * r / 8);
  const Eigen::Vector3d d = h > 0 ? Eigen::Vector3d((b - a) / h) : Eigen::Vector3d::UnitX();
  const Eigen::Matrix3d dd = d * d.transpose();
  return {
      cylinder + balls, (a + b) / 2, along * dd + across * (Eigen::Matrix3d::Identity() - dd), {}};
}

/// Computes the inertia of a point mass at offset r.
Eigen::Matrix3d point_inertia(double mass, const Eigen::Vector3d& r) {
  return mass * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
}

}  // namespace

LinkMass segment_mass(const Segment& segment) {
  // Combine the capsule with measured values.
  LinkMass body;
  if (segment.radius > 0) body = capsule(segment.proximal, segment.distal, segment.radius);
  if (segment.mass == 0) return body;
  if (!segment.inertia.isZero(0)) return {segment.mass, segment.com, segment.inertia, {}};
  if (segment.radius == 0) return {segment.mass, segment.com, segment.inertia, segment.name};
  return {segment.mass, segment.com, body.inertia * (segment.mass / body.mass), {}};
}

LinkMass combine(const LinkMass& a, const LinkMass& b) {
  const double mass = a.mass + b.mass;
  if (mass == 0) return {};
  const Eigen::Vector3d com = (a.mass * a.com + b.mass * b.com) / mass;
  return {
      mass, com,
      a.inertia + b.inertia + point_inertia(a.mass, a.com - com) +
          point_inertia(b.mass, b.com - com),
      a.segment_without_inertia.empty() ? b.segment_without_inertia : a.segment_without_inertia};
}

LinkMass displace(const Pose<double>& X, const LinkMass& body) {
  return {body.mass, X * body.com, X.R * body.inertia * X.R.transpose(),
          body.segment_without_inertia};
}

}  // namespace thenar
