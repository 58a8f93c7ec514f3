// Tests for hand_versions/human_hand.cpp, hand_use.cpp, muscle_forces.cpp and
// joint_torque_limits.cpp.

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "base/error.h"
#include "base/spatial.h"
#include "base/units.h"
#include "hand/skin/hand_anatomy.h"
#include "hand_versions/closing_synergy.h"
#include "hand_versions/human_hand.h"
#include "hand_versions/muscle_forces.h"
#include "hand_versions/tendon_hand.h"
#include "tendons/linear_tendons.h"
#include "tests/hand/hand_laws.h"
#include "tests/hand/skin/human_subjects.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::HasSubstr;

HumanHandOptions bare() {
  HumanHandOptions options;
  options.cover = Cover::kNone;
  return options;
}

int index_of(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

const Drive& drive_of(const Hand& hand, const std::string& name) {
  for (const Drive& drive : hand.layout().drives)
    if (drive.name == name) return drive;
  throw InputError("no drive " + name);
}

class HumanVersions : public testing::TestWithParam<HumanVersion> {};

TEST_P(HumanVersions, ObeysTheLawsOfHands) {
  const HumanHand human = build_human_hand(default_human(), GetParam(), bare());
  expect_hand_laws(*human.hand, 5);
  const HandLayout& layout = human.hand->layout();
  EXPECT_EQ(layout.coordinates.size(), 20U);  // the wrist is welded
  EXPECT_EQ(layout.tips.size(), 5U);
  EXPECT_EQ(human.patches.size(), 10U);
  EXPECT_EQ(human.targets.size(), 10U);
  EXPECT_NEAR(layout.approach.direction.norm(), 1, 1e-12);
  EXPECT_LT(layout.approach.direction.z(), -0.9);  // z is dorsal
}

// Every coordinate belongs to exactly one drive; flexion joints move inwards, others stand.
TEST_P(HumanVersions, DrivesEveryDigit) {
  const HumanHand human = build_human_hand(default_human(), GetParam(), bare());
  const HandLayout& layout = human.hand->layout();
  std::vector<int> moved(layout.coordinates.size(), 0);
  for (const Drive& drive : layout.drives)
    for (const DrivenCoordinate& driven : drive.moves) {
      ++moved[driven.coordinate];
      EXPECT_GT(driven.ratio, 0);
      EXPECT_EQ(drive.speed > 0,
                layout.coordinates[driven.coordinate].find("_AA") == std::string::npos);
    }
  for (const int times : moved) EXPECT_EQ(times, 1);
}

INSTANTIATE_TEST_SUITE_P(All, HumanVersions,
                         testing::Values(HumanVersion::kOrthogonalThumb, HumanVersion::kSkewedThumb,
                                         HumanVersion::kSoftPads, HumanVersion::kTendonNet));

const JointAxis& joint_of(const Subject& subject, const std::string& name) {
  for (const JointAxis& joint : subject.joints)
    if (joint.name == name) return joint;
  throw InputError("no joint " + name);
}

Eigen::Vector3d bone_direction(const Subject& subject, const std::string& name) {
  for (const Segment& segment : subject.segments)
    if (segment.name == name) return (segment.distal - segment.proximal).normalized();
  throw InputError("no " + name);
}

/// By how much a bone is flexed from the bone before it about an axis [rad].
double bend(const Eigen::Vector3d& axis, Eigen::Vector3d before, Eigen::Vector3d after) {
  before -= before.dot(axis) * axis;
  after -= after.dot(axis) * axis;
  return std::atan2(before.cross(after).dot(axis), before.dot(after));
}

// 8.6 deg about CMC1_FE and 35.6 deg about CMC1_AA bring the digitised metacarpal to where that of
// the ARMS model is neutral (both frames: x radial, y proximal, z dorsal); so ranges counted from
// there, -44.7 .. 28.6 and -44.7 .. 40.1 deg of the MyoHand, are shifted by as much.
TEST(DefaultHuman, CountsTheThumbsRangesFromItsNeutralPosture) {
  const Subject& human = default_human();
  const Subject arms = sample::subject("arms_thumb");
  const JointAxis &flexion = joint_of(human, "CMC1_FE"), &abduction = joint_of(human, "CMC1_AA");
  const Eigen::Vector3d turned = rotation_about<double>(flexion.direction, 8.6 * kDegree) *
                                 rotation_about<double>(abduction.direction, 35.6 * kDegree) *
                                 bone_direction(human, "MC1");
  constexpr double kShown = 0.06 * kDegree;  // ranges are rounded to 0.1 deg
  EXPECT_LT(std::acos(turned.dot(bone_direction(arms, "MC1"))), 0.15 * kDegree);
  EXPECT_NEAR(flexion.lower, (-44.7 + 8.6) * kDegree, kShown);
  EXPECT_NEAR(flexion.upper, (28.6 + 8.6) * kDegree, kShown);
  EXPECT_NEAR(abduction.lower, (-44.7 + 35.6) * kDegree, kShown);
  EXPECT_NEAR(abduction.upper, (40.1 + 35.6) * kDegree, kShown);
}

// From the straight posture: 7.9 deg of extension and 59.1 of flexion at MCP [ThumbMcpRange], 15
// and 80 at IP [EHand].
TEST(DefaultHuman, BendsItsThumbAsLivingHandsDo) {
  const Subject& human = default_human();
  const JointAxis &mcp = joint_of(human, "MCP1_FE"), &ip = joint_of(human, "IP1");
  const Eigen::Vector3d mc1 = bone_direction(human, "MC1"), pp1 = bone_direction(human, "PP1");
  const double at_mcp = bend(mcp.direction, mc1, pp1);
  const double at_ip = bend(ip.direction, pp1, bone_direction(human, "DP1"));
  constexpr double kShown = 0.06 * kDegree;
  EXPECT_NEAR(mcp.lower + at_mcp, -7.9 * kDegree, kShown);
  EXPECT_NEAR(mcp.upper + at_mcp, 59.1 * kDegree, kShown);
  EXPECT_NEAR(ip.lower + at_ip, -15 * kDegree, kShown);
  EXPECT_NEAR(ip.upper + at_ip, 80 * kDegree, kShown);
}

// Each step changes one thing.
TEST(HumanHand, GrowsRicherByOneThingAtATime) {
  const HumanHand a = build_human_hand(default_human(), HumanVersion::kOrthogonalThumb, bare());
  const HumanHand b = build_human_hand(default_human(), HumanVersion::kSkewedThumb, bare());
  const HumanHand c = build_human_hand(default_human(), HumanVersion::kSoftPads, bare());
  const HumanHand d = build_human_hand(default_human(), HumanVersion::kTendonNet, bare());
  const Eigen::VectorXd q = Eigen::VectorXd::Constant(20, 0.1);
  const auto tip = [&](const HumanHand& human, int digit) {
    const HandTip& at = human.hand->layout().tip_points[digit];
    return Eigen::Vector3d(human.hand->pose(q)[at.link] * at.p);
  };
  EXPECT_GT((tip(a, 0) - tip(b, 0)).norm(), 1e-3);
  for (int digit = 1; digit < 5; ++digit) EXPECT_EQ(tip(a, digit), tip(b, digit));
  EXPECT_EQ(b.contact, ContactModel::kHardPoint);
  EXPECT_EQ(c.contact, ContactModel::kSoftFinger);
  EXPECT_EQ(tip(b, 0), tip(c, 0));
  EXPECT_EQ(c.hand->actuation(q).upper, b.hand->actuation(q).upper);
  EXPECT_EQ(tip(c, 0), tip(d, 0));
  EXPECT_EQ(c.hand->layout().actuators.size(), 20U);
  EXPECT_EQ(d.hand->layout().actuators.size(), 35U);  // muscles that cross joints of digits
}

// Motors can do at the reference posture whatever the tendons can, and no joint more.
TEST(HumanHand, HasMotorsAsStrongAsItsTendons) {
  const Eigen::VectorXd q = Eigen::VectorXd::Zero(20);
  const HumanHand motors = build_human_hand(default_human(), HumanVersion::kSoftPads, bare());
  const HumanHand tendons = build_human_hand(default_human(), HumanVersion::kTendonNet, bare());
  const Actuation box = motors.hand->actuation(q), pull = tendons.hand->actuation(q);
  sample::Draw draw(9);
  for (int trial = 0; trial < 1000; ++trial) {
    Eigen::VectorXd u = pull.upper;
    for (double& tension : u) tension *= draw.number(0, 1) < 0.5 ? 0 : 1;
    const Eigen::VectorXd tau = pull.B * u;
    EXPECT_TRUE((tau.array() <= box.upper.array() + 1e-12).all());
    EXPECT_TRUE((tau.array() >= box.lower.array() - 1e-12).all());
  }
  for (int joint = 0; joint < 20; ++joint) {
    const Eigen::VectorXd u =
        (pull.B.row(joint).transpose().array() > 0).select(pull.upper, Eigen::VectorXd::Zero(35));
    EXPECT_NEAR(pull.B.row(joint).dot(u), box.upper[joint], 1e-12);
  }
}

TEST(HumanHand, CarriesNetsOnAllFingers) {
  const HumanHand human = build_human_hand(default_human(), HumanVersion::kTendonNet, bare());
  for (const std::string& warning : human.warnings)
    EXPECT_THAT(warning, testing::Not(HasSubstr("no net")));
  const Actuation actuation = human.hand->actuation(Eigen::VectorXd::Zero(20));
  EXPECT_EQ(actuation.status, ActuationStatus::kLinearised);
  EXPECT_EQ(actuation.warning, "");
}

// Of the deep flexor of the index finger, which no net moves.
TEST(HumanHand, RunsTendonsOnThePathsThatWereAsked) {
  std::vector<double> arms;
  for (const Path path : {Path::kViaPoint, Path::kFitted}) {
    HumanHandOptions options = bare();
    options.path = path;
    const HumanHand human = build_human_hand(default_human(), HumanVersion::kTendonNet, options);
    TendonOptions alone;
    alone.path = path;
    const auto finger = build_linear_tendons(default_human(), "index", alone);
    const HandLayout& layout = human.hand->layout();
    const int pip = index_of(layout.coordinates, "PIP2");
    Eigen::VectorXd q = Eigen::VectorXd::Zero(20);
    q[pip] = 0.9;
    const TendonNames& names = finger->digit().names;
    Eigen::VectorXd q_finger = Eigen::VectorXd::Zero(4);
    q_finger[index_of(names.coordinates, "PIP2")] = 0.9;
    const Eigen::MatrixXd R =
        finger->evaluate(q_finger, Eigen::VectorXd::Zero(static_cast<int>(names.muscles.size()))).R;
    arms.push_back(human.hand->actuation(q).B(pip, index_of(layout.actuators, "FDP2")));
    EXPECT_NEAR(arms.back(),
                R(index_of(names.muscles, "FDP2"), index_of(names.coordinates, "PIP2")), 1e-12);
  }
  EXPECT_GT(std::abs(arms[1] - arms[0]), 1e-7);  // [m/rad]
}

TEST(HumanHand, TouchesWithSkinOrBones) {
  HumanHandOptions options;
  options.cover = Cover::kBones;
  const HumanHand bones =
      build_human_hand(sample::subject("arms_thumb"), HumanVersion::kSkewedThumb, options);
  ASSERT_EQ(bones.hand->surfaces().size(), 3U);
  EXPECT_EQ(bones.hand->surfaces().front().material, "bone");
  const HumanHand skin = build_human_hand(sample::subject("arms_thumb"), HumanVersion::kSoftPads);
  ASSERT_EQ(skin.hand->surfaces().size(), 3U);
  EXPECT_EQ(skin.hand->surfaces().back().material, "skin");
}

// Pads of pulp are what the third version has beyond the second.
TEST(HumanHand, HasPadsAtItsFingertipsFromTheThirdVersionOn) {
  const Subject subject = sample::subject("arms_thumb");
  const auto materials = [&](HumanVersion version, const std::string& skin) {
    HumanHandOptions options;
    options.skin.material = skin;
    std::vector<std::string> found;
    for (const LinkSurface& surface : build_human_hand(subject, version, options).hand->surfaces())
      found.push_back(surface.material);
    return found;
  };
  using testing::Each;
  EXPECT_THAT(materials(HumanVersion::kSkewedThumb, "skin"), Each("skin"));
  const std::vector<std::string> soft = materials(HumanVersion::kSoftPads, "skin");
  EXPECT_EQ(std::count(soft.begin(), soft.end(), "fingertip"), 1);
  EXPECT_EQ(soft.front(), "fingertip");  // segments of a subject's file run inwards here
  EXPECT_THAT(materials(HumanVersion::kSoftPads, "rubber"), Each("rubber"));
}

// A flat hand has no tendons: strength is borrowed, twice as long is eight times as strong.
TEST(HumanHand, BorrowsStrengthByTheCubeOfLength) {
  const auto strength = [](double scale) {
    const Subject subject = sample::scaled({0.195 * scale, 0.085 * scale});
    const HumanHand human = build_human_hand(subject, HumanVersion::kSkewedThumb, bare());
    EXPECT_THAT(human.warnings, testing::Contains(HasSubstr("'human_hand' times")));
    return human.hand->actuation(Eigen::VectorXd::Zero(20)).upper;
  };
  const Eigen::VectorXd one = strength(1), two = strength(2);
  EXPECT_GT(one.minCoeff(), 0);
  EXPECT_LT((two - 8 * one).norm(), 1e-12 * two.norm());
}

TEST(HumanHand, RefusesTendonsWhereThereAreNone) {
  EXPECT_EQ(message_of(
                [] { (void)build_human_hand(sample::scaled(), HumanVersion::kTendonNet, bare()); }),
            "subject 'buchholz1992' has no tendons for the fourth version");
  // Its fingers have no muscles: motors borrow, tendons cannot.
  const Subject thumb_only = sample::subject("graspit_skewed_thumb");
  EXPECT_NO_THROW((void)build_human_hand(thumb_only, HumanVersion::kSkewedThumb, bare()));
  EXPECT_EQ(
      message_of([&] { (void)build_human_hand(thumb_only, HumanVersion::kTendonNet, bare()); }),
      "no muscle of 'graspit_skewed_thumb' moves its index; the fourth version wants tendons "
      "at every digit");
  EXPECT_EQ(human_version("soft"), HumanVersion::kSoftPads);
  EXPECT_EQ(human_version("tier3"), HumanVersion::kSoftPads);  // its old name
  EXPECT_EQ(message_of([] { (void)human_version("tier5"); }),
            "no version of the human hand 'tier5'; there are orthogonal, skewed, soft, tendons");
}

// -- Strength and closing ---------------------------------------------------------------------

// By hand: the middle finger's FDP has 4.1 cm^2 at 45 N/cm^2 = 184.5 N; the ring finger's section
// is (8.39 / 9.28)^2 of the middle finger's.
TEST(MuscleForces, TakeNamesakesOfTheMiddleFinger) {
  const MuscleForces forces = muscle_forces(default_human(), {"FDP3", "FDP4", "FPL"});
  EXPECT_NEAR(forces.max_force.at("FDP3"), 184.5, 1e-9);
  EXPECT_NEAR(forces.max_force.at("FDP4"), 184.5 * 8.39 * 8.39 / (9.28 * 9.28), 1e-9);
  EXPECT_NEAR(forces.max_force.at("FPL"), 201, 1e-9);
  EXPECT_THAT(forces.assumed, testing::ElementsAre("FDP4: 150.8 N, as FDP3 times 0.82"));
  EXPECT_THAT(message_of([] { (void)muscle_forces(sample::subject("mirakhorlo2016"), {"FCR"}); }),
              HasSubstr("largest tension of muscle 'FCR' of 'mirakhorlo2016' is unknown"));
}

/// Two joints, three tendons.
class ThreeTendons final : public Hand {
 public:
  ThreeTendons() {
    layout_.coordinates = {"J1", "J2"};
    layout_.actuators = {"FDP", "FDS", "EDC"};
  }
  const HandLayout& layout() const override { return layout_; }
  std::vector<Pose<double>> pose(const Eigen::VectorXd&) const override { return {}; }
  Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(const Eigen::VectorXd&, int,
                                                    const Eigen::Vector3d&) const override {
    return {};
  }
  Actuation actuation(const Eigen::VectorXd&) const override {
    Actuation actuation;
    actuation.B.resize(2, 3);
    actuation.B << 0.010, 0.008, -0.006, 0.005, 0.000, -0.004;
    actuation.tau_0 = Eigen::Vector2d(9, 9);
    actuation.lower = Eigen::Vector3d::Zero();
    actuation.upper = Eigen::Vector3d(100, 50, 20);
    return actuation;
  }
  const std::vector<LinkSurface>& surfaces() const override { return surfaces_; }

 private:
  HandLayout layout_;
  std::vector<LinkSurface> surfaces_;
};

TEST(JointStrength, IsTheBoxAboutTheTorques) {
  const TorqueLimits limits = joint_torque_limits(ThreeTendons(), Eigen::Vector2d::Zero());
  EXPECT_TRUE(matrix_near(limits.upper, Eigen::Vector2d(1.4, 0.5), 1e-12));
  EXPECT_TRUE(matrix_near(limits.lower, Eigen::Vector2d(-0.12, -0.08), 1e-12));
}

TEST(ClosingSynergy, PullsFlexorsAlone) {
  const ThreeTendons hand;
  const Actuation actuation = hand.actuation(Eigen::Vector2d::Zero());
  EXPECT_TRUE(matrix_near(max_flexor_tensions(hand.layout().actuators, actuation),
                          Eigen::Vector3d(100, 50, 0), 0));
  EXPECT_TRUE(matrix_near(max_flexor_tensions(hand), Eigen::Vector3d(100, 50, 0), 0));
  EXPECT_THROW((void)max_flexor_tensions({"FDP"}, actuation), InputError);
}

// Ratios of the flexors' torques at their largest tensions, by the hand's own B.
TEST(ClosingSynergy, ClosesByTheTendonsTorques) {
  const HumanHand human = build_human_hand(default_human(), HumanVersion::kTendonNet, bare());
  const HandLayout& layout = human.hand->layout();
  const Actuation actuation = human.hand->actuation(Eigen::VectorXd::Zero(20));
  const Drive& index = drive_of(*human.hand, "index");
  EXPECT_EQ(index.coupling, DriveCoupling::kCompliant);
  ASSERT_EQ(index.moves.size(), 3U);
  const int fds = index_of(layout.actuators, "FDS2"), fdp = index_of(layout.actuators, "FDP2");
  const auto torque = [&](const DrivenCoordinate& driven) {
    return actuation.B(driven.coordinate, fds) * actuation.upper[fds] +
           actuation.B(driven.coordinate, fdp) * actuation.upper[fdp];
  };
  for (const DrivenCoordinate& driven : index.moves)
    EXPECT_NEAR(driven.ratio / index.moves[0].ratio, torque(driven) / torque(index.moves[0]), 1e-9);
}

TEST(ClosingSynergy, CurlsMotorFingersByConvention) {
  const HumanHand human = build_human_hand(sample::scaled(), HumanVersion::kSkewedThumb, bare());
  const Drive& index = drive_of(*human.hand, "index");
  EXPECT_EQ(index.coupling, DriveCoupling::kBreakaway);
  ASSERT_EQ(index.moves.size(), 3U);
  EXPECT_EQ(index.moves[0].ratio, 1);
  EXPECT_EQ(index.moves[1].ratio, 1);
  EXPECT_NEAR(index.moves[2].ratio, 2.0 / 3, 1e-15);
}

}  // namespace
namespace {

const JointAxis& named_joint(const Subject& subject, const std::string& name) {
  for (const JointAxis& joint : subject.joints)
    if (joint.name == name) return joint;
  throw InputError("no joint " + name);
}

TEST(OrthogonalThumb, CrossesItsAxesAtRightAngles) {
  for (const char* name : {"mirakhorlo2016", "arms_thumb", "graspit_skewed_thumb"}) {
    const Subject simple = orthogonal_thumb(sample::subject(name));
    const JointAxis &flexion = named_joint(simple, "CMC1_FE"),
                    &abduction = named_joint(simple, "CMC1_AA");
    EXPECT_NEAR(flexion.direction.dot(abduction.direction), 0, 1e-12) << name;
    EXPECT_EQ(flexion.point, abduction.point) << name;
  }
}

TEST(OrthogonalThumb, TurnsAcrossItsBones) {
  const Subject given = sample::subject("mirakhorlo2016");
  const Subject simple = orthogonal_thumb(given);
  const HandAnatomy hand = find_anatomy(given);
  const DigitAnatomy* thumb = digit_named(hand, "thumb");
  for (const auto& [name, bone] : {std::pair("MCP1_FE", 1), {"IP1", 2}}) {
    const DigitBone& after = thumb->bones[bone];
    const JointAxis& joint = named_joint(simple, name);
    EXPECT_NEAR(joint.direction.dot((after.distal - after.proximal).normalized()), 0, 1e-12);
    EXPECT_EQ(joint.point, after.proximal);
    EXPECT_GT(joint.direction.dot(named_joint(given, name).direction), 0) << "turns the other way";
  }
}

TEST(OrthogonalThumb, LeavesAllElseAlone) {
  const Subject given = sample::subject("mirakhorlo2016"), simple = orthogonal_thumb(given);
  for (std::size_t i = 0; i < given.joints.size(); ++i) {
    const JointAxis &before = given.joints[i], &after = simple.joints[i];
    const bool thumb = before.name.find('1') != std::string::npos;
    EXPECT_EQ(before.direction != after.direction, thumb) << before.name;
    EXPECT_EQ(before.lower, after.lower);
    EXPECT_EQ(before.upper, after.upper);
  }
  for (std::size_t i = 0; i < given.segments.size(); ++i)
    EXPECT_EQ(given.segments[i].distal, simple.segments[i].distal);
}

// A thumb that is orthogonal already stays as it is.
TEST(OrthogonalThumb, ChangesNothingInASimpleHand) {
  const Subject given = sample::scaled(), simple = orthogonal_thumb(given);
  for (std::size_t i = 0; i < given.joints.size(); ++i) {
    EXPECT_TRUE(matrix_near(simple.joints[i].direction, given.joints[i].direction, 1e-12));
    EXPECT_TRUE(matrix_near(simple.joints[i].point, given.joints[i].point, 1e-12));
  }
}

TEST(OrthogonalThumb, WantsAThumb) {
  EXPECT_EQ(message_of([] { (void)orthogonal_thumb(sample::subject("an_chao_index")); }),
            "subject 'an_chao_index' has no thumb");
}

}  // namespace
}  // namespace thenar
