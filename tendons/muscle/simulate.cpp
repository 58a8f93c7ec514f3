#include "tendons/muscle/simulate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/enum_names.h"
#include "base/error.h"
#include "base/numbers.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Drift of an excursion above which integration errors do not explain it [m]
constexpr double kMaxDrift = 1e-4;
// Tolerance of the second integration over that of the first [1]
constexpr double kFinerToleranceRatio = 0.01;
constexpr int kSnapPieces = 16;  // number of pieces into which a step with a snap is divided
// Trials without an equilibrium of the net after which a motion ends
constexpr int kMaxObstacles = 30;
// Largest number of steps of the second integration over those of the first [1]
constexpr double kMaxStepsRatio = 5;
// Allowed error of a step over the tolerance, where steps make no progress [1]
constexpr double kLooseErrorRatio = 100;
constexpr double kLooseTime = 10 * kStallTime;  // time for which the larger error is allowed [s]
constexpr int kMaxLoosePeriods = 20;            // periods with larger errors in a motion

/// Returns whether excursions left their lines without any snap.
bool has_strayed(const Trajectory& path) {
  return path.snaps.empty() && !(path.drift.value_or(0) <= kMaxDrift);
}

/// Describes the first snap of a net, and the number of snaps.
std::string snap_words(const Trajectory& path) {
  const MotionSnap& first = path.snaps.front();
  return fmt::format(
      "the net snapped to another rest, band '{}' first, a knot by {:.2g} mm; {} released {:.2g} "
      "mJ",
      first.band, 1e3 * first.moved,
      path.snaps.size() == 1 ? "it" : fmt::format("{} snaps", path.snaps.size()),
      1e3 * released_energy(path));
}

/// Recorder of instants in a trajectory with memory for all.
class Recorder {
 public:
  Recorder(const MotionModel& model, FingerMotion& motion, const SimulateOptions& options)
      : model_(model),
        motion_(motion),
        sample_(options.sample),
        seconds_(options.seconds),
        tolerance_(options.tolerance),
        capacity_(static_cast<Index>(std::floor(options.seconds / options.sample * (1 + 1e-12))) +
                  1) {
    // Set names and fidelity.
    const TendonDigit& digit = model.tendons.digit();
    kept_.joints = digit.names.coordinates;
    kept_.muscles = digit.names.muscles;
    kept_.fidelity = digit.fidelity | Fidelity(Motion::kDynamic, model.contraction.rung());
    // Allocate all instants.
    const auto joints = static_cast<Index>(kept_.joints.size());
    const auto muscles = static_cast<Index>(kept_.muscles.size());
    for (VectorXd* v : {&kept_.time, &kept_.energy, &kept_.work, &kept_.dissipated})
      v->resize(capacity_);
    for (Eigen::MatrixXd* m : {&kept_.angle, &kept_.speed}) m->resize(capacity_, joints);
    for (Eigen::MatrixXd* m :
         {&kept_.excitation, &kept_.activation, &kept_.tension, &kept_.excursion, &kept_.fibre})
      m->resize(capacity_, muscles);
    kept_.slips.resize(capacity_, 4);
    kept_.tip.resize(capacity_, 3);
  }

  /// Returns the time of the next instant to keep [s]; infinite if there is none.
  [[nodiscard]] double next() const {
    return next_ < capacity_ ? std::min(static_cast<double>(next_) * sample_, seconds_) : HUGE_VAL;
  }

  /// Records an instant.
  void record(const MotionState& state, const VectorXd& excitation) {
    const MotionInstant now = motion_.instant_at(state);
    const Index i = next_;
    // Record states and tensions.
    kept_.time[i] = next();
    kept_.angle.row(i) = state.q;
    kept_.speed.row(i) = state.q_dot;
    kept_.excitation.row(i) = excitation;
    kept_.activation.row(i) = state.activation;
    kept_.tension.row(i) = now.tension;
    kept_.excursion.row(i) = now.excursion;
    kept_.fibre.row(i) = now.fibre;
    // Record slips of the hood, and the tip.
    const SlipTension& slips = now.pull.slips;
    kept_.slips.row(i) << slips.central, slips.radial, slips.ulnar, slips.terminal;
    const TendonModel<double>& bones = model_.tendons.digit().model;
    kept_.tip.row(i) = moved(pose_tree(bones.tree, state.q), bones.tip_link, bones.tip);
    // Record energies.
    kept_.energy[i] = motion_.energy(state);
    kept_.work[i] = state.work;
    kept_.dissipated[i] = state.dissipated;
    add_warning(now.pull.warning, next());
    ++next_;
  }

  /// Stores the first warning, with its time.
  void add_warning(const std::string& warning, double time) {
    if (warning.empty() || !kept_.warning.empty()) return;
    kept_.warning = fmt::format("{} (at {:.4g} s)", warning, time);
  }

  /// Records snaps, drift and warning of an accepted state.
  void record_accepted(const FingerMotion::Accepted& accepted, double time) {
    add_warning(accepted.warning, time);
    for (const NetSnap& snap : accepted.net.snaps)
      kept_.snaps.push_back(
          {reached_ + snap.share * (time - reached_), snap.band, snap.moved, snap.released});
    reached_ = time;
    if (accepted.drift.size() == 0) return;
    // Update the largest drift and its muscle.
    Index most = 0;
    const double drift = accepted.drift.cwiseAbs().maxCoeff<Eigen::PropagateNaN>(&most);
    const double before = kept_.drift.value_or(0);
    if (kept_.drift && (drift <= before || std::isnan(before))) return;
    // Store the first time at which the drift is too large.
    if (before <= kMaxDrift) drift_time_ = time;
    kept_.drift = drift;
    drift_muscle_ = kept_.muscles[most];
  }

  /// Puts a reason before all other warnings.
  void prepend_warning(const std::string& why, double time) {
    if (why.empty()) return;
    const std::string before = std::exchange(kept_.warning, "");
    add_warning(why, time);
    if (!before.empty()) kept_.warning += "; " + before;
  }

  /// Finishes the trajectory and returns it.
  Trajectory take(MotionStatus status, const std::string& why, const StiffOde& ode,
                  const EnergyBalance& balance) {
    if (has_strayed(kept_))
      prepend_warning(fmt::format("the excursion of '{}' came off its line by up to {:.2g} mm",
                                  drift_muscle_, 1e3 * *kept_.drift),
                      drift_time_);
    // Prepend drift, snaps and the reason for the end to the warning.
    if (!kept_.snaps.empty()) prepend_warning(snap_words(kept_), kept_.snaps.front().time);
    prepend_warning(why, ode.time());
    kept_.status = status;
    kept_.balance = balance;
    kept_.tolerance = tolerance_;
    kept_.counts = ode.counts();
    // Cut the arrays to the recorded instants.
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
  Index capacity_, next_ = 0;
  double drift_time_ = 0;     // first time with a drift above kMaxDrift [s]
  double reached_ = 0;        // time of the last accepted state [s]
  std::string drift_muscle_;  // muscle of the largest drift
  Trajectory kept_;
};

/// End of a motion with its reason, thrown where it is found.
struct Ending {
  MotionStatus status;
  std::string message;
};

constexpr std::array kOdeReasons{
    EnumName{OdeStatus::kStepped, ""},
    EnumName{OdeStatus::kLimit, "more steps than allowed"},
    EnumName{OdeStatus::kTooStiff, "no step is short enough"},
    EnumName{OdeStatus::kNotFinite, "rates are not finite, however short the step"},
    EnumName{OdeStatus::kSingular, "the equations of a step are singular"},
    EnumName{OdeStatus::kImpossible, "the tolerance is below rounding"},
    EnumName{OdeStatus::kFailed, "the integrator failed"}};

/// Describes why the integrator ended, with the obstacle of the last trial.
std::string reason(OdeStatus status, const FingerMotion& motion) {
  const std::string& obstacle = motion.obstacle();
  return name_in(kOdeReasons, status) + (obstacle.empty() ? "" : ": " + obstacle);
}

/// Energy balance, summed over steps.
class EnergyAccount {
 public:
  EnergyAccount(FingerMotion& motion, const MotionState& first)
      : motion_(motion), begin_(motion.energy(first)), work_(first.work) {
    add(first, {});
  }

  /// Adds an accepted state.
  void add(const MotionState& state, const NetStep& net) {
    // Update the energy error of the bones and of the net.
    net_error_ += net.unexplained;
    const double excess = motion_.energy(state) - begin_ - state.work + state.dissipated;
    error_ = max_or_nan({error_, std::abs(excess), std::abs(net_error_)});
    // Update the largest kinetic energy and the total work.
    kinetic_ = max_or_nan(kinetic_, motion_.kinetic_energy(state));
    turned_ += std::abs(state.work - work_);
    work_ = state.work;
    lost_ = state.dissipated;
  }

  [[nodiscard]] EnergyBalance balance() const { return {error_, kinetic_ + turned_ + lost_}; }

 private:
  FingerMotion& motion_;
  double begin_, work_, net_error_ = 0, lost_ = 0, error_ = 0, kinetic_ = 0, turned_ = 0;
};

/// Monitor of the progress of the last steps.
class ProgressMonitor {
 public:
  explicit ProgressMonitor(int steps) : steps_(steps) {}

  /// Counts a step. @return false: the motion has stalled
  bool advances(double time) {
    // Check progress once in every `steps_` steps.
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

/// Checks the options.
void check_options(const SimulateOptions& options) {
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

/// Returns the status of a motion whose integrator did not step.
MotionStatus end_of(OdeStatus status) {
  return status == OdeStatus::kLimit ? MotionStatus::kLimit : MotionStatus::kIntegratorFailed;
}

/// Starts a motion, with the first excitation as activation and zero speed where none are given.
MotionOnset onset(FingerMotion& motion, const MotionStart& start, const VectorXd& excitation) {
  const VectorXd still = VectorXd::Zero(start.q.size());
  return motion.start(start.q, start.q_dot.size() > 0 ? start.q_dot : still,
                      start.activation.size() > 0 ? start.activation : excitation);
}

/// Integration of a motion, piece by piece of the excitation.
class Integration {
 public:
  Integration(const MotionModel& model, const std::vector<ExcitationPiece>& pieces,
              const MotionStart& start, const SimulateOptions& options)
      : pieces_(pieces),
        options_(options),
        piece_(&pieces.front()),
        motion_(model),
        first_(onset(motion_, start, piece_->first)),
        begun_(motion_.accept(first_.state)),
        recorder_(model, motion_, options),
        account_(motion_, first_.state),
        stall_steps_(options.stall_steps),
        ode_([this](double time, const VectorXd& y) { return slope(time, y); }, 0,
             motion_.pack(first_.state),
             {options.tolerance, options.tolerance * motion_.scale(), options.max_steps,
              [this](double time, const VectorXd& y) { return jacobian(time, y); }}) {}

  /// Integrates to the end.
  Trajectory run() {
    recorder_.add_warning(first_.warning, 0);
    recorder_.record_accepted(begun_, 0);
    recorder_.record(first_.state, piece_->first);
    Ending end{MotionStatus::kCompleted, ""};
    try {
      for (const ExcitationPiece& next : pieces_) {
        piece_ = &next;
        if (piece_->jumps) restart();
        while (ode_.time() < piece_->end) step();
      }
    } catch (const Ending& early) {
      end = early;
    }
    warn_loose();
    Trajectory path = recorder_.take(end.status, end.message, ode_, account_.balance());
    path.effort = motion_.effort();
    return path;
  }

 private:
  /// Ends the motion, also from within a step, if it is stopped or its net takes too many
  /// evaluations.
  void check_limits() const {
    if (options_.progress.stop()) throw Ending{MotionStatus::kStopped, ""};
    if (motion_.effort() > allowed_effort(options_))
      throw Ending{MotionStatus::kLimit,
                   fmt::format("its net took more than {} evaluations of energy, so it gave up",
                               allowed_effort(options_))};
  }

  VectorXd slope(double time, const VectorXd& y) {
    check_limits();
    const VectorXd rates = motion_.pack(motion_.slope(motion_.unpack(y), piece_->value_at(time)));
    if (!motion_.obstacle().empty()) count_obstacle();
    return rates;
  }

  /// Ends the motion after too many trials without an equilibrium of the net, however short the
  /// step.
  void count_obstacle() {
    if (ode_.time() - obstacle_since_ >= kStallTime) {
      obstacle_since_ = ode_.time();
      obstacles_ = 0;
    }
    if (++obstacles_ >= kMaxObstacles)
      throw Ending{MotionStatus::kIntegratorFailed,
                   motion_.obstacle() + ", however short the step"};
  }

  Eigen::MatrixXd jacobian(double time, const VectorXd& y) {
    check_limits();
    return motion_.jacobian(motion_.unpack(y), piece_->value_at(time));
  }

  /// Takes one step, and records the instants within it.
  void step() {
    const OdeStatus status = ode_.step(piece_->end);
    // Restart once where no step is short enough, without the history of earlier steps.
    if (status == OdeStatus::kTooStiff && ode_.time() > restart_time_) {
      restart_time_ = ode_.time();
      return restart();
    }
    if (status != OdeStatus::kStepped) throw Ending{end_of(status), reason(status, motion_)};
    // Record instants within the last step.
    for (; recorder_.next() <= ode_.time();)
      recorder_.record(motion_.unpack(ode_.state_at(recorder_.next())),
                       piece_->value_at(recorder_.next()));
    // Follow a net that snaps through the step in pieces, to find the time.
    const MotionState now = motion_.unpack(ode_.state());
    if (motion_.snaps_before(now))
      for (int i = 1; i < kSnapPieces; ++i) {
        const double time = accepted_ + (ode_.time() - accepted_) * i / kSnapPieces;
        accept(motion_.unpack(ode_.state_at(time)), time);
      }
    accept(now, ode_.time());
    // Report progress, and check limits and stalling.
    options_.progress(ode_.time() / options_.seconds, "simulating");
    check_limits();
    handle_stall();
  }

  /// Restarts the integrator, with the presently allowed errors.
  void restart() { ode_.restart(loose_ ? kLooseErrorRatio : 1); }

  /// Allows larger errors for a while where rates jump, so that steps within the tolerance make no
  /// progress, for example where many bands of a net become slack. The energy balance includes
  /// these errors.
  void handle_stall() {
    // End a period of larger errors.
    if (loose_ && ode_.time() - loose_since_ >= kLooseTime) {
      loose_ = false;
      restart();
    }
    if (stall_steps_.advances(ode_.time())) return;
    // Start another period, or end the motion.
    if (loose_ || loose_periods_ == kMaxLoosePeriods)
      throw Ending{MotionStatus::kNoProgress,
                   fmt::format("{} steps took it less than {:.2g} s on, so it gave up",
                               options_.stall_steps, kStallTime)};
    loose_ = true;
    loose_since_ = ode_.time();
    ++loose_periods_;
    restart();
  }

  /// Adds a warning about periods with larger errors.
  void warn_loose() {
    if (loose_periods_ == 0) return;
    recorder_.prepend_warning(
        fmt::format("its rates jump: in {} stretch{} of {:.2g} s steps had {} times the error of "
                    "the tolerance, the last",
                    loose_periods_, loose_periods_ == 1 ? "" : "es", kLooseTime, kLooseErrorRatio),
        loose_since_);
  }

  /// Accepts a state, and adds it to the energy balance.
  void accept(const MotionState& state, double time) {
    const FingerMotion::Accepted accepted = motion_.accept(state);
    recorder_.record_accepted(accepted, time);
    account_.add(state, accepted.net);
    accepted_ = time;
  }

  const std::vector<ExcitationPiece>& pieces_;
  const SimulateOptions& options_;
  const ExcitationPiece* piece_;
  FingerMotion motion_;
  MotionOnset first_;
  FingerMotion::Accepted begun_;
  Recorder recorder_;
  EnergyAccount account_;
  ProgressMonitor stall_steps_;
  int obstacles_ = 0;          // trials without an equilibrium of the net ...
  double obstacle_since_ = 0;  // ... since this time [s]
  double accepted_ = 0;        // time of the last accepted state [s]
  double restart_time_ = -1;   // time of the last restart of the integrator [s]
  bool loose_ = false;         // true: steps may have kLooseErrorRatio times the error ...
  double loose_since_ = 0;     // ... since this time [s]
  int loose_periods_ = 0;      // number of such periods [1]
  StiffOde ode_;
};

}  // namespace

Trajectory simulate(const MotionModel& model, const Excitation& excitation,
                    const MotionStart& start, const SimulateOptions& options) {
  check_options(options);
  const auto muscles = static_cast<Index>(model.tendons.digit().names.muscles.size());
  require(excitation.value.cols() == muscles, "the digit has {} muscles, {} are excited", muscles,
          excitation.value.cols());
  const std::vector<ExcitationPiece> pieces = excitation_pieces(excitation, options.seconds);

  // Integrate to the tolerance.
  Trajectory path = Integration(model, pieces, start, options).run();
  const bool balanced = path.balance.holds();
  if (path.status != MotionStatus::kCompleted || (balanced && !has_strayed(path))) return path;
  // Integrate again with a smaller tolerance if energy does not balance or excursions drifted.
  SimulateOptions finer = options;
  finer.tolerance *= kFinerToleranceRatio;
  finer.max_effort = std::max(1L, allowed_effort(options) - path.effort);
  // Limit the steps if only excursions drifted, where smaller steps may not help.
  if (balanced)
    finer.max_steps = static_cast<int>(std::min<double>(
        options.max_steps, kMaxStepsRatio * static_cast<double>(path.counts.steps)));
  Trajectory again = Integration(model, pieces, start, finer).run();
  if (again.status == MotionStatus::kStopped) return again;
  // Return the better one.
  const bool better = again.status == MotionStatus::kCompleted && again.balance.holds() &&
                      (!balanced || !(again.drift.value_or(0) >= path.drift.value_or(0)));
  if (better) path = std::move(again);
  if (!path.balance.holds()) path.status = MotionStatus::kUnbalanced;
  return path;
}

long allowed_effort(const SimulateOptions& options) {
  if (options.max_effort > 0) return options.max_effort;
  return kMinEffort + std::lround(kEffortPerSecond * options.seconds);
}

}  // namespace thenar
