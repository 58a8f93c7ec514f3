// Closing of human hands, grasp/close_hand.cpp, with grasp/touching_hand.cpp and
// grasp/tendon_closing.cpp: an empty hand makes a fist, and a ball stops it.

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "grasp/close_hand.h"
#include "grasp/tendon_closing.h"
#include "tendons/hand/hand_use.h"
#include "tendons/hand/human_hand.h"
#include "tests/grasp/closing_samples.h"

namespace thenar {
namespace {

const ShapeSpec kBall = sample::shape(ShapeKind::kSphere, {0.035, 0, 0});

/// The ball far off.
Scene nothing() { return sample::scene({sample::placed("ball", kBall, {0, 0, 1})}); }

/// Coarse skin is built faster.
HumanHand human_of(HumanTier tier) {
  HumanHandOptions options;
  options.skin.triangles = 200;
  return build_human_hand(default_human(), tier, options);
}

CloseOptions options_of(const Hand& hand, HumanTier tier) {
  CloseOptions options;
  if (tier == HumanTier::kTendonNet) options.rates = tendon_closing_rates(hand, flexor_pull(hand));
  return options;
}

bool flexes(const std::string& joint) { return joint.find("_AA") == std::string::npos; }
bool of_thumb(const std::string& joint) { return joint.find('1') != std::string::npos; }

int coordinate(const Hand& hand, const std::string& name) {
  const auto& names = hand.layout().coordinates;
  return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

double deepest(const TouchingHand& hand, const Eigen::VectorXd& q, const std::string& digit) {
  const std::vector<LinkSurface>& surfaces = hand.hand->surfaces();
  const PosedHand posed{hand, {}, hand.hand->pose(q)};
  double depth = 0;
  for (const SurfacePair& pair : hand.self) {
    if (surfaces[pair.a].digit != digit && surfaces[pair.b].digit != digit) continue;
    Gap gap{pair.a, pair.b};
    depth = std::max(depth, -measure(gap, posed, 1e-4, 1e-3).distance);
  }
  return depth;
}

class HumanClosing : public testing::TestWithParam<HumanTier> {};

// The thumb's joints are left out: it ends on the fingers.
TEST_P(HumanClosing, MakesAFist) {
  const HumanHand human = human_of(GetParam());
  const Hand& hand = *human.hand;
  const Eigen::VectorXd start = open_posture(hand);
  const ClosedHand fist =
      close_hand(touching_hand(hand), {}, start, nothing(), options_of(hand, GetParam()));
  ASSERT_TRUE(fist.finished);
  for (Eigen::Index j = 0; j < start.size(); ++j) {
    const std::string& joint = hand.layout().coordinates[j];
    if (!flexes(joint) || of_thumb(joint)) continue;
    const double way = hand.layout().upper[j] - start[j];
    EXPECT_GT(fist.q[j] - start[j], 0.8 * way) << joint << " " << name_of(fist.stopped[j]);
  }
}

INSTANTIATE_TEST_SUITE_P(All, HumanClosing,
                         testing::Values(HumanTier::kOrthogonalThumb, HumanTier::kSkewedThumb,
                                         HumanTier::kSoftPads, HumanTier::kTendonNet));

// Both layers of skin pressed flat, 6 mm, and a millimetre between looks while it slides.
TEST(HumanClosing, StopsTheThumbOnTheIndexFinger) {
  const HumanHand human = human_of(HumanTier::kSkewedThumb);
  const Hand& hand = *human.hand;
  const TouchingHand touching = touching_hand(hand);
  const int root = coordinate(hand, "CMC1_FE");
  CloseOptions options;
  const ClosedHand fist = close_hand(touching, {}, open_posture(hand), nothing(), options);
  EXPECT_EQ(fist.stopped[root], StoppedBy::kContact);
  EXPECT_LT(deepest(touching, fist.q, "thumb"), 7.2e-3);
  options.self = false;
  const ClosedHand through = close_hand(touching, {}, open_posture(hand), nothing(), options);
  EXPECT_EQ(through.stopped[root], StoppedBy::kLimit);
  EXPECT_GT(deepest(touching, through.q, "thumb"), 7.2e-3);
}

TEST(OpenPosture, DoesNotBendAHumanHandBackwards) {
  const HumanHand human = human_of(HumanTier::kSkewedThumb);
  EXPECT_TRUE(open_posture(*human.hand).isZero(0));
  EXPECT_LT(open_posture(human.hand->layout()).minCoeff(), -0.3);
}

}  // namespace
}  // namespace thenar
