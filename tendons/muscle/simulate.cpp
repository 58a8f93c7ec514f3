#include "tendons/muscle/simulate.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Instants that are kept, in a trajectory with room for all.
class Recorder {
 public:
  Recorder(const MotionModel& model, FingerMotion& motion, const SimulateOptions& options)
      : model_(model),
        motion_(motion),
        sample_(options.sample),
        seconds_(options.seconds),
        room_(static_cast<Index>(std::floor(options.seconds / options.sample * (1 + 1e-12))) + 1) {
    const TendonDigit& digit = model.tendons.digit();
    kept_.joints = digit.names.coordinates;
    kept_.muscles = digit.names.muscles;
    kept_.fidelity = digit.fidelity | Fidelity(Motion::kDynamic, model.contraction.rung());
    const auto joints = static_cast<Index>(kept_.joints.size());
    const auto muscles = static_cast<Index>(kept_.muscles.size());
    for (VectorXd* v : {&kept_.time, &kept_.energy, &kept_.work, &kept_.lost}) v->resize(room_);
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
    kept_.time[i] = next();
    kept_.angle.row(i) = state.q;
    kept_.speed.row(i) = state.q_dot;
    kept_.excitation.row(i) = excitation;
    kept_.activation.row(i) = state.activation;
    kept_.tension.row(i) = now.tension;
    kept_.excursion.row(i) = state.excursion;
    kept_.fibre.row(i) = now.fibre;
    const SlipTension& slips = now.pull.slips;
    kept_.slips.row(i) << slips.central, slips.radial, slips.ulnar, slips.terminal;
    const TendonModel<double>& bones = model_.tendons.digit().model;
    kept_.tip.row(i) = moved(pose_tree(bones.tree, state.q), bones.tip_link, bones.tip);
    kept_.energy[i] = motion_.energy(state);
    kept_.work[i] = state.work;
    kept_.lost[i] = state.lost;
    note(now.pull.trouble, next());
    ++next_;
  }

  /// Keeps the first trouble, with its time.
  void note(const std::string& trouble, double time) {
    if (trouble.empty() || !kept_.trouble.empty()) return;
    kept_.trouble = fmt::format("{} (at {:.4g} s)", trouble, time);
  }

  Trajectory take(MotionStatus status, const std::string& why, const StiffOde& ode) {
    note(why, ode.time());
    kept_.status = status;
    kept_.counts = ode.counts();
    for (VectorXd* v : {&kept_.time, &kept_.energy, &kept_.work, &kept_.lost})
      v->conservativeResize(next_);
    for (Eigen::MatrixXd* m : {&kept_.angle, &kept_.speed, &kept_.excitation, &kept_.activation,
                               &kept_.tension, &kept_.excursion, &kept_.fibre})
      m->conservativeResize(next_, Eigen::NoChange);
    kept_.slips.conservativeResize(next_, Eigen::NoChange);
    kept_.tip.conservativeResize(next_, Eigen::NoChange);
    if (model_.contraction.rung() == Muscle::kBounds) kept_.fibre.resize(0, 0);
    return std::move(kept_);
  }

 private:
  const MotionModel& model_;
  FingerMotion& motion_;
  double sample_, seconds_;
  Index room_, next_ = 0;
  Trajectory kept_;
};

const char* reason(OdeStatus status) {
  switch (status) {
    case OdeStatus::kTooMany:
      return "more steps than allowed";
    case OdeStatus::kImpossible:
      return "the tolerance is below rounding";
    default:
      return "no step is short enough";
  }
}

void check(const SimulateOptions& options) {
  require(options.seconds > 0 && options.sample > 0 && options.tolerance > 0 &&
              std::isfinite(options.seconds),
          "time, sample and tolerance must be positive, got {} s, {} s, {}", options.seconds,
          options.sample, options.tolerance);
  require(options.seconds / options.sample < 1e7, "{} s in samples of {} s are too many",
          options.seconds, options.sample);
}

}  // namespace

Trajectory simulate(const MotionModel& model, const Excitation& excitation,
                    const MotionStart& start, const SimulateOptions& options) {
  check(options);
  const auto muscles = static_cast<Index>(model.tendons.digit().names.muscles.size());
  require(excitation.value.cols() == muscles, "the digit has {} muscles, {} are excited", muscles,
          excitation.value.cols());
  const std::vector<ExcitationPiece> pieces = excitation_pieces(excitation, options.seconds);
  const ExcitationPiece* piece = &pieces.front();

  FingerMotion motion(model);
  const VectorXd still = VectorXd::Zero(start.q.size());
  const auto [first, trouble] =
      motion.start(start.q, start.q_dot.size() > 0 ? start.q_dot : still,
                   start.activation.size() > 0 ? start.activation : piece->first);
  Recorder recorder(model, motion, options);
  recorder.note(trouble, 0);
  recorder.note(motion.accept(first), 0);
  recorder.keep(first, piece->first);

  const auto slope = [&](double time, const VectorXd& y) {
    return motion.pack(motion.slope(motion.unpack(y), piece->at(time)));
  };
  StiffOde ode(slope, 0, motion.pack(first),
               {options.tolerance, options.tolerance * motion.scale(), options.max_steps});

  for (const ExcitationPiece& next : pieces) {
    piece = &next;
    if (piece->jumps) ode.restart();
    while (ode.time() < piece->end) {
      const OdeStatus status = ode.step(piece->end);
      if (status != OdeStatus::kStepped)
        return recorder.take(MotionStatus::kStuck, reason(status), ode);
      for (; recorder.next() <= ode.time();)
        recorder.keep(motion.unpack(ode.state_at(recorder.next())), piece->at(recorder.next()));
      recorder.note(motion.accept(motion.unpack(ode.state())), ode.time());
      options.progress(ode.time() / options.seconds, "simulating");
      if (options.progress.stop()) return recorder.take(MotionStatus::kStopped, "", ode);
    }
  }
  return recorder.take(MotionStatus::kDone, "", ode);
}

double energy_error(const Trajectory& trajectory) {
  if (trajectory.energy.size() == 0) return 0;
  const VectorXd made = trajectory.energy.array() - trajectory.energy[0] -
                        (trajectory.work - trajectory.lost).array();
  return made.cwiseAbs().maxCoeff();
}

}  // namespace thenar
