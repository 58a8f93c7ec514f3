#include "apps/file_summary.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "api/files.h"
#include "base/nearest_name.h"
#include "data/io/anthropometry.h"
#include "data/io/experiment.h"
#include "data/io/file_kind.h"
#include "data/io/fit_settings.h"
#include "data/io/mesh/repair_shape.h"
#include "data/io/net_description.h"
#include "data/io/robot/robot.h"
#include "data/io/world/world.h"
#include "geometry/solid.h"
#include "kinematics_fit/fit.h"
#include "report/table.h"
#include "tendons/tendon_model.h"

namespace thenar {
namespace {

std::string summary(const Subject& subject) {
  std::vector<std::string> digits;
  for (const Digit& digit : subject.digits) {
    (void)build_tendon_digit(subject, digit.name);  // throws if tendons and bones do not fit
    digits.push_back(digit.name);
  }
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
  return fmt::format("experiment '{}': {} {} of specimen {}, {}, {}, {} loaded", experiment.name,
                     experiment.species, experiment.digit, experiment.specimen,
                     counted(experiment.trials.size(), "trial"),
                     counted(experiment.postures.size(), "posture"),
                     counted(muscles.size(), "muscle"));
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
  (void)build_solid(body.shapes);  // throws if a mesh has holes
  std::vector<std::string> kinds;
  for (const ShapeSpec& shape : body.shapes) kinds.push_back(name_of(shape.kind));
  std::vector<std::string> warnings;
  note_turned(body.shapes, fmt::format("object '{}'", body.name), warnings);
  std::string text =
      fmt::format("object '{}': {} ({}), material {}", body.name, counted(kinds.size(), "shape"),
                  listed(kinds), body.material.empty() ? "unknown" : body.material);
  for (const std::string& warning : warnings) text += "; warning: " + warning;
  return text;
}

std::string summary(const WorldSpec& world) {
  std::size_t objects = 0;
  for (const PlacedBody& placed : world.bodies) {
    (void)build_solid(placed.body.shapes);
    objects += placed.dynamic ? 1 : 0;
  }
  std::vector<std::string> hands;
  for (const PlacedHand& hand : world.hands) hands.push_back(hand.name);
  return fmt::format("world '{}': {} ({}), {}, {}", world.name, counted(hands.size(), "hand"),
                     listed(hands), counted(objects, "object"),
                     counted(world.bodies.size() - objects, "obstacle"));
}

std::string summary(const Materials& materials) {
  return fmt::format("materials: {}, friction of {}",
                     counted(materials.materials.size(), "material"),
                     counted(materials.friction.size(), "pair"));
}

std::string summary(const RobotSpec& robot) {
  for (const RobotLink& link : robot.links)
    for (const ShapeSpec& shape : link.shapes)
      require_solid(shape, fmt::format("link '{}'", link.name));
  return fmt::format("robot '{}': {}, {}, {}", robot.name, counted(robot.links.size(), "link"),
                     counted(robot.joints.size(), "joint"), counted(robot.dofs.size(), "motor"));
}

}  // namespace

std::string summarise_file(const std::string& path) {
  for (const std::string& warning : checksum_warnings(path))
    fmt::print(stderr, "thenar: warning: {}\n", warning);
  switch (find_file_kind(path)) {
    case FileKind::kSubject:
      return summary(read_subject(path));
    case FileKind::kExperiment:
      return summary(read_experiment(path));
    case FileKind::kFitSettings:
      return summary(read_fit_settings(path));
    case FileKind::kProportions:
      return summary(read_proportions(path));
    case FileKind::kNet:
      return summary(read_net(path));
    case FileKind::kResult:
      return summary(read_fit(path));
    case FileKind::kObject:
      return summary(read_object(path));
    case FileKind::kWorld:
      return summary(read_world(path));
    case FileKind::kMaterials:
      return summary(read_materials(path, built_in_materials()));
    case FileKind::kRobot:
      return summary(read_robot(path));
  }
  return "";
}

}  // namespace thenar
