// Every robot that is compared by default, and the human hand with an orthogonal thumb, holds a
// ball of 70 mm in one of its first 20 approaches; so do the other tiers where THENAR_ALL_HANDS is
// set: long_hands.

#include <cstdlib>

#include <gtest/gtest.h>

#include "grasp/closing/approach_sampling.h"
#include "grasp/compare/pregrasp.h"
#include "grasp/robot/robot_hand.h"
#include "hand_versions/human_hand.h"

namespace thenar {
namespace {

/// The number of the first approach that ends in force closure; 20: none.
int first_closure(const Hand& hand, ContactModel contact) {
  PlacedBody placed;
  placed.body = read_object(THENAR_DATA_DIR "/objects/sphere_70.toml");
  const GraspSetup setup{build_body(placed), {}, built_in_materials()};
  const CollisionHand touching = collision_hand(hand);
  GraspOptions options;
  options.pads.contact = contact;
  for (int n = 0; n < 20; ++n) {
    std::mt19937 posture(static_cast<unsigned>(n)), start(static_cast<unsigned>(100 + n));
    const Eigen::VectorXd q = sample_preshape(touching, n, posture);
    const Pose<double> X_WH = sample_approach_pose(touching, q, setup.object, start);
    options.stand_off = sample_stand_off(start);
    options.approach_distance = approach_distance(touching, q, setup.object);
    const Grasp done = centred_grasp(touching, X_WH, q, setup, options);
    if (done.outcome == GraspOutcome::kGrasped && done.quality.force_closure) return n;
  }
  return 20;
}

class RobotOnBall : public testing::TestWithParam<const char*> {};

TEST_P(RobotOnBall, ClosesWithForceClosure) {
  const RobotHand hand(read_robot(std::string(THENAR_DATA_DIR "/robots/") + GetParam() + ".toml"));
  EXPECT_LT(first_closure(hand, ContactModel::kHardPoint), 20);
}

INSTANTIATE_TEST_SUITE_P(Default, RobotOnBall,
                         testing::Values("barrett", "dlr", "shadow", "allegro", "leap", "robonaut",
                                         "parallel_jaw", "robotiq_2f85"),
                         [](const auto& tested) { return std::string(tested.param); });

class HumanOnBall : public testing::TestWithParam<const char*> {};

// A hand takes seconds to build: the others, which differ in pads and tendons alone, where asked.
TEST_P(HumanOnBall, ClosesWithForceClosure) {
  if (GetParam() != std::string("orthogonal") && std::getenv("THENAR_ALL_HANDS") == nullptr)
    GTEST_SKIP() << "set THENAR_ALL_HANDS to try it";
  const HumanHand human = build_human_hand(default_human(), human_version(GetParam()));
  EXPECT_LT(first_closure(*human.hand, human.contact), 20);
}

INSTANTIATE_TEST_SUITE_P(Default, HumanOnBall,
                         testing::Values("orthogonal", "skewed", "soft", "tendons"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace thenar
