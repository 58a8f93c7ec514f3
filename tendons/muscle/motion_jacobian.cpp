#include <Eigen/Cholesky>

#include "tendons/muscle/finger_motion.h"

// Slopes of the equations of motion, for the integrator.

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// How moment arms change: d(R q')/d. and (dR/d.)' t, one column a posture angle or tension.
struct ArmSlopes {
  MatrixXd speed_by_q, speed_by_t;    // (muscles, coordinates) [m/s/rad], (muscles, muscles)
  MatrixXd torque_by_q, torque_by_t;  // (coordinates, coordinates), (coordinates, muscles)
};

/// Differences of moment arms, which are themselves slopes.
/// @param t        tensions that a net rests under [N] (muscles)
/// @param t_more   that the arms pass on beside those [N] (muscles)
ArmSlopes arm_slopes(const DigitTendons& tendons, const MotionState& state, const VectorXd& t,
                     const VectorXd& t_more, const TendonPull& here, bool averaged) {
  constexpr double kStep = 1e-5;                 // of an angle [rad]
  constexpr double kPart = 1e-3, kLeast = 0.01;  // of a tension and [N]
  const Index joints = state.q.size(), muscles = t.size();
  const auto arms = [&](const VectorXd& q, const VectorXd& at) {
    const TendonPull pull = tendons.pull(q, at, here.nodes);
    return averaged ? tendons.mean_arms(q, at, pull, kArmWidth) : pull.R;
  };
  const bool net = tendons.digit().fidelity.hood == Hood::kFloatingNet;
  ArmSlopes out{MatrixXd(muscles, joints), MatrixXd::Zero(muscles, muscles),
                MatrixXd(joints, joints), MatrixXd::Zero(joints, muscles)};
  for (Index j = 0; j < joints; ++j) {
    VectorXd q = state.q;
    q[j] += kStep;
    const MatrixXd dR = (arms(q, t) - here.R) / kStep;
    out.speed_by_q.col(j) = dR * state.q_dot;
    out.torque_by_q.col(j) = dR.transpose() * t_more;
  }
  for (Index m = 0; net && m < muscles; ++m) {
    VectorXd more = t;
    more[m] += kPart * (t[m] + kLeast);
    const MatrixXd dR = (arms(state.q, more) - here.R) / (more[m] - t[m]);
    out.speed_by_t.col(m) = dR * state.q_dot;
    out.torque_by_t.col(m) = dR.transpose() * t_more;
  }
  return out;
}

}  // namespace

MatrixXd FingerMotion::jacobian(const MotionState& state, const VectorXd& excitation) {
  const Index n = state.q.size(), m = muscles_, size = pack(state).size();
  const Index a = 2 * n, e = a + m, r = e + m, f = r + state.reach.size();
  const Skeleton& skeleton = model_.tendons.digit().skeleton;
  const MotionInstant now = at(state);
  const MatrixXd& R = now.pull.R;
  const VectorXd under = rested_under(state, now.tension);
  const VectorXd more = net_feels_ ? VectorXd(now.tension - under) : VectorXd::Zero(m);
  const ArmSlopes arms = arm_slopes(tendons(), state, under, more, now.pull, net_feels_);

  // Tensions by all states, the way through R q' apart.
  MatrixXd t_y = MatrixXd::Zero(m, size), J = MatrixXd::Zero(size, size);
  VectorXd by_velocity(m);
  for (Index i = 0; i < m; ++i) {
    const int k = static_cast<int>(i);
    MuscleState muscle = muscle_state(state, k);
    if (model_.contraction.feels_velocity()) muscle.velocity = -R.row(i).dot(state.q_dot);
    const TensionSlopes slopes = model_.contraction.tension_slopes(k, muscle);
    by_velocity[i] = slopes.by_velocity;
    t_y(i, a + i) = slopes.by_activation;
    t_y(i, e + i) = slopes.by_length;
    if (state.reach.size() > 0) {
      t_y(i, r + i) = slopes.by_reach;
      const ReachRateSlopes rate = model_.contraction.reach_rate_slopes(k, muscle);
      J(r + i, a + i) = rate.by_activation;
      J(r + i, e + i) = rate.by_length;
      J(r + i, r + i) = rate.by_reach;
    }
    J(a + i, a + i) = activation_rate_slope(excitation[i], state.activation[i], model_.activation);
  }

  // R q' by all states; a net's R by the tensions that it rests under.
  MatrixXd v_y = MatrixXd::Zero(m, size), tau_y = MatrixXd::Zero(n, size);
  v_y.leftCols(n) = arms.speed_by_q;
  v_y.middleCols(n, n) = R;
  if (net_feels_)
    v_y.middleCols(f, m) = arms.speed_by_t;
  else
    v_y += arms.speed_by_t * t_y;
  t_y -= by_velocity.asDiagonal() * v_y;

  // Torques of the tendons.
  tau_y.leftCols(n) = tendons().torque_by_posture(state.q, under, now.pull) + arms.torque_by_q;
  if (net_feels_) tau_y.middleCols(f, m) = arms.torque_by_t;
  tau_y += R.transpose() * t_y;
  J.block(e, 0, m, size) = -v_y;
  if (net_feels_) {
    J.block(f, 0, m, size) = t_y / kNetLag;
    J.block(f, f, m, m).diagonal().array() -= 1 / kNetLag;
  }
  J.row(size - 2) = state.q_dot.transpose() * tau_y;
  J.row(size - 2).segment(n, n) += now.pull.tau.transpose();
  J.row(size - 1).segment(n, n) = 2 * damping_.cwiseProduct(state.q_dot).transpose();

  // Bones.
  tau_y.leftCols(n).diagonal() += holding_slope(skeleton, model_.resistance, state.q);
  tau_y.middleCols(n, n).diagonal() -= damping_;
  J.block(0, n, n, n).setIdentity();
  J.block(n, 0, n, size) = multibody_.mass_matrix(state.q).llt().solve(tau_y);
  const VectorXd tau = now.pull.tau + holding_torque(skeleton, model_.resistance, state.q) -
                       damping_.cwiseProduct(state.q_dot);
  const auto bones = [&](const VectorXd& q, const VectorXd& q_dot) {
    return multibody_.forward_dynamics({q, q_dot}, tau, {model_.gravity, {}});
  };
  constexpr double kStep = 1e-5;  // [rad], [rad/s] over the speed and 1
  const double speed_step = kStep * (1 + state.q_dot.cwiseAbs().maxCoeff());
  for (Index j = 0; j < n; ++j) {
    const VectorXd one = VectorXd::Unit(n, j);
    J.block(n, j, n, 1) +=
        (bones(state.q + kStep * one, state.q_dot) - bones(state.q - kStep * one, state.q_dot)) /
        (2 * kStep);
    J.block(n, n + j, n, 1) += (bones(state.q, state.q_dot + speed_step * one) -
                                bones(state.q, state.q_dot - speed_step * one)) /
                               (2 * speed_step);
  }
  return J;
}

}  // namespace thenar
