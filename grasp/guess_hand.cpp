#include "grasp/guess_hand.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "grasp/guess_closing.h"

namespace thenar {
namespace {

bool any_speed(const RobotSpec& robot) {
  return std::any_of(robot.dofs.begin(), robot.dofs.end(),
                     [](const RobotDof& dof) { return dof.speed != 0; });
}

/// Calls the digit that is opposed to the others the thumb, unless links say what it is.
void name_thumb(ClosingGuess& guess) {
  const auto called = [&](const std::string& name) {
    return std::any_of(guess.robot.links.begin(), guess.robot.links.end(),
                       [&](const RobotLink& link) { return link.digit == name; });
  };
  const std::string thumb = guess.thumb;
  if (thumb.rfind("finger ", 0) != 0 || called("thumb")) return;
  for (RobotLink& link : guess.robot.links)
    if (link.digit == thumb) link.digit = "thumb";
  std::replace(guess.idle.begin(), guess.idle.end(), thumb, std::string("thumb"));
}

void tell_digits(RobotSpec& robot) {
  std::vector<std::string> names;
  std::set<std::string> digits;
  for (const RobotLink& link : robot.links) {
    if (link.digit.empty()) continue;
    names.push_back(fmt::format("{} of {}", link.name, link.digit));
    digits.insert(link.digit);
  }
  robot.warnings.push_back(
      fmt::format("no digits are stated: {} guessed: {}", digits.size(), fmt::join(names, ", ")));
}

/// Says what guess_closing() found, in the robot's warnings.
RobotSpec with_closing(const RobotSpec& robot, const ClosingKnown& known, bool digits_guessed) {
  ClosingGuess guess = guess_closing(robot, known);
  if (digits_guessed) {
    name_thumb(guess);
    tell_digits(guess.robot);
  }
  std::vector<std::string>& warnings = guess.robot.warnings;
  if (!known.closing)
    warnings.push_back(fmt::format(
        "no closing is stated: it is guessed as {}",
        guess.closing.empty() ? "none" : fmt::format("{}", fmt::join(guess.closing, ", "))));
  if (!guess.set.empty())
    warnings.push_back(
        fmt::format("so that digits face each other, closing begins with {} (rad or m)",
                    fmt::join(guess.set, ", ")));
  const Eigen::Vector3d &p = guess.robot.approach.point, &d = guess.robot.approach.direction;
  if (!known.approach)
    warnings.push_back(
        fmt::format("no approach is stated: it is guessed as along [{:.3f}, {:.3f}, {:.3f}] from "
                    "[{:.4f}, {:.4f}, {:.4f}] m",
                    d.x(), d.y(), d.z(), p.x(), p.y(), p.z()));
  if (!guess.idle.empty())
    warnings.push_back(fmt::format("closed on a ball of {:.0f} mm, {} touch{} nothing",
                                   2e3 * guess.ball, fmt::join(guess.idle, ", "),
                                   guess.idle.size() == 1 ? "es" : ""));
  guess.robot.closing_stated = guess.robot.approach_stated = true;
  return std::move(guess.robot);
}

bool states_digits(const RobotSpec& robot) {
  return std::any_of(robot.links.begin(), robot.links.end(),
                     [](const RobotLink& link) { return !link.digit.empty(); });
}

void name_nominal(RobotSpec& robot) {
  std::vector<std::string> nominal;
  for (const RobotDof& dof : robot.dofs)
    if (dof.nominal_effort && dof.max_effort > 0) nominal.push_back(dof.name);
  if (!nominal.empty())
    robot.warnings.push_back(
        fmt::format("efforts of {} are nominal, as a model's placeholders: measures of force take "
                    "them for unknown",
                    fmt::join(nominal, ", ")));
}

}  // namespace

RobotSpec with_materials(RobotSpec robot) {
  std::vector<std::string> bare;
  for (RobotLink& link : robot.links) {
    if (link.shapes.empty() || !link.material.empty()) continue;
    link.material = kGuessedMaterial;
    bare.push_back(link.name);
  }
  if (!bare.empty())
    robot.warnings.push_back(fmt::format("no material is stated: {} is taken for {}",
                                         kGuessedMaterial, fmt::join(bare, ", ")));
  return robot;
}

void require_closed_loops(const RobotSpec& robot) {
  require(
      robot.open_loops.empty(),
      "robot '{}' cannot grasp: its parts form loops that are not solved, so that it would come "
      "apart: {}",
      robot.name, fmt::join(robot.open_loops, "; "));
}

RobotSpec graspable(RobotSpec robot) {
  require_closed_loops(robot);
  robot = with_materials(std::move(robot));
  name_nominal(robot);
  const bool guess_them = !states_digits(robot) && !robot.approach_stated;
  if (guess_them) {
    if (guess_digits(robot) == 0) return robot;
    robot.closing_stated = false;
  }
  if (!states_digits(robot)) return robot;
  if (!any_speed(robot)) robot.closing_stated = robot.dofs.empty();
  if (robot.closing_stated && robot.approach_stated) return robot;
  return with_closing(robot, {robot.closing_stated, robot.approach_stated}, guess_them);
}

}  // namespace thenar
