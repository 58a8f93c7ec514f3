#include "tendons/muscle/finger_motion.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "base/error.h"
#include "tendons/digit_tendons.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kPulls = 1e-3;  // beyond its base tension; less is slack [N]

Index muscles_of(const MotionModel& model) {
  return static_cast<Index>(model.tendons.digit().names.muscles.size());
}

bool has_net(const MotionModel& model) {
  return model.tendons.digit().fidelity.hood == Hood::kFloatingNet;
}

double weight_energy(const Skeleton& skeleton, const VectorXd& q, const Eigen::Vector3d& gravity) {
  const TreeState<double> state = pose_tree(skeleton.tree, q);
  double energy = 0;
  for (std::size_t i = 0; i < skeleton.masses.size(); ++i)
    energy -= skeleton.masses[i].mass *
              gravity.dot(moved(state, static_cast<int>(i), skeleton.masses[i].com));
  return energy;
}

}  // namespace

FingerMotion::FingerMotion(const MotionModel& model)
    : model_(model),
      blended_(model.tendons.smoothed(model.blend)),
      compliant_(has_net(model) ? model.contraction.with_compliant_tendon(kRigidStrain) : nullptr),
      multibody_(model.tendons.digit().skeleton, Passive::kOff),
      damping_(joint_damping(model.tendons.digit().skeleton, model.resistance)),
      base_tension_(has_net(model) ? model.base_tension : 0),
      muscles_(muscles_of(model)) {
  require(model.base_tension >= 0 && model.base_tension < 1e3,
          "base tension must be >= 0, and little, got {} N", model.base_tension);
  require(model.gravity.allFinite(), "gravity has an entry that is not finite");
  // Muscles of the contraction are those of the digit, in its order.
  const std::vector<std::string>& names = model.tendons.digit().names.muscles;
  const std::vector<Musculotendon>& muscles = model.contraction.muscles();
  require(muscles.size() == names.size(), "{} muscles contract, the digit has {}", muscles.size(),
          names.size());
  for (std::size_t m = 0; m < names.size(); ++m)
    require(muscles[m].name == names[m], "muscle {} contracts as '{}', the digit calls it '{}'", m,
            muscles[m].name, names[m]);
}

MotionOnset FingerMotion::start(const VectorXd& q, const VectorXd& q_dot,
                                const VectorXd& activation) {
  // Shapes and ranges.
  const Index joints = damping_.size(), muscles = muscles_;
  require(q.size() == joints && q_dot.size() == joints && activation.size() == muscles,
          "wanted {} angles, {} speeds, {} activations; got {}, {}, {}", joints, joints, muscles,
          q.size(), q_dot.size(), activation.size());
  require(q.allFinite() && q_dot.allFinite(), "the start has an angle or speed that is not finite");
  require((activation.array() >= 0 && activation.array() <= 1).all(),
          "activations must be in 0..1");
  last_nodes_.resize(3, 0);  // of another motion
  // Excursion from the reference posture, along a walk of the net.
  const Excursion way =
      excursion(tendons(), VectorXd::Zero(joints), q, VectorXd::Ones(muscles));  // [N]
  const std::string warning = way.warning.empty() ? "" : "on the way to the start: " + way.warning;
  MotionState state{q, q_dot, activation, way.e, {}, 0, 0};
  // Fibres in balance with their tendons.
  if (contraction().has_fibre_state()) {
    VectorXd projected_fibre(muscles);
    for (int m = 0; m < muscles; ++m)
      projected_fibre[m] =
          contraction().isometric_projected_fibre(m, activation[m], muscle_state(state, m).length);
    state.projected_fibre = projected_fibre;
  }
  // Lengths of lines where excursions are zero, for the correction of drift.
  slack_length_.resize(0);
  if (has_net(model_) && tendons().digit().model.friction.isZero(0)) {
    const MotionInstant now = at(state);
    slack_length_ = tendons().lengths(q, now.tension, now.pull) - state.excursion;
  }
  return {state, warning};
}

VectorXd FingerMotion::drift(const MotionState& state, const MotionInstant& now) const {
  if (slack_length_.size() == 0) return VectorXd::Zero(muscles_);
  return state.excursion + slack_length_ - tendons().lengths(state.q, now.tension, now.pull);
}

MuscleState FingerMotion::muscle_state(const MotionState& state, int m) const {
  const Musculotendon& muscle = contraction().muscles()[static_cast<std::size_t>(m)];
  const double projected_fibre = state.projected_fibre.size() > 0 ? state.projected_fibre[m] : 0;
  return {state.activation[m], musculotendon_length_at_optimum(muscle) + state.excursion[m], 0,
          projected_fibre};
}

VectorXd FingerMotion::tension(const MotionState& state, const VectorXd& velocity) const {
  return VectorXd::NullaryExpr(muscles_, [&](Index m) {
    MuscleState muscle = muscle_state(state, static_cast<int>(m));
    muscle.velocity = velocity[m];
    return base_tension_ + contraction().tension(static_cast<int>(m), muscle);
  });
}

MotionInstant FingerMotion::at(const MotionState& state) const {
  const DigitTendons& tendons = this->tendons();
  const VectorXd none = VectorXd::Zero(muscles_);
  MotionInstant now;
  // Fibre lengths follow from the states.
  now.fibre = VectorXd::NullaryExpr(muscles_, [&](Index m) {
    return contraction().fibre(static_cast<int>(m), muscle_state(state, static_cast<int>(m)));
  });
  // On rigid tendons velocity comes first, from arms without tension.
  const bool feels = contraction().depends_on_velocity();
  now.tension =
      tension(state, feels ? VectorXd(-tendons.evaluate(state.q, none, last_nodes_).R * state.q_dot)
                           : none);
  if (!now.tension.allFinite()) {  // a trial of the integrator far off: it takes a shorter step
    const Index joints = state.q.size();
    now.pull.tau = VectorXd::Constant(joints, HUGE_VAL);
    now.pull.R = Eigen::MatrixXd::Zero(muscles_, joints);
    return now;
  }
  // Torque and arms at these tensions.
  now.pull = tendons.evaluate(state.q, now.tension, last_nodes_);
  return now;
}

FingerMotion::TensionRate FingerMotion::tension_rate(const MotionState& state,
                                                     const MotionInstant& now,
                                                     const VectorXd& excitation) const {
  TensionRate out;
  // Without a net: excursion' = -R q'.
  out.excursion = -now.pull.R * state.q_dot;
  if (!has_net(model_)) return out;
  // Derivatives of tension, and its rate at constant length.
  VectorXd by_length(muscles_), rest(muscles_);
  for (Index i = 0; i < muscles_; ++i) {
    const int m = static_cast<int>(i);
    const MuscleState muscle = muscle_state(state, m);
    const TensionDerivatives slopes = contraction().tension_derivatives(m, muscle);
    by_length[i] = slopes.by_length;
    rest[i] = slopes.by_activation *
                  activation_rate(excitation[i], state.activation[i], model_.activation) +
              slopes.by_projected_fibre * contraction().projected_fibre_rate(m, muscle);
  }
  // Compliance of the net, and the linear system for excursion'.
  out.G = tendons().compliance(state.q, now.tension, now.pull);
  out.A = out.G * by_length.asDiagonal();
  out.A.diagonal().array() += 1;
  // Correction of drift, then the solution.
  out.excursion -= kBaumgarteRate * drift(state, now);
  out.excursion = out.A.partialPivLu().solve(out.excursion - out.G * rest);
  out.tension = by_length.cwiseProduct(out.excursion) + rest;
  return out;
}

MotionState FingerMotion::slope(const MotionState& state, const VectorXd& excitation) {
  // A trial state far off: an infinite rate makes the integrator take a shorter step.
  const MotionInstant now = at(state);
  if (!now.pull.tau.allFinite() || !now.tension.allFinite())
    return unpack(VectorXd::Constant(pack(state).size(), HUGE_VAL));
  // Torque of tendons, resistance and damping.
  const VectorXd damped = damping_.cwiseProduct(state.q_dot);
  const VectorXd tau =
      now.pull.tau +
      resistance_torque(model_.tendons.digit().skeleton, model_.resistance, state.q) - damped;
  MotionState rate = state;
  // Bones, activations, fibres, excursions, energies.
  rate.q = state.q_dot;
  rate.q_dot = multibody_.forward_dynamics({state.q, state.q_dot}, tau, {model_.gravity, {}});
  for (int m = 0; m < excitation.size(); ++m) {
    rate.activation[m] = activation_rate(excitation[m], state.activation[m], model_.activation);
    if (rate.projected_fibre.size() > 0)
      rate.projected_fibre[m] = contraction().projected_fibre_rate(m, muscle_state(state, m));
  }
  rate.excursion = tension_rate(state, now, excitation).excursion;
  rate.work = now.pull.tau.dot(state.q_dot);
  rate.dissipated = damped.dot(state.q_dot);
  return rate;
}

FingerMotion::Accepted FingerMotion::accept(const MotionState& state) {
  const MotionInstant now = at(state);
  last_nodes_ = now.pull.nodes;
  if (slack_length_.size() == 0) return {now.pull.warning, {}};
  const VectorXd drift = this->drift(state, now);
  return {now.pull.warning, (now.tension.array() <= base_tension_ + kPulls).select(0, drift)};
}

double FingerMotion::energy(const MotionState& state) {
  const Skeleton& skeleton = model_.tendons.digit().skeleton;
  return kinetic_energy(state) + weight_energy(skeleton, state.q, model_.gravity) +
         resistance_energy(skeleton, model_.resistance, state.q);
}

double FingerMotion::kinetic_energy(const MotionState& state) {
  return multibody_.kinetic_energy({state.q, state.q_dot});
}

// NOLINTNEXTLINE(readability-convert-member-functions-to-static): the inverse of unpack()
VectorXd FingerMotion::pack(const MotionState& state) const {
  VectorXd y(2 * state.q.size() + 2 * state.activation.size() + state.projected_fibre.size() + 2);
  y << state.q, state.q_dot, state.activation, state.excursion, state.projected_fibre, state.work,
      state.dissipated;
  return y;
}

MotionState FingerMotion::unpack(const VectorXd& y) const {
  Index next = 0;
  const auto take = [&](Index size) -> VectorXd {
    next += size;
    return y.segment(next - size, size);
  };
  const Index joints = damping_.size(), muscles = muscles_;
  MotionState state;
  state.q = take(joints);
  state.q_dot = take(joints);
  state.activation = take(muscles);
  state.excursion = take(muscles);
  state.projected_fibre = take(contraction().has_fibre_state() ? muscles : 0);
  state.work = y[next];
  state.dissipated = y[next + 1];
  return state;
}

VectorXd FingerMotion::scale() const {
  const Index joints = damping_.size(), muscles = muscles_;
  const VectorXd one = VectorXd::Ones(joints), each = VectorXd::Ones(muscles);
  const VectorXd projected_fibre =
      contraction().has_fibre_state() ? VectorXd(0.01 * each) : VectorXd();
  return pack({one, one, each, 0.01 * each, projected_fibre, 1e-3, 1e-3});
}

}  // namespace thenar

// Slopes of the equations of motion, for the integrator.

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// How moment arms and what tendons give change: d(R q' + G t')/d. at fixed q' and t', one column a
/// posture angle or tension.
struct ArmRateDerivatives {
  MatrixXd by_q, by_t;  // (muscles, coordinates) [m/s/rad], (muscles, muscles) [m/s/N]
};

/// Differences of what is itself a slope.
/// @param t      tensions [N] (muscles)
/// @param t_dot  their rates [N/s] (muscles)
ArmRateDerivatives arm_derivatives(const DigitTendons& tendons, const MotionState& state,
                                   const VectorXd& t, const VectorXd& t_dot,
                                   const TendonTorque& here) {
  constexpr double kStep = 1e-5;               // of an angle [rad]
  constexpr double kPart = 1e-3, kMin = 0.01;  // of a tension and [N]
  const Index joints = state.q.size(), muscles = t.size();
  const bool net = tendons.digit().fidelity.hood == Hood::kFloatingNet;
  // The quantity whose derivative is sought: R q' + G t'.
  const auto rate = [&](const VectorXd& q, const VectorXd& at, const TendonTorque& pull) {
    VectorXd v = pull.R * state.q_dot;
    if (net) v += tendons.compliance(q, at, pull) * t_dot;
    return v;
  };
  const VectorXd v = rate(state.q, t, here);
  ArmRateDerivatives out{MatrixXd(muscles, joints), MatrixXd::Zero(muscles, muscles)};
  // One column for each angle.
  for (Index j = 0; j < joints; ++j) {
    VectorXd q = state.q;
    q[j] += kStep;
    out.by_q.col(j) = (rate(q, t, tendons.evaluate(q, t, here.nodes)) - v) / kStep;
  }
  // With a net, one column for each tension.
  for (Index m = 0; net && m < muscles; ++m) {
    VectorXd more = t;
    more[m] += kPart * (t[m] + kMin);
    const TendonTorque pull = tendons.evaluate(state.q, more, here.nodes);
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
    // Central differences by an angle, then by a speed.
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
  // The instant, its rates, and derivatives of the arms.
  const MotionInstant now = at(state);
  const MatrixXd& R = now.pull.R;
  const TensionRate rate = tension_rate(state, now, excitation);
  const ArmRateDerivatives arms =
      arm_derivatives(tendons(), state, now.tension, rate.tension, now.pull);

  // Tensions by all states, the way through R q' apart; and their rates, but by that of excursion.
  MatrixXd t_y = MatrixXd::Zero(m, size), J = MatrixXd::Zero(size, size), rest_y = t_y;
  VectorXd by_velocity(m);
  for (Index i = 0; i < m; ++i) {
    const int k = static_cast<int>(i);
    MuscleState muscle = muscle_state(state, k);
    if (contraction().depends_on_velocity()) muscle.velocity = -R.row(i).dot(state.q_dot);
    const TensionDerivatives slopes = contraction().tension_derivatives(k, muscle);
    by_velocity[i] = slopes.by_velocity;
    t_y(i, a + i) = slopes.by_activation;
    t_y(i, e + i) = slopes.by_length;
    if (state.projected_fibre.size() > 0) {
      t_y(i, r + i) = slopes.by_projected_fibre;
      const FibreRateDerivatives projected_fibre = contraction().fibre_rate_derivatives(k, muscle);
      J(r + i, a + i) = projected_fibre.by_activation;
      J(r + i, e + i) = projected_fibre.by_length;
      J(r + i, r + i) = projected_fibre.by_projected_fibre;
      rest_y.row(i) = slopes.by_projected_fibre * J.row(r + i);
      // A tendon's stiffness depends on length - projected_fibre.
      MuscleState longer = muscle;
      longer.length += kStretch;
      const double bend =
          (contraction().tension_derivatives(k, longer).by_length - slopes.by_length) / kStretch;
      const double turn =
          bend * (rate.excursion[i] - contraction().projected_fibre_rate(k, muscle));
      rest_y(i, e + i) += turn;
      rest_y(i, r + i) -= turn;
    }
    J(a + i, a + i) =
        activation_rate_derivative(excitation[i], state.activation[i], model_.activation);
    rest_y(i, a + i) += slopes.by_activation * J(a + i, a + i);
  }

  // R q' by all states, and what tendons give; for a net by tensions, too.
  MatrixXd v_y = MatrixXd::Zero(m, size), tau_y = MatrixXd::Zero(n, size);
  v_y.leftCols(n) = arms.by_q;
  v_y.middleCols(n, n) = R;
  v_y += arms.by_t * t_y;
  t_y -= by_velocity.asDiagonal() * v_y;
  if (slack_length_.size() > 0) {  // excursions that have strayed return
    v_y.leftCols(n) += kBaumgarteRate * R;
    v_y.middleCols(e, m).diagonal().array() += kBaumgarteRate;
    v_y += kBaumgarteRate * rate.G * t_y;
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
  tau_y.leftCols(n).diagonal() += resistance_derivative(skeleton, model_.resistance, state.q);
  tau_y.middleCols(n, n).diagonal() -= damping_;
  J.block(0, n, n, n).setIdentity();
  J.block(n, 0, n, size) = multibody_.mass_matrix(state.q).llt().solve(tau_y);
  const VectorXd tau = now.pull.tau + resistance_torque(skeleton, model_.resistance, state.q) -
                       damping_.cwiseProduct(state.q_dot);
  J.block(n, 0, n, 2 * n) +=
      acceleration_slopes(state, [&](const VectorXd& q, const VectorXd& q_dot) {
        return multibody_.forward_dynamics({q, q_dot}, tau, {model_.gravity, {}});
      });
  return J;
}

}  // namespace thenar
