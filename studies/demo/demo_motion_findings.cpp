#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/units.h"
#include "grasp/compare/closure_counts.h"
#include "report/pages/compare_rungs.h"
#include "studies/demo/demo_findings.h"

namespace thenar {
namespace {

/// The most accurate of a method's runs; null if none was solved.
const WorkPoint* most_accurate(const std::vector<WorkPoint>& points, SteppingMethod method) {
  const WorkPoint* best = nullptr;
  for (const WorkPoint& point : points)
    if (point.method == method && point.status == SceneStatus::kDone &&
        (best == nullptr || point.error < best->error))
      best = &point;
  return best;
}

std::string accuracy_words(const WorkPoint* point) {
  if (point == nullptr) return "nothing that was solved";
  return fmt::format("{:.2g} mm in {:.3g} ms", point->error / kMm, 1e3 * point->cpu_seconds);
}

/// Score of a hand over all objects.
struct HandScore {
  std::string hand;
  ClosureCount count;
  double epsilon = 0;  // largest of any grasp [1]
};

std::vector<HandScore> scores_of(const Comparison& comparison) {
  // Score each hand by its closures and its largest epsilon.
  std::vector<HandScore> scores;
  for (const std::string& hand : comparison.hands) {
    HandScore score{hand, count_closures(comparison, hand)};
    for (const HandOnObject& cell : comparison.cells) {
      if (cell.hand == hand && cell.closures > 0)
        score.epsilon = std::max(score.epsilon, cell.quantile(1));
    }
    scores.push_back(score);
  }
  return scores;
}

}  // namespace

Finding glass_finding(const SceneResult& glass) {
  // Follow the centre of mass of the glass, along the vertical.
  const Mechanism& mechanism = glass.built->scene.mechanism;
  const auto body = static_cast<std::size_t>(body_named(mechanism, "glass"));
  const Eigen::Vector3d com = mechanism.bodies[body].mass.com;
  const auto height = [&](const std::vector<Pose<double>>& X) { return (X[body] * com).z(); };
  const double fallen =
      (height(glass.measures.X_WB.front()) - height(glass.measures.X_WB.back())) / kMm;
  return {{"What becomes of a slippery wine glass in a hand that closes?",
           fmt::format("Figure 3 of [Miller2005]: a Barrett hand closes on a wine glass that lies "
                       "on a table, with friction 0.1. {:.3g} s were simulated.",
                       glass.run.samples.back().t),
           fmt::format("The fingers squeeze the tapered bowl out; it rolls, and at the end its "
                       "centre has fallen by {:.0f} mm.",
                       fallen)},
          fmt::format("Wine glass: a closing hand squeezes it out, and its centre falls by {:.0f} "
                      "mm.",
                      fallen)};
}

Finding thumb_mug_finding(const DemoMotion& motion) {
  // The pad has turned by the change of its angle towards the mug.
  const auto turned = [](const std::vector<PadState>& states) -> double {
    if (states.empty()) return NAN;
    // No minus before what rounds to zero.
    return std::round(10 * (states.front().angle - states.back().angle) / kDegree) / 10 + 0.0;
  };
  const double force = motion.pad.empty() ? NAN : motion.pad.back().force;
  return {{"Does a thumb roll onto its pad when it is pressed on a mug?",
           "Figure 8 of [Miller2005]: a thumb meets a mug on its ulnar side, and the grip "
           "tightens. The thumb's joints give way within capsules around their skewed axes; a "
           "second thumb turns on ideal hinges.",
           fmt::format("At {:.0f} N its pad has turned towards the mug by {:.1f} degrees with "
                       "joints that give, and by {:.1f} degrees on ideal hinges.",
                       force, turned(motion.pad), turned(motion.pad_on_pins))},
          fmt::format(
              "Thumb on a mug: at {1:.0f} N its pad turns by {0:.1f} degrees on compliant joints, "
              "by {2:.1f} on ideal hinges.",
              turned(motion.pad), force, turned(motion.pad_on_pins))};
}

Finding stepping_finding(const std::vector<WorkPoint>& points) {
  return {
      {"How accurate are scenes in motion, and what does accuracy cost?",
       "A ball rolls off another without slip; elliptic integrals give where it ends. Both "
       "methods of stepping ran with many settings.",
       fmt::format("Steps between events reach an error of {}, steps of a fixed length one of {}.",
                   accuracy_words(most_accurate(points, SteppingMethod::kEvents)),
                   accuracy_words(most_accurate(points, SteppingMethod::kTimeStepping)))},
      ""};
}

Finding hands_finding(const Comparison& comparison) {
  // Tell the share of closures of every hand, and which hand has the largest epsilon.
  const std::vector<HandScore> scores = scores_of(comparison);
  std::vector<std::string> closures;
  double widest = 0;
  std::string widest_hand;
  for (const HandScore& score : scores) {
    closures.push_back(fmt::format("{} {:.0f} %", score.hand, 100 * score.count.success_rate()));
    if (score.epsilon <= widest) continue;
    widest = score.epsilon;
    widest_hand = score.hand;
  }
  const std::string shares = fmt::format("{}", fmt::join(closures, ", "));
  return {
      {"How do a human hand and robot hands compare when they grasp?",
       fmt::format("{} hands approached {} objects ({}) from {} random directions each and "
                   "closed; then their contacts were measured.",
                   comparison.hands.size(), comparison.objects.size(),
                   fmt::join(comparison.objects, ", "), comparison.approaches),
       fmt::format("Approaches that end in force closure: {}. The largest epsilon, {:.3f}, is "
                   "that of {}.",
                   shares, widest, widest_hand)},
      fmt::format("Hands: approaches that end in force closure: {}; the largest epsilon, {:.3f}, "
                  "is that of {}.",
                  shares, widest, widest_hand)};
}

Finding pad_finding(const PressResult& pressed) {
  const PressInstant* end = pressed.end_of_motion();
  // The most accurate model that costs less than a millisecond.
  const PressRung* cheap = nullptr;
  for (const PressRung& rung : pressed.rungs)
    if (rung.message.empty() && !rung.finest && rung.cpu < 1e-3 &&
        (cheap == nullptr || rung.error < cheap->error))
      cheap = &rung;
  const std::string force = end == nullptr ? "was not solved"
                                           : fmt::format("is {:.3g} N on {:.3g} mm2", end->force,
                                                         end->area / (kMm * kMm));
  const std::string price =
      cheap == nullptr ? "No model costs less than a millisecond"
                       : fmt::format(
                             "Of models below a millisecond the best, {}, is off by {:.2g} % "
                             "in {:.2g} \u00b5s",
                             cheap->element, 100 * cheap->error, 1e6 * cheap->cpu);
  return {
      {"What does a finger pad do under an object, and how cheap may a model of it be?",
       fmt::format("The pad was pressed by {} with finite elements to a depth of {:.2g} mm, and "
                   "at that depth by each cheaper model.",
                   pressed.object.name, end == nullptr ? NAN : end->depth / kMm),
       fmt::format("The force {}. {}.", force, price)},
      fmt::format("Finger pads: under a {} the force {}. {}.", pressed.object.name, force, price)};
}

Finding pencil_finding(const RungComparison& pencil) {
  std::vector<std::string> parts;
  for (const RungRun& run : pencil.runs)
    if (&run != &pencil.runs[pencil.finest])
      parts.push_back(fmt::format("{} {:.3g} % in {:.2g} s", run.rung, 100 * run.error.force_end,
                                  cpu_per_second(run)));
  return {{"What do models of finger pads cost when a pencil is pinched, and how far are they off?",
           fmt::format("A pencil was pinched between thumb and index finger on {} rungs of pads.",
                       pencil.runs.size()),
           fmt::format("{}. Errors of the normal forces at the end, and processor time for a "
                       "simulated second: {}.",
                       finest_words(pencil), fmt::join(parts, ", "))},
          ""};
}

}  // namespace thenar
