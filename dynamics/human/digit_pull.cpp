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

constexpr double kFarAngle = 0.02;      // at which slopes by posture are found anew [rad]
constexpr double kFarTension = 0.1;     // likewise, of the tension [1], and
constexpr double kSomeTension = 0.1;    // of what counts as any [N]
constexpr double kBaumgarteRate = 1e3;  // at which excursions return to lines of a net [1/s]
constexpr double kSettledRate = 1e-9;   // of activation [1/s], of a fibre [optimal lengths/s]

VectorXd gathered(const VectorXd& from, const std::vector<int>& places) {
  VectorXd out;
  gather(from, places, out);
  return out;
}

}  // namespace

DigitPull::DigitPull(DigitPullModel model)
    : model_(std::make_shared<const DigitPullModel>(std::move(model))),
      given_(model_->tendons->muscles().size()),
      excited_(model_->tendons->muscles().size()) {
  // Tendons, places and schedules must fit.
  const TendonGroup& group = *model_->tendons;
  const std::size_t joints = group.coordinates().size();
  require(model_->places.q.size() == joints && model_->places.v.size() == joints,
          "'{}' has {} joints, got {} places", model_->name, joints, model_->places.q.size());
  muscles_.count = static_cast<Index>(group.muscles().size());
  check_schedules(model_->tensions, group.muscles(), std::numeric_limits<double>::max(),
                  model_->name, "tension");
  check_schedules(model_->excitations, group.muscles(), 1, model_->name, "excitation");
  // A net in motion has smoothed bands, as in FingerMotion; without a net there are arms alone.
  const bool net = group.has_net();
  if (net) blended_ = std::make_shared<const TendonGroup>(group.smoothed(model_->blend));
  if (!net) arms_.emplace(group);
  // Muscles contract unless their tension is given; only those may be excited.
  muscles_.contracts.assign(static_cast<std::size_t>(muscles_.count),
                            model_->contraction != nullptr);
  for (const MuscleSchedule& given : model_->tensions)
    muscles_.contracts[static_cast<std::size_t>(given.muscle)] = false;
  for (const MuscleSchedule& each : model_->excitations)
    require(contracts(each.muscle), "'{}' has a tension or cannot contract, and is excited",
            group.muscles()[static_cast<std::size_t>(each.muscle)]);
  // Values of all muscles, zero at first.
  now_.excitation.setZero(muscles_.count);
  now_.excursion.setZero(muscles_.count);
  now_.state.clear(muscles_.count);
  // Contraction of these very muscles; under a net tendons yield.
  if (!model_->contraction) return;
  require(static_cast<Index>(model_->contraction->muscles().size()) == muscles_.count,
          "{} muscles contract, '{}' has {}", model_->contraction->muscles().size(), model_->name,
          muscles_.count);
  for (std::size_t m = 0; m < group.muscles().size(); ++m)
    require(model_->contraction->muscles()[m].name == group.muscles()[m],
            "muscle {} contracts as '{}', '{}' calls it '{}'", m,
            model_->contraction->muscles()[m].name, model_->name, group.muscles()[m]);
  if (net) compliant_ = model_->contraction->with_compliant_tendon(kRigidStrain);
  // States: activation, and excursion and fibre where tension depends on them.
  for (int m = 0; m < muscles_.count; ++m)
    if (contracts(m)) muscles_.contracting.push_back(m);
  muscles_.has_fibre = contraction().has_fibre_state();
  muscles_.feels_speed = !muscles_.contracting.empty() && contraction().depends_on_velocity();
  muscles_.has_excursion = muscles_.has_fibre || contraction().depends_on_velocity();
  muscles_.states = static_cast<Index>(muscles_.contracting.size()) *
                    (1 + (muscles_.has_excursion ? 1 : 0) + (muscles_.has_fibre ? 1 : 0));
  // Lengths by which states are scaled.
  tensions_.emplace(contraction());
  muscles_.fibre_length.resize(muscles_.count);
  muscles_.length_at_optimum.resize(muscles_.count);
  for (Index m = 0; m < muscles_.count; ++m) {
    const Musculotendon& muscle = contraction().muscles()[static_cast<std::size_t>(m)];
    muscles_.fibre_length[m] = muscle.optimal_fibre_length;
    muscles_.length_at_optimum[m] = musculotendon_length_at_optimum(muscle);
  }
}

std::unique_ptr<ForceElement> DigitPull::clone() const {
  return std::make_unique<DigitPull>(*this);
}

const std::vector<std::string>& DigitPull::muscles() const { return model_->tendons->muscles(); }

bool DigitPull::contracts(int muscle) const {
  return muscles_.contracts[static_cast<std::size_t>(muscle)];
}

std::vector<std::string> DigitPull::state_names() const {
  // States in three lists: activations, excursions, fibres.
  std::vector<std::string> names;
  for (const int m : muscles_.contracting)
    names.push_back("activation " + muscles()[static_cast<std::size_t>(m)] + " [1]");
  for (const int m : muscles_.contracting)
    if (muscles_.has_excursion)
      names.push_back("excursion " + muscles()[static_cast<std::size_t>(m)] +
                      " [optimal fibre lengths]");
  for (const int m : muscles_.contracting)
    if (muscles_.has_fibre)
      names.push_back("projected fibre " + muscles()[static_cast<std::size_t>(m)] +
                      " [optimal fibre lengths]");
  return names;
}

VectorXd DigitPull::start(const VectorXd& q) const {
  const auto count = static_cast<Index>(muscles_.contracting.size());
  VectorXd z = VectorXd::Zero(muscles_.states);
  if (!muscles_.has_excursion) return z;
  // Excursion from the reference posture, along a walk of the net; then fibres in balance.
  const VectorXd excursion = tendons().excursion(gathered(q, model_->places.q)).e;
  for (Index i = 0; i < count; ++i) {
    const int m = muscles_.contracting[static_cast<std::size_t>(i)];
    z[count + i] = excursion[m] / muscles_.fibre_length[m];
    if (muscles_.has_fibre)
      z[2 * count + i] = contraction().isometric_projected_fibre(
                             m, 0, muscles_.length_at_optimum[m] + excursion[m]) /
                         muscles_.fibre_length[m];
  }
  return z;
}

std::string DigitPull::start_warning(const VectorXd& q) const {
  return muscles_.has_excursion ? tendons().excursion(gathered(q, model_->places.q)).warning : "";
}

/// Tendons without a net are linear: their arms do for all tensions, and for all calls at a
/// posture.
void DigitPull::set_arms(const VectorXd& q) const {
  if (arms_q_.size() == q.size() && arms_q_ == q) return;
  arms_q_.setConstant(q.size(), std::numeric_limits<double>::quiet_NaN());  // should it throw
  arms_->solve(q, now_.pull);
  arms_q_ = q;
}

/// Returns true if the slopes by posture are known at a posture nearby; slopes of arms hold for all
/// tensions, others for similar tensions only.
bool DigitPull::knows_stiffness(const VectorXd& q, const VectorXd& t) const {
  if (last_.stiffness_q.size() == 0) return false;
  for (Index i = 0; i < q.size(); ++i)
    if (!(std::abs(q[i] - last_.stiffness_q[i]) < kFarAngle)) return false;
  return last_.arm_slopes.exist || ((t - last_.stiffness_t).array().abs() <
                                    kFarTension * last_.stiffness_t.array() + kSomeTension)
                                       .all();
}

/// Slopes of arms at a posture. @return whether they exist there
bool DigitPull::set_arm_slopes(const VectorXd& q) {
  if (has_net()) return false;
  arms_->slopes(q, last_.arm_slopes);
  // Without them nothing is known until the stiffness has been found in another way.
  last_.stiffness_q = last_.arm_slopes.exist ? q : VectorXd();
  return last_.arm_slopes.exist;
}

void DigitPull::set_posture_stiffness(const Now& now) {
  if (set_arm_slopes(now.q)) return;
  // Slope of the torque by posture at constant tension; steps take its symmetric part.
  const MatrixXd by_posture = tendons().torque_by_posture(now.q, now.tension, now.pull);
  last_.posture_stiffness = -0.5 * (by_posture + by_posture.transpose());
  last_.stiffness_q = now.q;
  last_.stiffness_t = now.tension;
}

/// Returns the parts of the action to compute: a net computes all parts at once, and the first call
/// computes slopes by posture, whatever it needs.
ElementNeed DigitPull::need_of(const ElementInput& at) const {
  return has_net() || last_.stiffness_q.size() == 0 ? ElementNeed::kAll : at.need;
}

/// Returns true if positions, speeds and states of the pull are finite.
bool DigitPull::is_finite(const ElementInput& at) const {
  // Zero times what is no number is no number; sums apart, so that they do not wait for each other.
  double of_q = 0, of_v = 0, of_z = 0;
  for (std::size_t c = 0; c < model_->places.q.size(); ++c) {
    of_q += 0 * at.q[model_->places.q[c]];
    of_v += 0 * at.v[model_->places.v[c]];
  }
  const double* const z = at.z.data() + at.first_z;
  for (Index i = 0; i < muscles_.states; ++i) of_z += 0 * z[i];
  return of_q + of_v + of_z == 0;
}

/// States of muscles that contract.
void DigitPull::set_states(const ElementInput& at, Now& now) const {
  const auto count = static_cast<Index>(muscles_.contracting.size());
  const double* z = at.z.data() + at.first_z;
  for (Index i = 0; i < count; ++i) {
    const int m = muscles_.contracting[static_cast<std::size_t>(i)];
    now.excitation[m] = excited_.of(m).at(at.t);
    now.state.activation[m] = z[i];
    if (!muscles_.has_excursion) continue;
    now.excursion[m] = z[count + i] * muscles_.fibre_length[m];
    now.state.length[m] = now.excursion[m] + muscles_.length_at_optimum[m];
    if (muscles_.has_fibre)
      now.state.projected_fibre[m] = z[2 * count + i] * muscles_.fibre_length[m];
  }
}

/// Tensions, and for kAll their derivatives.
void DigitPull::set_tensions(double t, ElementNeed need, Now& now) const {
  // Tensions by contraction, with derivatives where slopes are asked for.
  if (!muscles_.contracting.empty()) {
    if (need == ElementNeed::kAll)
      tensions_->solver().derivatives(now.state, now.by);
    else
      tensions_->solver().tensions(now.state, now.by);
  }
  // Derivatives are those of muscles that contract.
  for (int m = 0; need == ElementNeed::kAll && !muscles_.contracting.empty() && m < muscles_.count;
       ++m)
    if (!contracts(m))
      now.by.by_activation[m] = now.by.by_length[m] = now.by.by_velocity[m] =
          now.by.by_projected_fibre[m] = 0;
  // Given or contracted, above the least tension of a net.
  const double base = has_net() ? model_->base_tension : 0;
  now.tension.resize(muscles_.count);
  for (int m = 0; m < muscles_.count; ++m)
    now.tension[m] = base + (contracts(m) ? now.by.tension[m] : given_.of(m).at(t));
}

const DigitPull::Now& DigitPull::now(const ElementInput& at, ElementNeed need) const {
  // Posture, schedules and states.
  Now& now = now_;
  gather(at.q, model_->places.q, now.q);
  gather(at.v, model_->places.v, now.q_dot);
  given_.find(model_->tensions, at.acting);
  excited_.find(model_->excitations, at.acting);
  set_states(at, now);
  // Without a net arms come first: they do not depend on tension, but tensions may on velocity.
  if (!has_net()) {
    set_arms(now.q);
    now.stretch.noalias() = -now.pull.R.lazyProduct(now.q_dot);
  }
  if (muscles_.feels_speed)
    for (const int m : muscles_.contracting) now.state.velocity[m] = now.stretch[m];
  if (need == ElementNeed::kStates) return now;
  // Tensions, then torque: a net is solved for it, arms give it.
  set_tensions(at.t, need, now);
  if (!now.tension.allFinite()) return now;
  if (has_net()) {
    now.pull = tendons().evaluate(now.q, now.tension, last_.nodes);
    now.stretch.noalias() = -now.pull.R * now.q_dot;
  } else {
    now.pull.tau.noalias() = now.pull.R.transpose().lazyProduct(now.tension);
  }
  return now;
}

bool DigitPull::act(const ElementInput& at, ElementAction& out) {
  // A trial far off: efforts that are no number make the step shorter.
  const std::vector<int>& v = model_->places.v;
  const auto refuse = [&] {
    for (const int place : v) out.tau[place] = std::numeric_limits<double>::quiet_NaN();
    return false;
  };
  if (!is_finite(at)) return refuse();
  // Quantities at the state, as far as they are needed.
  const ElementNeed need = need_of(at);
  const Now& now = this->now(at, need);
  MatrixXd G, A;
  // Add the torque at the joints.
  if (need != ElementNeed::kStates) {
    if (!now.tension.allFinite() || !now.pull.tau.allFinite()) return refuse();
    for (std::size_t c = 0; c < v.size(); ++c) out.tau[v[c]] += now.pull.tau[static_cast<Index>(c)];
    last_.tension = now.tension;
  }
  // Slopes, then rates; excursions need the others.
  if (need == ElementNeed::kAll) add_slopes(now, G, A, out);
  set_rates(at, now, out);
  if (muscles_.has_excursion && !muscles_.contracting.empty())
    set_excursion_rates(at, now, G, A, out);
  return trusted(now.pull.status);
}

/// Slopes at constant tensions, then those of the tensions.
void DigitPull::add_slopes(const Now& now, MatrixXd& G, MatrixXd& A, ElementAction& out) {
  const std::vector<int>& v = model_->places.v;
  // Slopes at constant tension, from the last accept().
  if (last_.stiffness_q.size() == 0) set_posture_stiffness(now);
  if (last_.arm_slopes.exist)
    tendons().add_stiffness(last_.arm_slopes, now.tension, v, scratch_.by_pair, out.stiffness);
  else
    scatter(last_.posture_stiffness, v, v, out.stiffness);
  // Slopes of tensions with excursion: directly, or under a net by  A = 1 + G dt/d excursion.
  if (muscles_.contracting.empty()) return;
  if (!has_net()) {
    add_tension_slopes(now, out);
    return;
  }
  const MatrixXd& R = now.pull.R;
  G = tendons().compliance(now.q, now.tension, now.pull);
  A = G * now.by.by_length.asDiagonal();
  A.diagonal().array() += 1;
  scatter(R.transpose() * (now.by.by_length.asDiagonal() * A.partialPivLu().solve(R)), v, v,
          out.stiffness);
}

/// R' (dt/d excursion) R and R' (dt/d velocity) R of tendons without a net, both symmetric.
void DigitPull::add_tension_slopes(const Now& now, ElementAction& out) {
  const std::vector<int>& v = model_->places.v;
  const MatrixXd& R = now.pull.R;
  scratch_.by_arm.resize(2 * muscles_.count);
  double *const by_angle = scratch_.by_arm.data(), *const by_speed = by_angle + muscles_.count;
  for (Index j = 0; j < R.cols(); ++j) {
    // Slopes of tensions by one coordinate.
    const double* const arm_j = R.data() + j * muscles_.count;
    for (Index m = 0; m < muscles_.count; ++m) {
      by_angle[m] = now.by.by_length[m] * arm_j[m];
      by_speed[m] = now.by.by_velocity[m] * arm_j[m];
    }
    const int column = v[static_cast<std::size_t>(j)];
    // Entry of the pair (i, j), and its mirror image.
    for (Index i = 0; i <= j; ++i) {
      const double* const arm_i = R.data() + i * muscles_.count;
      double stiffness = 0, damping = 0;
      for (Index m = 0; m < muscles_.count; ++m) {
        stiffness += arm_i[m] * by_angle[m];
        damping += arm_i[m] * by_speed[m];
      }
      const int row = v[static_cast<std::size_t>(i)];
      out.stiffness(row, column) += stiffness;
      out.damping(row, column) += damping;
      if (i == j) continue;
      out.stiffness(column, row) += stiffness;
      out.damping(column, row) += damping;
    }
  }
}

/// Activations and fibres.
void DigitPull::set_rates(const ElementInput& at, const Now& now, ElementAction& out) const {
  const auto count = static_cast<Index>(muscles_.contracting.size());
  for (Index i = 0; i < count; ++i) {
    const int m = muscles_.contracting[static_cast<std::size_t>(i)];
    // Activation follows excitation.
    const ActivationRate rate =
        activation_rate_with_slope(now.excitation[m], now.state.activation[m], model_->activation);
    out.z_rate[at.first_z + i] = rate.rate;
    out.z_decay[at.first_z + i] = std::max(0.0, -rate.by_activation);
    if (!muscles_.has_fibre) continue;
    // Fibres by force balance with their tendons.
    const MuscleState state = now.state.muscle(m);
    out.z_rate[at.first_z + 2 * count + i] =
        contraction().projected_fibre_rate(m, state) / muscles_.fibre_length[m];
    out.z_decay[at.first_z + 2 * count + i] =
        std::max(0.0, -contraction().fibre_rate_derivatives(m, state).by_projected_fibre);
  }
}

/// Excursions, after the other states; under a net they return to the lengths of lines
/// [Baumgarte1972]. @param G, A  of add_slopes(), of a net
void DigitPull::set_excursion_rates(const ElementInput& at, const Now& now, const MatrixXd& G,
                                    const MatrixXd& A, ElementAction& out) {
  const auto count = static_cast<Index>(muscles_.contracting.size());
  // Muscles lengthen with the joints.
  double decay = 0;
  scratch_.excursion_rate = now.stretch;
  if (has_net()) {
    if (last_.slack_length.size() > 0) {
      const VectorXd lengths = tendons().lengths(now.q, now.tension, now.pull);
      scratch_.excursion_rate -= kBaumgarteRate * (now.excursion + last_.slack_length - lengths);
      decay = kBaumgarteRate;
    }
    // Rates of tensions at constant excursion; then  A excursion' = -R q' - G rest.
    VectorXd rest = VectorXd::Zero(muscles_.count);
    for (const MuscleSchedule& given : model_->tensions)
      rest[given.muscle] = given_.of(given.muscle).slope();
    for (Index i = 0; i < count; ++i) {
      const int m = muscles_.contracting[static_cast<std::size_t>(i)];
      rest[m] = now.by.by_activation[m] * out.z_rate[at.first_z + i];
      if (muscles_.has_fibre)
        rest[m] += now.by.by_projected_fibre[m] * out.z_rate[at.first_z + 2 * count + i] *
                   muscles_.fibre_length[m];
    }
    scratch_.excursion_rate = A.partialPivLu().solve(scratch_.excursion_rate - G * rest);
  }
  // Rates over the optimal fibre length.
  for (Index i = 0; i < count; ++i) {
    const int m = muscles_.contracting[static_cast<std::size_t>(i)];
    out.z_rate[at.first_z + count + i] = scratch_.excursion_rate[m] / muscles_.fibre_length[m];
    out.z_decay[at.first_z + count + i] = decay;
  }
}

void DigitPull::accept(const ElementInput& at) {
  if (!is_finite(at)) return;
  // Renew slopes of arms, where there is no net, once the posture has changed much.
  gather(at.q, model_->places.q, scratch_.accepted_q);
  if (!has_net() && last_.tension.size() > 0 &&
      (knows_stiffness(scratch_.accepted_q, last_.tension) || set_arm_slopes(scratch_.accepted_q)))
    return;
  // Otherwise slopes need tensions and the pull.
  const Now& now = this->now(at, ElementNeed::kRates);
  if (!now.tension.allFinite() || !now.pull.tau.allFinite()) return;
  if (!knows_stiffness(now.q, now.tension)) set_posture_stiffness(now);
  // Net: nodes to start from, and lengths to which excursions return.
  if (!has_net()) return;
  last_.nodes.clear();
  for (const TendonTorque& digit : now.pull.digits) last_.nodes.push_back(digit.nodes);
  if (muscles_.has_excursion && last_.slack_length.size() == 0 && !tendons().has_friction())
    last_.slack_length = tendons().lengths(now.q, now.tension, now.pull) - now.excursion;
}

std::vector<double> DigitPull::switches() const {
  std::vector<double> times;
  for (const auto* schedules : {&model_->tensions, &model_->excitations})
    for (const MuscleSchedule& each : *schedules) {
      times.push_back(each.when.from);
      if (std::isfinite(each.when.to)) times.push_back(each.when.to);
      for (const double t : each.time)
        if (each.when.holds(t)) times.push_back(t);
    }
  return times;
}

bool DigitPull::moves(const ElementInput& at) const {
  // A tension that changes, or a muscle that is not at rest, moves.
  for (const MuscleSchedule& given : model_->tensions)
    if (given.when.holds(at.acting) && piece_at(given, at.acting).slope() != 0) return true;
  if (muscles_.contracting.empty()) return false;
  const Now& now = this->now(at, ElementNeed::kRates);
  return std::any_of(muscles_.contracting.begin(), muscles_.contracting.end(), [&](int m) {
    const double rate =
        activation_rate(now.excitation[m], now.state.activation[m], model_->activation);
    const double fibre =
        muscles_.has_fibre
            ? contraction().projected_fibre_rate(m, now.state.muscle(m)) / muscles_.fibre_length[m]
            : 0;
    return excited_.of(m).slope() != 0 || std::abs(rate) > kSettledRate ||
           std::abs(fibre) > kSettledRate;
  });
}

std::vector<ElementControl> DigitPull::controls() const {
  std::vector<ElementControl> out;
  // Excitation of muscles that contract, tension of the others.
  for (std::size_t m = 0; m < muscles().size(); ++m) {
    const bool excited = muscles_.contracts[m];
    out.push_back({name() + "/" + muscles()[m], excited ? "1" : "N", 0,
                   excited ? 1 : std::numeric_limits<double>::infinity(),
                   (excited ? excited_ : given_).set_value(m)});
  }
  return out;
}

bool DigitPull::set_control(const std::string& name, double value) {
  for (std::size_t m = 0; m < muscles().size(); ++m) {
    if (name != this->name() + "/" + muscles()[m]) continue;
    // Check the range; the value holds from the next step on, in place of schedules.
    const bool excited = muscles_.contracts[m];
    require(value >= 0 && std::isfinite(value) && (!excited || value <= 1),
            "{} of '{}' must be {}, got {}", excited ? "excitation" : "tension", name,
            excited ? "0 to 1" : "0 N or more", value);
    (excited ? excited_ : given_).set(m, value);
    return true;
  }
  return false;
}

std::vector<ElementValue> DigitPull::readings(const ElementInput& at) {
  const PullInstant now = this->at(at);
  // Tension of each muscle, and the activation of those that contract.
  std::vector<ElementValue> out;
  for (std::size_t m = 0; m < muscles().size(); ++m) {
    const std::string muscle = name() + "/" + muscles()[m];
    out.push_back({muscle, "N", now.tension[static_cast<Index>(m)]});
    if (muscles_.contracts[m])
      out.push_back({muscle + " activation", "1", now.activation[static_cast<Index>(m)]});
  }
  return out;
}

PullInstant DigitPull::at(const ElementInput& at) const {
  const Now& now = this->now(at, ElementNeed::kRates);
  return {now.tension,   now.excitation,  now.state.activation,
          now.excursion, now.pull.status, now.pull.warning};
}

}  // namespace thenar
