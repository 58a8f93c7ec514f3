#pragma once

/// Subjects made up for tests and benchmarks: known in closed form, or as general as can be.

#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/units.h"
#include "data/io/subject.h"
#include "hand/skeleton.h"

namespace thenar::sample {

/// Numbers and vectors at random.
class Draw {
 public:
  explicit Draw(unsigned seed) : rng_(seed) {}

  double number(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(rng_);
  }
  Eigen::Vector3d vector(double bound) {
    const double x = number(-bound, bound), y = number(-bound, bound);
    return {x, y, number(-bound, bound)};
  }
  Eigen::Vector3d direction() {
    std::normal_distribution<double> normal;
    const double x = normal(rng_), y = normal(rng_);
    return Eigen::Vector3d(x, y, normal(rng_)).normalized();
  }
  Eigen::VectorXd numbers(Eigen::Index size, double lower, double upper) {
    Eigen::VectorXd v(size);
    for (double& x : v) x = number(lower, upper);
    return v;
  }

  /// A posture within the limits.
  Eigen::VectorXd posture(const Skeleton& skeleton) {
    Eigen::VectorXd q(skeleton.coordinates());
    for (Eigen::Index i = 0; i < q.size(); ++i)
      q[i] = number(skeleton.limits[i].lower, skeleton.limits[i].upper);
    return q;
  }

 private:
  std::mt19937 rng_;
};

inline JointAxis hinge(const std::string& name, const std::string& parent, const std::string& child,
                       const Eigen::Vector3d& direction, const Eigen::Vector3d& point) {
  JointAxis joint;
  joint.name = name;
  joint.parent = parent;
  joint.child = child;
  joint.direction = direction;
  joint.point = point;
  return joint;
}

inline Segment bone(const std::string& name, const Eigen::Vector3d& proximal,
                    const Eigen::Vector3d& distal, double radius) {
  Segment segment;
  segment.name = name;
  segment.proximal = proximal;
  segment.distal = distal;
  segment.radius = radius;
  return segment;
}

inline Digit digit(const std::string& name, const std::string& tip_segment,
                   const Eigen::Vector3d& tip) {
  Digit d;
  d.name = name;
  d.tip_segment = tip_segment;
  d.tip = tip;
  return d;
}

inline constexpr double kUpperLength = 0.045;  // of the two-link digit, first link  [m]
inline constexpr double kLowerLength = 0.030;  // second link                        [m]

/// Two links in the plane z = 0, straight along x, which turn about z.
inline Subject two_link() {
  Subject subject;
  subject.name = "two-link";
  subject.base = "palm";
  const Eigen::Vector3d a(0, 0, 0), b(kUpperLength, 0, 0), c(kUpperLength + kLowerLength, 0, 0);
  subject.segments = {bone("palm", -b, a, 0.01), bone("upper", a, b, 0.008),
                      bone("lower", b, c, 0.007)};
  subject.joints = {hinge("J1", "palm", "upper", {0, 0, 1}, a),
                    hinge("J2", "upper", "lower", {0, 0, 1}, b)};
  subject.digits = {digit("index", "lower", c)};
  return subject;
}

/// A finger of skewed axes: universal MCP, PIP, and a DIP that turns by 2/3 PIP + 0.1 rad.
inline Subject coupled_digit() {
  Draw draw(7);
  Subject subject;
  subject.name = "coupled";
  subject.base = "MC";
  const std::vector<Eigen::Vector3d> ends{{0, 0, 0}, {0.045, 0, 0}, {0.070, 0, 0}, {0.090, 0, 0}};
  const std::vector<std::string> names{"MC", "PP", "MP", "DP"};
  subject.segments.push_back(bone("MC", {-0.06, 0, 0}, ends[0], 0.010));
  for (int i = 1; i < 4; ++i)
    subject.segments.push_back(bone(names[i], ends[i - 1], ends[i], 0.009));
  const std::vector<std::string> joints{"MCP_AA", "MCP_FE", "PIP", "DIP"};
  for (int i = 0; i < 4; ++i) {
    const int child = std::max(i, 1);
    subject.joints.push_back(hinge(joints[i], names[child - 1], names[child], draw.direction(),
                                   ends[child - 1] + draw.vector(0.004)));
    subject.joints.back().stiffness = draw.number(0.01, 0.05);
    subject.joints.back().damping = draw.number(0.001, 0.005);
    subject.joints.back().rest = draw.number(-0.2, 0.2);
  }
  subject.joints[3].coupling = Coupling{"PIP", 2.0 / 3.0, 0.1};
  subject.digits = {digit("index", "DP", ends[3])};
  return subject;
}

/// Adds one digit of the random hand: a universal joint and two hinges, all skewed.
inline void add_digit(Subject& subject, const std::string& name, Draw& draw) {
  const Eigen::Vector3d forward = Eigen::Vector3d(1, 0, 0) + draw.vector(0.4);
  Eigen::Vector3d end = Eigen::Vector3d(0.08, 0, 0) + draw.vector(0.03);
  std::string parent = "palm";
  for (int i = 0; i < 3; ++i) {
    const std::string child = fmt::format("{}_{}", name, i);
    const int hinges = i == 0 ? 2 : 1;
    for (int k = 0; k < hinges; ++k)
      subject.joints.push_back(hinge(fmt::format("{}_{}_{}", name, i, k), parent, child,
                                     draw.direction(), end + draw.vector(0.005)));
    const Eigen::Vector3d next = end + draw.number(0.02, 0.05) * forward;
    Segment segment = bone(child, end, next, 0);
    segment.mass = draw.number(0.005, 0.05);
    segment.com = (end + next) / 2 + draw.vector(0.003);
    // Three masses on three axes at distances 1, 2, 3 satisfy the triangle inequality.
    const Eigen::Vector3d spread(draw.number(1, 2), draw.number(2, 3), draw.number(3, 4));
    const Eigen::Matrix3d R =
        Eigen::AngleAxisd(draw.number(0, kPi), draw.direction()).toRotationMatrix();
    const Eigen::Vector3d moments = spread.sum() * Eigen::Vector3d::Ones() - spread;
    segment.inertia = segment.mass * 1e-5 * R * moments.asDiagonal() * R.transpose();
    segment.inertia = (segment.inertia + segment.inertia.transpose().eval()) / 2;
    subject.segments.push_back(segment);
    parent = child;
    end = next;
  }
  subject.digits.push_back(digit(name, parent, end));
}

/// Five digits of four hinges on a wrist of `wrist_hinges` (0, 1 or 2); every axis is skewed.
inline Subject random_hand(unsigned seed, int wrist_hinges = 2) {
  Draw draw(seed);
  Subject subject;
  subject.name = "random hand";
  subject.base = wrist_hinges == 0 ? "palm" : "forearm";
  Segment palm = bone("palm", {0, 0, 0}, {0.08, 0, 0}, 0);
  palm.mass = 0.3;
  palm.com = {0.04, 0.002, -0.003};
  palm.inertia = 1e-4 * Eigen::Vector3d(2, 3, 4).asDiagonal();
  subject.segments = {palm};
  for (int k = 0; k < wrist_hinges; ++k)
    subject.joints.push_back(
        hinge(fmt::format("wrist_{}", k), "forearm", "palm", draw.direction(), draw.vector(0.005)));
  for (const char* name : {"thumb", "index", "middle", "ring", "little"})
    add_digit(subject, name, draw);
  for (JointAxis& joint : subject.joints) {
    joint.lower = -1.2;
    joint.upper = 1.4;
    joint.stiffness = draw.number(0.01, 0.1);
    joint.damping = draw.number(0.001, 0.01);
  }
  return subject;
}

}  // namespace thenar::sample
