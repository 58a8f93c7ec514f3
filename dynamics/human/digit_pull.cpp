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

SchedulePiece constant_piece(double begin, double value) {
  SchedulePiece piece;
  piece.begin = begin;
  piece.value = piece.last = value;
  return piece;
}
SchedulePiece piece_at(const MuscleSchedule& schedule, double from) {
  const Index last = schedule.time.size() - 1;
  // Constant before the first knot and behind the last, otherwise the line between two.
  if (from < schedule.time[0]) return constant_piece(from, schedule.value[0]);
  Index k = 0;
  while (k < last && schedule.time[k + 1] <= from) ++k;
  if (k == last) return constant_piece(schedule.time[k], schedule.value[k]);
  return {schedule.time[k], schedule.time[k + 1], schedule.value[k], schedule.value[k + 1]};
}

/// The pieces of all muscles; zero where no schedule acts.
void set_pieces_of(const std::vector<MuscleSchedule>& schedules, double from,
                   std::vector<SchedulePiece>& pieces) {
  for (SchedulePiece& piece : pieces) piece = {};
  for (const MuscleSchedule& schedule : schedules)
    if (schedule.when.holds(from))
      pieces[static_cast<std::size_t>(schedule.muscle)] = piece_at(schedule, from);
}

VectorXd gathered(const VectorXd& from, const std::vector<int>& places) {
  VectorXd out;
  gather(from, places, out);
  return out;
}

void check_schedules(const std::vector<MuscleSchedule>& schedules, const DigitPullModel& model,
                     double most, const char* what) {
  // Each schedule is of a muscle of its own, with knots in order and values in range.
  const std::vector<std::string>& names = model.tendons->muscles();
  for (std::size_t i = 0; i < schedules.size(); ++i) {
    const MuscleSchedule& each = schedules[i];
    require(each.muscle >= 0 && each.muscle < static_cast<int>(names.size()),
            "'{}' has no muscle {}", model.name, each.muscle);
    const std::string& name = names[static_cast<std::size_t>(each.muscle)];
    require(each.time.size() > 0 && each.time.size() == each.value.size(),
            "{} of '{}' has {} instants and {} values", what, name, each.time.size(),
            each.value.size());
    for (Index k = 1; k < each.time.size(); ++k)
      require(each.time[k] >= each.time[k - 1], "{} of '{}' goes back in time", what, name);
    require((each.value.array() >= 0).all() && (each.value.array() <= most).all(),
            "{} of '{}' must be 0 to {:g}", what, name, most);
    // Two schedules of a muscle must not act at once.
    for (std::size_t j = 0; j < i; ++j)
      require(schedules[j].muscle != each.muscle || schedules[j].when.from >= each.when.to ||
                  schedules[j].when.to <= each.when.from,
              "two drives give '{}' its {} at once", name, what);
  }
}

}  // namespace

double SchedulePiece::at(double t) const {
  if (value == last) return value;
  const double part = std::clamp((t - begin) / (end - begin), 0.0, 1.0);
  return part < 1 ? std::clamp(value + part * (last - value), std::min(value, last),
                               std::max(value, last))
                  : last;
}

DigitPull::DigitPull(DigitPullModel model)
    : model_(std::make_shared<const DigitPullModel>(std::move(model))) {
  // Tendons, places and schedules must fit.
  const TendonGroup& group = *model_->tendons;
  const std::size_t joints = group.coordinates().size();
  require(model_->places.q.size() == joints && model_->places.v.size() == joints,
          "'{}' has {} joints, got {} places", model_->name, joints, model_->places.q.size());
  muscles_ = static_cast<Index>(group.muscles().size());
  check_schedules(model_->tensions, *model_, std::numeric_limits<double>::max(), "tension");
  check_schedules(model_->excitations, *model_, 1, "excitation");
  // A net in motion has smoothed bands, as in FingerMotion; without a net there are arms alone.
  const bool net = group.has_net();
  if (net) blended_ = std::make_shared<const TendonGroup>(group.smoothed(model_->blend));
  if (!net) arms_.emplace(group);
  // Muscles contract unless their tension is given; only those may be excited.
  contracts_.assign(static_cast<std::size_t>(muscles_), model_->contraction != nullptr);
  for (const MuscleSchedule& given : model_->tensions)
    contracts_[static_cast<std::size_t>(given.muscle)] = false;
  for (const MuscleSchedule& each : model_->excitations)
    require(contracts(each.muscle), "'{}' has a tension or cannot contract, and is excited",
            group.muscles()[static_cast<std::size_t>(each.muscle)]);
  // Values of all muscles, zero at first.
  given_.resize(static_cast<std::size_t>(muscles_));
  set_.resize(static_cast<std::size_t>(muscles_));
  excited_ = given_;
  now_.excitation.setZero(muscles_);
  now_.excursion.setZero(muscles_);
  now_.state.clear(muscles_);
  // Contraction of these very muscles; under a net tendons yield.
  if (!model_->contraction) return;
  require(static_cast<Index>(model_->contraction->muscles().size()) == muscles_,
          "{} muscles contract, '{}' has {}", model_->contraction->muscles().size(), model_->name,
          muscles_);
  for (std::size_t m = 0; m < group.muscles().size(); ++m)
    require(model_->contraction->muscles()[m].name == group.muscles()[m],
            "muscle {} contracts as '{}', '{}' calls it '{}'", m,
            model_->contraction->muscles()[m].name, model_->name, group.muscles()[m]);
  if (net) compliant_ = model_->contraction->with_compliant_tendon(kRigidStrain);
  // States: activation, and excursion and fibre where tension depends on them.
  for (int m = 0; m < muscles_; ++m)
    if (contracts(m)) contracting_.push_back(m);
  has_fibre_ = contraction().has_fibre_state();
  feels_speed_ = !contracting_.empty() && contraction().depends_on_velocity();
  has_excursion_ = has_fibre_ || contraction().depends_on_velocity();
  states_ = static_cast<Index>(contracting_.size()) *
            (1 + (has_excursion_ ? 1 : 0) + (has_fibre_ ? 1 : 0));
  // Lengths by which states are scaled.
  tensions_.emplace(contraction());
  fibre_length_.resize(muscles_);
  length_at_optimum_.resize(muscles_);
  for (Index m = 0; m < muscles_; ++m) {
    const Musculotendon& muscle = contraction().muscles()[static_cast<std::size_t>(m)];
    fibre_length_[m] = muscle.optimal_fibre_length;
    length_at_optimum_[m] = musculotendon_length_at_optimum(muscle);
  }
}

std::unique_ptr<ForceElement> DigitPull::clone() const {
  return std::make_unique<DigitPull>(*this);
}

const std::vector<std::string>& DigitPull::muscles() const { return model_->tendons->muscles(); }

bool DigitPull::contracts(int muscle) const { return contracts_[static_cast<std::size_t>(muscle)]; }

std::vector<std::string> DigitPull::state_names() const {
  // States in three lists: activations, excursions, fibres.
  std::vector<std::string> names;
  for (const int m : contracting_)
    names.push_back("activation " + muscles()[static_cast<std::size_t>(m)] + " [1]");
  for (const int m : contracting_)
    if (has_excursion_)
      names.push_back("excursion " + muscles()[static_cast<std::size_t>(m)] +
                      " [optimal fibre lengths]");
  for (const int m : contracting_)
    if (has_fibre_)
      names.push_back("projected fibre " + muscles()[static_cast<std::size_t>(m)] +
                      " [optimal fibre lengths]");
  return names;
}

VectorXd DigitPull::start(const VectorXd& q) const {
  const auto count = static_cast<Index>(contracting_.size());
  VectorXd z = VectorXd::Zero(states_);
  if (!has_excursion_) return z;
  // Excursion from the reference posture, along a walk of the net; then fibres in balance.
  const VectorXd excursion = tendons().excursion(gathered(q, model_->places.q)).e;
  for (Index i = 0; i < count; ++i) {
    const int m = contracting_[static_cast<std::size_t>(i)];
    z[count + i] = excursion[m] / fibre_length_[m];
    if (has_fibre_)
      z[2 * count + i] =
          contraction().isometric_projected_fibre(m, 0, length_at_optimum_[m] + excursion[m]) /
          fibre_length_[m];
  }
  return z;
}

std::string DigitPull::start_warning(const VectorXd& q) const {
  return has_excursion_ ? tendons().excursion(gathered(q, model_->places.q)).warning : "";
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
  if (stiffness_q_.size() == 0) return false;
  for (Index i = 0; i < q.size(); ++i)
    if (!(std::abs(q[i] - stiffness_q_[i]) < kFarAngle)) return false;
  return arm_slopes_.exist ||
         ((t - stiffness_t_).array().abs() < kFarTension * stiffness_t_.array() + kSomeTension)
             .all();
}

/// Slopes of arms at a posture. @return whether they exist there
bool DigitPull::set_arm_slopes(const VectorXd& q) {
  if (has_net()) return false;
  arms_->slopes(q, arm_slopes_);
  // Without them nothing is known until the stiffness has been found in another way.
  stiffness_q_ = arm_slopes_.exist ? q : VectorXd();
  return arm_slopes_.exist;
}

void DigitPull::set_posture_stiffness(const Now& now) {
  if (set_arm_slopes(now.q)) return;
  // Slope of the torque by posture at constant tension; steps take its symmetric part.
  const MatrixXd by_posture = tendons().torque_by_posture(now.q, now.tension, now.pull);
  posture_stiffness_ = -0.5 * (by_posture + by_posture.transpose());
  stiffness_q_ = now.q;
  stiffness_t_ = now.tension;
}

/// Returns the parts of the action to compute: a net computes all parts at once, and the first call
/// computes slopes by posture, whatever it needs.
ElementNeed DigitPull::need_of(const ElementInput& at) const {
  return has_net() || stiffness_q_.size() == 0 ? ElementNeed::kAll : at.need;
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
  for (Index i = 0; i < states_; ++i) of_z += 0 * z[i];
  return of_q + of_v + of_z == 0;
}

/// Finds which pieces of the schedules act.
void DigitPull::set_pieces(double acting) const {
  if (acting_ == acting) return;
  set_pieces_of(model_->tensions, acting, given_);
  set_pieces_of(model_->excitations, acting, excited_);
  for (std::size_t m = 0; m < set_.size(); ++m)
    if (set_[m]) (contracts_[m] ? excited_ : given_)[m] = constant_piece(0, *set_[m]);
  acting_ = acting;
}

/// States of muscles that contract.
void DigitPull::set_states(const ElementInput& at, Now& now) const {
  const auto count = static_cast<Index>(contracting_.size());
  const double* z = at.z.data() + at.first_z;
  for (Index i = 0; i < count; ++i) {
    const int m = contracting_[static_cast<std::size_t>(i)];
    now.excitation[m] = excited_[static_cast<std::size_t>(m)].at(at.t);
    now.state.activation[m] = z[i];
    if (!has_excursion_) continue;
    now.excursion[m] = z[count + i] * fibre_length_[m];
    now.state.length[m] = now.excursion[m] + length_at_optimum_[m];
    if (has_fibre_) now.state.projected_fibre[m] = z[2 * count + i] * fibre_length_[m];
  }
}

/// Tensions, and for kAll their derivatives.
void DigitPull::set_tensions(double t, ElementNeed need, Now& now) const {
  // Tensions by contraction, with derivatives where slopes are asked for.
  if (!contracting_.empty()) {
    if (need == ElementNeed::kAll)
      tensions_->solver().derivatives(now.state, now.by);
    else
      tensions_->solver().tensions(now.state, now.by);
  }
  // Derivatives are those of muscles that contract.
  for (int m = 0; need == ElementNeed::kAll && !contracting_.empty() && m < muscles_; ++m)
    if (!contracts(m))
      now.by.by_activation[m] = now.by.by_length[m] = now.by.by_velocity[m] =
          now.by.by_projected_fibre[m] = 0;
  // Given or contracted, above the least tension of a net.
  const double base = has_net() ? model_->base_tension : 0;
  now.tension.resize(muscles_);
  for (int m = 0; m < muscles_; ++m)
    now.tension[m] =
        base + (contracts(m) ? now.by.tension[m] : given_[static_cast<std::size_t>(m)].at(t));
}

const DigitPull::Now& DigitPull::now(const ElementInput& at, ElementNeed need) const {
  // Posture, schedules and states.
  Now& now = now_;
  gather(at.q, model_->places.q, now.q);
  gather(at.v, model_->places.v, now.q_dot);
  set_pieces(at.acting);
  set_states(at, now);
  // Without a net arms come first: they do not depend on tension, but tensions may on velocity.
  if (!has_net()) {
    set_arms(now.q);
    now.stretch.noalias() = -now.pull.R.lazyProduct(now.q_dot);
  }
  if (feels_speed_)
    for (const int m : contracting_) now.state.velocity[m] = now.stretch[m];
  if (need == ElementNeed::kStates) return now;
  // Tensions, then torque: a net is solved for it, arms give it.
  set_tensions(at.t, need, now);
  if (!now.tension.allFinite()) return now;
  if (has_net()) {
    now.pull = tendons().evaluate(now.q, now.tension, last_nodes_);
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
    last_tension_ = now.tension;
  }
  // Slopes, then rates; excursions need the others.
  if (need == ElementNeed::kAll) add_slopes(now, G, A, out);
  set_rates(at, now, out);
  if (has_excursion_ && !contracting_.empty()) set_excursion_rates(at, now, G, A, out);
  return trusted(now.pull.status);
}

/// Slopes at constant tensions, then those of the tensions.
void DigitPull::add_slopes(const Now& now, MatrixXd& G, MatrixXd& A, ElementAction& out) {
  const std::vector<int>& v = model_->places.v;
  // Slopes at constant tension, from the last accept().
  if (stiffness_q_.size() == 0) set_posture_stiffness(now);
  if (arm_slopes_.exist)
    tendons().add_stiffness(arm_slopes_, now.tension, v, by_pair_, out.stiffness);
  else
    scatter(posture_stiffness_, v, v, out.stiffness);
  // Slopes of tensions with excursion: directly, or under a net by  A = 1 + G dt/d excursion.
  if (contracting_.empty()) return;
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
  by_arm_.resize(2 * muscles_);
  double *const by_angle = by_arm_.data(), *const by_speed = by_angle + muscles_;
  for (Index j = 0; j < R.cols(); ++j) {
    // Slopes of tensions by one coordinate.
    const double* const arm_j = R.data() + j * muscles_;
    for (Index m = 0; m < muscles_; ++m) {
      by_angle[m] = now.by.by_length[m] * arm_j[m];
      by_speed[m] = now.by.by_velocity[m] * arm_j[m];
    }
    const int column = v[static_cast<std::size_t>(j)];
    // Entry of the pair (i, j), and its mirror image.
    for (Index i = 0; i <= j; ++i) {
      const double* const arm_i = R.data() + i * muscles_;
      double stiffness = 0, damping = 0;
      for (Index m = 0; m < muscles_; ++m) {
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
  const auto count = static_cast<Index>(contracting_.size());
  for (Index i = 0; i < count; ++i) {
    const int m = contracting_[static_cast<std::size_t>(i)];
    // Activation follows excitation.
    const ActivationRate rate =
        activation_rate_with_slope(now.excitation[m], now.state.activation[m], model_->activation);
    out.z_rate[at.first_z + i] = rate.rate;
    out.z_decay[at.first_z + i] = std::max(0.0, -rate.by_activation);
    if (!has_fibre_) continue;
    // Fibres by force balance with their tendons.
    const MuscleState state = now.state.of(m);
    out.z_rate[at.first_z + 2 * count + i] =
        contraction().projected_fibre_rate(m, state) / fibre_length_[m];
    out.z_decay[at.first_z + 2 * count + i] =
        std::max(0.0, -contraction().fibre_rate_derivatives(m, state).by_projected_fibre);
  }
}

/// Excursions, after the other states; under a net they return to the lengths of lines
/// [Baumgarte1972]. @param G, A  of add_slopes(), of a net
void DigitPull::set_excursion_rates(const ElementInput& at, const Now& now, const MatrixXd& G,
                                    const MatrixXd& A, ElementAction& out) {
  const auto count = static_cast<Index>(contracting_.size());
  // Muscles lengthen with the joints.
  double decay = 0;
  excursion_rate_ = now.stretch;
  if (has_net()) {
    if (slack_length_.size() > 0) {
      const VectorXd lengths = tendons().lengths(now.q, now.tension, now.pull);
      excursion_rate_ -= kBaumgarteRate * (now.excursion + slack_length_ - lengths);
      decay = kBaumgarteRate;
    }
    // Rates of tensions at constant excursion; then  A excursion' = -R q' - G rest.
    VectorXd rest = VectorXd::Zero(muscles_);
    for (const MuscleSchedule& given : model_->tensions)
      rest[given.muscle] = given_[static_cast<std::size_t>(given.muscle)].slope();
    for (Index i = 0; i < count; ++i) {
      const int m = contracting_[static_cast<std::size_t>(i)];
      rest[m] = now.by.by_activation[m] * out.z_rate[at.first_z + i];
      if (has_fibre_)
        rest[m] += now.by.by_projected_fibre[m] * out.z_rate[at.first_z + 2 * count + i] *
                   fibre_length_[m];
    }
    excursion_rate_ = A.partialPivLu().solve(excursion_rate_ - G * rest);
  }
  // Rates over the optimal fibre length.
  for (Index i = 0; i < count; ++i) {
    const int m = contracting_[static_cast<std::size_t>(i)];
    out.z_rate[at.first_z + count + i] = excursion_rate_[m] / fibre_length_[m];
    out.z_decay[at.first_z + count + i] = decay;
  }
}

void DigitPull::accept(const ElementInput& at) {
  if (!is_finite(at)) return;
  // Renew slopes of arms, where there is no net, once the posture has changed much.
  gather(at.q, model_->places.q, accepted_q_);
  if (!has_net() && last_tension_.size() > 0 &&
      (knows_stiffness(accepted_q_, last_tension_) || set_arm_slopes(accepted_q_)))
    return;
  // Otherwise slopes need tensions and the pull.
  const Now& now = this->now(at, ElementNeed::kRates);
  if (!now.tension.allFinite() || !now.pull.tau.allFinite()) return;
  if (!knows_stiffness(now.q, now.tension)) set_posture_stiffness(now);
  // Net: nodes to start from, and lengths to which excursions return.
  if (!has_net()) return;
  last_nodes_.clear();
  for (const TendonTorque& digit : now.pull.digits) last_nodes_.push_back(digit.nodes);
  if (has_excursion_ && slack_length_.size() == 0 && !tendons().has_friction())
    slack_length_ = tendons().lengths(now.q, now.tension, now.pull) - now.excursion;
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
  if (contracting_.empty()) return false;
  const Now& now = this->now(at, ElementNeed::kRates);
  return std::any_of(contracting_.begin(), contracting_.end(), [&](int m) {
    const double rate =
        activation_rate(now.excitation[m], now.state.activation[m], model_->activation);
    const double fibre =
        has_fibre_ ? contraction().projected_fibre_rate(m, now.state.of(m)) / fibre_length_[m] : 0;
    return excited_[static_cast<std::size_t>(m)].slope() != 0 || std::abs(rate) > kSettledRate ||
           std::abs(fibre) > kSettledRate;
  });
}

std::vector<ElementControl> DigitPull::controls() const {
  std::vector<ElementControl> out;
  // Excitation of muscles that contract, tension of the others.
  for (std::size_t m = 0; m < set_.size(); ++m) {
    const bool excited = contracts_[m];
    out.push_back({name() + "/" + muscles()[m], excited ? "1" : "N", 0,
                   excited ? 1 : std::numeric_limits<double>::infinity(), set_[m]});
  }
  return out;
}

bool DigitPull::set_control(const std::string& name, double value) {
  for (std::size_t m = 0; m < set_.size(); ++m) {
    if (name != this->name() + "/" + muscles()[m]) continue;
    // Check the range; the value holds from the next step on, in place of schedules.
    const bool excited = contracts_[m];
    require(value >= 0 && std::isfinite(value) && (!excited || value <= 1),
            "{} of '{}' must be {}, got {}", excited ? "excitation" : "tension", name,
            excited ? "0 to 1" : "0 N or more", value);
    set_[m] = value;
    acting_ = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  return false;
}

std::vector<ElementValue> DigitPull::readings(const ElementInput& at) {
  const PullInstant now = this->at(at);
  // Tension of each muscle, and the activation of those that contract.
  std::vector<ElementValue> out;
  for (std::size_t m = 0; m < set_.size(); ++m) {
    const std::string muscle = name() + "/" + muscles()[m];
    out.push_back({muscle, "N", now.tension[static_cast<Index>(m)]});
    if (contracts_[m])
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
