// Tests for grasp/robot/robot_hand.cpp and grasp/robot/robot_tips.cpp, on small robots and on
// data/robots.

#include "grasp/robot/robot_hand.h"

#include <filesystem>

#include <gmock/gmock.h>

#include "base/error.h"
#include "base/units.h"
#include "data/io/toml_table.h"
#include "tests/data/robot/sample_robots.h"
#include "tests/hand/hand_laws.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

const std::string kRobots = std::string(THENAR_DATA_DIR) + "/robots/";

RobotSpec robot(const std::string& name) { return read_robot(kRobots + name + ".toml"); }

std::vector<std::string> all_robots() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kRobots))
    names.push_back(entry.path().stem().string());
  return names;
}

std::size_t index_of(const RobotHand& hand, const std::string& link) {
  const auto at = std::find(hand.links().begin(), hand.links().end(), link);
  EXPECT_NE(at, hand.links().end()) << link;
  return static_cast<std::size_t>(at - hand.links().begin());
}

VectorXd zero(const RobotHand& hand) {
  return VectorXd::Zero(static_cast<Eigen::Index>(hand.layout().coordinates.size()));
}

// The 100 m of way of the mobile base would leave no digits for difference quotients.
TEST(RobotHand, ObeysTheLawsOfHands) {
  unsigned seed = 81;
  for (const std::string& name : all_robots()) {
    SCOPED_TRACE(name);
    RobotSpec spec = robot(name);
    for (RobotJoint& joint : spec.joints) joint.upper = std::min(joint.upper, 10.0);
    expect_hand_laws(RobotHand(spec), ++seed);
  }
  expect_hand_laws(RobotHand(attach(robot("puma560"), "link 6", robot("barrett"), {})), ++seed);
  RobotSpec small = sample::small_robot(4);
  for (RobotJoint& joint : small.joints) {
    joint.stiffness = 0.3;
    joint.X_PJ.p /= 1000;  // to the size of a hand
    joint.X_JC.p /= 1000;
  }
  expect_hand_laws(RobotHand(small), ++seed);
}

constexpr double kPrinted = 0.6e-6;  // figures are printed to 1 um, quaternions to 8 digits [m]

TEST(RobotHand, HasLinksWherePublishedFiguresHaveThem) {
  const std::string path = std::string(THENAR_DATA_DIR) + "/../tests/data/robot/tip_positions.toml";
  const TomlFile file(read_text_file(path), path);
  TomlTable top = file.top();
  std::size_t tips = 0;
  for (TomlTable& tip : top.tables("tip")) {
    const RobotHand hand(robot(tip.text("robot")));
    const std::size_t link = index_of(hand, tip.text("link"));
    const Vector3d published = tip.vector(Dimension::kLength, "position");
    EXPECT_TRUE(matrix_near(hand.link_frames(zero(hand))[link].p, published,
                            tip.number_or(Dimension::kLength, "tolerance", kPrinted)))
        << tip.text("robot") << ": " << tip.text("link");
    ++tips;
  }
  EXPECT_GE(tips, 50U);
}

/// The end of the Puma by the product of its Denavit-Hartenberg rows, written out.
Pose<double> puma_end(const VectorXd& q) {
  const double d[] = {0.67183, 0, 0.15005, 0.4318, 0, 0};
  const double a[] = {0, 0.4318, 0.0203, 0, 0, 0};
  const double alpha[] = {kPi / 2, 0, -kPi / 2, kPi / 2, -kPi / 2, 0};
  Pose<double> X;
  for (int i = 0; i < 6; ++i) {
    const Pose<double> about_z{rotation_about<double>(Vector3d::UnitZ(), q[i]), {0, 0, d[i]}};
    const Pose<double> about_x{rotation_about<double>(Vector3d::UnitX(), alpha[i]), {a[i], 0, 0}};
    X = X * about_z * about_x;
  }
  return X;
}

// qz, qr, qn, qs of [RoboticsToolbox]. Ready (qr): the arm stands straight up, so the wrist is
// above the shoulder by both lengths and the elbow's offset lies across.
TEST(RobotHand, PosesThePumaAsPublished) {
  const RobotHand arm(robot("puma560"));
  std::vector<VectorXd> postures(4, VectorXd::Zero(6));
  postures[1] << 0, kPi / 2, -kPi / 2, 0, 0, 0;
  postures[2] << 0, kPi / 4, kPi, 0, kPi / 4, 0;
  postures[3] << 0, 0, -kPi / 2, 0, 0, 0;
  for (const VectorXd& q : postures) {
    const Pose<double> end = arm.link_frames(q)[index_of(arm, "link 6")], wanted = puma_end(q);
    EXPECT_TRUE(matrix_near(end.R, wanted.R, 1e-9));  // angles in the file have ten digits
    EXPECT_TRUE(matrix_near(end.p, wanted.p, 1e-9));
  }
  const Vector3d ready = arm.link_frames(postures[1])[index_of(arm, "link 6")].p;
  EXPECT_TRUE(matrix_near(ready, Vector3d(0.0203, -0.15005, 0.67183 + 0.4318 + 0.4318), 1e-9));
}

// Barrett on Puma on XR4000: the fingertip is where the poses of the three, each by itself, put it.
TEST(RobotHand, MountsAHandOnAnArmOnABase) {
  const RobotSpec base = robot("xr4000"), arm = robot("puma560"), tool = robot("barrett");
  std::mt19937 rng(7);
  const Pose<double> X_top = sample::random_pose(rng), X_wrist = sample::random_pose(rng);
  const RobotHand all(attach(attach(base, "top", arm, X_top), "link 6", tool, X_wrist));
  ASSERT_EQ(all.layout().coordinates.size(), 3U + 6 + 7);

  const RobotHand on_base(base), on_arm(arm), on_tool(tool);
  VectorXd q(16);
  for (double& value : q) value = sample::odd_number(rng, 2);
  const Pose<double> top = on_base.link_frames(q.head(3))[index_of(on_base, "top")];
  const Pose<double> wrist = on_arm.link_frames(q.segment(3, 6))[index_of(on_arm, "link 6")];
  for (const char* link : {"palm", "finger 1 L3", "finger 3 L2"}) {
    const Pose<double> wanted =
        top * X_top * wrist * X_wrist * on_tool.link_frames(q.tail(7))[index_of(on_tool, link)];
    const Pose<double> got = all.link_frames(q)[index_of(all, link)];
    EXPECT_TRUE(matrix_near(got.R, wanted.R, 1e-12));
    EXPECT_TRUE(matrix_near(got.p, wanted.p, 1e-9));  // of lengths up to 1 km
  }
}

// Spread: 1 coordinate, rigid. Fingers: inner and outer joint each, outer at a third.
TEST(RobotHand, LetsBreakawayJointsPart) {
  const RobotHand hand(robot("barrett"));
  const HandLayout& layout = hand.layout();
  ASSERT_EQ(layout.coordinates.size(), 7U);
  ASSERT_EQ(layout.drives.size(), 4U);
  EXPECT_EQ(layout.drives[0].coupling, DriveCoupling::kRigid);
  EXPECT_EQ(layout.drives[0].moves.size(), 1U);
  const Drive& finger = layout.drives[1];
  EXPECT_EQ(finger.coupling, DriveCoupling::kBreakaway);
  EXPECT_EQ(finger.breakaway, 0.5);
  ASSERT_EQ(finger.moves.size(), 2U);
  EXPECT_EQ(finger.moves[0].ratio, 1);
  EXPECT_NEAR(finger.moves[1].ratio, 1.0 / 3, 1e-9);
  EXPECT_EQ(layout.coordinates[static_cast<std::size_t>(finger.moves[1].coordinate)],
            "finger 1 J3");
}

// DriveCoupling by a clutch: the outer joint, of ratio 1/3, gets 3 u less what the clutch gives the
// inner one, of ratio 1; 3 u whole once the clutch has opened. Worms hold both, and lock the
// spread.
TEST(RobotHand, DrivesTheOuterJointThroughTheClutch) {
  const RobotHand hand(robot("barrett"));
  const Drive& finger = hand.layout().drives[1];
  const int inner = finger.moves[0].coordinate, outer = finger.moves[1].coordinate;
  EXPECT_FALSE(finger.backdrivable);
  const Actuation coupled = hand.actuation(zero(hand));
  EXPECT_EQ(coupled.B(inner, 1), 0);
  EXPECT_NEAR(coupled.B(outer, 1), 3, 1e-8);
  EXPECT_EQ(coupled.reactions.non_backdrivable.size(), 6U);
  ASSERT_EQ(coupled.reactions.R.cols(), 4);  // the spread, three clutches
  EXPECT_EQ(coupled.reactions.R(inner, 1), 1);
  EXPECT_NEAR(coupled.reactions.R(outer, 1), -3, 1e-8);
  EXPECT_EQ(coupled.reactions.lower[1], 0);
  EXPECT_EQ(coupled.reactions.upper[1], finger.breakaway);
  VectorXd parted = zero(hand);
  parted[outer] = 0.2;
  EXPECT_EQ(hand.actuation(parted).reactions.R(outer, 1), 0);
  EXPECT_NEAR(hand.actuation(parted).B(outer, 1), 3, 1e-8);
}

// tau = u r / (r'r) with r = (1/2, 1/2): the motor's power u whenever both joints move by r.
TEST(RobotHand, SharesTheMotorOfACompliantDrive) {
  const RobotHand hand(robot("shadow"));
  const auto& drives = hand.layout().drives;
  const auto shared = std::find_if(drives.begin(), drives.end(), [](const Drive& drive) {
    return drive.coupling == DriveCoupling::kCompliant;
  });
  ASSERT_NE(shared, drives.end());
  const VectorXd column = hand.actuation(zero(hand)).B.col(shared - drives.begin());
  for (const DrivenCoordinate& move : shared->moves) EXPECT_NEAR(column[move.coordinate], 1, 1e-12);
}

TEST(RobotHand, KnowsEffortsThatArePublished) {
  EXPECT_EQ(RobotHand(robot("franka_hand")).actuation(VectorXd::Zero(1)).upper[0], 200);
  EXPECT_EQ(RobotHand(robot("puma560")).actuation(VectorXd::Zero(6)).upper[0],
            std::numeric_limits<double>::infinity());
}

// The outer joint of small_robot follows by 1/3 and an offset; springs pull to rest.
TEST(RobotHand, PullsJointsToTheRestOfTheirSprings) {
  RobotSpec spec = sample::small_robot();
  for (RobotJoint& joint : spec.joints) {
    joint.stiffness = 0;
    joint.lower = -3;
    joint.upper = 3;
  }
  spec.dofs[0].kind = DriveCoupling::kRigid;
  spec.joints[1].stiffness = 0.6;
  spec.joints[1].rest = 0.5;
  spec.joints[1].offset = 0.2;
  const RobotHand hand(spec);
  const Eigen::Vector2d q(0.3, 0);  // outer joint at 0.1 + 0.2
  EXPECT_NEAR(hand.actuation(q).tau_0[0], 0.6 * (0.5 - 0.3) / 3, 1e-15);
}

TEST(RobotHand, OpensJawsTogether) {
  const RobotHand hand(robot("parallel_jaw"));
  const std::vector<Pose<double>> X = hand.pose(VectorXd::Constant(1, 0.02));
  ASSERT_EQ(X.size(), 2U);
  EXPECT_TRUE(matrix_near(X[0].p, Vector3d(-0.02, 0, 0), 1e-17));
  EXPECT_TRUE(matrix_near(X[1].p, Vector3d(0.02, 0, 0), 1e-17));
  EXPECT_EQ(hand.layout().drives[0].speed, -1);
  EXPECT_EQ(hand.layout().upper[0], 0.055);
  // Middle of the jaws' front faces: 75 mm boxes centred 25 mm out.
  EXPECT_TRUE(matrix_near(hand.layout().tip_points[0].p, Vector3d(-0.008, 0.0625, 0), 1e-12));
}

// Pads of the linkage stay upright: knuckle and finger turn against each other.
TEST(RobotHand, KeepsThePadsOfTheLinkageParallel) {
  const RobotHand hand(robot("robotiq_2f85"));
  const std::size_t left = index_of(hand, "left pad"), right = index_of(hand, "right pad");
  const std::vector<Pose<double>> open = hand.link_frames(zero(hand));
  const std::vector<Pose<double>> shut = hand.link_frames(VectorXd::Constant(1, 0.8));
  EXPECT_TRUE(matrix_near(open[left].R, shut[left].R, 1e-15));
  const double gap = 0.00635;  // pads' thickness: half of each lies on either side of its frame
  EXPECT_NEAR((open[left].p - open[right].p).norm() - gap, 0.085, 0.002);  // its name: 85 mm
  EXPECT_NEAR((shut[left].p - shut[right].p).norm() - gap, 0, 0.004);
  // Tips: half a pad of 37.5 mm beyond the pad's frame, away from the joint that bears it.
  const Vector3d tip = open[left].p + Vector3d(0, 0, 0.0375 / 2);
  EXPECT_TRUE(matrix_near(hand.layout().tip_points[0].p, tip, 1e-12));
}

struct JointReach {
  const char* robot;
  const char* digit;
  const char* link;  // outermost
  Vector3d along;    // of its frame (3)
  double length;     // of the tip beyond its origin [m]
};

// Lengths of the outermost links as published [GraspItRobots]; a tip frame ends at its origin.
TEST(RobotHand, EndsDigitsAtTheirPublishedLengths) {
  const JointReach reaches[] = {{"dlr", "thumb", "thumb L4", Vector3d::UnitZ(), 0.04656},
                                {"robonaut", "index", "index L4", Vector3d::UnitX(), 0.01778},
                                {"robonaut", "thumb", "thumb L3", Vector3d::UnitX(), 0.03294},
                                {"rutgers", "little", "little L4", Vector3d::UnitX(), 0.03175},
                                {"shadow", "index", "fftip", Vector3d::UnitZ(), 0}};
  for (const JointReach& reach : reaches) {
    SCOPED_TRACE(reach.robot);
    const RobotHand hand(robot(reach.robot));
    const Pose<double> frame = hand.link_frames(zero(hand))[index_of(hand, reach.link)];
    const HandLayout& layout = hand.layout();
    const auto at = std::find(layout.tips.begin(), layout.tips.end(), reach.digit);
    ASSERT_NE(at, layout.tips.end());
    const HandTip& tip = layout.tip_points[static_cast<std::size_t>(at - layout.tips.begin())];
    EXPECT_NEAR(reach.along.dot(frame.inverse() * tip.p), reach.length, 2e-6);  // boxes: to 1 um
  }
}

// Reference: every degree of freedom zero, every joint at its offset.
TEST(RobotHand, DisplacesNothingAtItsReference) {
  for (const std::string& name : all_robots()) {
    const RobotHand hand(robot(name));
    for (const Pose<double>& X : hand.pose(zero(hand))) {
      EXPECT_TRUE(X.R.isIdentity(0));
      EXPECT_TRUE(X.p.isZero(1e-15));
    }
  }
}

TEST(RobotHand, CarriesItsSurfacesInTheHandsFrame) {
  const RobotHand hand(robot("barrett"));
  ASSERT_EQ(hand.surfaces().size(), 9U);  // palm, 3 + 3 + 2 links
  EXPECT_EQ(hand.surfaces()[0].link, -1);
  const LinkSurface& tip = hand.surfaces()[3];
  EXPECT_EQ(tip.name, "finger 1 L3");
  EXPECT_EQ(tip.digit, "finger 1");
  EXPECT_EQ(tip.material, "wood");
  // Its frame lies inside near the end, 2 mm from the far end of its box.
  const Vector3d end = hand.link_frames(zero(hand))[index_of(hand, "finger 1 L3")].p;
  EXPECT_LT(tip.solid->shape->distance(end), 0);
  EXPECT_GT(tip.solid->shape->distance(end), -0.0021);
}

TEST(RobotHand, RefusesLimitsThatLeaveNothing) {
  RobotSpec spec = sample::small_robot();
  spec.dofs[1].lower = spec.dofs[1].upper = spec.joints[2].upper + 1;
  EXPECT_THAT(message_of([&] { (void)RobotHand(spec); }), testing::HasSubstr("leave nothing"));
}

TEST(RobotHand, NamesTheLinkWhoseMeshIsNoSolid) {
  RobotSpec spec = robot("parallel_jaw");
  ShapeSpec leaky;
  leaky.kind = ShapeKind::kMesh;
  leaky.mesh = {Eigen::Matrix3d::Identity(), Eigen::Vector3i(0, 1, 2)};
  spec.links.back().shapes = {leaky};
  EXPECT_THAT(message_of([&] { (void)RobotHand(spec); }),
              testing::AllOf(testing::HasSubstr("link '" + spec.links.back().name + "'"),
                             testing::HasSubstr("it is flat")));
}

TEST(RobotHand, FindsThePostureOfItsMotors) {
  const RobotHand hand(robot("barrett"));
  const VectorXd q = hand.posture(Eigen::Vector4d(0.1, 0.9, 0.3, 0.6));
  VectorXd wanted(7);
  wanted << 0.1, 0.9, 0.3, 0.3, 0.1, 0.6, 0.2;
  EXPECT_TRUE(matrix_near(q, wanted, 1e-9));  // the third is printed to nine digits
}

}  // namespace
}  // namespace thenar
