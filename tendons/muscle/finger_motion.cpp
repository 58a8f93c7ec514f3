#include "tendons/muscle/finger_motion.h"

#include <Eigen/Cholesky>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Tension above the base tension below which a muscle is slack [N]
constexpr double kPullingTension = 1e-3;

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
  // Check that the muscles of the contraction are those of the digit, in its order.
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
  // Check shapes and ranges.
  const Index joints = damping_.size(), muscles = muscles_;
  require(q.size() == joints && q_dot.size() == joints && activation.size() == muscles,
          "wanted {} angles, {} speeds, {} activations; got {}, {}, {}", joints, joints, muscles,
          q.size(), q_dot.size(), activation.size());
  require(q.allFinite() && q_dot.allFinite(), "the start has an angle or speed that is not finite");
  for (Index m = 0; m < muscles; ++m)
    require(activation[m] >= 0 && activation[m] <= 1,
            "wanted activations from 0 to 1, got {} of muscle number {}", activation[m], m + 1);
  follower_ = tendons().follower();
  on_tendons_ = false;
  // Compute the excursion from the reference posture.
  const Excursion way =
      excursion(tendons(), VectorXd::Zero(joints), q, VectorXd::Ones(muscles));  // [N]
  const std::string warning = way.warning.empty() ? "" : "on the way to the start: " + way.warning;
  MotionState state{q, q_dot, activation, way.e, {}, 0, 0};
  // Balance fibres with their tendons.
  if (contraction().has_fibre_state()) {
    VectorXd projected_fibre(muscles);
    for (int m = 0; m < muscles; ++m)
      projected_fibre[m] = contraction().isometric_projected_fibre(
          m, activation[m], muscle_state(state, state.excursion, m).length);
    state.projected_fibre = projected_fibre;
  }
  // Store the line lengths at zero excursion, and switch to elastic tendons if possible.
  if (has_net(model_)) {
    const MotionInstant now = instant_at(state);
    slack_length_ = tendons().lengths(q, now.tension, now.pull) - state.excursion;
    switch_to_tendons(state, now);
  }
  return {state, warning};
}

void FingerMotion::switch_to_tendons(MotionState& state, const MotionInstant& now) {
  if (!contraction().has_fibre_state()) return;
  std::vector<std::shared_ptr<const TensionLaw>> laws;
  for (int m = 0; m < muscles_; ++m) laws.push_back(contraction().tendon_law(m, base_tension_));
  auto follower =
      tendons().follower_on_tendons({laws, state.q, tendon_ends(state.projected_fibre), now.pull});
  if (!follower) return;
  follower_ = std::move(follower);
  on_tendons_ = true;
  state.excursion.resize(0);
}

VectorXd FingerMotion::tendon_ends(const VectorXd& projected_fibre) const {
  VectorXd ends = slack_length_ + projected_fibre;
  for (Index m = 0; m < muscles_; ++m)
    ends[m] -= musculotendon_length_at_optimum(contraction().muscles()[m]);
  return ends;
}

VectorXd FingerMotion::line_excursion(const MotionState& state, const MotionInstant& now) const {
  return tendons().lengths(state.q, now.tension, now.pull) - slack_length_;
}

MuscleState FingerMotion::muscle_state(const MotionState& state, const VectorXd& excursion,
                                       int m) const {
  const Musculotendon& muscle = contraction().muscles()[m];
  const double projected_fibre = state.projected_fibre.size() > 0 ? state.projected_fibre[m] : 0;
  return {state.activation[m], musculotendon_length_at_optimum(muscle) + excursion[m], 0,
          projected_fibre};
}

VectorXd FingerMotion::tension(const MotionState& state, const VectorXd& velocity) const {
  return VectorXd::NullaryExpr(muscles_, [&](Index m) {
    MuscleState muscle = muscle_state(state, state.excursion, static_cast<int>(m));
    muscle.velocity = velocity[m];
    return base_tension_ + contraction().tension(static_cast<int>(m), muscle);
  });
}

TendonTorque FingerMotion::tendon_torque(const VectorXd& q, const VectorXd& t) const {
  return follower_ ? follower_->torque_at(q, t) : tendons().evaluate(q, t, {});
}

VectorXd FingerMotion::fibres(const MotionState& state, const VectorXd& excursion) const {
  return VectorXd::NullaryExpr(muscles_, [&](Index m) {
    return contraction().fibre(static_cast<int>(m),
                               muscle_state(state, excursion, static_cast<int>(m)));
  });
}

MotionInstant FingerMotion::rejected_instant(MotionInstant now) const {
  now.pull.tau = VectorXd::Constant(damping_.size(), HUGE_VAL);
  now.pull.R = Eigen::MatrixXd::Zero(muscles_, damping_.size());
  return now;
}

MotionInstant FingerMotion::instant_at(const MotionState& state) const {
  const VectorXd none = VectorXd::Zero(muscles_);
  MotionInstant now;
  // Take lengths and tensions from the common equilibrium of net and elastic tendons.
  if (on_tendons_) {
    const VectorXd ends = tendon_ends(state.projected_fibre);
    now.excursion = now.tension = VectorXd::Constant(muscles_, HUGE_VAL);
    now.fibre = fibres(state, none);
    if (!ends.allFinite() || !state.q.allFinite()) return rejected_instant(std::move(now));
    now.pull = follower_->torque_at(state.q, ends);
    if (!now.pull.tau.allFinite()) return now;
    now.tension = now.pull.tension;
    now.excursion = now.pull.length - slack_length_;
    return now;
  }
  now.excursion = state.excursion;
  now.fibre = fibres(state, now.excursion);
  // Compute tensions; with rigid tendons they need velocities from arms without tension.
  const bool needs_velocity = contraction().depends_on_velocity();
  now.tension = tension(
      state, needs_velocity ? VectorXd(-tendon_torque(state.q, none).R * state.q_dot) : none);
  if (!now.tension.allFinite()) return rejected_instant(std::move(now));
  // Compute torque and arms at these tensions.
  now.pull = tendon_torque(state.q, now.tension);
  return now;
}

VectorXd FingerMotion::excursion_rate(const MotionState& state, const MotionInstant& now) const {
  const VectorXd by_posture = -now.pull.R * state.q_dot;
  if (!has_net(model_)) return by_posture;
  return by_posture + kFollowRate * (line_excursion(state, now) - state.excursion);
}

MotionState FingerMotion::slope(const MotionState& state, const VectorXd& excitation) {
  // Reject a trial state without torque: an infinite rate makes the integrator shorten its step.
  const MotionInstant now = instant_at(state);
  effort_ += now.pull.effort;
  obstacle_.clear();
  if (!now.pull.tau.allFinite() || !now.tension.allFinite()) {
    obstacle_ = now.pull.warning;
    return unpack(VectorXd::Constant(pack(state).size(), HUGE_VAL));
  }
  // Sum the torques of tendons, resistance and damping.
  const VectorXd damped = damping_.cwiseProduct(state.q_dot);
  const VectorXd tau =
      now.pull.tau +
      resistance_torque(model_.tendons.digit().skeleton, model_.resistance, state.q) - damped;
  MotionState rate = state;
  // Compute the rates of bones, activations, fibres, excursions and energies.
  rate.q = state.q_dot;
  rate.q_dot = multibody_.forward_dynamics({state.q, state.q_dot}, tau, {model_.gravity, {}});
  for (int m = 0; m < excitation.size(); ++m) {
    rate.activation[m] =
        activation_rate(excitation[m], state.activation[m], model_.activation).rate;
    if (rate.projected_fibre.size() > 0)
      rate.projected_fibre[m] =
          contraction().projected_fibre_rate(m, muscle_state(state, now.excursion, m));
  }
  if (!on_tendons_) rate.excursion = excursion_rate(state, now);
  rate.work = now.pull.tau.dot(state.q_dot);
  rate.dissipated = damped.dot(state.q_dot);
  return rate;
}

bool FingerMotion::snaps_before(const MotionState& state) const {
  if (!follower_) return false;
  (void)instant_at(state);
  return follower_->snapped();
}

FingerMotion::Accepted FingerMotion::accept(const MotionState& state) {
  const MotionInstant now = instant_at(state);
  effort_ += now.pull.effort;
  Accepted out;
  out.warning = now.pull.warning;
  if (follower_) out.net = follower_->accept(state.q, load(state, now));
  if (!has_net(model_) || on_tendons_) return out;
  // Compare excursions of muscles that pull with the lengths of their lines.
  const VectorXd drift = state.excursion - line_excursion(state, now);
  out.drift = (now.tension.array() <= base_tension_ + kPullingTension).select(0, drift);
  return out;
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
  VectorXd y(2 * state.q.size() + state.activation.size() + state.excursion.size() +
             state.projected_fibre.size() + 2);
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
  state.excursion = take(on_tendons_ ? 0 : muscles);
  state.projected_fibre = take(contraction().has_fibre_state() ? muscles : 0);
  state.work = y[next];
  state.dissipated = y[next + 1];
  return state;
}

VectorXd FingerMotion::scale() const {
  const Index joints = damping_.size(), muscles = muscles_;
  const VectorXd one = VectorXd::Ones(joints), each = VectorXd::Ones(muscles);
  const VectorXd length = 0.01 * each;
  return pack({one, one, each, on_tendons_ ? VectorXd() : length,
               contraction().has_fibre_state() ? length : VectorXd(), 1e-3, 1e-3});
}

// Jacobian of the equations of motion, for the integrator.

namespace {

using Eigen::MatrixXd;

/// Computes d(R q')/dq at fixed q' and tensions t, by finite differences of R, itself a derivative
/// [m/s/rad] (muscles, coordinates).
MatrixXd arm_derivatives(const DigitTendons& tendons, const MotionState& state, const VectorXd& t,
                         const TendonTorque& here) {
  constexpr double kDifferenceStep = 1e-5;  // step of an angle [rad]
  const VectorXd v = here.R * state.q_dot;
  MatrixXd by_q(t.size(), state.q.size());
  for (Index j = 0; j < state.q.size(); ++j) {
    VectorXd q = state.q;
    q[j] += kDifferenceStep;
    by_q.col(j) = (tendons.evaluate(q, t).R * state.q_dot - v) / kDifferenceStep;
  }
  return by_q;
}

/// Computes the derivatives of the bones' acceleration at fixed torques by central differences: one
/// column per posture angle, then one per speed [1/s^2] and [1/s] (coordinates, 2 coordinates).
template <typename Acceleration>
MatrixXd acceleration_slopes(const MotionState& state, const Acceleration& bones) {
  constexpr double kDifferenceStep =
      1e-5;  // step of an angle [rad]; of a speed, over 1 rad/s plus the largest speed
  const Index n = state.q.size();
  const double speed_step = kDifferenceStep * (1 + state.q_dot.cwiseAbs().maxCoeff());
  MatrixXd slopes(n, 2 * n);
  for (Index j = 0; j < n; ++j) {
    // Take differences by an angle, then by a speed.
    const VectorXd one = VectorXd::Unit(n, j);
    slopes.col(j) = (bones(state.q + kDifferenceStep * one, state.q_dot) -
                     bones(state.q - kDifferenceStep * one, state.q_dot)) /
                    (2 * kDifferenceStep);
    slopes.col(n + j) = (bones(state.q, state.q_dot + speed_step * one) -
                         bones(state.q, state.q_dot - speed_step * one)) /
                        (2 * speed_step);
  }
  return slopes;
}

}  // namespace

/// Fills the rows of fibres and excursions in J, and returns the derivative of the tendon torque by
/// all states (coordinates, states). Tensions follow from states.
MatrixXd FingerMotion::state_jacobian(const MotionState& state, const MotionInstant& now,
                                      MatrixXd& J) const {
  const Index n = state.q.size(), m = muscles_, size = J.rows();
  const Index a = 2 * n, e = a + m, r = e + m;
  const MatrixXd& R = now.pull.R;
  // Differentiate tensions by all states, except through R q'.
  MatrixXd t_y = MatrixXd::Zero(m, size);
  VectorXd by_velocity(m);
  for (Index i = 0; i < m; ++i) {
    const int k = static_cast<int>(i);
    MuscleState muscle = muscle_state(state, state.excursion, k);
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
    }
  }

  // Differentiate excursions,  -R q',  on which tensions may depend; under a net they follow its
  // lines, so fast that derivatives of R are negligible.
  J.block(e, n, m, n) = -R;
  if (has_net(model_)) {
    J.middleRows(e, m) -=
        kFollowRate * (tendons().compliance(state.q, now.tension, now.pull) * t_y);
    J.block(e, 0, m, n) -= kFollowRate * R;
    J.block(e, e, m, m).diagonal().array() -= kFollowRate;
  } else {
    J.block(e, 0, m, n) = -arm_derivatives(tendons(), state, now.tension, now.pull);
    t_y += by_velocity.asDiagonal() * J.middleRows(e, m);
  }

  // Differentiate the torques of the tendons.
  MatrixXd tau_y = R.transpose() * t_y;
  tau_y.leftCols(n) += tendons().torque_by_posture(state.q, now.tension, now.pull);
  return tau_y;
}

/// Fills the same rows where tensions and lengths follow from the far ends of tendons.
MatrixXd FingerMotion::jacobian_on_tendons(const MotionState& state, const MotionInstant& now,
                                           MatrixXd& J) const {
  const Index n = state.q.size(), m = muscles_, a = 2 * n, r = a + m;
  const EndSlopes slopes = follower_->slopes(state.q, tendon_ends(state.projected_fibre));
  for (Index i = 0; i < m; ++i) {
    const int k = static_cast<int>(i);
    const FibreRateDerivatives rate =
        contraction().fibre_rate_derivatives(k, muscle_state(state, now.excursion, k));
    J(r + i, a + i) = rate.by_activation;
    J.row(r + i).head(n) = rate.by_length * slopes.length_by_posture.row(i);
    J.row(r + i).segment(r, m) = rate.by_length * slopes.length_by_end.row(i);
    J(r + i, r + i) += rate.by_projected_fibre;
  }
  MatrixXd tau_y = MatrixXd::Zero(n, J.rows());
  tau_y.leftCols(n) = slopes.torque_by_posture;
  tau_y.middleCols(r, m) = slopes.torque_by_end;
  return tau_y;
}

MatrixXd FingerMotion::jacobian(const MotionState& state, const VectorXd& excitation) {
  const Index n = state.q.size(), m = muscles_, size = pack(state).size();
  const Index a = 2 * n;
  const Skeleton& skeleton = model_.tendons.digit().skeleton;
  // Evaluate the state, and fill the rows of activations, fibres, excursions and energies.
  const MotionInstant now = instant_at(state);
  effort_ += now.pull.effort;
  if (!now.pull.tau.allFinite()) return MatrixXd::Constant(size, size, HUGE_VAL);
  MatrixXd J = MatrixXd::Zero(size, size);
  for (Index i = 0; i < m; ++i)
    J(a + i, a + i) =
        activation_rate(excitation[i], state.activation[i], model_.activation).by_activation;
  MatrixXd tau_y = on_tendons_ ? jacobian_on_tendons(state, now, J) : state_jacobian(state, now, J);
  J.row(size - 2) = state.q_dot.transpose() * tau_y;
  J.row(size - 2).segment(n, n) += now.pull.tau.transpose();
  J.row(size - 1).segment(n, n) = 2 * damping_.cwiseProduct(state.q_dot).transpose();

  // Fill the rows of bones, under the torques of tendons, joint resistance and damping.
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
