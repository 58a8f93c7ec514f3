#pragma once

/// Random mechanisms and random states of them.

#include <random>
#include <string>

#include <Eigen/Dense>

#include "dynamics/mechanism/mechanism.h"

namespace thenar::sample {

/// A random stream for mechanisms.
class MechanismDraw {
 public:
  explicit MechanismDraw(unsigned seed) : engine_(seed) {}

  double number(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(engine_);
  }
  int whole(int lower, int upper) {
    return std::uniform_int_distribution<int>(lower, upper)(engine_);
  }
  Eigen::Vector3d vector(double size) {
    return {number(-size, size), number(-size, size), number(-size, size)};
  }
  Pose<double> frame(double size) {
    const Eigen::Vector3d axis = vector(1).normalized();
    return {rotation_about<double>(axis, number(-3, 3)), vector(size)};
  }
  /// A body of six points with mass.
  BodyMass body() {
    BodyMass out{0, {0, 0, 0}, Eigen::Matrix3d::Zero()};
    std::vector<std::pair<double, Eigen::Vector3d>> points;
    for (int i = 0; i < 6; ++i) points.emplace_back(number(0.01, 0.1), vector(0.03));
    for (const auto& [mass, p] : points) {
      out.mass += mass;
      out.com += mass * p;
    }
    out.com /= out.mass;
    for (const auto& [mass, p] : points) {
      const Eigen::Vector3d arm = p - out.com;
      out.inertia +=
          mass * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
    }
    return out;
  }

  /// A tree with joints of all kinds. @param shares  some hinges and slides follow others
  Mechanism mechanism(int bodies, bool shares) {
    Mechanism out;
    for (int i = 0; i < bodies; ++i) {
      MechanismJoint joint;
      joint.name = "j" + std::to_string(i);
      joint.kind = kJointKindNames[static_cast<std::size_t>(whole(0, 4))].value;
      joint.parent = whole(-1, i - 1);
      joint.X_PF = frame(0.05);
      joint.X_BM = frame(0.05);
      if (joint.kind == JointKind::kHinge || joint.kind == JointKind::kSlide) {
        const int known = static_cast<int>(out.coordinates.size());
        joint.coordinate = shares && known > 0 && whole(0, 1) == 0 ? whole(0, known - 1) : known;
        if (joint.coordinate == known) {
          out.coordinates.push_back({"u" + std::to_string(known)});
        } else {
          joint.curve = {number(-0.3, 0.3), number(-0.1, 0.1)};
        }
        if (shares) joint.ratio = number(0.5, 1.5), joint.offset = number(-0.2, 0.2);
      }
      out.joints.push_back(joint);
      out.bodies.push_back({"b" + std::to_string(i), body(), {}, {}});
    }
    return out;
  }

  /// Positions with unit quaternions; hinges and slides within `size`.
  Eigen::VectorXd position(const Mechanism& mechanism, double size = 1) {
    const MechanismLayout layout = layout_of(mechanism);
    Eigen::VectorXd q(layout.q);
    for (Eigen::Index i = 0; i < q.size(); ++i) q[i] = number(-size, size);
    for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
      const JointKind kind = mechanism.joints[i].kind;
      if (kind == JointKind::kBall || kind == JointKind::kFree)
        q.segment<4>(layout.first_q[i]).normalize();
    }
    return q;
  }
  Eigen::VectorXd numbers(int count, double size) {
    return Eigen::VectorXd::NullaryExpr(count, [&] { return number(-size, size); });
  }

 private:
  std::mt19937 engine_;
};

}  // namespace thenar::sample
