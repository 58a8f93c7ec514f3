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

constexpr double kFarAngle = 0.02;     // at which slopes by posture are found anew [rad]
constexpr double kFarTension = 0.1;    // likewise, of the tension [1], and
constexpr double kSomeTension = 0.1;   // of what counts as any [N]
constexpr double kSettledRate = 1e-9;  // of activation [1/s], of a fibre [optimal lengths/s]

/// The straight piece of a schedule that begins at or before an instant. Before its begin and after
/// its end, where trial steps may look, it is constant.
struct SchedulePiece {
  double begin = 0, end = std::numeric_limits<double>::infinity();  // [s]
  double value = 0, last = 0;                                       // at begin and end

  [[nodiscard]] double slope() const { return (last - value) / (end - begin); }  // [1/s]
  /// Between both values to the last bit: tensions that end at 0 are never below it.
  [[nodiscard]] double at(double t) const {
    const double part = std::clamp((t - begin) / (end - begin), 0.0, 1.0);
    return part < 1 ? std::clamp(value + part * (last - value), std::min(value, last),
                                 std::max(value, last))
                    : last;
  }
};
SchedulePiece constant_piece(double begin, double value) {
  SchedulePiece piece;
  piece.begin = begin;
  piece.value = piece.last = value;
  return piece;
}
SchedulePiece piece_at(const MuscleSchedule& schedule, double from) {
  const Index last = schedule.time.size() - 1;
  if (from < schedule.time[0]) return constant_piece(from, schedule.value[0]);
  Index k = 0;
  while (k < last && schedule.time[k + 1] <= from) ++k;
  if (k == last) return constant_piece(schedule.time[k], schedule.value[k]);
  return {schedule.time[k], schedule.time[k + 1], schedule.value[k], schedule.value[k + 1]};
}

/// The piece of a muscle among schedules; zero where none acts.
SchedulePiece piece_of(const std::vector<MuscleSchedule>& schedules, int muscle, double from) {
  for (const MuscleSchedule& schedule : schedules)
    if (schedule.muscle == muscle && schedule.when.holds(from)) return piece_at(schedule, from);
  return {};
}

void check_schedules(const std::vector<MuscleSchedule>& schedules, const DigitPullModel& model,
                     double most, const char* what) {
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
    for (std::size_t j = 0; j < i; ++j)
      require(schedules[j].muscle != each.muscle || schedules[j].when.from >= each.when.to ||
                  schedules[j].when.to <= each.when.from,
              "two drives give '{}' its {} at once", name, what);
  }
}

}  // namespace

DigitPull::DigitPull(DigitPullModel model)
    : model_(std::make_shared<const DigitPullModel>(std::move(model))) {
  const TendonGroup& group = *model_->tendons;
  const std::size_t joints = group.coordinates().size();
  require(model_->places.q.size() == joints && model_->places.v.size() == joints,
          "'{}' has {} joints, got {} places", model_->name, joints, model_->places.q.size());
  muscles_ = static_cast<Index>(group.muscles().size());
  check_schedules(model_->tensions, *model_, std::numeric_limits<double>::max(), "tension");
  check_schedules(model_->excitations, *model_, 1, "excitation");
  // A net in motion: see FingerMotion.
  const bool net = group.has_net();
  if (net) blended_ = std::make_shared<const TendonGroup>(group.smoothed(model_->blend));
  if (!net) arms_.emplace(group);
  contracts_.assign(static_cast<std::size_t>(muscles_), model_->contraction != nullptr);
  for (const MuscleSchedule& given : model_->tensions)
    contracts_[static_cast<std::size_t>(given.muscle)] = false;
  for (const MuscleSchedule& each : model_->excitations)
    require(contracts(each.muscle), "'{}' has a tension or cannot contract, and is excited",
            group.muscles()[static_cast<std::size_t>(each.muscle)]);
  if (!model_->contraction) return;
  require(static_cast<Index>(model_->contraction->muscles().size()) == muscles_,
          "{} muscles contract, '{}' has {}", model_->contraction->muscles().size(), model_->name,
          muscles_);
  for (std::size_t m = 0; m < group.muscles().size(); ++m)
    require(model_->contraction->muscles()[m].name == group.muscles()[m],
            "muscle {} contracts as '{}', '{}' calls it '{}'", m,
            model_->contraction->muscles()[m].name, model_->name, group.muscles()[m]);
  if (net) compliant_ = model_->contraction->with_compliant_tendon(kRigidStrain);
  for (int m = 0; m < muscles_; ++m)
    if (contracts(m)) contracting_.push_back(m);
  has_fibre_ = contraction().has_fibre_state();
  has_excursion_ = has_fibre_ || contraction().depends_on_velocity();
}

std::unique_ptr<ForceElement> DigitPull::clone() const {
  return std::make_unique<DigitPull>(*this);
}

const std::vector<std::string>& DigitPull::muscles() const { return model_->tendons->muscles(); }

bool DigitPull::contracts(int muscle) const { return contracts_[static_cast<std::size_t>(muscle)]; }

double DigitPull::fibre_length(int m) const {
  return contraction().muscles()[static_cast<std::size_t>(m)].optimal_fibre_length;
}

std::vector<std::string> DigitPull::state_names() const {
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
  VectorXd z = VectorXd::Zero(static_cast<Index>(state_names().size()));
  if (!has_excursion_) return z;
  // Excursion from the reference posture, along a walk of the net; then fibres in balance.
  const VectorXd excursion = tendons().excursion(q(model_->places.q)).e;
  for (Index i = 0; i < count; ++i) {
    const int m = contracting_[static_cast<std::size_t>(i)];
    const Musculotendon& muscle = contraction().muscles()[static_cast<std::size_t>(m)];
    z[count + i] = excursion[m] / fibre_length(m);
    if (has_fibre_)
      z[2 * count + i] = contraction().isometric_projected_fibre(
                             m, 0, musculotendon_length_at_optimum(muscle) + excursion[m]) /
                         fibre_length(m);
  }
  return z;
}

std::string DigitPull::start_warning(const VectorXd& q) const {
  return has_excursion_ ? tendons().excursion(q(model_->places.q)).warning : "";
}

/// Tendons without a net are linear: their arms do for all tensions, and for all calls at a
/// posture.
void DigitPull::set_arms(const VectorXd& q) const {
  if (arms_q_.size() == q.size() && arms_q_ == q) return;
  arms_q_.resize(0);  // should it throw
  arms_->solve(q, now_.pull);
  arms_q_ = q;
}

/// Whether slopes by posture are known of a place nearby.
bool DigitPull::knows_stiffness(const VectorXd& q, const VectorXd& t) const {
  return posture_stiffness_.size() > 0 && (q - stiffness_q_).cwiseAbs().maxCoeff() < kFarAngle &&
         ((t - stiffness_t_).array().abs() < kFarTension * stiffness_t_.array() + kSomeTension)
             .all();
}

void DigitPull::set_posture_stiffness(const Now& now) {
  const MatrixXd by_posture = tendons().torque_by_posture(now.q, now.tension, now.pull);
  posture_stiffness_ = -0.5 * (by_posture + by_posture.transpose());
  stiffness_q_ = now.q;
  stiffness_t_ = now.tension;
}

/// What is asked of a pull: a net has all its parts at once, and slopes by posture are found at
/// the first call, whatever that is for.
ElementNeed DigitPull::need_of(const ElementInput& at) const {
  return has_net() || posture_stiffness_.size() == 0 ? ElementNeed::kAll : at.need;
}

const DigitPull::Now& DigitPull::now(const ElementInput& at, ElementNeed need) const {
  Now& now = now_;
  now.q = at.q(model_->places.q);
  now.q_dot = at.v(model_->places.v);
  now.excitation.setZero(muscles_);
  now.excursion.setZero(muscles_);
  now.tension.setZero(muscles_);
  now.state.assign(static_cast<std::size_t>(muscles_), {});
  now.by.assign(static_cast<std::size_t>(muscles_), {});
  // States of muscles that contract.
  const auto count = static_cast<Index>(contracting_.size());
  for (Index i = 0; i < count; ++i) {
    const int m = contracting_[static_cast<std::size_t>(i)];
    MuscleState& state = now.state[static_cast<std::size_t>(m)];
    now.excitation[m] = piece_of(model_->excitations, m, at.acting).at(at.t);
    state.activation = at.z[at.first_z + i];
    if (!has_excursion_) continue;
    now.excursion[m] = at.z[at.first_z + count + i] * fibre_length(m);
    state.length = now.excursion[m] + musculotendon_length_at_optimum(
                                          contraction().muscles()[static_cast<std::size_t>(m)]);
    if (has_fibre_) state.projected_fibre = at.z[at.first_z + 2 * count + i] * fibre_length(m);
  }
  // Where tension depends on velocity, arms come first; there they do not depend on tension.
  if (!has_net()) set_arms(now.q);
  if (count > 0 && contraction().depends_on_velocity()) {
    now.stretch = -(now.pull.R * now.q_dot);
    for (const int m : contracting_)
      now.state[static_cast<std::size_t>(m)].velocity = now.stretch[m];
  }
  if (need == ElementNeed::kStates) return now;
  // Tensions, and their slopes.
  for (int m = 0; m < muscles_; ++m) {
    const auto k = static_cast<std::size_t>(m);
    if (need == ElementNeed::kAll && contracts(m))
      now.by[k] = contraction().tension_derivatives(m, now.state[k]);
    now.tension[m] = (has_net() ? model_->base_tension : 0) +
                     (contracts(m) ? contraction().tension(m, now.state[k])
                                   : piece_of(model_->tensions, m, at.acting).at(at.t));
  }
  if (!now.tension.allFinite()) return now;
  if (has_net())
    now.pull = tendons().evaluate(now.q, now.tension, last_nodes_);
  else
    now.pull.tau.noalias() = now.pull.R.transpose() * now.tension;
  return now;
}

bool DigitPull::act(const ElementInput& at, ElementAction& out) {
  // A trial far off: efforts that are no number make the step shorter.
  const std::vector<int>& v = model_->places.v;
  const auto refuse = [&] {
    out.tau(v).setConstant(std::numeric_limits<double>::quiet_NaN());
    return false;
  };
  if (!at.q.allFinite() || !at.v.allFinite() || !at.z.allFinite()) return refuse();
  const ElementNeed need = need_of(at);
  const Now& now = this->now(at, need);
  MatrixXd G, A;
  if (need != ElementNeed::kStates) {
    if (!now.tension.allFinite() || !now.pull.tau.allFinite()) return refuse();
    out.tau(v) += now.pull.tau;
    last_tension_ = now.tension;
  }
  if (need == ElementNeed::kAll) add_slopes(now, G, A, out);
  set_rates(at, now, G, A, out);
  return trusted(now.pull.status);
}

/// Slopes at constant tensions, then those of the tensions.
void DigitPull::add_slopes(const Now& now, MatrixXd& G, MatrixXd& A, ElementAction& out) {
  const std::vector<int>& v = model_->places.v;
  const MatrixXd& R = now.pull.R;
  if (posture_stiffness_.size() == 0) set_posture_stiffness(now);
  out.stiffness(v, v) += posture_stiffness_;
  if (contracting_.empty()) return;
  by_length_.resize(muscles_);
  by_velocity_.resize(muscles_);
  for (Index m = 0; m < muscles_; ++m) {
    by_length_[m] = now.by[static_cast<std::size_t>(m)].by_length;
    by_velocity_[m] = now.by[static_cast<std::size_t>(m)].by_velocity;
  }
  if (has_net()) {
    G = tendons().compliance(now.q, now.tension, now.pull);
    A = G * by_length_.asDiagonal();
    A.diagonal().array() += 1;
    scaled_ = by_length_.asDiagonal() * A.partialPivLu().solve(R);
  } else {
    scaled_ = by_length_.asDiagonal() * R;
  }
  slope_ = R.transpose().lazyProduct(scaled_);
  out.stiffness(v, v) += slope_;
  scaled_ = by_velocity_.asDiagonal() * R;
  slope_ = R.transpose().lazyProduct(scaled_);
  out.damping(v, v) += slope_;
}

void DigitPull::set_rates(const ElementInput& at, const Now& now, const MatrixXd& G,
                          const MatrixXd& A, ElementAction& out) {
  const auto count = static_cast<Index>(contracting_.size());
  if (count == 0) return;
  // Activations and fibres, and, for a net, the rates of tensions at constant length.
  VectorXd rest;
  if (has_net()) {
    rest = VectorXd::Zero(muscles_);
    for (const MuscleSchedule& given : model_->tensions)
      rest[given.muscle] = piece_of(model_->tensions, given.muscle, at.acting).slope();
  }
  for (Index i = 0; i < count; ++i) {
    const int m = contracting_[static_cast<std::size_t>(i)];
    const MuscleState& state = now.state[static_cast<std::size_t>(m)];
    const TensionDerivatives& by = now.by[static_cast<std::size_t>(m)];
    const double rate = activation_rate(now.excitation[m], state.activation, model_->activation);
    out.z_rate[at.first_z + i] = rate;
    out.z_decay[at.first_z + i] = std::max(
        0.0, -activation_rate_derivative(now.excitation[m], state.activation, model_->activation));
    if (has_net()) rest[m] = by.by_activation * rate;
    if (!has_fibre_) continue;
    const double fibre = contraction().projected_fibre_rate(m, state);
    out.z_rate[at.first_z + 2 * count + i] = fibre / fibre_length(m);
    out.z_decay[at.first_z + 2 * count + i] =
        std::max(0.0, -contraction().fibre_rate_derivatives(m, state).by_projected_fibre);
    if (has_net()) rest[m] += by.by_projected_fibre * fibre;
  }
  if (!has_excursion_) return;
  // Excursions; under a net they return to the lengths of lines [Baumgarte1972].
  excursion_rate_.noalias() = -now.pull.R * now.q_dot;
  VectorXd& excursion = excursion_rate_;
  double decay = 0;
  if (has_net()) {
    if (slack_length_.size() > 0) {
      const VectorXd lengths = tendons().lengths(now.q, now.tension, now.pull);
      excursion -= kBaumgarteRate * (now.excursion + slack_length_ - lengths);
      decay = kBaumgarteRate;
    }
    excursion = A.partialPivLu().solve(excursion - G * rest);
  }
  for (Index i = 0; i < count; ++i) {
    const int m = contracting_[static_cast<std::size_t>(i)];
    out.z_rate[at.first_z + count + i] = excursion[m] / fibre_length(m);
    out.z_decay[at.first_z + count + i] = decay;
  }
}

void DigitPull::accept(const ElementInput& at) {
  if (!at.q.allFinite() || !at.v.allFinite() || !at.z.allFinite()) return;
  if (!has_net() && last_tension_.size() > 0 &&
      knows_stiffness(at.q(model_->places.q), last_tension_))
    return;
  const Now& now = this->now(at, ElementNeed::kRates);
  if (!now.tension.allFinite() || !now.pull.tau.allFinite()) return;
  if (!knows_stiffness(now.q, now.tension)) set_posture_stiffness(now);
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
  for (const MuscleSchedule& given : model_->tensions)
    if (given.when.holds(at.acting) && piece_at(given, at.acting).slope() != 0) return true;
  if (contracting_.empty()) return false;
  const Now& now = this->now(at, ElementNeed::kRates);
  return std::any_of(contracting_.begin(), contracting_.end(), [&](int m) {
    const MuscleState& state = now.state[static_cast<std::size_t>(m)];
    const double rate = activation_rate(now.excitation[m], state.activation, model_->activation);
    const double fibre =
        has_fibre_ ? contraction().projected_fibre_rate(m, state) / fibre_length(m) : 0;
    return piece_of(model_->excitations, m, at.acting).slope() != 0 ||
           std::abs(rate) > kSettledRate || std::abs(fibre) > kSettledRate;
  });
}

PullInstant DigitPull::at(const ElementInput& at) const {
  const Now& now = this->now(at, ElementNeed::kRates);
  PullInstant out;
  out.tension = now.tension;
  out.excitation = now.excitation;
  out.excursion = now.excursion;
  out.activation = VectorXd::Zero(muscles_);
  for (const int m : contracting_)
    out.activation[m] = now.state[static_cast<std::size_t>(m)].activation;
  out.status = now.pull.status;
  out.warning = now.pull.warning;
  return out;
}

}  // namespace thenar
