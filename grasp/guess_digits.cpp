#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <utility>
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

/// Bodies of each digit; branches that a loop holds together are one.
std::vector<std::set<std::size_t>> find_branches(const RobotSpec& robot, const Bodies& bodies) {
  std::vector<std::set<std::size_t>> branches;
  for (std::size_t leaf = 1; leaf < bodies.parent.size(); ++leaf) {
    if (!bodies.shaped[leaf] || bodies.branches[leaf] > 0) continue;
    branches.emplace_back();
    for (std::size_t b = leaf; b != 0 && bodies.branches[b] <= 1; b = bodies.parent[b])
      branches.back().insert(b);
  }
  for (const auto& [a, b] : robot.joined) {
    const auto with = [&](const std::string& link) {
      return std::find_if(branches.begin(), branches.end(),
                          [&](const std::set<std::size_t>& branch) {
                            return branch.count(bodies.of.at(link)) > 0;
                          });
    };
    const auto one = with(a), other = with(b);
    if (one == branches.end() || other == branches.end() || one == other) continue;
    one->insert(other->begin(), other->end());
    branches.erase(other);
  }
  return branches;
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// What fingers are called: words, and after them beginnings of names, after a side as in "rh_".
const std::vector<std::pair<std::string, std::vector<std::string>>> kFingers{
    {"thumb", {"thumb", "^th"}},
    {"index", {"index", "^ff"}},
    {"middle", {"middle", "^mf"}},
    {"ring", {"ring", "^rf"}},
    {"little", {"little", "pinky", "^lf"}}};

bool names_finger(const std::string& link, const std::vector<std::string>& words) {
  const std::size_t side = link.find_last_of("_:/");
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    if (word[0] != '^') return link.find(word) != std::string::npos;
    const std::string beginning = word.substr(1);
    return link.rfind(beginning, 0) == 0 ||
           (side != std::string::npos && link.compare(side + 1, beginning.size(), beginning) == 0);
  });
}

/// What a digit of these links is called; a name is used once.
std::string name_digit(const std::vector<RobotLink*>& links, std::set<std::string>& taken) {
  for (const auto& [finger, words] : kFingers) {
    const auto named =
        std::count_if(links.begin(), links.end(), [&words = words](const RobotLink* link) {
          return names_finger(lower_case(link->name), words);
        });
    // Not the middle link of any finger: most links of a digit have its name.
    if (2 * named >= static_cast<long>(links.size()) && taken.insert(finger).second) return finger;
  }
  for (std::size_t i = 1;; ++i)
    if (const std::string name = fmt::format("finger {}", i); taken.insert(name).second)
      return name;
}

}  // namespace

int guess_digits(RobotSpec& robot) {
  const Bodies bodies = find_bodies(robot);
  std::set<std::string> taken;
  for (const std::set<std::size_t>& branch : find_branches(robot, bodies)) {
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
