// Closing of human hands, grasp/closing/close_hand.cpp, with grasp/collision_hand.cpp and
// grasp/closing/tendon_closing.cpp: an empty hand makes a fist, and a ball stops it.

#include <algorithm>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "grasp/closing/close_hand.h"
#include "grasp/closing/tendon_closing.h"
#include "hand_versions/closing_synergy.h"
#include "hand_versions/human_hand.h"
#include "tests/grasp/closing_samples.h"

namespace thenar {
namespace {

const ShapeSpec kLargeBall = sample::shape(ShapeKind::kSphere, {0.035, 0, 0});

/// The ball far off.
GraspSetup nothing() { return sample::setup({sample::placed("ball", kLargeBall, {0, 0, 1})}); }

/// Built once, with coarse skin.
const HumanHand& human_of(HumanVersion tier) {
  static std::map<HumanVersion, HumanHand> built;
  const auto found = built.find(tier);
  if (found != built.end()) return found->second;
  HumanHandOptions options;
  options.skin.triangles = 200;
  return built.emplace(tier, build_human_hand(default_human(), tier, options)).first->second;
}

CloseOptions options_of(const Hand& hand, HumanVersion tier) {
  CloseOptions options;
  if (tier == HumanVersion::kTendonNet)
    options.rates = tendon_closing_rates(hand, max_flexor_tensions(hand));
  return options;
}

bool flexes(const std::string& joint) { return joint.find("_AA") == std::string::npos; }
bool of_thumb(const std::string& joint) { return joint.find('1') != std::string::npos; }

int coordinate(const Hand& hand, const std::string& name) {
  const auto& names = hand.layout().coordinates;
  return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

constexpr double kMeasured = 1e-5;  // of a depth [m]

/// How deep a digit is in other links of the hand, to kMeasured [m].
double deepest(const CollisionHand& hand, const Eigen::VectorXd& q, const std::string& digit) {
  const std::vector<LinkSurface>& surfaces = hand.hand->surfaces();
  const PosedCollisionHand posed{hand, {}, hand.hand->pose(q)};
  SignedDistanceOptions exact;
  exact.relative = 0;
  exact.tolerance = kMeasured;
  exact.cutoff = 1e-3;
  double depth = 0;
  for (const SurfacePair& pair : hand.self_pairs) {
    if (surfaces[pair.a].digit != digit && surfaces[pair.b].digit != digit) continue;
    const SignedDistance found =
        signed_distance(hand.trees[pair.a], posed.surface_pose(pair.a), *surfaces[pair.b].solid,
                        posed.surface_pose(pair.b), exact);
    depth = std::max(depth, -found.distance);
  }
  return depth;
}

class HumanClosing : public testing::TestWithParam<HumanVersion> {};

// Thumbs are left out, which end on the fingers. What stops the others is their own limit, or the
// palm with the thumb's eminence.
TEST_P(HumanClosing, MakesAFist) {
  const HumanHand& human = human_of(GetParam());
  const Hand& hand = *human.hand;
  const Eigen::VectorXd start = open_posture(hand.layout());
  const ClosedHand fist =
      close_hand(collision_hand(hand), {}, start, nothing(), options_of(hand, GetParam()));
  ASSERT_TRUE(fist.finished);
  for (Eigen::Index j = 0; j < start.size(); ++j) {
    const std::string& joint = hand.layout().coordinates[j];
    if (!flexes(joint) || of_thumb(joint)) continue;
    const double range = hand.layout().upper[j] - hand.layout().lower[j];
    EXPECT_GT(fist.q[j] - hand.layout().lower[j], 0.8 * range)
        << joint << " " << name_of(fist.stopped[j]);
  }
}

INSTANTIATE_TEST_SUITE_P(All, HumanClosing,
                         testing::Values(HumanVersion::kOrthogonalThumb, HumanVersion::kSkewedThumb,
                                         HumanVersion::kSoftPads, HumanVersion::kTendonNet));

// Not abducted, it runs onto its side: both layers of skin are pressed flat, 3 mm each, and it is
// stopped at the first look after that, at most a millimetre of sliding later.
TEST(HumanClosing, StopsTheThumbOnTheIndexFinger) {
  const HumanHand& human = human_of(HumanVersion::kSkewedThumb);
  const Hand& hand = *human.hand;
  const CollisionHand touching = collision_hand(hand);
  const int root = coordinate(hand, "CMC1_FE");
  const double flat = 2 * 3e-3 + 1e-3 + kMeasured;
  Eigen::VectorXd start = open_posture(hand.layout());
  start[coordinate(hand, "CMC1_AA")] = 0;
  CloseOptions options;
  const ClosedHand fist = close_hand(touching, {}, start, nothing(), options);
  EXPECT_EQ(fist.stopped[root], StoppedBy::kContact);
  EXPECT_LT(deepest(touching, fist.q, "thumb"), flat);
  options.self = false;
  const ClosedHand through = close_hand(touching, {}, start, nothing(), options);
  EXPECT_EQ(through.stopped[root], StoppedBy::kLimit);
  EXPECT_GT(deepest(touching, through.q, "thumb"), flat);
}

/// Against the palm.
GraspSetup ball_in(const Hand& hand) {
  const PalmApproach& palm = hand.layout().approach;
  return sample::setup({sample::placed("ball", kLargeBall, palm.point + 0.038 * palm.direction)});
}

// A joint that still moved a link against the ball would go on: each of them is stopped by contact.
// The thumb meets it from the other side.
TEST(HumanClosing, CurlsRoundABallByTendons) {
  const HumanHand& human = human_of(HumanVersion::kTendonNet);
  const Hand& hand = *human.hand;
  const CollisionHand touching = collision_hand(hand);
  const GraspSetup setup = ball_in(hand);
  const ClosedHand closed = close_hand(touching, {}, open_posture(hand.layout()), setup,
                                       options_of(hand, HumanVersion::kTendonNet));
  ASSERT_TRUE(closed.overlaps.empty());
  ASSERT_TRUE(closed.finished);
  for (std::size_t j = 0; j < closed.stopped.size(); ++j)
    if (flexes(hand.layout().coordinates[j])) {
      EXPECT_EQ(closed.stopped[j], StoppedBy::kContact) << hand.layout().coordinates[j];
    }
  const PosedCollisionHand posed{touching, {}, hand.pose(closed.q)};
  for (std::size_t s = 0; s < touching.trees.size(); ++s) {
    if (hand.surfaces()[s].name.rfind("DP", 0) != 0) continue;
    Clearance clearance{static_cast<int>(s), -1, &setup.object};
    const double distance = measure_clearance(clearance, posed, 2.5e-5, 1e-3).distance;
    EXPECT_GT(distance, 0) << hand.surfaces()[s].name;
    EXPECT_LT(distance, 1.3e-4) << hand.surfaces()[s].name;
  }
}

TEST(OpenPosture, OfAHumanIsStraightWithTheThumbAbducted) {
  const HumanHand& human = human_of(HumanVersion::kSkewedThumb);
  const Eigen::VectorXd q = open_posture(human.hand->layout());
  const int abduction = coordinate(*human.hand, "CMC1_AA");
  for (Eigen::Index j = 0; j < q.size(); ++j)
    if (j != abduction) {
      EXPECT_NEAR(q[j], 0, 1e-12) << human.hand->layout().coordinates[j];
    }
  const HandLayout& layout = human.hand->layout();
  EXPECT_DOUBLE_EQ(q[abduction], (layout.lower[abduction] + layout.upper[abduction]) / 2);
}

// A layout that states none opens what it drives to the limit it comes from.
TEST(OpenPosture, IsTheLimitsThatDrivesComeFromWhereAHandStatesNone) {
  HandLayout layout = human_of(HumanVersion::kSkewedThumb).hand->layout();
  layout.open.resize(0);
  const Eigen::VectorXd q = open_posture(layout), rates = ClosingDrives(layout).rates();
  for (Eigen::Index j = 0; j < q.size(); ++j)
    EXPECT_EQ(q[j], rates[j] > 0 ? layout.lower[j] : 0) << layout.coordinates[j];
  EXPECT_LT(q.minCoeff(), -0.3);  // bent backwards
}

}  // namespace
}  // namespace thenar
