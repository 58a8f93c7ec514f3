#include "api/simulate.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "api/named/files.h"
#include "api/named/result_origin.h"
#include "base/enum_names.h"
#include "base/error.h"
#include "base/lists.h"
#include "base/units.h"
#include "data/io/result_file.h"
#include "tendons/muscle/contraction.h"
#include "tendons/muscle/excitation.h"
#include "tendons/muscle/finger_motion.h"
#include "tendons/muscle/simulate.h"

namespace thenar {
namespace {

/// Slack lengths of tendons that the subject does not state, or others.
void set_slack(const std::map<std::string, double>& slack, Subject& subject) {
  // Names must be muscles of the subject, lengths positive.
  const std::vector<std::string> names = names_of(subject.muscles);
  (void)in_order(slack, names, "muscle", "tendon_slack");  // refuses unknown names
  for (MuscleUnit& muscle : subject.muscles) {
    const auto found = slack.find(muscle.name);
    if (found == slack.end()) continue;
    require_field("tendon_slack", found->second > 0, "wanted a slack length > 0 of '{}', got {} mm",
                  muscle.name, found->second / kMm);
    muscle.tendon_slack = found->second;
  }
}

/// Returns the requested excitation; adds its file to the sources.
Excitation excitation_of(const DigitMotionRequest& request, const std::vector<std::string>& muscles,
                         std::vector<SourceText>& sources) {
  // One kind of input, and at least something that moves the digit.
  require_field("excitation_file", request.excitation.empty() || request.excitation_file.empty(),
                "wanted excitations of muscles or a file of them, got both");
  require_field(
      "excitation",
      !request.excitation.empty() || !request.excitation_file.empty() || !request.gravity.isZero(0),
      "wanted what moves the digit: excitations of muscles, a file of them, or gravity");
  for (const auto& [muscle, value] : request.excitation)
    require_field("excitation", value >= 0 && value <= 1,
                  "wanted excitations from 0 to 1, got {} of '{}'", value, muscle);
  if (request.excitation_file.empty())
    return constant_excitation(in_order(request.excitation, muscles, "muscle", "excitation"));
  sources.push_back(read_source(request.excitation_file));
  return parse_excitation(sources.back().text, request.excitation_file, muscles);
}

/// Numbers of every instant.
void add_instants(const Trajectory& t, ResultFile& file) {
  // Tables over the instants: motion of joints, then muscles, then the account of energy.
  file.add("time", t.time, "s", {"instant"});
  file.add("angle", t.angle, "rad", {"instant", "joint"});
  file.add("speed", t.speed, "rad/s", {"instant", "joint"});
  file.add("excitation", t.excitation, "1", {"instant", "muscle"});
  file.add("activation", t.activation, "1", {"instant", "muscle"});
  file.add("tension", t.tension, "N", {"instant", "muscle"});
  file.add("excursion", t.excursion, "m", {"instant", "muscle"});
  if (t.fibre.size() > 0) file.add("fibre", t.fibre, "1", {"instant", "muscle"});
  file.add("slips", t.slips, "N", {"instant", "slip"});
  file.add("name/slip", std::vector<std::string>{"central", "radial", "ulnar", "terminal"});
  file.add("tip", t.tip, "m", {"instant", "axis"});
  file.add("energy", t.energy, "J", {"instant"});
  file.add("work", t.work, "J", {"instant"});
  file.add("lost", t.dissipated, "J", {"instant"});
}

/// Snaps of a net; nothing where there are none.
void add_snaps(const Trajectory& t, ResultFile& file) {
  if (t.snaps.empty()) return;
  // A snap is a jump of the net to another equilibrium, which releases energy.
  const auto count = static_cast<Eigen::Index>(t.snaps.size());
  std::vector<std::string> bands;
  Eigen::VectorXd time(count), moved(count), released(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const MotionSnap& snap = t.snaps[static_cast<std::size_t>(i)];
    bands.push_back(snap.band);
    time[i] = snap.time, moved[i] = snap.moved, released[i] = snap.released;
  }
  file.add("snap/band", bands);
  file.add("snap/time", time, "s", {"snap"});
  file.add("snap/moved", moved, "m", {"snap"});
  file.add("snap/released", released, "J", {"snap"});
}

/// Adds the rungs from which the digit can be built again.
void add_rungs(const TendonOptions& rungs, PassiveMoments passive, ResultFile& file) {
  // The words of the rungs, which read_motion() turns back.
  const std::vector<RungWords> words = explain(Fidelity(rungs.path, rungs.hood));
  file.add("rungs/path", words[kPathLadder].rung);
  file.add("rungs/hood", words[kHoodLadder].rung);
  file.add("rungs/wrist", rungs.wrist_mode == WristMode::kFree ? "free" : "welded");
  file.add("rungs/passive", name_in(kPassiveNames, passive));
  if (rungs.frozen.empty()) return;
  std::vector<std::string> joints;
  Eigen::VectorXd angles(static_cast<Eigen::Index>(rungs.frozen.size()));
  for (const auto& [joint, angle] : rungs.frozen) {
    angles[static_cast<Eigen::Index>(joints.size())] = angle;
    joints.push_back(joint);
  }
  file.add("name/frozen", joints);
  file.add("rungs/frozen_angle", angles, "rad", {"frozen"});
}

/// Returns the requested muscle rung; else rigid tendons where the subject states the fibre lengths
/// of all, else bounds, with a warning.
Muscle muscle_rung(const DigitMotionRequest& request, const Subject& subject,
                   const TendonDigit& digit, std::vector<std::string>& warnings) {
  // The request decides; otherwise the best rung that the subject has data for.
  if (request.muscle) return *request.muscle;
  const std::string without = muscle_without_fibre(subject, digit);
  if (without.empty()) return Muscle::kRigidTendon;
  require_field(
      "tendon_slack", request.tendon_slack.empty(),
      "slack lengths of tendons are those of fibres: subject '{}' states no 'fibre_length_mm' "
      "of '{}'",
      subject.name, without);
  warnings.push_back(
      fmt::format("muscles pull by their bounds alone, whatever their length and speed, as subject "
                  "'{}' states no 'fibre_length_mm' of '{}'",
                  subject.name, without));
  return Muscle::kBounds;
}

Status status_of(MotionStatus status) {
  if (status == MotionStatus::kCompleted) return Status::kSolved;
  if (status == MotionStatus::kStopped) return Status::kStopped;
  return status == MotionStatus::kLimit ? Status::kLimit : Status::kStalled;
}

}  // namespace

DigitMotionResult simulate_digit(const DigitMotionRequest& request, const Progress& progress) {
  // Refuse a blend of no length, and a damping that would add energy.
  require_field("blend", request.blend > 0, "wanted a strain above 0 to blend over, got {}",
                request.blend);
  require_field("damping", request.damping >= 0, "wanted a damping of at least 0 N m s/rad, got {}",
                request.damping);
  // The digit at its start.
  DigitCase at = build_digit(request.digit, Hood::kFractions);
  require_field("digit", at.map.empty(),
                "digit '{}' of '{}' has no bones, only tip map '{}'; it cannot move", at.digit,
                at.subject.name, at.map);
  set_slack(request.tendon_slack, at.subject);
  DigitMotionResult motion{request, {},         at.subject.name, at.digit,  at.tendons,
                           {},      at.sources, at.rungs,        at.passive};
  motion.outcome.warn(at.warnings);
  const TendonDigit& digit = at.bones();
  const std::vector<std::string>& muscles = digit.names.muscles;
  require_field("digit", !muscles.empty(),
                "no muscle of subject '{}' crosses a free joint of this digit", motion.subject);
  const MotionStart start{at.grid.postures.front(),
                          {},
                          Eigen::VectorXd::Zero(static_cast<Eigen::Index>(muscles.size()))};
  // The physics.
  const Muscle rung = muscle_rung(request, at.subject, digit, motion.outcome.warnings);
  const auto contraction = build_contraction(musculotendons(at.subject, digit, rung), rung);
  MotionModel model{*motion.tendons, *contraction};
  model.gravity = request.gravity;
  model.resistance.damping = request.damping;
  model.blend = request.blend;
  SimulateOptions options;
  options.seconds = request.seconds;
  options.sample = request.sample;
  options.tolerance = request.tolerance;
  options.progress = progress;
  const Excitation excitation = excitation_of(request, muscles, motion.sources);
  // Integrate the equations of motion until the time is over, or the motion cannot go on.
  motion.trajectory = simulate(model, excitation, start, options);
  motion.outcome.status = status_of(motion.trajectory.status);
  motion.outcome.warn(motion_warnings(motion.trajectory));
  return motion;
}

std::vector<std::string> motion_warnings(const Trajectory& trajectory) {
  const bool ended = trajectory.status == MotionStatus::kCompleted ||
                     trajectory.status == MotionStatus::kStopped ||
                     trajectory.status == MotionStatus::kUnbalanced;
  if (trajectory.warning.empty() || !ended) return {};
  return {trajectory.warning};
}

void write_motion(const DigitMotionResult& motion, const std::string& path, const RunRecord& run) {
  // Who moved, and how it ended.
  const Trajectory& t = motion.trajectory;
  ResultFile file;
  file.add("format", kMotionFormat);
  file.add("status", name_of(t.status));
  file.add("trouble", t.warning);
  file.add("subject", motion.subject);
  file.add("digit", motion.digit);
  file.add("name/joint", t.joints);
  file.add("name/muscle", t.muscles);
  add_rungs(motion.rungs, motion.passive, file);
  add_instants(t, file);
  // The account: energy that does not balance, and how far constraints have drifted.
  file.add("energy_error", t.balance.error, "J");
  file.add("turned_over", t.balance.turned_over, "J");
  file.add("stray", t.drift.value_or(std::nan("")), "m");
  add_snaps(t, file);
  file.add("tolerance", t.tolerance, "1");
  add_origin(motion.sources, run, file);
  file.add("provenance/fidelity", describe(motion.trajectory.fidelity));
  write_result(file, path);
}

std::string name_of(MotionStatus status) {
  constexpr std::array kWords{EnumName{MotionStatus::kCompleted, "done"},
                              EnumName{MotionStatus::kStopped, "stopped"},
                              EnumName{MotionStatus::kLimit, "stuck"},
                              EnumName{MotionStatus::kIntegratorFailed, "stuck"},
                              EnumName{MotionStatus::kNoProgress, "no progress"},
                              EnumName{MotionStatus::kUnbalanced, "energy does not balance"}};
  return name_in(kWords, status);
}

}  // namespace thenar
