// Scenes with finger pads of elements: what they press on moves as Newton and Coulomb say.

#include "api/scenes/simulate_scene.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "tests/data_folder.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// Force of one body on another at an instant.
Vector3d force_between(const SceneResult& scene, const SceneSample& sample, const std::string& on,
                       const std::string& by) {
  const auto& bodies = scene.built->scene.mechanism.bodies;
  Vector3d sum(0, 0, 0);
  for (const ContactSample& contact : sample.contacts) {
    const std::string& a = bodies[static_cast<std::size_t>(contact.a)].name;
    const std::string& b = bodies[static_cast<std::size_t>(contact.b)].name;
    if (a == on && b == by) sum += contact.force;
    if (a == by && b == on) sum -= contact.force;
  }
  return sum;
}

TEST(SimulateScene, AFingerOfElementsDrawsACoinAgainstTheFrictionOfATable) {
  SceneRequest request;
  request.scene = kData + "/scenes/coin_draw.toml";
  const SceneResult scene = simulate_scene(request);
  ASSERT_EQ(scene.run.status, SceneStatus::kDone);
  EXPECT_EQ(scene.run.cost.unsolved, 0);
  // While the finger goes at 50 mm/s, and its pad has yielded.
  constexpr double kWeight = 0.008 * 9.81, kFriction = 0.3;
  int seen = 0;
  double drawn = 0, rubbed = 0;
  for (const SceneSample& sample : scene.run.samples) {
    if (sample.t < 0.7 || sample.t > 0.88) continue;
    const Vector3d pad = force_between(scene, sample, "coin", "human:skewed/DP2");
    const Vector3d table = force_between(scene, sample, "coin", "table");
    // The coin neither rises nor, but for what the pad creeps, changes its speed.
    EXPECT_NEAR(table.z(), kWeight - pad.z(), 1e-3);
    // Pads may err by 5 % of their push between two moves.
    EXPECT_NEAR(pad.head<2>().norm(), kFriction * table.z(), 0.05 * pad.norm());
    drawn += pad.head<2>().norm();
    rubbed += kFriction * table.z();
    ++seen;
  }
  EXPECT_GE(seen, 8);
  EXPECT_NEAR(drawn / rubbed, 1, 0.01);
}

}  // namespace
}  // namespace thenar
