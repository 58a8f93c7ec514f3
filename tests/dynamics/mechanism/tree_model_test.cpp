// Tests for dynamics/mechanism/tree_model.cpp.

#include "dynamics/mechanism/tree_model.h"

#include <gtest/gtest.h>

#include "tests/dynamics/mechanism/sample_mechanisms.h"

namespace thenar {
namespace {

int depth_of(const TreeModel& model, int link) {
  int depth = 0;
  for (; link >= 0; link = model.links[static_cast<std::size_t>(link)].parent) ++depth;
  return depth;
}

// Recursions go up and down the list, and overlap what does not depend on each other.
TEST(TreeModel, OrdersLinksByDepth) {
  sample::MechanismDraw draw(3);
  for (int trial = 0; trial < 50; ++trial) {
    const Mechanism mechanism = draw.mechanism(draw.whole(2, 12), trial % 2 == 1);
    if (layout_of(mechanism).v == 0) continue;
    const TreeModel model = tree_model(mechanism);
    for (int i = 1; i < static_cast<int>(model.links.size()); ++i)
      EXPECT_LE(depth_of(model, i - 1), depth_of(model, i));
  }
}

// A body with a joint that moves leads to the link of that joint.
TEST(TreeModel, LeadsFromBodiesToTheirLinks) {
  sample::MechanismDraw draw(4);
  const Mechanism mechanism = draw.mechanism(12, false);
  const TreeModel model = tree_model(mechanism);
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    if (mechanism.joints[i].kind == JointKind::kWeld) continue;
    const TreeLink& link = model.links[static_cast<std::size_t>(model.bodies[i].link)];
    EXPECT_EQ(link.joint.name, mechanism.joints[i].name);
    EXPECT_EQ(link.first_v, model.layout.first_v[i]);
  }
}

}  // namespace
}  // namespace thenar
