#pragma once

/// Hands with four fingers and a thumb in the manner of what is sold, as formats leave them that
/// say nothing of digits, closing and approach.

#include <cmath>
#include <string>
#include <vector>

#include "tests/grasp/closing_samples.h"

namespace thenar::sample {

/// How such a hand is built.
struct MadeUpHand {
  bool left = false;
  bool one_motor_a_finger = false;  // outer joints follow the inner one
  bool meshes = false;              // boxes as meshes in place of capsules
  bool arched = false;              // opposition moves the little finger's side, too
  int thumb = 0;                    // 0: opposition, then flexion; 1: flexion, then opposition and
                                    // flexion; 2: abduction across, then opposition and flexion
  bool negative = false;            // flexion is negative
  Eigen::Vector3d turn{0, 0, 0};    // of the base frame, as a rotation vector [rad] (3)
  double scale = 1;                 // of all lengths [1]
};

/// Builds one: fingers along x, the palm's normal z, the thumb towards y; all mirrored of a left
/// one, then turned.
class HandMaker {
 public:
  explicit HandMaker(const MadeUpHand& how) : how_(how) {
    robot_.name = "made up";
    robot_.closing_stated = robot_.approach_stated = false;
    R_ = how.turn.norm() > 0 ? rotation_about<double>(how.turn.normalized(), how.turn.norm())
                             : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    RobotLink palm;
    palm.name = "base";
    palm.shapes = {box({0.09, 0.085, 0.025}, {-0.045, 0, -0.0125})};
    robot_.links.push_back(palm);
    const char* const names[] = {"second", "third", "fourth", "fifth"};
    for (int f = 0; f < 4; ++f) finger(names[f], 0.033 - 0.022 * f, f >= 2);
    thumb();
  }

  [[nodiscard]] RobotSpec hand() const { return robot_; }

 private:
  [[nodiscard]] Eigen::Vector3d place(Eigen::Vector3d p) const {
    if (how_.left) p.y() = -p.y();
    return how_.scale * (R_ * p);
  }
  [[nodiscard]] Eigen::Vector3d direction(Eigen::Vector3d d) const {
    if (how_.left) d.y() = -d.y();
    return R_ * d;
  }
  /// An axis turns the other way round in a mirror.
  [[nodiscard]] Eigen::Vector3d axis(Eigen::Vector3d a) const {
    if (how_.left) a = Eigen::Vector3d(-a.x(), a.y(), -a.z());
    return R_ * a;
  }

  [[nodiscard]] ShapeSpec box(const Eigen::Vector3d& edges, const Eigen::Vector3d& at) const {
    ShapeSpec spec = shape(ShapeKind::kBox, how_.scale * edges, place(at));
    spec.X_BS.R = R_;
    return spec;
  }

  /// A phalanx from the joint's origin along a way.
  [[nodiscard]] ShapeSpec phalanx_shape(const Eigen::Vector3d& way, double length,
                                        double radius) const {
    const Eigen::Vector3d z = direction(way).normalized();
    Eigen::Matrix3d R;
    const Tangents t = tangents(z);
    R << t.e1, t.e2, z;
    if (R.determinant() < 0) R.col(0) *= -1;
    ShapeSpec spec = shape(ShapeKind::kCapsule, {how_.scale * radius, how_.scale * length, 0},
                           how_.scale * length / 2 * z);
    spec.X_BS.R = R;
    if (!how_.meshes) return spec;
    spec.kind = ShapeKind::kMesh;
    spec.mesh =
        build_solid({shape(ShapeKind::kBox,
                           how_.scale * Eigen::Vector3d(2 * radius, 2 * radius, length + radius))})
            .visual;
    return spec;
  }

  /// A link on a hinge, which may follow that of another link.
  struct Hinge {
    std::string name, parent;   // of the links
    Eigen::Vector3d at, about;  // from the hinge before it; any length
    double lower, upper;        // [rad]
    std::string leader;         // empty: it follows none
    double ratio;               // of its angle to the leader's [1]
  };
  void add(const Hinge& hinge, const std::vector<ShapeSpec>& shapes) {
    RobotLink link;
    link.name = hinge.name;
    link.shapes = shapes;
    robot_.links.push_back(link);
    RobotJoint joint;
    joint.name = hinge.name + " joint";
    joint.parent = hinge.parent;
    joint.child = hinge.name;
    joint.X_PJ.p = place(hinge.at);
    const double sign = how_.negative ? -1 : 1;
    joint.axis = sign * axis(hinge.about.normalized());
    joint.lower = how_.negative ? -hinge.upper : hinge.lower;
    joint.upper = how_.negative ? -hinge.lower : hinge.upper;
    joint.dof = (hinge.leader.empty() ? hinge.name : hinge.leader) + " joint";
    joint.ratio = hinge.ratio;
    robot_.joints.push_back(joint);
    if (!hinge.leader.empty()) return;
    RobotDof dof;
    dof.name = joint.dof;
    dof.lower = joint.lower;
    dof.upper = joint.upper;
    dof.speed = 1;
    robot_.dofs.push_back(dof);
  }

  void finger(const std::string& name, double y, bool far_side) {
    if (how_.arched && far_side) {
      arched_.push_back(name);
      return;  // built with the thumb's opposition
    }
    build_finger(name, "base", {0, y, -0.01});
  }

  void build_finger(const std::string& name, const std::string& parent, const Eigen::Vector3d& at) {
    const Eigen::Vector3d x(1, 0, 0), flex(0, -1, 0);
    const std::string leader = how_.one_motor_a_finger ? name + " 1" : "";
    add({name + " 1", parent, at, flex, -0.1, 1.6, "", 1}, {phalanx_shape(x, 0.042, 0.008)});
    add({name + " 2", name + " 1", {0.042, 0, 0}, flex, -0.1, 1.7, leader, 1},
        {phalanx_shape(x, 0.026, 0.0075)});
    add({name + " 3", name + " 2", {0.026, 0, 0}, flex, -0.1, 1.5, leader, 0.8},
        {phalanx_shape(x, 0.018, 0.007)});
  }

  void thumb() {
    const Eigen::Vector3d at(-0.065, 0.042, -0.008);
    if (how_.thumb == 0) {
      // In the palm's plane at 0; opposition swings it out of it about the palm's length.
      const Eigen::Vector3d way(0.6, 0.8, 0), flex(0, 0, -1);
      add({"opposer 0", "base", at, {1, 0, 0}, 0, 1.9, "", 1}, {});
      segments("opposer 0", {0, 0, 0}, way, flex, 3);
    } else if (how_.thumb == 1) {
      // Out of the palm by flexion about its length, round by a twist of the metacarpal.
      const Eigen::Vector3d way(0.5, 0.85, 0);
      add({"opposer 0", "base", at, {1, -0.6, 0}, -0.2, 1.3, "", 1}, {});
      add({"opposer 0a", "opposer 0", {0, 0, 0}, way, -0.8, 0.8, "", 1},
          {phalanx_shape(way, 0.04, 0.009)});
      segments("opposer 0a", 0.04 * way.normalized(), way, {0, 0, -1}, 2);
    } else {
      // Across the palm's normal, then round its own length.
      const Eigen::Vector3d way(0.3, 0.95, 0);
      add({"opposer 0", "base", at, {0, 0, 1}, -0.6, 0.6, "", 1}, {});
      add({"opposer 0a", "opposer 0", {0, 0, 0}, {1, 0, 0}, 0, 1.8, "", 1},
          {phalanx_shape(way, 0.04, 0.009)});
      segments("opposer 0a", 0.04 * way.normalized(), way, {0, 0, -1}, 2);
    }
    for (std::size_t i = 0; i < arched_.size(); ++i) {
      const std::string arch = arched_[i] + " arch";
      add({arch, "base", {-0.06, 0, -0.012}, {-1, 0, 0}, 0, 0.6, "opposer 0", 0.2}, {});
      build_finger(arched_[i], arch, {0.06, -0.011 - 0.022 * static_cast<double>(i), 0.002});
    }
  }

  void segments(const std::string& parent, const Eigen::Vector3d& at, const Eigen::Vector3d& way,
                const Eigen::Vector3d& flex, int count) {
    const double lengths[] = {0.045, 0.032, 0.026};
    std::string before = parent;
    Eigen::Vector3d from = at;
    for (int i = 0; i < count; ++i) {
      const std::string name = "opposer " + std::to_string(i + 1);
      const double length = lengths[3 - count + i];
      const bool follows = how_.one_motor_a_finger && i > 0;
      add({name, before, from, flex, -0.1, 1.2, follows ? "opposer 1" : "", 1},
          {phalanx_shape(way, length, 0.009)});
      before = name;
      from = length * way.normalized();
    }
  }

  MadeUpHand how_;
  Eigen::Matrix3d R_;
  RobotSpec robot_;
  std::vector<std::string> arched_;
};

}  // namespace thenar::sample
