#include "grasp/robot/infer_hand.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "base/lists.h"
#include "base/words.h"
#include "grasp/robot/infer_closing.h"
#include "grasp/robot/pinned_bars.h"

namespace thenar {
namespace {

constexpr const char* kSoftMaterial = "rubber";
constexpr const char* kSoftWords[] = {"silicone", "rubber", "elastomer"};

/// Names the opposed digit "thumb", unless the file names its digits.
void name_thumb(InferredClosing& guess) {
  const auto called = [&](const std::string& name) {
    return any_of(guess.robot.links, [&](const RobotLink& link) { return link.digit == name; });
  };
  const std::string thumb = guess.thumb;
  if (thumb.rfind("finger ", 0) != 0 || called("thumb")) return;
  for (RobotLink& link : guess.robot.links)
    if (link.digit == thumb) link.digit = "thumb";
  std::replace(guess.idle.begin(), guess.idle.end(), thumb, std::string("thumb"));
}

/// Adds a warning that lists the inferred digits.
void warn_of_digits(RobotSpec& robot) {
  std::vector<std::string> names;
  for (const RobotLink& link : robot.links)
    if (!link.digit.empty()) names.push_back(fmt::format("{} of {}", link.name, link.digit));
  robot.warnings.push_back(fmt::format("no digits are stated: {} guessed: {}",
                                       digits_in(robot).size(), fmt::join(names, ", ")));
}

/// Selects the efforts in the direction of closing, where a file's efforts differ by direction, and
/// adds a warning.
void select_closing_efforts(RobotSpec& robot) {
  std::vector<std::string> taken, none;
  for (RobotDof& dof : robot.dofs) {
    if (!take_effort_of_speed(dof)) continue;
    if (dof.max_effort > 0)
      taken.push_back(fmt::format("{:.4g} for '{}'", dof.max_effort, dof.name));
    else
      none.push_back("'" + dof.name + "'");
  }
  if (!taken.empty())
    robot.warnings.push_back(
        fmt::format("efforts are those of the direction that closes: {}", some_of(taken)));
  if (!none.empty())
    robot.warnings.push_back(
        fmt::format("no effort in the direction that closes: {}; it is unknown", some_of(none)));
}

/// Returns the robot with the closing of infer_closing(), and warnings about what was inferred.
RobotSpec with_closing(const RobotSpec& robot, const StatedClosing& known, bool digits_guessed) {
  InferredClosing guess = infer_closing(robot, known);
  if (digits_guessed) {
    name_thumb(guess);
    warn_of_digits(guess.robot);
  }
  std::vector<std::string>& warnings = guess.robot.warnings;
  // One warning for each inference.
  if (!known.closing)
    warnings.push_back(fmt::format(
        "no closing is stated: it is inferred as {}",
        guess.closing.empty() ? "none" : fmt::format("{}", fmt::join(guess.closing, ", "))));
  if (!guess.set.empty())
    warnings.push_back(
        fmt::format("so that digits face each other, closing begins with {} (rad or m)",
                    fmt::join(guess.set, ", ")));
  const Eigen::Vector3d &p = guess.robot.approach.point, &d = guess.robot.approach.direction;
  if (!known.approach)
    warnings.push_back(
        fmt::format("no approach is stated: it is inferred as along [{:.3f}, {:.3f}, {:.3f}] from "
                    "[{:.4f}, {:.4f}, {:.4f}] m",
                    d.x(), d.y(), d.z(), p.x(), p.y(), p.z()));
  if (!guess.idle.empty())
    warnings.push_back(fmt::format(
        "in the trial of this guess, closed on a ball of {:.0f} mm, {} "
        "touch{} nothing",
        2e3 * guess.ball, fmt::join(guess.idle, ", "), guess.idle.size() == 1 ? "es" : ""));
  select_closing_efforts(guess.robot);
  // The robot now states both.
  guess.robot.closing_stated = guess.robot.approach_stated = true;
  return std::move(guess.robot);
}

/// Adds a warning about nominal efforts.
void warn_of_nominal_efforts(RobotSpec& robot) {
  std::vector<std::string> nominal;
  for (const RobotDof& dof : robot.dofs)
    if (dof.nominal_effort && dof.max_effort > 0) nominal.push_back(dof.name);
  if (!nominal.empty())
    robot.warnings.push_back(
        fmt::format("effort limits of {} look like placeholders; measures of force treat them as "
                    "unknown",
                    fmt::join(nominal, ", ")));
}

/// Returns whether the name of a link indicates a soft pad.
bool is_named_soft(const std::string& link) {
  const std::string name = lower_case(link);
  return any_of(kSoftWords, [&](const char* word) { return name.find(word) != std::string::npos; });
}

}  // namespace

RobotSpec with_materials(RobotSpec robot) {
  std::vector<std::string> bare, soft;
  for (RobotLink& link : robot.links) {
    if (link.shapes.empty() || !link.material.empty()) continue;
    const bool named_soft = is_named_soft(link.name);
    link.material = named_soft ? kSoftMaterial : kDefaultMaterial;
    (named_soft ? soft : bare).push_back(link.name);
  }
  if (!soft.empty())
    robot.warnings.push_back(
        fmt::format("no material is stated: {} is assumed for {}, by the names", kSoftMaterial,
                    fmt::join(soft, ", ")));
  if (!bare.empty())
    robot.warnings.push_back(fmt::format("no material is stated: {} is assumed for {}",
                                         kDefaultMaterial, fmt::join(bare, ", ")));
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
  // Digits are inferred only if the file describes no part of a hand.
  warn_of_nominal_efforts(robot);
  const bool infer_them = digits_in(robot).empty() && !robot.approach_stated;
  if (infer_them) (void)infer_digits(robot);
  if (digits_in(robot).empty()) return robot;
  // Speeds that are all zero state no closing.
  if (!any_speed(robot)) robot.closing_stated = robot.dofs.empty();
  if (robot.closing_stated && robot.approach_stated) return robot;
  return with_closing(robot, {robot.closing_stated, robot.approach_stated}, infer_them);
}

namespace {

/// Returns the bodies of each digit; branches that a loop joins, in the file or by a pinned bar,
/// are one digit.
std::vector<std::set<std::size_t>> find_branches(const RobotSpec& robot,
                                                 const RigidBodies& bodies) {
  const std::vector<RigidBody>& list = bodies.bodies;
  std::vector<std::set<std::size_t>> branches;
  // Branches run from each leaf inwards to the next branching point.
  for (std::size_t leaf = 1; leaf < list.size(); ++leaf) {
    if (!list[leaf].shaped || list[leaf].branches > 0) continue;
    branches.emplace_back();
    for (std::size_t b = leaf; b != 0 && list[b].branches <= 1; b = list[b].parent)
      branches.back().insert(b);
  }
  // Merge branches that a loop joins.
  std::vector<std::pair<std::size_t, std::size_t>> joined = pinned_bars(robot, bodies);
  for (const auto& [a, b] : robot.joined)
    joined.emplace_back(bodies.body_of_link.at(a), bodies.body_of_link.at(b));
  for (const auto& [a, b] : joined) {
    const auto with = [&](std::size_t body) {
      return std::find_if(
          branches.begin(), branches.end(),
          [&](const std::set<std::size_t>& branch) { return branch.count(body) > 0; });
    };
    const auto one = with(a), other = with(b);
    if (one == branches.end() || other == branches.end() || one == other) continue;
    one->insert(other->begin(), other->end());
    branches.erase(other);
  }
  return branches;
}

/// Names of fingers: words within a name, and (^) prefixes of names, also after a side as in "rh_".
const std::vector<std::pair<std::string, std::vector<std::string>>> kFingers{
    {"thumb", {"thumb", "^th"}},
    {"index", {"index", "^ff"}},
    {"middle", {"middle", "^mf"}},
    {"ring", {"ring", "^rf"}},
    {"little", {"little", "pinky", "^lf"}}};

bool names_finger(const std::string& link, const std::vector<std::string>& words) {
  const std::size_t side = link.find_last_of("_:/");
  return any_of(words, [&](const std::string& word) {
    if (word[0] != '^') return link.find(word) != std::string::npos;
    const std::string beginning = word.substr(1);
    return link.rfind(beginning, 0) == 0 ||
           (side != std::string::npos && link.compare(side + 1, beginning.size(), beginning) == 0);
  });
}

/// Returns a name for a digit with these links; each name is used once.
std::string name_digit(const std::vector<RobotLink*>& links, std::set<std::string>& taken) {
  for (const auto& [finger, words] : kFingers) {
    const auto named =
        std::count_if(links.begin(), links.end(), [&words = words](const RobotLink* link) {
          return names_finger(lower_case(link->name), words);
        });
    // Most links of a digit carry its name; "middle" alone may denote the middle link of any
    // finger.
    if (2 * named > static_cast<long>(links.size()) && taken.insert(finger).second) return finger;
  }
  // Without a known name the digit gets the next number.
  for (std::size_t i = 1;; ++i)
    if (std::string name = fmt::format("finger {}", i); taken.insert(name).second) return name;
}

}  // namespace

int infer_digits(RobotSpec& robot) {
  const RigidBodies bodies = find_rigid_bodies(robot);
  // All shaped links of a branch get the name of its digit.
  std::set<std::string> taken;
  for (const std::set<std::size_t>& branch : find_branches(robot, bodies)) {
    std::vector<RobotLink*> links;
    for (RobotLink& link : robot.links)
      if (!link.shapes.empty() && branch.count(bodies.body_of_link.at(link.name)) == 1)
        links.push_back(&link);
    const std::string name = name_digit(links, taken);
    for (RobotLink* link : links) link->digit = name;
  }
  return static_cast<int>(taken.size());
}

}  // namespace thenar
