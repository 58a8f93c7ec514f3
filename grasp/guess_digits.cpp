#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "grasp/guess_hand.h"

namespace thenar {
namespace {

/// Links that nothing moves against each other; the first holds the base.
struct Bodies {
  std::map<std::string, std::size_t> of;  // by the name of a link
  std::vector<std::size_t> parent;        // of each body; of the first itself
  std::vector<int> branches;              // that go on from each body
  std::vector<bool> shaped;               // whether it, or what it carries, has a shape
};

Bodies find_bodies(const RobotSpec& robot) {
  Bodies bodies{{{robot.links.front().name, 0}}, {0}, {0}, {false}};
  for (const RobotJoint& joint : robot.joints) {
    const std::size_t parent = bodies.of[joint.parent];
    const bool moves = joint.kind != RobotJointKind::kFixed;
    bodies.of[joint.child] = moves ? bodies.parent.size() : parent;
    if (moves) bodies.parent.push_back(parent);
  }
  bodies.branches.resize(bodies.parent.size(), 0);
  bodies.shaped.resize(bodies.parent.size(), false);
  for (const RobotLink& link : robot.links)
    if (!link.shapes.empty()) bodies.shaped[bodies.of[link.name]] = true;
  for (std::size_t b = bodies.parent.size(); b-- > 1;) {
    if (!bodies.shaped[b]) continue;
    bodies.shaped[bodies.parent[b]] = true;
    ++bodies.branches[bodies.parent[b]];
  }
  return bodies;
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// What a digit of these links is called; a name is used once.
std::string name_digit(const std::vector<RobotLink*>& links, std::set<std::string>& taken) {
  static const std::array<const char*, 5> fingers{"thumb", "index", "middle", "ring", "little"};
  for (const char* finger : fingers)
    for (const RobotLink* link : links)
      if (lower_case(link->name).find(finger) != std::string::npos && taken.insert(finger).second)
        return finger;
  for (std::size_t i = 1;; ++i)
    if (const std::string name = fmt::format("finger {}", i); taken.insert(name).second)
      return name;
}

}  // namespace

int guess_digits(RobotSpec& robot) {
  const Bodies bodies = find_bodies(robot);
  std::set<std::string> taken;
  for (std::size_t leaf = 1; leaf < bodies.parent.size(); ++leaf) {
    if (!bodies.shaped[leaf] || bodies.branches[leaf] > 0) continue;
    std::set<std::size_t> branch;
    for (std::size_t b = leaf; b != 0 && bodies.branches[b] <= 1; b = bodies.parent[b])
      branch.insert(b);
    std::vector<RobotLink*> links;
    for (RobotLink& link : robot.links)
      if (!link.shapes.empty() && branch.count(bodies.of.at(link.name)) == 1)
        links.push_back(&link);
    const std::string name = name_digit(links, taken);
    for (RobotLink* link : links) link->digit = name;
  }
  return static_cast<int>(taken.size());
}

}  // namespace thenar
