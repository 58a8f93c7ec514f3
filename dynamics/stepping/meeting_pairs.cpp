#include "dynamics/stepping/meeting_pairs.h"

#include "base/lists.h"

namespace thenar {
namespace {

/// Groups bodies that are welded to each other; returns the first body of each body's group. Welds
/// to the world do not count: a table and a robot's base are two groups.
std::vector<int> welded_groups(const Mechanism& mechanism) {
  std::vector<int> group(mechanism.bodies.size());
  for (std::size_t i = 0; i < group.size(); ++i) {
    const MechanismJoint& joint = mechanism.joints[i];
    group[i] = joint.kind == JointKind::kWeld && joint.parent >= 0 ? group[joint.parent]
                                                                   : static_cast<int>(i);
  }
  return group;
}

/// Lists the pairs of groups that a joint connects, also across groups without a surface (the
/// middle of a universal joint): they overlap there by design.
std::vector<std::pair<int, int>> neighbours(const Mechanism& mechanism,
                                            const std::vector<int>& group) {
  // Find the groups that have a surface.
  std::vector<bool> has_surface(group.size());
  for (std::size_t i = 0; i < group.size(); ++i)
    if (mechanism.bodies[i].solid) has_surface[group[i]] = true;
  // Pair each group with its ancestors up to the first that has a surface.
  std::vector<std::pair<int, int>> out;
  for (std::size_t i = 0; i < group.size(); ++i) {
    if (group[i] != static_cast<int>(i)) continue;
    int parent = mechanism.joints[i].parent;
    while (parent >= 0) {
      const int other = group[parent];
      out.emplace_back(static_cast<int>(i), other);
      if (has_surface[other]) break;
      parent = mechanism.joints[other].parent;
    }
  }
  return out;
}

bool has_pair(const std::vector<std::pair<int, int>>& pairs, int a, int b) {
  return contains(pairs, std::pair(a, b)) || contains(pairs, std::pair(b, a));
}

}  // namespace

std::vector<std::pair<int, int>> pairs_that_may_meet(const MovingScene& scene,
                                                     const TreeModel& model) {
  // Select pairs with surfaces, on different links, not connected by a joint and not excluded.
  const std::vector<int> group = welded_groups(scene.mechanism);
  const std::vector<std::pair<int, int>> connected = neighbours(scene.mechanism, group);
  const std::size_t count = scene.mechanism.bodies.size();
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j) {
      if (!scene.mechanism.bodies[i].solid || !scene.mechanism.bodies[j].solid) continue;
      const int a = static_cast<int>(i), b = static_cast<int>(j);
      if (model.bodies[i].link != model.bodies[j].link &&
          !has_pair(connected, group[i], group[j]) && !has_pair(scene.excluded_pairs, a, b))
        pairs.emplace_back(a, b);
    }
  return pairs;
}

}  // namespace thenar
