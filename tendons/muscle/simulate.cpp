#include "tendons/muscle/simulate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/numbers.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kJump = 1e-4;    // of a line, beyond what integration leaves [m]
constexpr double kFiner = 0.01;   // tolerance of the second integration over that of the first
constexpr double kMoreSteps = 5;  // of the second over the first, which a smooth motion needs

/// Whether a net went to another equilibrium, as far as its lines tell.
bool has_jumped(const Trajectory& path) { return !(path.drift.value_or(0) <= kJump); }

/// Instants that are kept, in a trajectory with room for all.
class Recorder {
 public:
  Recorder(const MotionModel& model, FingerMotion& motion, const SimulateOptions& options)
      : model_(model),
        motion_(motion),
        sample_(options.sample),
        seconds_(options.seconds),
        tolerance_(options.tolerance),
        room_(static_cast<Index>(std::floor(options.seconds / options.sample * (1 + 1e-12))) + 1) {
    // Names and fidelity.
    const TendonDigit& digit = model.tendons.digit();
    kept_.joints = digit.names.coordinates;
    kept_.muscles = digit.names.muscles;
    kept_.fidelity = digit.fidelity | Fidelity(Motion::kDynamic, model.contraction.rung());
    // Room for all instants.
    const auto joints = static_cast<Index>(kept_.joints.size());
    const auto muscles = static_cast<Index>(kept_.muscles.size());
    for (VectorXd* v : {&kept_.time, &kept_.energy, &kept_.work, &kept_.dissipated})
      v->resize(room_);
    for (Eigen::MatrixXd* m : {&kept_.angle, &kept_.speed}) m->resize(room_, joints);
    for (Eigen::MatrixXd* m :
         {&kept_.excitation, &kept_.activation, &kept_.tension, &kept_.excursion, &kept_.fibre})
      m->resize(room_, muscles);
    kept_.slips.resize(room_, 4);
    kept_.tip.resize(room_, 3);
  }

  /// Time of the next instant to keep [s]; infinite if there is none.
  double next() const {
    return next_ < room_ ? std::min(static_cast<double>(next_) * sample_, seconds_) : HUGE_VAL;
  }

  void keep(const MotionState& state, const VectorXd& excitation) {
    const MotionInstant now = motion_.at(state);
    const Index i = next_;
    // States and tensions.
    kept_.time[i] = next();
    kept_.angle.row(i) = state.q;
    kept_.speed.row(i) = state.q_dot;
    kept_.excitation.row(i) = excitation;
    kept_.activation.row(i) = state.activation;
    kept_.tension.row(i) = now.tension;
    kept_.excursion.row(i) = state.excursion;
    kept_.fibre.row(i) = now.fibre;
    // Slips of the hood, and the tip.
    const SlipTension& slips = now.pull.slips;
    kept_.slips.row(i) << slips.central, slips.radial, slips.ulnar, slips.terminal;
    const TendonModel<double>& bones = model_.tendons.digit().model;
    kept_.tip.row(i) = moved(pose_tree(bones.tree, state.q), bones.tip_link, bones.tip);
    // Energies.
    kept_.energy[i] = motion_.energy(state);
    kept_.work[i] = state.work;
    kept_.dissipated[i] = state.dissipated;
    note(now.pull.warning, next());
    ++next_;
  }

  /// Keeps the first warning, with its time.
  void note(const std::string& warning, double time) {
    if (warning.empty() || !kept_.warning.empty()) return;
    kept_.warning = fmt::format("{} (at {:.4g} s)", warning, time);
  }

  void note_accepted(const FingerMotion::Accepted& accepted, double time) {
    note(accepted.warning, time);
    if (accepted.drift.size() == 0) return;
    // Muscle of the largest drift.
    Index most = 0;
    const double drift = accepted.drift.cwiseAbs().maxCoeff<Eigen::PropagateNaN>(&most);
    const double before = kept_.drift.value_or(0);
    if (kept_.drift && (drift <= before || std::isnan(before))) return;
    // First instant at which the drift shows a jump.
    if (before <= kJump) jumped_ = time;
    kept_.drift = drift;
    strays_ = kept_.muscles[static_cast<std::size_t>(most)];
  }

  /// Why it ended comes before whatever was noted on the way.
  void note_end(const std::string& why, double time) {
    if (why.empty()) return;
    const std::string before = std::exchange(kept_.warning, "");
    note(why, time);
    if (!before.empty()) kept_.warning += "; " + before;
  }

  Trajectory take(MotionStatus status, const std::string& why, const StiffOde& ode,
                  const EnergyBalance& balance) {
    // A jump of the net is part of the ending's story.
    if (has_jumped(kept_))
      note_end(fmt::format("the net jumped to another rest, the line of '{}' by up to {:.2g} mm: "
                           "what that sets free is in no balance, and the motion after it may "
                           "hang on the tolerance",
                           strays_, 1e3 * *kept_.drift),
               jumped_);
    note_end(why, ode.time());
    kept_.status = status;
    kept_.balance = balance;
    kept_.tolerance = tolerance_;
    kept_.counts = ode.counts();
    // Cut to the instants that were reached.
    for (VectorXd* v : {&kept_.time, &kept_.energy, &kept_.work, &kept_.dissipated})
      v->conservativeResize(next_);
    for (Eigen::MatrixXd* m : {&kept_.angle, &kept_.speed, &kept_.excitation, &kept_.activation,
                               &kept_.tension, &kept_.excursion, &kept_.fibre})
      m->conservativeResize(next_, Eigen::NoChange);
    kept_.slips.conservativeResize(next_, Eigen::NoChange);
    kept_.tip.conservativeResize(next_, Eigen::NoChange);
    kept_.balance.error = max_or_nan(balance.error, energy_error(kept_));
    if (model_.contraction.rung() == Muscle::kBounds) kept_.fibre.resize(0, 0);
    return std::move(kept_);
  }

 private:
  const MotionModel& model_;
  FingerMotion& motion_;
  double sample_, seconds_, tolerance_;
  Index room_, next_ = 0;
  double jumped_ = 0;   // when the drift first was beyond kJump [s]
  std::string strays_;  // muscle of the largest drift
  Trajectory kept_;
};

const char* reason(OdeStatus status) {
  switch (status) {
    case OdeStatus::kStepped:
      return "";
    case OdeStatus::kLimit:
      return "more steps than allowed";
    case OdeStatus::kTooStiff:
      return "no step is short enough";
    case OdeStatus::kNotFinite:
      return "rates are not finite, however short the step";
    case OdeStatus::kSingular:
      return "the equations of a step are singular";
    case OdeStatus::kImpossible:
      return "the tolerance is below rounding";
    case OdeStatus::kFailed:
      break;
  }
  return "the integrator failed";
}

/// Adds up what became of energy from step to step.
class Account {
 public:
  Account(FingerMotion& motion, const MotionState& first)
      : motion_(motion), begin_(motion.energy(first)), work_(first.work) {
    add(first);
  }

  void add(const MotionState& state) {
    // Energy drift, kinetic energy, and the work turned over.
    const double made = motion_.energy(state) - begin_ - state.work + state.dissipated;
    error_ = max_or_nan(error_, std::abs(made));
    kinetic_ = max_or_nan(kinetic_, motion_.kinetic_energy(state));
    turned_ += std::abs(state.work - work_);
    work_ = state.work;
    lost_ = state.dissipated;
  }

  EnergyBalance balance() const { return {error_, kinetic_ + turned_ + lost_}; }

 private:
  FingerMotion& motion_;
  double begin_, work_, lost_ = 0, error_ = 0, kinetic_ = 0, turned_ = 0;
};

/// Whether the last steps have got anywhere.
class Patience {
 public:
  explicit Patience(int steps) : steps_(steps) {}

  /// @return false: give up
  bool go_on(double time) {
    // Judge progress once in every `steps_` steps.
    if (++count_ < steps_) return true;
    const bool far = time - since_ >= kStallTime;
    since_ = time;
    count_ = 0;
    return far;
  }

 private:
  int steps_, count_ = 0;
  double since_ = 0;
};

void check(const SimulateOptions& options) {
  require(options.seconds > 0 && options.sample > 0 && options.tolerance > 0 &&
              std::isfinite(options.seconds),
          "time, sample and tolerance must be positive, got {} s, {} s, {}", options.seconds,
          options.sample, options.tolerance);
  require(options.seconds / options.sample < 1e7, "{} s in samples of {} s are too many",
          options.seconds, options.sample);
  require(options.max_steps > 0 && options.stall_steps > 0,
          "wanted at least one step and some patience, got {} and {}", options.max_steps,
          options.stall_steps);
}

/// How a motion ends whose integrator did not step.
MotionStatus end_of(OdeStatus status) {
  return status == OdeStatus::kLimit ? MotionStatus::kLimit : MotionStatus::kIntegratorFailed;
}

/// One integration.
Trajectory integrate(const MotionModel& model, const std::vector<ExcitationPiece>& pieces,
                     const MotionStart& start, const SimulateOptions& options) {
  // First state, with activations of the first excitation if none are given.
  const ExcitationPiece* piece = &pieces.front();
  FingerMotion motion(model);
  const VectorXd still = VectorXd::Zero(start.q.size());
  const auto [first, warning] =
      motion.start(start.q, start.q_dot.size() > 0 ? start.q_dot : still,
                   start.activation.size() > 0 ? start.activation : piece->first);
  // Everything that is recorded begins with the first instant.
  Recorder recorder(model, motion, options);
  recorder.note(warning, 0);
  recorder.note(motion.accept(first).warning, 0);
  recorder.keep(first, piece->first);
  Account account(motion, first);
  Patience stall_steps(options.stall_steps);

  // Rates and their derivatives for the integrator.
  const auto slope = [&](double time, const VectorXd& y) {
    return motion.pack(motion.slope(motion.unpack(y), piece->at(time)));
  };
  const auto jacobian = [&](double time, const VectorXd& y) {
    return motion.jacobian(motion.unpack(y), piece->at(time));
  };
  StiffOde ode(
      slope, 0, motion.pack(first),
      {options.tolerance, options.tolerance * motion.scale(), options.max_steps, jacobian});
  const auto take = [&](MotionStatus status, const std::string& why) {
    return recorder.take(status, why, ode, account.balance());
  };

  // Integrate piece by piece of the excitation.
  for (const ExcitationPiece& next : pieces) {
    piece = &next;
    if (piece->jumps) ode.restart();
    while (ode.time() < piece->end) {
      const OdeStatus status = ode.step(piece->end);
      if (status != OdeStatus::kStepped) return take(end_of(status), reason(status));
      // Instants to keep lie within the last step.
      for (; recorder.next() <= ode.time();)
        recorder.keep(motion.unpack(ode.state_at(recorder.next())), piece->at(recorder.next()));
      // Accept the step, and account for its energy.
      const MotionState now = motion.unpack(ode.state());
      recorder.note_accepted(motion.accept(now), ode.time());
      account.add(now);
      // Progress, stopping and stalling.
      options.progress(ode.time() / options.seconds, "simulating");
      if (options.progress.stop()) return take(MotionStatus::kStopped, "");
      if (!stall_steps.go_on(ode.time()))
        return take(MotionStatus::kNoProgress,
                    fmt::format("{} steps took it less than {:.2g} s on, so it gave up",
                                options.stall_steps, kStallTime));
    }
  }
  return take(MotionStatus::kCompleted, "");
}

}  // namespace

Trajectory simulate(const MotionModel& model, const Excitation& excitation,
                    const MotionStart& start, const SimulateOptions& options) {
  check(options);
  const auto muscles = static_cast<Index>(model.tendons.digit().names.muscles.size());
  require(excitation.value.cols() == muscles, "the digit has {} muscles, {} are excited", muscles,
          excitation.value.cols());
  const std::vector<ExcitationPiece> pieces = excitation_pieces(excitation, options.seconds);

  // First integration.
  Trajectory path = integrate(model, pieces, start, options);
  const bool balanced = path.balance.holds();
  if (path.status != MotionStatus::kCompleted || (balanced && !has_jumped(path))) return path;
  // Energy does not balance, or the net jumped: once more with a smaller tolerance.
  SimulateOptions finer = options;
  finer.tolerance *= kFiner;
  // Smaller steps do not help a net that jumps by itself.
  if (balanced)
    finer.max_steps = static_cast<int>(
        std::min<double>(options.max_steps, kMoreSteps * static_cast<double>(path.counts.steps)));
  Trajectory again = integrate(model, pieces, start, finer);
  if (again.status == MotionStatus::kStopped) return again;
  // Keep the better one.
  const bool better = again.status == MotionStatus::kCompleted && again.balance.holds() &&
                      (!balanced || !(again.drift.value_or(0) >= path.drift.value_or(0)));
  if (better) path = std::move(again);
  if (!path.balance.holds()) path.status = MotionStatus::kUnbalanced;
  return path;
}

VectorXd energy_drift(const Trajectory& trajectory) {
  if (trajectory.energy.size() == 0) return {};
  return trajectory.energy.array() - trajectory.energy[0] -
         (trajectory.work - trajectory.dissipated).array();
}

double energy_error(const Trajectory& trajectory) {
  return trajectory.energy.size() > 0 ? max_or_nan(energy_drift(trajectory).cwiseAbs()) : 0;
}

}  // namespace thenar
