#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "tendons/muscle/finger_motion.h"

// Slopes of the equations of motion, for the integrator.

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// How moment arms and what tendons give change: d(R q' + G t')/d. at fixed q' and t', one column a
/// posture angle or tension.
struct ArmSlopes {
  MatrixXd by_q, by_t;  // (muscles, coordinates) [m/s/rad], (muscles, muscles) [m/s/N]
};

/// Differences of what is itself a slope.
/// @param t      tensions [N] (muscles)
/// @param t_dot  their rates [N/s] (muscles)
ArmSlopes arm_slopes(const DigitTendons& tendons, const MotionState& state, const VectorXd& t,
                     const VectorXd& t_dot, const TendonPull& here) {
  constexpr double kStep = 1e-5;                 // of an angle [rad]
  constexpr double kPart = 1e-3, kLeast = 0.01;  // of a tension and [N]
  const Index joints = state.q.size(), muscles = t.size();
  const bool net = tendons.digit().fidelity.hood == Hood::kFloatingNet;
  const auto rate = [&](const VectorXd& q, const VectorXd& at, const TendonPull& pull) {
    VectorXd v = pull.R * state.q_dot;
    if (net) v += tendons.give(q, at, pull) * t_dot;
    return v;
  };
  const VectorXd v = rate(state.q, t, here);
  ArmSlopes out{MatrixXd(muscles, joints), MatrixXd::Zero(muscles, muscles)};
  for (Index j = 0; j < joints; ++j) {
    VectorXd q = state.q;
    q[j] += kStep;
    out.by_q.col(j) = (rate(q, t, tendons.pull(q, t, here.nodes)) - v) / kStep;
  }
  for (Index m = 0; net && m < muscles; ++m) {
    VectorXd more = t;
    more[m] += kPart * (t[m] + kLeast);
    const TendonPull pull = tendons.pull(state.q, more, here.nodes);
    out.by_t.col(m) = (rate(state.q, more, pull) - v) / (more[m] - t[m]);
  }
  return out;
}

/// Slopes of the bones' acceleration at fixed torques, by central differences, one column a posture
/// angle, then one a speed [1/s^2] and [1/s] (coordinates, 2 coordinates).
template <typename Acceleration>
MatrixXd acceleration_slopes(const MotionState& state, const Acceleration& bones) {
  constexpr double kStep = 1e-5;  // [rad], [rad/s] over the speed and 1
  const Index n = state.q.size();
  const double speed_step = kStep * (1 + state.q_dot.cwiseAbs().maxCoeff());
  MatrixXd slopes(n, 2 * n);
  for (Index j = 0; j < n; ++j) {
    const VectorXd one = VectorXd::Unit(n, j);
    slopes.col(j) =
        (bones(state.q + kStep * one, state.q_dot) - bones(state.q - kStep * one, state.q_dot)) /
        (2 * kStep);
    slopes.col(n + j) = (bones(state.q, state.q_dot + speed_step * one) -
                         bones(state.q, state.q_dot - speed_step * one)) /
                        (2 * speed_step);
  }
  return slopes;
}

}  // namespace

MatrixXd FingerMotion::jacobian(const MotionState& state, const VectorXd& excitation) {
  const Index n = state.q.size(), m = muscles_, size = pack(state).size();
  const Index a = 2 * n, e = a + m, r = e + m;
  constexpr double kStretch = 1e-8;  // [m]
  const Skeleton& skeleton = model_.tendons.digit().skeleton;
  const MotionInstant now = at(state);
  const MatrixXd& R = now.pull.R;
  const TensionRate rate = tension_rate(state, now, excitation);
  const ArmSlopes arms = arm_slopes(tendons(), state, now.tension, rate.tension, now.pull);

  // Tensions by all states, the way through R q' apart; and their rates, but by that of excursion.
  MatrixXd t_y = MatrixXd::Zero(m, size), J = MatrixXd::Zero(size, size), rest_y = t_y;
  VectorXd by_velocity(m);
  for (Index i = 0; i < m; ++i) {
    const int k = static_cast<int>(i);
    MuscleState muscle = muscle_state(state, k);
    if (contraction().feels_velocity()) muscle.velocity = -R.row(i).dot(state.q_dot);
    const TensionSlopes slopes = contraction().tension_slopes(k, muscle);
    by_velocity[i] = slopes.by_velocity;
    t_y(i, a + i) = slopes.by_activation;
    t_y(i, e + i) = slopes.by_length;
    if (state.reach.size() > 0) {
      t_y(i, r + i) = slopes.by_reach;
      const ReachRateSlopes reach = contraction().reach_rate_slopes(k, muscle);
      J(r + i, a + i) = reach.by_activation;
      J(r + i, e + i) = reach.by_length;
      J(r + i, r + i) = reach.by_reach;
      rest_y.row(i) = slopes.by_reach * J.row(r + i);
      // A tendon's stiffness depends on length - reach.
      MuscleState longer = muscle;
      longer.length += kStretch;
      const double bend =
          (contraction().tension_slopes(k, longer).by_length - slopes.by_length) / kStretch;
      const double turn = bend * (rate.excursion[i] - contraction().reach_rate(k, muscle));
      rest_y(i, e + i) += turn;
      rest_y(i, r + i) -= turn;
    }
    J(a + i, a + i) = activation_rate_slope(excitation[i], state.activation[i], model_.activation);
    rest_y(i, a + i) += slopes.by_activation * J(a + i, a + i);
  }

  // R q' by all states, and what tendons give; for a net by tensions, too.
  MatrixXd v_y = MatrixXd::Zero(m, size), tau_y = MatrixXd::Zero(n, size);
  v_y.leftCols(n) = arms.by_q;
  v_y.middleCols(n, n) = R;
  v_y += arms.by_t * t_y;
  t_y -= by_velocity.asDiagonal() * v_y;
  if (slack_length_.size() > 0) {  // excursions that have strayed return
    v_y.leftCols(n) += kReturn * R;
    v_y.middleCols(e, m).diagonal().array() += kReturn;
    v_y += kReturn * rate.G * t_y;
  }

  // Torques of the tendons.
  tau_y.leftCols(n) = tendons().torque_by_posture(state.q, now.tension, now.pull);
  tau_y += R.transpose() * t_y;
  J.block(e, 0, m, size) = rate.G.size() > 0
                               ? MatrixXd(-rate.A.partialPivLu().solve(v_y + rate.G * rest_y))
                               : MatrixXd(-v_y);
  J.row(size - 2) = state.q_dot.transpose() * tau_y;
  J.row(size - 2).segment(n, n) += now.pull.tau.transpose();
  J.row(size - 1).segment(n, n) = 2 * damping_.cwiseProduct(state.q_dot).transpose();

  // Bones, under the torques of tendons, of what holds joints, and of damping.
  tau_y.leftCols(n).diagonal() += holding_slope(skeleton, model_.resistance, state.q);
  tau_y.middleCols(n, n).diagonal() -= damping_;
  J.block(0, n, n, n).setIdentity();
  J.block(n, 0, n, size) = multibody_.mass_matrix(state.q).llt().solve(tau_y);
  const VectorXd tau = now.pull.tau + holding_torque(skeleton, model_.resistance, state.q) -
                       damping_.cwiseProduct(state.q_dot);
  J.block(n, 0, n, 2 * n) +=
      acceleration_slopes(state, [&](const VectorXd& q, const VectorXd& q_dot) {
        return multibody_.forward_dynamics({q, q_dot}, tau, {model_.gravity, {}});
      });
  return J;
}

}  // namespace thenar
