#pragma once

/// Contact problems built from bodies: W = J M^-1 J',  b = J v.

#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include "contact/contact_problem.h"

namespace thenar::sample {

/// Rigid bodies that touch each other or a ground, in one instant.
struct TouchingBodies {
  struct Body {
    double mass;                           // [kg]
    Eigen::Matrix3d inertia;               // [kg m^2]
    Eigen::Vector3d centre;                // [m]
    Eigen::Matrix<double, 6, 1> velocity;  // of turning, of the centre [rad/s], [m/s]
  };
  std::vector<Body> bodies;
  std::vector<Eigen::MatrixXd> rows;  // J of each block (rows, 6 bodies)
  std::vector<ContactBlock> blocks;

  /// Rows of the velocity of `point` of a body along `direction`, times `sign`.
  void add_point(Eigen::MatrixXd* J, int row, int body, const Eigen::Vector3d& point,
                 const Eigen::Vector3d& direction, double sign) const {
    if (body < 0) return;
    const Eigen::Vector3d arm = point - bodies[static_cast<std::size_t>(body)].centre;
    J->block<1, 3>(row, 6 * body) += sign * arm.cross(direction).transpose();
    J->block<1, 3>(row, 6 * body + 3) += sign * direction.transpose();
  }

  /// A contact of `body` with `other` (-1: ground); the normal points into `body`.
  void touch(const ContactBlock& block, int body, int other, const Eigen::Vector3d& point,
             const Eigen::Vector3d& normal) {
    const int count = row_count(block.law);
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(count, 6 * static_cast<int>(bodies.size()));
    const Eigen::Vector3d side =
        std::abs(normal.z()) < 0.9 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX();
    const Eigen::Vector3d t1 = normal.cross(side).cross(normal).normalized(), t2 = normal.cross(t1);
    const Eigen::Vector3d directions[3] = {normal, t1, t2};
    for (int k = 0; k < std::min(count, 3); ++k) {
      add_point(&J, k, body, point, directions[k], 1);
      add_point(&J, k, other, point, directions[k], -1);
    }
    if (count == 4) {
      if (body >= 0) J.block<1, 3>(3, 6 * body) += normal.transpose();
      if (other >= 0) J.block<1, 3>(3, 6 * other) -= normal.transpose();
    }
    rows.push_back(J);
    blocks.push_back(block);
  }

  [[nodiscard]] Eigen::MatrixXd jacobian() const {
    Eigen::Index count = 0;
    for (const Eigen::MatrixXd& part : rows) count += part.rows();
    Eigen::MatrixXd J(count, 6 * static_cast<Eigen::Index>(bodies.size()));
    count = 0;
    for (const Eigen::MatrixXd& part : rows) {
      J.middleRows(count, part.rows()) = part;
      count += part.rows();
    }
    return J;
  }
  [[nodiscard]] Eigen::MatrixXd inverse_mass() const {
    const auto n = static_cast<Eigen::Index>(bodies.size());
    Eigen::MatrixXd out = Eigen::MatrixXd::Zero(6 * n, 6 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Body& body = bodies[static_cast<std::size_t>(i)];
      out.block<3, 3>(6 * i, 6 * i) = body.inertia.inverse();
      out.block<3, 3>(6 * i + 3, 6 * i + 3) = Eigen::Matrix3d::Identity() / body.mass;
    }
    return out;
  }
  [[nodiscard]] Eigen::VectorXd velocity() const {
    Eigen::VectorXd out(6 * static_cast<Eigen::Index>(bodies.size()));
    for (std::size_t i = 0; i < bodies.size(); ++i)
      out.segment<6>(6 * static_cast<Eigen::Index>(i)) = bodies[i].velocity;
    return out;
  }
  [[nodiscard]] ContactProblem problem() const {
    const Eigen::MatrixXd J = jacobian();
    Eigen::MatrixXd W = J * inverse_mass() * J.transpose();
    W = ((W + W.transpose()) / 2).eval();
    return {blocks, W, J * velocity()};
  }
};

/// What random bodies and contacts are like.
struct RandomTouch {
  int bodies = 3;
  int contacts = 6;
  double friction_low = 0.1, friction_high = 1.2;  // uniform [1]
  double mass_decades = 1;                         // masses 10^(+- this) kg, log-uniform
  double soft = 0.3;                               // share of soft fingers
  double limits = 0.2;                             // share of unilateral, box and bilateral rows
};

inline Eigen::Vector3d random_direction(std::mt19937& rng) {
  std::normal_distribution<double> normal;
  Eigen::Vector3d v(normal(rng), normal(rng), normal(rng));
  return v.normalized();
}

/// Balls of random masses, inertias and velocities that touch each other and the ground at random
/// points, with some single rows (bounds on a random velocity) between.
inline TouchingBodies random_touch(std::mt19937& rng, const RandomTouch& like) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<double> normal;
  TouchingBodies out;
  for (int i = 0; i < like.bodies; ++i) {
    TouchingBodies::Body body;
    body.mass = std::pow(10, like.mass_decades * (2 * unit(rng) - 1));
    const Eigen::Matrix3d R =
        Eigen::AngleAxisd(3 * unit(rng), random_direction(rng)).toRotationMatrix();
    const Eigen::Vector3d I(0.3 + unit(rng), 0.3 + unit(rng), 0.3 + unit(rng));
    const double radius = 0.02 + 0.05 * unit(rng);
    body.inertia = body.mass * radius * radius * R * I.asDiagonal() * R.transpose();
    body.centre = Eigen::Vector3d(0.1 * i, 0, 0);
    for (int k = 0; k < 3; ++k) {
      body.velocity(k) = normal(rng) / radius;
      body.velocity(3 + k) = normal(rng);
    }
    out.bodies.push_back(body);
  }
  std::uniform_int_distribution<int> which(0, like.bodies - 1);
  for (int c = 0; c < like.contacts; ++c) {
    const int body = which(rng);
    int other = which(rng);
    if (other == body) other = -1;
    const double mu = like.friction_low + (like.friction_high - like.friction_low) * unit(rng);
    const Eigen::Vector3d n = random_direction(rng);
    const Eigen::Vector3d point = out.bodies[static_cast<std::size_t>(body)].centre -
                                  0.05 * (n + 0.3 * random_direction(rng));
    const double kind = unit(rng);
    ContactBlock block = coulomb_block(mu);
    if (kind < like.limits) {
      const double half = std::pow(10, like.mass_decades) * 0.1 * unit(rng);
      const double pick = unit(rng);
      block = pick < 0.4   ? unilateral_block()
              : pick < 0.8 ? box_block(-half, half)
                           : bilateral_block();
    } else if (kind < like.limits + like.soft) {
      block = soft_finger_block(mu, 0.001 + 0.01 * unit(rng));
    }
    out.touch(block, body, other, point, n);
  }
  return out;
}

}  // namespace thenar::sample
