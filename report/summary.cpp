#include "report/summary.h"

#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/lists.h"
#include "base/nearest_name.h"
#include "base/units.h"
#include "base/words.h"
#include "posterior/hand_posterior.h"

namespace thenar {
namespace {

std::string summary(const Subject& subject) {
  const std::vector<std::string> digits = names_of(subject.digits);
  std::string text = fmt::format(
      "subject '{}': {}, {}, {}, {}", subject.name, counted(subject.segments.size(), "segment"),
      counted(subject.joints.size(), "joint"), counted(subject.muscles.size(), "muscle"),
      counted(digits.size(), "digit"));
  if (!digits.empty()) text += fmt::format(" ({})", listed(digits));
  if (!subject.tip_maps.empty()) text += ", " + counted(subject.tip_maps.size(), "tip map");
  return text;
}

std::string summary(const Experiment& experiment) {
  std::set<std::string> muscles;
  for (const Trial& trial : experiment.trials)
    for (const auto& [muscle, tension] : trial.tension) muscles.insert(muscle);
  return fmt::format(
      "experiment '{}': {} {}{} of specimen {}, {}, {}, {} loaded", experiment.name,
      experiment.species, experiment.digit, experiment.digit == "thumb" ? "" : " finger",
      experiment.specimen, counted(experiment.trials.size(), "trial"),
      counted(experiment.postures.size(), "posture"), counted(muscles.size(), "muscle"));
}

std::string summary(const FitSettings& settings) {
  return fmt::format("fit settings: {}, {}", counted(settings.rules.size(), "parameter rule"),
                     counted(settings.axis_distances.size(), "axis distance"));
}

std::string summary(const HandProportions& hand) {
  std::size_t segments = 0, joints = 0;
  for (const DigitProportion& digit : hand.digits)
    for (const SegmentProportion& segment : digit.segments) {
      ++segments;
      joints += segment.joints.size();
    }
  return fmt::format("proportions '{}': {}, {}, {}", hand.name,
                     counted(hand.digits.size(), "digit"), counted(segments, "segment"),
                     counted(joints, "joint"));
}

std::string summary(const DigitVariability& digit) {
  return fmt::format("variability of axes '{}': {} axes about '{}'", digit.name, digit.axes.size(),
                     digit.mean_subject);
}

std::string summary(const PinchLosses& losses) {
  return fmt::format("losses of pinch '{}': {} under {} ({})", losses.name, losses.digit,
                     counted(losses.blocks.size(), "nerve block"),
                     listed(transformed(losses.blocks, &NerveBlock::nerve)));
}

std::string summary(const NetDescription& net) {
  return fmt::format("net '{}': {}, {}, {}", net.name, counted(net.nodes.size(), "node"),
                     counted(net.bands.size(), "band"), counted(net.muscles.size(), "muscle"));
}

std::string summary(const Fit& fit) {
  std::size_t trials = 0;
  for (const Experiment& experiment : fit.problem.experiments()) trials += experiment.trials.size();
  return fmt::format("fit of {} to {} of {}: {}, {}", fit.inputs.subject.path,
                     counted(trials, "trial"),
                     counted(fit.problem.experiments().size(), "experiment"),
                     counted(static_cast<std::size_t>(fit.problem.size()), "coordinate"),
                     convergence_word(fit.solution));
}

std::string summary(const BodySpec& body) {
  std::vector<std::string> kinds;
  for (const ShapeSpec& shape : body.shapes) kinds.push_back(name_of(shape.kind));
  return fmt::format("object '{}': {} ({}), material {}", body.name, counted(kinds.size(), "shape"),
                     listed(kinds), body.material.empty() ? "unknown" : body.material);
}

std::string summary(const WorldSpec& world) {
  std::size_t objects = 0;
  for (const PlacedBody& placed : world.bodies) objects += placed.dynamic ? 1 : 0;
  return fmt::format("world '{}': {} ({}), {}, {}", world.name, counted(world.hands.size(), "hand"),
                     listed(names_of(world.hands)), counted(objects, "object"),
                     counted(world.bodies.size() - objects, "obstacle"));
}

/// "2 pads (soft-finger), "; nothing without pads.
std::string pad_words(const std::vector<ScenePadSpec>& pads) {
  if (pads.empty()) return "";
  std::set<std::string> rungs;
  for (const ScenePadSpec& pad : pads) rungs.insert(pad.rung);
  return fmt::format("{} ({}), ", counted(pads.size(), "pad"), fmt::join(rungs, ", "));
}

std::string summary(const SceneSpec& scene) {
  return fmt::format(
      "scene '{}': {}, {}, {}, {}, {}{:g} s", scene.name, counted(scene.hands.size(), "hand"),
      scene.bodies.size() == 1 ? "1 body" : fmt::format("{} bodies", scene.bodies.size()),
      counted(scene.forces.size(), "force"), counted(scene.drives.size(), "drive"),
      pad_words(scene.pads), scene.stepping.duration);
}

std::string summary(const CalibratedLaws& laws) {
  return fmt::format(
      "laws of pad '{}': fitted to presses ({}), checked on others ({}); error of force {:.2g} % "
      "by soft finger",
      laws.name, laws.evidence.fitted, laws.evidence.checked,
      100 * laws.soft_finger_error.force.rms);
}
std::string summary(const PadData& data) {
  return fmt::format("measured presses of pad '{}' ({}), {} to fit: {}", data.pad,
                     data.presses.size(), counted(data.constants.size(), "constant"), data.title);
}
std::string summary(const PadSpec& pad) {
  return fmt::format("pad '{}': {:g} x {:g} x {:g} mm, {} pulp, {}, {} of its numbers assumed",
                     pad.name, pad.length / kMm, pad.width / kMm, pad.height / kMm, pad.pulp.law,
                     counted(pad.layers.size(), "layer"), assumed_words(pad).size());
}

std::string summary(const Materials& materials) {
  return fmt::format("materials: {}, friction of {}",
                     counted(materials.materials.size(), "material"),
                     counted(materials.friction.size(), "pair"));
}

std::string summary(const RobotSpec& robot) {
  return fmt::format("robot '{}': {}, {}, {}", robot.name, counted(robot.links.size(), "link"),
                     counted(robot.joints.size(), "joint"), counted(robot.dofs.size(), "motor"));
}

std::string summary(const PosteriorRun& run) {
  const FitProblem& problem = run.posterior->problem();
  return fmt::format(
      "posterior of {} from {}: {}, {}", listed(problem.specimens()), run.inputs.subject.path,
      counted(static_cast<std::size_t>(problem.size()), "coordinate"), describe_run(run));
}

std::string summary(const ResultFile& motion) {
  if (motion.texts.count("scene") > 0) {
    const std::size_t runs = motion.texts.count("varied") > 0 ? motion.matrix("value").rows() : 1;
    return fmt::format("{} of scene '{}'", counted(runs, "run"), motion.text("scene"));
  }
  return fmt::format("motion of the {} of '{}': {}, {}, {}", motion.text("digit"),
                     motion.text("subject"),
                     counted(motion.arrays.at("time").values.size(), "instant"),
                     counted(motion.list("name/joint").size(), "joint"),
                     counted(motion.list("name/muscle").size(), "muscle"));
}

}  // namespace

std::string summary_of(const Thing& thing) {
  return std::visit([](const auto& each) { return summary(each); }, thing);
}

}  // namespace thenar
