#include "report/answers/simulate.h"

#include <fmt/format.h>

#include "base/units.h"
#include "report/answers/passive_words.h"
#include "tendons/muscle/trajectory_table.h"

namespace thenar {
namespace {

/// Angles and speeds at the start and the end.
Table joint_summary(const Trajectory& t) {
  const Eigen::Index last = t.time.size() - 1;
  Table table{{"joint", "start_deg", "end_deg", "min_deg", "max_deg", "end_speed_deg_s"}};
  for (Eigen::Index j = 0; j < t.angle.cols(); ++j) {
    const Eigen::VectorXd angle = t.angle.col(j) / kDegree;
    table.add({nth(t.joints, j), shown(angle[0], 2), shown(angle[last], 2),
               shown(angle.minCoeff(), 2), shown(angle.maxCoeff(), 2),
               shown(t.speed(last, j) / kDegree, 2)});
  }
  return table;
}

/// Activations, tensions and lengths at the end.
Table muscle_summary(const Trajectory& t) {
  const Eigen::Index last = t.time.size() - 1;
  Table table{{"muscle", "end_activation", "end_tension_N", "max_tension_N", "end_excursion_mm",
               "end_fibre_per_optimal"}};
  for (Eigen::Index m = 0; m < t.tension.cols(); ++m)
    table.add({nth(t.muscles, m), shown(t.activation(last, m), 4), shown(t.tension(last, m), 3),
               shown(t.tension.col(m).maxCoeff(), 3), shown(t.excursion(last, m) / kMm, 3),
               t.fibre.size() > 0 ? shown(t.fibre(last, m), 3) : "-"});
  return table;
}

/// The first snaps of the net.
Table snap_table(const Trajectory& t) {
  constexpr std::size_t kMaxSnaps = 10;  // Most rows of snaps
  Table table{{"time_s", "band", "moved_mm", "released_mJ"}};
  for (std::size_t i = 0; i < std::min(t.snaps.size(), kMaxSnaps); ++i) {
    const MotionSnap& snap = t.snaps[i];
    table.add({shown(snap.time, 6), snap.band, shown(snap.moved / kMm, 3),
               shown(1e3 * snap.released, 4)});
  }
  if (t.snaps.size() > kMaxSnaps)
    table.add({fmt::format("{} more", t.snaps.size() - kMaxSnaps), "", "", ""});
  return table;
}

/// The state at the last instant.
Fields end_state(const DigitMotionResult& motion) {
  const Trajectory& t = motion.trajectory;
  const Eigen::Index last = t.time.size() - 1;
  Fields fields{
      {"time", units::kSecond, t.time[last]},
      {"posture", units::kDegree, t.joints, t.angle.row(last)},
      {"speed", units::kDegreePerSecondShort, t.joints, t.speed.row(last)},
      {"activation", units::kOne, t.muscles, t.activation.row(last)},
      {"tension", units::kNewton, t.muscles, t.tension.row(last)},
      {"excursion", units::kMillimetre, t.muscles, t.excursion.row(last)},
      {"slips", units::kNewton, {"central", "radial", "ulnar", "terminal"}, t.slips.row(last)},
      {"tip", units::kMillimetre, t.tip.row(last)}};
  if (motion.tendons) add_passive(motion.tendons->digit().skeleton, t.angle.row(last), fields);
  return fields;
}

}  // namespace

std::string text_of(const DigitMotionResult& motion) {
  const Trajectory& t = motion.trajectory;
  const Eigen::Index last = t.time.size() - 1;
  std::string text =
      fmt::format("{} of {}: {} after {:.4g} s\nmodel: {}\n\n", motion.digit, motion.subject,
                  name_of(t.status), t.time[last], describe(t.fidelity));
  text += titled("Joints", joint_summary(t));
  text += titled("Muscles (excursion: lengthening since the reference posture)", muscle_summary(t));
  // The tip, the energy account, the integration.
  text +=
      fmt::format("final tip position, subject's frame: ({}) mm\n",
                  fmt::join(cells(Eigen::Vector3d(t.tip.row(last).transpose() / kMm), 2), ", "));
  text += fmt::format(
      "work of the tendons {:.4g} mJ, dissipated in the joints {:.4g} mJ; energy error {:.2g} mJ "
      "of "
      "{:.4g} mJ total energy exchanged\n",
      1e3 * t.work[last], 1e3 * t.dissipated[last], 1e3 * t.balance.error,
      1e3 * t.balance.turned_over);
  text += fmt::format("largest deviation of a muscle excursion from the tendon length: {}\n",
                      t.drift ? fmt::format("{:.2g} mm", *t.drift / kMm) : "not applicable");
  if (motion.tendons) text += passive_line(motion.tendons->digit().skeleton, t.angle.row(last));
  if (!t.snaps.empty()) text += titled("Snaps of the net to another equilibrium", snap_table(t));
  return text + fmt::format("{} steps to a tolerance of {:.2g}\n", t.counts.steps, t.tolerance);
}

Fields fields_of(const DigitMotionResult& motion) {
  const Trajectory& t = motion.trajectory;
  const Eigen::Index last = t.time.size() - 1;
  return {{"subject", motion.subject},
          {"digit", motion.digit},
          {"fidelity", describe(t.fidelity)},
          {"status", name_of(t.status)},
          {"trouble", t.warning},
          {"warning", t.warning},
          {"instants", t.time.size()},
          {"last", end_state(motion)},
          {"work", units::kJoule, t.work[last]},
          {"lost", units::kJoule, t.dissipated[last]},
          {"energy_error", units::kJoule, t.balance.error},
          {"turned_over", units::kJoule, t.balance.turned_over},
          {"stray", units::kMillimetre, t.drift},
          {"drift", units::kMillimetre, t.drift},
          {"snaps", fields_of_each(t.snaps,
                                   [](const MotionSnap& snap) {
                                     return Fields{{"time", units::kSecond, snap.time},
                                                   {"band", snap.band},
                                                   {"moved", units::kMillimetre, snap.moved},
                                                   {"released", units::kJoule, snap.released}};
                                   })},
          {"released", units::kJoule, released_energy(t)},
          {"tolerance", t.tolerance},
          {"steps", t.counts.steps},
          {"slopes", t.counts.slopes},
          {"net_evaluations", t.effort}};
}

Table table_of(const DigitMotionResult& motion) {
  const TrajectoryTable numbers = trajectory_table(motion.trajectory);
  Table table{numbers.columns};
  const auto cell = [](double value) { return fmt::format("{:.9g}", value + 0.0); };
  for (const auto& instant : numbers.values.rowwise()) table.add(transformed(instant, cell));
  return table;
}

std::string refusal_of(const DigitMotionResult& motion) {
  const Trajectory& t = motion.trajectory;
  if (t.status == MotionStatus::kCompleted || t.status == MotionStatus::kStopped) return "";
  if (t.status == MotionStatus::kNoProgress) return "the motion does not get on: " + t.warning;
  if (t.status != MotionStatus::kUnbalanced) return "the motion is stuck: " + t.warning;
  return fmt::format("energy does not balance: error {:.2g} mJ of {:.4g} mJ total energy exchanged",
                     1e3 * t.balance.error, 1e3 * t.balance.turned_over);
}

}  // namespace thenar
