// Tests for grasp/compare: tiny comparisons whose answers can be worked out by hand.

#include "grasp/compare/compare_hands.h"

#include <cmath>

#include <gmock/gmock.h>

#include "base/error.h"
#include "grasp/compare/grasp_type.h"
#include "grasp/compare/opposition.h"
#include "grasp/compare/pregrasp.h"
#include "grasp/compare/workspace.h"
#include "grasp/robot/robot_hand.h"
#include "tests/grasp/closing_samples.h"
#include "tests/grasp/jaws.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::HasSubstr;

ComparedHand compared(const std::string& name, const RobotSpec& robot) {
  ComparedHand hand;
  hand.name = name;
  hand.hand = std::make_shared<RobotHand>(robot);
  return hand;
}

/// 30 mm a side, 50 g.
BodySpec cube() {
  BodySpec body = sample::placed("cube", sample::jaw_cube(), {0, 0, 0}).body;
  body.uniform_mass = 0.05;
  return body;
}

CompareOptions few(int threads = 1) {
  CompareOptions options;
  options.approaches = 24;
  options.threads = threads;
  options.tasks = {GraspTask::kHoldWeight, GraspTask::kPull, GraspTask::kTurn};
  options.workspace_draws = 500;
  return options;
}

GraspSetup cube_scene(const Eigen::Vector3d& at) {
  return sample::setup({sample::placed("cube", sample::jaw_cube(), at)});
}

Grasp squeeze(const Eigen::Vector3d& cube_at) {
  const RobotHand hand(sample::jaws());
  GraspOptions options;
  options.approach_distance = 0;
  return centred_grasp(collision_hand(hand), {}, open_posture(hand.layout()), cube_scene(cube_at),
                       options);
}

std::vector<double> listed(const Eigen::VectorXd& v) { return {v.data(), v.data() + v.size()}; }

void expect_same(const HandOnObject& a, const HandOnObject& b) {
  EXPECT_EQ(a.outcomes, b.outcomes);
  EXPECT_EQ(a.closures, b.closures);
  EXPECT_EQ(listed(a.epsilon), listed(b.epsilon));
  EXPECT_EQ(a.types, b.types);
  ASSERT_EQ(a.best.size(), b.best.size());
  for (std::size_t i = 0; i < a.best.size(); ++i) {
    EXPECT_EQ(a.best[i].approach, b.best[i].approach);
    EXPECT_EQ(a.best[i].q, b.best[i].q);
    EXPECT_EQ(a.best[i].margin, b.best[i].margin);
  }
}

/// The only cell of the jaws on the cube.
HandOnObject jaws_on_cube(const CompareOptions& options) {
  return compare({compared("jaws", sample::jaws())}, {cube()}, options).cells.at(0);
}

TEST(Compare, GivesTheSameOnAnyNumberOfThreads) {
  const HandOnObject one = jaws_on_cube(few(1));
  expect_same(one, jaws_on_cube(few(3)));
  EXPECT_GT(one.closures, 0);
  CompareOptions other = few(1);
  other.seed = 2;
  EXPECT_NE(listed(jaws_on_cube(other).epsilon), listed(one.epsilon));
}

// Pieces of all pairs are done in any order; pairs are kept in that of hands and objects.
TEST(Compare, KeepsPairsInOrderOnAnyNumberOfThreads) {
  const std::vector<ComparedHand> hands{compared("one", sample::jaws()),
                                        compared("two", sample::jaws())};
  BodySpec larger = scaled(cube(), 1.2);
  larger.name = "larger";
  std::vector<Comparison> all;
  for (const int threads : {1, 3}) {
    CompareOptions options = few(threads);
    std::vector<std::size_t> kept;
    options.keep = [&](const Comparison& so_far) { kept.push_back(so_far.cells.size()); };
    all.push_back(compare(hands, {cube(), larger}, options));
    EXPECT_THAT(kept, testing::ElementsAre(1, 2, 3, 4));
    EXPECT_TRUE(all.back().complete);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const HandOnObject& cell = all[1].cells[i];
    EXPECT_EQ(cell.hand, i < 2 ? "one" : "two");
    EXPECT_EQ(cell.object, i % 2 == 0 ? "cube" : "larger");
    expect_same(all[0].cells[i], cell);
  }
  ASSERT_EQ(all[1].abilities.size(), 2U);
  for (std::size_t h = 0; h < 2; ++h) {
    EXPECT_EQ(all[1].abilities[h].hand, hands[h].name);
    EXPECT_EQ(all[0].abilities[h].digits[0].workspace, all[1].abilities[h].digits[0].workspace);
    EXPECT_EQ(all[0].abilities[h].types, all[1].abilities[h].types);
  }
}

TEST(Compare, CountsEveryApproachOnce) {
  const HandOnObject cell = jaws_on_cube(few());
  int sum = 0;
  for (const int times : cell.outcomes) sum += times;
  EXPECT_EQ(sum, 24);
  int types = 0;
  for (const auto& [type, times] : cell.types) types += times;
  EXPECT_EQ(types, cell.closures);
  EXPECT_EQ(cell.epsilon.size(), cell.closures);
  EXPECT_LE(cell.quantile(0.5), cell.quantile(1));
  ASSERT_FALSE(cell.best.empty());
  EXPECT_EQ(cell.best.front().epsilon, cell.quantile(1));
}

TEST(Compare, GoesOnFromWhatIsDone) {
  const ComparedHand hand = compared("jaws", sample::jaws());
  const Comparison whole = compare({hand}, {cube()}, few());
  ASSERT_TRUE(whole.complete);
  HandOnObject known = whole.cells.front();
  known.seconds = 12345;
  const Comparison again = compare({hand}, {cube()}, few(), {}, {known});
  EXPECT_EQ(again.cells.front().seconds, 12345);
}

TEST(Compare, StopsWithWholeCells) {
  Progress stop;
  stop.stop_requested = [] { return true; };
  const Comparison none = compare({compared("jaws", sample::jaws())}, {cube()}, few(), stop);
  EXPECT_FALSE(none.complete);
  EXPECT_TRUE(none.cells.empty());
}

// Asked again and again, it hears of a stop wherever it comes; what it has by then is whole.
TEST(Compare, StopsWhereverItIsAsked) {
  const ComparedHand hand = compared("jaws", sample::jaws());
  CompareOptions options = few();
  options.approaches = 3;
  int all = 0;
  Progress counting;
  counting.stop_requested = [&] { return ++all, false; };
  const Comparison whole = compare({hand}, {cube()}, options, counting);
  ASSERT_TRUE(whole.complete);
  ASSERT_GT(all, 8);  // approaches, draws of workspaces, digits
  for (const int patience : {1, all / 2, all - 1}) {
    int asked = 0;
    Progress stop;
    stop.stop_requested = [&] { return ++asked > patience; };
    const Comparison part = compare({hand}, {cube()}, options, stop);
    EXPECT_FALSE(part.complete) << patience;
    EXPECT_TRUE(part.abilities.empty()) << patience;
    for (const HandOnObject& cell : part.cells) EXPECT_EQ(cell.approaches, 3);
    EXPECT_LE(asked, patience + 8) << "went on";
  }
}

// The hand that cannot touch comes last: nothing is worked out for the one before.
TEST(Compare, ChecksAllHandsBeforeAnyWork) {
  RobotSpec bare = sample::jaws();
  for (RobotLink& link : bare.links) link.shapes.clear();
  RobotSpec strange = sample::jaws();
  for (RobotLink& link : strange.links) link.material = "cheese";
  const ComparedHand jaws = compared("jaws", sample::jaws());
  CompareOptions options = few();
  options.keep = [](const Comparison&) { FAIL() << "a cell was worked out"; };
  EXPECT_THAT(message_of([&] {
                (void)compare({jaws, compared("bare", bare)}, {cube()}, options);
              }),
              HasSubstr("hand 'bare' has no surface"));
  EXPECT_THAT(message_of([&] {
                (void)compare({jaws, compared("strange", strange)}, {cube()}, options);
              }),
              HasSubstr("hand 'strange': "));
}

TEST(Compare, SaysAWarningOfManyHandsOnce) {
  ComparedHand one = compared("one", sample::jaws()), two = compared("two", sample::jaws());
  one.warnings = {"assumed"};
  two.warnings = {"assumed", "left out"};
  CompareOptions options = few();
  options.approaches = 1;
  EXPECT_THAT(compare({one, two}, {cube()}, options).warnings,
              testing::ElementsAre("one, two: assumed", "two: left out"));
}

TEST(Compare, RefusesNamesTwiceAndUnknownTasks) {
  const ComparedHand hand = compared("jaws", sample::jaws());
  EXPECT_THAT(message_of([&] {
                (void)compare({hand, hand}, {cube()}, few());
              }),
              HasSubstr("'jaws' is named twice"));
  EXPECT_THAT(message_of([&] { (void)grasp_task("juggle"); }), HasSubstr("juggle"));
}

// Twice as long: eight times the mass, 32 times the moments of inertia.
TEST(Compare, ScalesBodiesAtTheSameDensity) {
  BodySpec body = cube();
  body.mass = BodyMass{0.05, {0.001, 0, 0}, Eigen::Matrix3d::Identity()};
  const BodySpec large = scaled(body, 2);
  EXPECT_EQ(large.shapes[0].size.x(), 0.06);
  EXPECT_DOUBLE_EQ(large.mass->mass, 0.4);
  EXPECT_EQ(large.mass->com.x(), 0.002);
  EXPECT_DOUBLE_EQ(large.mass->inertia(0, 0), 32);
}

// The jaws stop 80 mm apart less the cube; 10 mm off, only the near one would touch.
TEST(CentredGrasp, LetsTheObjectYieldToTheNearJaw) {
  const Grasp done = squeeze({0.01, 0, 0});
  EXPECT_EQ(done.contacts.size(), 8u);
  EXPECT_TRUE(done.quality.force_closure);
  EXPECT_NEAR(done.approached.X_WH.p.x(), 0.01, 2e-4);  // accuracy of both contacts
}

TEST(CentredGrasp, LeavesCentredObjectsAlone) {
  EXPECT_EQ(squeeze({0, 0, 0}).approached.X_WH.p, Eigen::Vector3d(0, 0, 0));
}

TEST(GraspType, NamesWhatTouches) {
  const RobotHand hand(sample::jaws());
  EXPECT_EQ(grasp_type(hand, squeeze({0, 0, 0}).contacts), "precision, pad, 2 digits");
  EXPECT_EQ(grasp_type(hand, {}), "palm alone");
}

// Tip of two links l = 50 mm, angles a in [0, pi/2] and b = a' in [0, pi/2] apart: area
// integral l^2 sin b da db = l^2 pi / 2.
TEST(Workspace, OfAPlanarFingerHasItsArea) {
  RobotSpec robot = sample::finger(DriveCoupling::kRigid);
  robot.joints[1].dof = "second";
  robot.joints[1].ratio = 1;
  robot.dofs.push_back(sample::motor("second", DriveCoupling::kRigid));
  const RobotHand hand(robot);
  std::mt19937 random(1);
  const DigitAbility finger = measure_workspaces(hand, 40000, 2e-3, random).digits.front();
  EXPECT_EQ(finger.dimension, 2);
  // The tip is the far end of the distal capsule, one radius beyond the second link.
  const double l1 = sample::kLength, l2 = sample::kLength + sample::kRadius;
  EXPECT_NEAR(finger.workspace, l1 * l2 * kPi / 2, finger.workspace_error);
  EXPECT_LT(finger.workspace_error, 0.1 * finger.workspace);
}

// Fingers of 58 mm, 80 mm apart, meet; 150 mm apart they do not.
TEST(Opposition, OfTwoFingersIsWhetherTheyMeet) {
  std::mt19937 random(1);
  const Opposition near = measure_opposition(compared("near", sample::pincer(0.08)), random);
  EXPECT_EQ(near.score, 10);
  EXPECT_EQ(near.reached.size(), 1u);
  EXPECT_EQ(measure_opposition(compared("far", sample::pincer(0.15)), random).score, 0);
}

}  // namespace
}  // namespace thenar
