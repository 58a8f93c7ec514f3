#include "dynamics/human/digit_pull.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/LU>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Changes of posture and tension above which the posture stiffness is updated
constexpr double kStiffnessUpdateAngle = 0.02;   // change of an angle [rad]
constexpr double kStiffnessUpdateTension = 0.1;  // relative change of a tension [1],
constexpr double kTensionFloor = 0.1;            // plus this absolute change [N]
constexpr double kBaumgarteRate = 1e3;  // decay rate of the error of a net's excursions [1/s]
constexpr double kRestRate = 1e-9;      // largest rate at rest: activation, fibre lengths [1/s]

VectorXd gathered(const VectorXd& from, const std::vector<int>& indices) {
  VectorXd out;
  gather(from, indices, out);
  return out;
}

/// Returns which muscles contract: those without a given tension (muscles).
std::vector<bool> contracting_muscles(const DigitPullModel& model) {
  std::vector<bool> out(model.tendons->muscles().size(), model.contraction != nullptr);
  for (const MuscleSchedule& given : model.tensions) out[given.muscle] = false;
  return out;
}

/// Checks indices, schedules and contraction against the tendons.
/// @throws InputError as DigitPull.
void check_model(const DigitPullModel& model) {
  const TendonGroup& group = *model.tendons;
  const std::size_t joints = group.coordinates().size();
  require(model.indices.q.size() == joints && model.indices.v.size() == joints,
          "'{}' has {} joints, got {} places", model.name, joints, model.indices.q.size());
  check_schedules(model.tensions, group.muscles(), std::numeric_limits<double>::max(), model.name,
                  "tension");
  check_schedules(model.excitations, group.muscles(), 1, model.name, "excitation");
  const std::vector<bool> contracts = contracting_muscles(model);
  for (const MuscleSchedule& each : model.excitations)
    require(contracts[each.muscle], "'{}' has a tension or cannot contract, and is excited",
            group.muscles()[each.muscle]);
  // Check that the contraction has the same muscles.
  if (!model.contraction) return;
  const std::vector<Musculotendon>& muscles = model.contraction->muscles();
  require(muscles.size() == group.muscles().size(), "{} muscles contract, '{}' has {}",
          muscles.size(), model.name, group.muscles().size());
  for (std::size_t m = 0; m < muscles.size(); ++m)
    require(muscles[m].name == group.muscles()[m],
            "muscle {} contracts as '{}', '{}' calls it '{}'", m, muscles[m].name, model.name,
            group.muscles()[m]);
}

/// Returns the layout of the states: activation, and excursion and fibre where tension depends on
/// them.
/// @param contraction  null: no muscle contracts
MuscleLayout muscle_layout(const DigitPullModel& model, const Contraction* contraction) {
  MuscleLayout out;
  out.contracts = contracting_muscles(model);
  out.total = static_cast<Index>(out.contracts.size());
  if (contraction == nullptr) return out;
  // List the contracting muscles, and store the lengths that scale the states.
  out.fibre_length.resize(out.total);
  out.length_at_optimum.resize(out.total);
  for (int m = 0; m < out.total; ++m) {
    if (out.contracts[m]) out.contracting.push_back(m);
    const Musculotendon& muscle = contraction->muscles()[m];
    out.fibre_length[m] = muscle.optimal_fibre_length;
    out.length_at_optimum[m] = musculotendon_length_at_optimum(muscle);
  }
  // Select the states.
  out.has_fibre = contraction->has_fibre_state();
  out.depends_on_velocity = !out.contracting.empty() && contraction->depends_on_velocity();
  out.has_excursion = out.has_fibre || contraction->depends_on_velocity();
  out.states = static_cast<Index>(out.contracting.size()) *
               (1 + (out.has_excursion ? 1 : 0) + (out.has_fibre ? 1 : 0));
  return out;
}

}  // namespace

DigitPull::DigitPull(DigitPullModel model)
    : model_(std::make_shared<const DigitPullModel>(std::move(model))),
      tension_pieces_(model_->tendons->muscles().size()),
      excitation_pieces_(model_->tendons->muscles().size()) {
  check_model(*model_);
  // Smooth the bands of a net, as in FingerMotion; tendons without a net have moment arms alone.
  const TendonGroup& group = *model_->tendons;
  const bool net = group.has_net();
  if (net) blended_ = std::make_shared<const TendonGroup>(group.smoothed(model_->blend));
  if (!net) arms_.emplace(group);
  // Give a contraction on a net compliant tendons.
  const bool may_contract = model_->contraction != nullptr;
  if (may_contract && net) compliant_ = model_->contraction->with_compliant_tendon(kRigidStrain);
  if (may_contract) solver_.emplace(contraction());
  // Lay out the states, and initialize the values of all muscles.
  muscles_ = muscle_layout(*model_, may_contract ? &contraction() : nullptr);
  values_.excitation.setZero(muscles_.total);
  values_.excursion.setZero(muscles_.total);
  values_.state.clear(muscles_.total);
}

std::vector<std::string> DigitPull::state_names() const {
  // Order of the states: all activations, all excursions, all fibres.
  std::vector<std::string> names;
  for (const int m : muscles_.contracting) names.push_back("activation " + muscles()[m] + " [1]");
  for (const int m : muscles_.contracting)
    if (muscles_.has_excursion)
      names.push_back("excursion " + muscles()[m] + " [optimal fibre lengths]");
  for (const int m : muscles_.contracting)
    if (muscles_.has_fibre)
      names.push_back("projected fibre " + muscles()[m] + " [optimal fibre lengths]");
  return names;
}

VectorXd DigitPull::initial_states(const VectorXd& q) const {
  const auto count = static_cast<Index>(muscles_.contracting.size());
  VectorXd z = VectorXd::Zero(muscles_.states);
  if (!muscles_.has_excursion) return z;
  // Excursions from the reference posture, then fibre lengths in isometric equilibrium.
  const VectorXd excursion = tendons().excursion(gathered(q, model_->indices.q)).e;
  for (Index i = 0; i < count; ++i) {
    const int m = muscles_.contracting[i];
    z[count + i] = excursion[m] / muscles_.fibre_length[m];
    if (muscles_.has_fibre)
      z[2 * count + i] = contraction().isometric_projected_fibre(
                             m, 0, muscles_.length_at_optimum[m] + excursion[m]) /
                         muscles_.fibre_length[m];
  }
  return z;
}

std::string DigitPull::start_warning(const VectorXd& q) const {
  return muscles_.has_excursion ? tendons().excursion(gathered(q, model_->indices.q)).warning : "";
}

/// Computes the moment arms of tendons without a net, unless they are known at this posture. They
/// do not depend on tension.
void DigitPull::set_arms(const VectorXd& q) const {
  if (arms_q_.size() == q.size() && arms_q_ == q) return;
  arms_q_.setConstant(q.size(), std::numeric_limits<double>::quiet_NaN());  // if solve() throws
  arms_->solve(q, values_.torque);
  arms_q_ = q;
}

/// Returns true if the cached posture stiffness is valid at q and t: slopes of arms at nearby
/// postures, a stiffness without them at nearby tensions, too.
bool DigitPull::has_stiffness_near(const VectorXd& q, const VectorXd& t) const {
  if (cache_.stiffness_q.size() == 0) return false;
  for (Index i = 0; i < q.size(); ++i)
    if (!(std::abs(q[i] - cache_.stiffness_q[i]) < kStiffnessUpdateAngle)) return false;
  return cache_.arm_slopes.exist ||
         ((t - cache_.stiffness_t).array().abs() <
          kStiffnessUpdateTension * cache_.stiffness_t.array() + kTensionFloor)
             .all();
}

/// Computes the slopes of arms at a posture. @return false if they do not exist there
bool DigitPull::set_arm_slopes(const VectorXd& q) {
  if (has_net()) return false;
  arms_->slopes(q, cache_.arm_slopes);
  // Without slopes the cache is invalid until set_posture_stiffness().
  cache_.stiffness_q = cache_.arm_slopes.exist ? q : VectorXd();
  return cache_.arm_slopes.exist;
}

void DigitPull::set_posture_stiffness(const PullValues& values) {
  if (set_arm_slopes(values.q)) return;
  // Derivative of the torque by posture at constant tension, symmetric part.
  const MatrixXd by_posture = tendons().torque_by_posture(values.q, values.tension, values.torque);
  cache_.posture_stiffness = -0.5 * (by_posture + by_posture.transpose());
  cache_.stiffness_q = values.q;
  cache_.stiffness_t = values.tension;
}

/// Returns the parts of the action to compute: all parts for a net, which computes them together,
/// and in the first call, which has no cached stiffness.
ElementNeed DigitPull::effective_need(const ElementInput& at) const {
  return has_net() || cache_.stiffness_q.size() == 0 ? ElementNeed::kAll : at.need;
}

/// Returns true if positions, speeds and states of the element are finite.
bool DigitPull::has_finite_inputs(const ElementInput& at) const {
  // 0 times NaN or infinity is NaN; separate sums run in parallel.
  double of_q = 0, of_v = 0, of_z = 0;
  for (std::size_t c = 0; c < model_->indices.q.size(); ++c) {
    of_q += 0 * at.q[model_->indices.q[c]];
    of_v += 0 * at.v[model_->indices.v[c]];
  }
  const double* const z = at.z.data() + at.first_z;
  for (Index i = 0; i < muscles_.states; ++i) of_z += 0 * z[i];
  return of_q + of_v + of_z == 0;
}

/// Reads the states of contracting muscles.
void DigitPull::set_states(const ElementInput& at, PullValues& values) const {
  const auto count = static_cast<Index>(muscles_.contracting.size());
  const double* z = at.z.data() + at.first_z;
  for (Index i = 0; i < count; ++i) {
    const int m = muscles_.contracting[i];
    values.excitation[m] = excitation_pieces_.piece_of(m).value_at(at.t);
    values.state.activation[m] = z[i];
    if (!muscles_.has_excursion) continue;
    values.excursion[m] = z[count + i] * muscles_.fibre_length[m];
    values.state.length[m] = values.excursion[m] + muscles_.length_at_optimum[m];
    if (muscles_.has_fibre)
      values.state.projected_fibre[m] = z[2 * count + i] * muscles_.fibre_length[m];
  }
}

/// Computes the tensions, and for kAll their derivatives.
void DigitPull::set_tensions(double t, ElementNeed need, PullValues& values) const {
  // Solve the contraction, with derivatives if they are needed.
  if (!muscles_.contracting.empty()) {
    if (need == ElementNeed::kAll)
      solver_->solver().derivatives(values.state, values.contracted);
    else
      solver_->solver().tensions(values.state, values.contracted);
  }
  // Clear the derivatives of muscles that do not contract.
  for (int m = 0; need == ElementNeed::kAll && !muscles_.contracting.empty() && m < muscles_.total;
       ++m)
    if (!contracts(m))
      values.contracted.by_activation[m] = values.contracted.by_length[m] =
          values.contracted.by_velocity[m] = values.contracted.by_projected_fibre[m] = 0;
  // Total tension: contracted or given, plus the base tension of a net.
  const double base = has_net() ? model_->base_tension : 0;
  values.tension.resize(muscles_.total);
  for (int m = 0; m < muscles_.total; ++m)
    values.tension[m] = base + (contracts(m) ? values.contracted.tension[m]
                                             : tension_pieces_.piece_of(m).value_at(t));
}

const DigitPull::PullValues& DigitPull::evaluate(const ElementInput& at, ElementNeed need) const {
  // Read posture, schedules and states.
  PullValues& values = values_;
  gather(at.q, model_->indices.q, values.q);
  gather(at.v, model_->indices.v, values.q_dot);
  tension_pieces_.select(model_->tensions, at.selection_time);
  excitation_pieces_.select(model_->excitations, at.selection_time);
  set_states(at, values);
  // Without a net, compute the arms first, as tensions may depend on the lengthening rate.
  if (!has_net()) {
    set_arms(values.q);
    values.lengthening_rate.noalias() = -values.torque.R.lazyProduct(values.q_dot);
  }
  if (muscles_.depends_on_velocity)
    for (const int m : muscles_.contracting) values.state.velocity[m] = values.lengthening_rate[m];
  if (need == ElementNeed::kStates) return values;
  // Compute tensions, then the torque, by the equilibrium of a net or by the moment arms.
  set_tensions(at.t, need, values);
  if (!values.tension.allFinite()) return values;
  if (has_net()) {
    values.torque = tendons().evaluate(values.q, values.tension, cache_.nodes);
    values.lengthening_rate.noalias() = -values.torque.R * values.q_dot;
  } else {
    values.torque.tau.noalias() = values.torque.R.transpose().lazyProduct(values.tension);
  }
  return values;
}

bool DigitPull::add_action(const ElementInput& at, ElementAction& out) {
  // NaN efforts make the stepper retry with a shorter step.
  const std::vector<int>& v = model_->indices.v;
  const auto refuse = [&] {
    for (const int index : v) out.tau[index] = std::numeric_limits<double>::quiet_NaN();
    return false;
  };
  if (!has_finite_inputs(at)) return refuse();
  // Evaluate tendons and muscles.
  const ElementNeed need = effective_need(at);
  const PullValues& values = evaluate(at, need);
  MatrixXd G, A;
  // Add the torque at the joints.
  if (need != ElementNeed::kStates) {
    if (!values.tension.allFinite() || !values.torque.tau.allFinite()) return refuse();
    for (std::size_t c = 0; c < v.size(); ++c) out.tau[v[c]] += values.torque.tau[c];
    cache_.tension = values.tension;
  }
  // Add slopes, then rates; the rates of excursions depend on the others.
  if (need == ElementNeed::kAll) add_slopes(values, G, A, out);
  set_rates(at, values, out);
  if (muscles_.has_excursion && !muscles_.contracting.empty())
    set_excursion_rates(at, values, G, A, out);
  return is_trusted(values.torque.status);
}

/// Adds the stiffness at constant tension and that of the tensions; of a net it returns G and A.
void DigitPull::add_slopes(const PullValues& values, MatrixXd& G, MatrixXd& A, ElementAction& out) {
  const std::vector<int>& v = model_->indices.v;
  // Stiffness at constant tension, from the cache.
  if (cache_.stiffness_q.size() == 0) set_posture_stiffness(values);
  if (cache_.arm_slopes.exist)
    tendons().add_stiffness(cache_.arm_slopes, values.tension, v, scratch_.pair_sums,
                            out.stiffness);
  else
    scatter(cache_.posture_stiffness, v, v, out.stiffness);
  // Stiffness by the tensions: without a net directly, with a net by  A = 1 + G dt/d excursion.
  if (muscles_.contracting.empty()) return;
  if (!has_net()) {
    add_tension_slopes(values, out);
    return;
  }
  const MatrixXd& R = values.torque.R;
  G = tendons().compliance(values.q, values.tension, values.torque);
  A = G * values.contracted.by_length.asDiagonal();
  A.diagonal().array() += 1;
  scatter(R.transpose() * (values.contracted.by_length.asDiagonal() * A.partialPivLu().solve(R)), v,
          v, out.stiffness);
}

/// Adds R' (dt/d excursion) R and R' (dt/d velocity) R of tendons without a net, both symmetric.
void DigitPull::add_tension_slopes(const PullValues& values, ElementAction& out) {
  const std::vector<int>& v = model_->indices.v;
  const MatrixXd& R = values.torque.R;
  scratch_.weighted_arms.resize(2 * muscles_.total);
  double *const by_angle = scratch_.weighted_arms.data(), *const by_speed =
                                                              by_angle + muscles_.total;
  for (Index j = 0; j < R.cols(); ++j) {
    // Derivatives of the tensions by coordinate j.
    const double* const arm_j = R.data() + j * muscles_.total;
    for (Index m = 0; m < muscles_.total; ++m) {
      by_angle[m] = values.contracted.by_length[m] * arm_j[m];
      by_speed[m] = values.contracted.by_velocity[m] * arm_j[m];
    }
    const int at_j = v[j];
    // Entries (i, j) and (j, i).
    for (Index i = 0; i <= j; ++i) {
      const double* const arm_i = R.data() + i * muscles_.total;
      double stiffness = 0, damping = 0;
      for (Index m = 0; m < muscles_.total; ++m) {
        stiffness += arm_i[m] * by_angle[m];
        damping += arm_i[m] * by_speed[m];
      }
      const int at_i = v[i];
      out.stiffness(at_i, at_j) += stiffness;
      out.damping(at_i, at_j) += damping;
      if (i == j) continue;
      out.stiffness(at_j, at_i) += stiffness;
      out.damping(at_j, at_i) += damping;
    }
  }
}

/// Sets the rates of activations and fibres, and their decay rates.
void DigitPull::set_rates(const ElementInput& at, const PullValues& values,
                          ElementAction& out) const {
  const auto count = static_cast<Index>(muscles_.contracting.size());
  for (Index i = 0; i < count; ++i) {
    const int m = muscles_.contracting[i];
    // Activation dynamics.
    const ActivationRate rate =
        activation_rate(values.excitation[m], values.state.activation[m], model_->activation);
    out.z_rate[at.first_z + i] = rate.rate;
    out.z_decay[at.first_z + i] = std::max(0.0, -rate.by_activation);
    if (!muscles_.has_fibre) continue;
    // Fibre length by force equilibrium with the tendon.
    const MuscleState state = values.state.muscle(m);
    out.z_rate[at.first_z + 2 * count + i] =
        contraction().projected_fibre_rate(m, state) / muscles_.fibre_length[m];
    out.z_decay[at.first_z + 2 * count + i] =
        std::max(0.0, -contraction().fibre_rate_derivatives(m, state).by_projected_fibre);
  }
}

/// Sets the rates of excursions, after those of the other states; with a net they are stabilized
/// towards the line lengths [Baumgarte1972].
/// @param G, A  results of add_slopes(), used with a net only
void DigitPull::set_excursion_rates(const ElementInput& at, const PullValues& values,
                                    const MatrixXd& G, const MatrixXd& A, ElementAction& out) {
  const auto count = static_cast<Index>(muscles_.contracting.size());
  // Lengthening by the motion of the joints.
  double decay = 0;
  scratch_.excursion_rate = values.lengthening_rate;
  if (has_net()) {
    if (cache_.slack_length.size() > 0) {
      const VectorXd lengths = tendons().lengths(values.q, values.tension, values.torque);
      scratch_.excursion_rate -=
          kBaumgarteRate * (values.excursion + cache_.slack_length - lengths);
      decay = kBaumgarteRate;
    }
    // Tension rates at constant excursion; then solve  A excursion' = -R q' - G tension_rate.
    VectorXd tension_rate = VectorXd::Zero(muscles_.total);
    for (const MuscleSchedule& given : model_->tensions)
      tension_rate[given.muscle] = tension_pieces_.piece_of(given.muscle).slope();
    for (Index i = 0; i < count; ++i) {
      const int m = muscles_.contracting[i];
      tension_rate[m] = values.contracted.by_activation[m] * out.z_rate[at.first_z + i];
      if (muscles_.has_fibre)
        tension_rate[m] += values.contracted.by_projected_fibre[m] *
                           out.z_rate[at.first_z + 2 * count + i] * muscles_.fibre_length[m];
    }
    scratch_.excursion_rate = A.partialPivLu().solve(scratch_.excursion_rate - G * tension_rate);
  }
  // Scale by the optimal fibre length.
  for (Index i = 0; i < count; ++i) {
    const int m = muscles_.contracting[i];
    out.z_rate[at.first_z + count + i] = scratch_.excursion_rate[m] / muscles_.fibre_length[m];
    out.z_decay[at.first_z + count + i] = decay;
  }
}

void DigitPull::accept_step(const ElementInput& at) {
  if (!has_finite_inputs(at)) return;
  // Without a net, update the slopes of arms once the posture has changed much.
  gather(at.q, model_->indices.q, scratch_.accepted_q);
  if (!has_net() && cache_.tension.size() > 0 &&
      (has_stiffness_near(scratch_.accepted_q, cache_.tension) ||
       set_arm_slopes(scratch_.accepted_q)))
    return;
  // Otherwise update the posture stiffness from tensions and torque.
  const PullValues& values = evaluate(at, ElementNeed::kRates);
  if (!values.tension.allFinite() || !values.torque.tau.allFinite()) return;
  if (!has_stiffness_near(values.q, values.tension)) set_posture_stiffness(values);
  // Net: store the nodes for a warm start, and the lengths towards which excursions are stabilized.
  if (!has_net()) return;
  cache_.nodes.clear();
  for (const TendonTorque& digit : values.torque.digits) cache_.nodes.push_back(digit.nodes);
  if (muscles_.has_excursion && cache_.slack_length.size() == 0 && !tendons().has_friction())
    cache_.slack_length =
        tendons().lengths(values.q, values.tension, values.torque) - values.excursion;
}

std::vector<double> DigitPull::switching_times() const {
  std::vector<double> times;
  for (const auto* schedules : {&model_->tensions, &model_->excitations})
    for (const MuscleSchedule& each : *schedules) {
      times.push_back(each.when.from);
      if (std::isfinite(each.when.to)) times.push_back(each.when.to);
      for (const double t : each.time)
        if (each.when.contains(t)) times.push_back(t);
    }
  return times;
}

bool DigitPull::may_start_motion(const ElementInput& at) const {
  // A tension that changes may move the scene, and so may a muscle whose states change.
  for (const MuscleSchedule& given : model_->tensions)
    if (given.when.contains(at.selection_time) && piece_at(given, at.selection_time).slope() != 0)
      return true;
  if (muscles_.contracting.empty()) return false;
  const PullValues& values = evaluate(at, ElementNeed::kRates);
  return std::any_of(muscles_.contracting.begin(), muscles_.contracting.end(), [&](int m) {
    const double rate =
        activation_rate(values.excitation[m], values.state.activation[m], model_->activation).rate;
    const double fibre = muscles_.has_fibre
                             ? contraction().projected_fibre_rate(m, values.state.muscle(m)) /
                                   muscles_.fibre_length[m]
                             : 0;
    return excitation_pieces_.piece_of(m).slope() != 0 || std::abs(rate) > kRestRate ||
           std::abs(fibre) > kRestRate;
  });
}

std::vector<ElementControl> DigitPull::controls() const {
  std::vector<ElementControl> out;
  // Excitation of muscles that contract, tension of the others.
  for (std::size_t m = 0; m < muscles().size(); ++m) {
    const bool excited = muscles_.contracts[m];
    out.push_back({name() + "/" + muscles()[m], excited ? "1" : "N", 0,
                   excited ? 1 : std::numeric_limits<double>::infinity(),
                   (excited ? excitation_pieces_ : tension_pieces_).value_set(m)});
  }
  return out;
}

bool DigitPull::set_control(const std::string& name, double value) {
  for (std::size_t m = 0; m < muscles().size(); ++m) {
    if (name != this->name() + "/" + muscles()[m]) continue;
    // Check the range, and override the schedules from the next step on.
    const bool excited = muscles_.contracts[m];
    require(value >= 0 && std::isfinite(value) && (!excited || value <= 1),
            "{} of '{}' must be {}, got {}", excited ? "excitation" : "tension", name,
            excited ? "0 to 1" : "0 N or more", value);
    (excited ? excitation_pieces_ : tension_pieces_).set_value(m, value);
    return true;
  }
  return false;
}

std::vector<ElementValue> DigitPull::readings(const ElementInput& at) {
  const PullState values = state_at(at);
  // Tension of each muscle, and the activation of those that contract.
  std::vector<ElementValue> out;
  for (std::size_t m = 0; m < muscles().size(); ++m) {
    const std::string muscle = name() + "/" + muscles()[m];
    out.push_back({muscle, "N", values.tension[m]});
    if (muscles_.contracts[m]) out.push_back({muscle + " activation", "1", values.activation[m]});
  }
  return out;
}

PullState DigitPull::state_at(const ElementInput& at) const {
  const PullValues& values = evaluate(at, ElementNeed::kRates);
  return {values.tension,   values.excitation,    values.state.activation,
          values.excursion, values.torque.status, values.torque.warning};
}

}  // namespace thenar
