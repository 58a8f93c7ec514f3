#include "tendons/muscle/finger_motion.h"

#include <cmath>

#include <Eigen/LU>

#include "base/error.h"
#include "tendons/muscle/excursion.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kPulls = 1e-3;  // beyond its tonus; less is slack [N]

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
      blended_(model.tendons.blended(model.blend)),
      softened_(has_net(model) ? model.contraction.softened(kRigidStrain) : nullptr),
      multibody_(model.tendons.digit().skeleton, Passive::kOff),
      damping_(joint_damping(model.tendons.digit().skeleton, model.resistance)),
      tonus_(has_net(model) ? model.tonus : 0),
      muscles_(muscles_of(model)) {
  require(model.tonus >= 0 && model.tonus < 1e3, "tonus must be >= 0, and little, got {} N",
          model.tonus);
  require(model.gravity.allFinite(), "gravity has an entry that is not finite");
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
  const Index joints = damping_.size(), muscles = muscles_;
  require(q.size() == joints && q_dot.size() == joints && activation.size() == muscles,
          "wanted {} angles, {} speeds, {} activations; got {}, {}, {}", joints, joints, muscles,
          q.size(), q_dot.size(), activation.size());
  require(q.allFinite() && q_dot.allFinite(), "the start has an angle or speed that is not finite");
  require((activation.array() >= 0 && activation.array() <= 1).all(),
          "activations must be in 0..1");
  last_nodes_.resize(3, 0);  // of another motion
  const Excursion way =
      excursion(tendons(), VectorXd::Zero(joints), q, VectorXd::Ones(muscles));  // [N]
  const std::string trouble = way.trouble.empty() ? "" : "on the way to the start: " + way.trouble;
  MotionState state{q, q_dot, activation, way.e, {}, 0, 0};
  if (contraction().has_reach()) {
    VectorXd reach(muscles);
    for (int m = 0; m < muscles; ++m)
      reach[m] = contraction().reach_at_rest(m, activation[m], muscle_state(state, m).length);
    state.reach = reach;
  }
  slack_length_.resize(0);
  if (has_net(model_) && tendons().digit().model.friction.isZero(0)) {
    const MotionInstant now = at(state);
    slack_length_ = tendons().lengths(q, now.tension, now.pull) - state.excursion;
  }
  return {state, trouble};
}

VectorXd FingerMotion::stray(const MotionState& state, const MotionInstant& now) const {
  if (slack_length_.size() == 0) return VectorXd::Zero(muscles_);
  return state.excursion + slack_length_ - tendons().lengths(state.q, now.tension, now.pull);
}

MuscleState FingerMotion::muscle_state(const MotionState& state, int m) const {
  const Musculotendon& muscle = contraction().muscles()[static_cast<std::size_t>(m)];
  const double reach = state.reach.size() > 0 ? state.reach[m] : 0;
  return {state.activation[m], optimal_length(muscle) + state.excursion[m], 0, reach};
}

VectorXd FingerMotion::tension(const MotionState& state, const VectorXd& velocity) const {
  return VectorXd::NullaryExpr(muscles_, [&](Index m) {
    MuscleState muscle = muscle_state(state, static_cast<int>(m));
    muscle.velocity = velocity[m];
    return tonus_ + contraction().tension(static_cast<int>(m), muscle);
  });
}

MotionInstant FingerMotion::at(const MotionState& state) const {
  const DigitTendons& tendons = this->tendons();
  const VectorXd none = VectorXd::Zero(muscles_);
  MotionInstant now;
  now.fibre = VectorXd::NullaryExpr(muscles_, [&](Index m) {
    return contraction().fibre(static_cast<int>(m), muscle_state(state, static_cast<int>(m)));
  });
  const bool feels = contraction().feels_velocity();
  now.tension = tension(
      state, feels ? VectorXd(-tendons.pull(state.q, none, last_nodes_).R * state.q_dot) : none);
  if (!now.tension.allFinite()) {  // a trial of the integrator far off: it takes a shorter step
    const Index joints = state.q.size();
    now.pull.tau = VectorXd::Constant(joints, HUGE_VAL);
    now.pull.R = Eigen::MatrixXd::Zero(muscles_, joints);
    return now;
  }
  now.pull = tendons.pull(state.q, now.tension, last_nodes_);
  return now;
}

FingerMotion::TensionRate FingerMotion::tension_rate(const MotionState& state,
                                                     const MotionInstant& now,
                                                     const VectorXd& excitation) const {
  TensionRate out;
  out.excursion = -now.pull.R * state.q_dot;
  if (!has_net(model_)) return out;
  VectorXd by_length(muscles_), rest(muscles_);
  for (Index i = 0; i < muscles_; ++i) {
    const int m = static_cast<int>(i);
    const MuscleState muscle = muscle_state(state, m);
    const TensionSlopes slopes = contraction().tension_slopes(m, muscle);
    by_length[i] = slopes.by_length;
    rest[i] = slopes.by_activation *
                  activation_rate(excitation[i], state.activation[i], model_.activation) +
              slopes.by_reach * contraction().reach_rate(m, muscle);
  }
  out.G = tendons().give(state.q, now.tension, now.pull);
  out.A = out.G * by_length.asDiagonal();
  out.A.diagonal().array() += 1;
  out.excursion -= kReturn * stray(state, now);
  out.excursion = out.A.partialPivLu().solve(out.excursion - out.G * rest);
  out.tension = by_length.cwiseProduct(out.excursion) + rest;
  return out;
}

MotionState FingerMotion::slope(const MotionState& state, const VectorXd& excitation) {
  const MotionInstant now = at(state);
  if (!now.pull.tau.allFinite() || !now.tension.allFinite())
    return unpack(VectorXd::Constant(pack(state).size(), HUGE_VAL));
  const VectorXd damped = damping_.cwiseProduct(state.q_dot);
  const VectorXd tau = now.pull.tau +
                       holding_torque(model_.tendons.digit().skeleton, model_.resistance, state.q) -
                       damped;
  MotionState rate = state;
  rate.q = state.q_dot;
  rate.q_dot = multibody_.forward_dynamics({state.q, state.q_dot}, tau, {model_.gravity, {}});
  for (int m = 0; m < excitation.size(); ++m) {
    rate.activation[m] = activation_rate(excitation[m], state.activation[m], model_.activation);
    if (rate.reach.size() > 0) rate.reach[m] = contraction().reach_rate(m, muscle_state(state, m));
  }
  rate.excursion = tension_rate(state, now, excitation).excursion;
  rate.work = now.pull.tau.dot(state.q_dot);
  rate.lost = damped.dot(state.q_dot);
  return rate;
}

FingerMotion::Accepted FingerMotion::accept(const MotionState& state) {
  const MotionInstant now = at(state);
  last_nodes_ = now.pull.nodes;
  const VectorXd stray = this->stray(state, now);
  return {now.pull.trouble, (now.tension.array() <= tonus_ + kPulls).select(0, stray)};
}

double FingerMotion::energy(const MotionState& state) {
  const Skeleton& skeleton = model_.tendons.digit().skeleton;
  return kinetic_energy(state) + weight_energy(skeleton, state.q, model_.gravity) +
         holding_energy(skeleton, model_.resistance, state.q);
}

double FingerMotion::kinetic_energy(const MotionState& state) {
  return multibody_.kinetic_energy({state.q, state.q_dot});
}

VectorXd FingerMotion::pack(const MotionState& state) const {
  VectorXd y(2 * state.q.size() + 2 * state.activation.size() + state.reach.size() + 2);
  y << state.q, state.q_dot, state.activation, state.excursion, state.reach, state.work, state.lost;
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
  state.reach = take(contraction().has_reach() ? muscles : 0);
  state.work = y[next];
  state.lost = y[next + 1];
  return state;
}

VectorXd FingerMotion::scale() const {
  const Index joints = damping_.size(), muscles = muscles_;
  const VectorXd one = VectorXd::Ones(joints), each = VectorXd::Ones(muscles);
  const VectorXd reach = contraction().has_reach() ? VectorXd(0.01 * each) : VectorXd();
  return pack({one, one, each, 0.01 * each, reach, 1e-3, 1e-3});
}

}  // namespace thenar
