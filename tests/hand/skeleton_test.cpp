// Tests for hand/skeleton.cpp.

#include <limits>

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include "base/error.h"
#include "base/units.h"
#include "hand/skeleton.h"
#include "tests/hand/sample_subjects.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

/// Where the tip of a digit is.
Eigen::Vector3d tip_at(const Skeleton& skeleton, const std::string& digit,
                       const std::map<std::string, double>& angles) {
  const SkeletonTip& t = tip(skeleton, digit);
  return moved(pose_tree(skeleton.tree, posture(skeleton, angles)), t.link, t.p);
}

/// Displacement of a segment from the reference posture, through frozen joints too.
Pose<double> segment_pose(const Skeleton& skeleton, const std::string& segment,
                          const std::map<std::string, double>& angles) {
  const int link = skeleton.link_of_segment.at(segment);
  const Pose<double>& at = skeleton.segment_at.at(segment);
  if (link < 0) return at;
  return pose_tree(skeleton.tree, posture(skeleton, angles))[link].X * at;
}

template <typename Call>
std::string message(Call call) {
  try {
    call();
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

std::map<std::string, double> random_angles(const Skeleton& skeleton, unsigned seed) {
  sample::Draw draw(seed);
  std::map<std::string, double> angles;
  for (const std::string& name : skeleton.coordinate_names) angles[name] = draw.number(-1, 1);
  return angles;
}

TEST(Skeleton, UniversalJointIsTwoHingesOnOneSegment) {
  const Skeleton skeleton = build_skeleton(sample::coupled_digit());
  EXPECT_EQ(skeleton.hinge_names, (std::vector<std::string>{"MCP_AA", "MCP_FE", "PIP", "DIP"}));
  EXPECT_EQ(skeleton.link_of_segment.at("PP"), 1);
  EXPECT_EQ(skeleton.masses[0].mass, 0);
  EXPECT_GT(skeleton.masses[1].mass, 0);
}

// Freezing at angle a is the same as posing at q = a, for one, the first, the second or all.
TEST(Skeleton, FrozenJointsAreWelded) {
  const Subject subject = sample::random_hand(21);
  const Skeleton full = build_skeleton(subject);
  const auto angles = random_angles(full, 22);
  const std::vector<std::vector<std::string>> choices{
      {"wrist_0"},
      {"wrist_1", "thumb_0_0"},
      {"thumb_0_1", "index_2_0"},
      {"wrist_0", "wrist_1", "ring_0_0", "ring_0_1", "ring_1_0", "ring_2_0"},
      full.coordinate_names};
  for (const auto& choice : choices) {
    SkeletonOptions options;
    auto free = angles;
    for (const std::string& name : choice) {
      options.frozen[name] = angles.at(name);
      free.erase(name);
    }
    const Skeleton welded = build_skeleton(subject, options);
    EXPECT_EQ(welded.coordinates() + choice.size(), angles.size());
    for (const Segment& segment : subject.segments) {
      const Pose<double> a = segment_pose(full, segment.name, angles);
      const Pose<double> b = segment_pose(welded, segment.name, free);
      EXPECT_TRUE(matrix_near(a.R, b.R, 1e-14));
      EXPECT_TRUE(matrix_near(a.p, b.p, 1e-14));
    }
    for (const Digit& digit : subject.digits)
      EXPECT_TRUE(
          matrix_near(tip_at(full, digit.name, angles), tip_at(welded, digit.name, free), 1e-14));
  }
}

TEST(Skeleton, WeldedMassesMoveTogether) {
  const Subject subject = sample::random_hand(23);
  const Skeleton full = build_skeleton(subject);
  SkeletonOptions options;
  options.frozen["thumb_1_0"] = 0.6;
  const Skeleton welded = build_skeleton(subject, options);
  const TreeState<double> state = pose_tree(full.tree, posture(full, {{"thumb_1_0", 0.6}}));
  const LinkMass& near = full.masses[full.link_of_segment.at("thumb_0")];
  const LinkMass& far = full.masses[full.link_of_segment.at("thumb_1")];
  const Eigen::Vector3d far_com = moved(state, full.link_of_segment.at("thumb_1"), far.com);
  const LinkMass& both = welded.masses[welded.link_of_segment.at("thumb_0")];
  EXPECT_DOUBLE_EQ(both.mass, near.mass + far.mass);
  EXPECT_TRUE(matrix_near(both.mass * both.com, near.mass * near.com + far.mass * far_com, 1e-16));
}

TEST(Skeleton, DroppedDigitsChangeNothingElse) {
  const Subject subject = sample::random_hand(24);
  const Skeleton full = build_skeleton(subject);
  SkeletonOptions options;
  options.digits = {"thumb", "ring"};
  const Skeleton kept = build_skeleton(subject, options);
  EXPECT_EQ(kept.coordinates(), 2 + 4 + 4);
  EXPECT_EQ(kept.tips.size(), 2U);
  const auto angles = random_angles(kept, 25);
  for (const std::string digit : {"thumb", "ring"})
    EXPECT_EQ(tip_at(kept, digit, angles), tip_at(full, digit, angles));
}

TEST(Skeleton, CoupledHingeFollowsItsLeader) {
  const Subject subject = sample::coupled_digit();
  Subject uncoupled = subject;
  uncoupled.joints[3].coupling.reset();
  const Skeleton skeleton = build_skeleton(subject);
  EXPECT_EQ(skeleton.coordinates(), 3);
  const Eigen::Vector3d follows = tip_at(skeleton, "index", {{"MCP_FE", 0.2}, {"PIP", 0.9}});
  const Eigen::Vector3d turned =
      tip_at(build_skeleton(uncoupled), "index",
             {{"MCP_FE", 0.2}, {"PIP", 0.9}, {"DIP", 2.0 / 3.0 * 0.9 + 0.1}});
  EXPECT_TRUE(matrix_near(follows, turned, 1e-16));
}

TEST(Skeleton, FollowerOfAFrozenLeaderIsFrozenToo) {
  SkeletonOptions options;
  options.frozen["PIP"] = 0.9;
  const Skeleton welded = build_skeleton(sample::coupled_digit(), options);
  EXPECT_EQ(welded.hinge_names, (std::vector<std::string>{"MCP_AA", "MCP_FE"}));
  EXPECT_TRUE(matrix_near(
      tip_at(welded, "index", {{"MCP_FE", 0.2}}),
      tip_at(build_skeleton(sample::coupled_digit()), "index", {{"MCP_FE", 0.2}, {"PIP", 0.9}}),
      1e-16));
}

// By hand: both springs at PIP angle q and DIP angle 2/3 q + 0.1; the DIP acts through 2/3.
TEST(Skeleton, LeaderFeelsTheSpringOfItsFollower) {
  const Subject subject = sample::coupled_digit();
  const JointAxis &pip = subject.joints[2], &dip = subject.joints[3];
  const double q = 0.7;
  const double expected = -pip.stiffness * (q - pip.rest) -
                          2.0 / 3.0 * dip.stiffness * (2.0 / 3.0 * q + 0.1 - dip.rest);
  const Skeleton skeleton = build_skeleton(subject);
  EXPECT_NEAR(passive_torque(skeleton, posture(skeleton, {{"PIP", q}}))[2], expected, 1e-16);
  EXPECT_NEAR(skeleton.limits[2].damping, pip.damping + 4.0 / 9.0 * dip.damping, 1e-16);
}

// By hand: DIP = 2/3 PIP + 0.1 stays in 0 .. 0.9 while PIP stays in -0.15 .. 1.2.
TEST(Skeleton, LeaderHasTheRangeThatItsFollowerAllows) {
  Subject subject = sample::coupled_digit();
  JointAxis &pip = subject.joints[2], &dip = subject.joints[3];
  pip.lower = 0, pip.upper = 2;
  dip.lower = 0, dip.upper = 0.9;
  EXPECT_NEAR(build_skeleton(subject).limits[2].lower, 0, 1e-16);
  EXPECT_NEAR(build_skeleton(subject).limits[2].upper, 1.2, 1e-15);
  // The other way round: DIP = -2/3 PIP + 0.1 needs PIP in -1.2 .. 0.15.
  dip.coupling->ratio = -2.0 / 3.0;
  EXPECT_NEAR(build_skeleton(subject).limits[2].upper, 0.15, 1e-15);
  // A joint without a range allows all.
  dip.lower = -kPi, dip.upper = kPi;
  EXPECT_EQ(build_skeleton(subject).limits[2].upper, 2);
}

TEST(Skeleton, SaysWhichFollowerCanNeverBeInItsRange) {
  Subject subject = sample::coupled_digit();
  JointAxis &pip = subject.joints[2], &dip = subject.joints[3];
  pip.lower = 0, pip.upper = 1;
  dip.lower = 1, dip.upper = 2;
  EXPECT_EQ(
      message([&] { (void)build_skeleton(subject); }),
      "joint 'DIP' has the range 1 .. 2 rad, which it never has while it follows 'PIP' in its "
      "range 0 .. 1 rad");
}

TEST(Skeleton, SaysWhichDigitIsUnknown) {
  SkeletonOptions options;
  options.digits = {"index", "tail"};
  EXPECT_EQ(message([&] { (void)build_skeleton(sample::two_link(), options); }),
            "subject 'two-link' has no digit 'tail'; there are index");
}

TEST(Skeleton, SaysWhichFrozenJointIsUnknown) {
  SkeletonOptions options;
  options.frozen["J3"] = 0;
  EXPECT_EQ(message([&] { (void)build_skeleton(sample::two_link(), options); }),
            "subject 'two-link' has no joint 'J3' to freeze");
}

TEST(Skeleton, RejectsFrozenAngleOutsideLimits) {
  Subject subject = sample::two_link();
  subject.joints[0].lower = -0.5;
  subject.joints[0].upper = 1.5;
  SkeletonOptions options;
  options.frozen["J1"] = 2;
  EXPECT_EQ(message([&] { (void)build_skeleton(subject, options); }),
            "joint 'J1' cannot be frozen at 2 rad, outside its limits -0.5 .. 1.5");
}

TEST(Skeleton, SaysWhichJointHangsInTheAir) {
  Subject subject = sample::two_link();
  std::swap(subject.joints[0], subject.joints[1]);
  EXPECT_EQ(message([&] { (void)build_skeleton(subject); }),
            "joint 'J2' hangs on segment 'upper', which no earlier joint reaches");
}

TEST(Skeleton, RejectsClosedLoops) {
  Subject subject = sample::two_link();
  subject.joints.push_back(sample::hinge("J3", "palm", "lower", {0, 0, 1}, {0, 0, 0}));
  EXPECT_EQ(message([&] { (void)build_skeleton(subject); }),
            "joint 'J3' moves segment 'lower' from 'palm', an earlier joint from 'upper'");
}

TEST(Skeleton, SaysWhichLeaderIsMissing) {
  Subject subject = sample::coupled_digit();
  subject.joints[3].coupling->leader = "PIP9";
  EXPECT_EQ(message([&] { (void)build_skeleton(subject); }),
            "joint 'DIP' is coupled to 'PIP9', which is not a free joint before it");
}

// A second tip may sit half-way down the path of the first.
TEST(Skeleton, DropsADigitOnThePathOfAnother) {
  Subject subject = sample::two_link();
  subject.digits.push_back(sample::digit("knuckle", "upper", {0.02, 0, 0}));
  SkeletonOptions options;
  options.digits = {"index"};
  const Skeleton kept = build_skeleton(subject, options);
  ASSERT_EQ(kept.tips.size(), 1U);
  EXPECT_EQ(kept.tips[0].digit, "index");
}

TEST(Skeleton, SaysWhichDigitItsLeaderIsOf) {
  Subject subject = sample::random_hand(26);
  for (JointAxis& joint : subject.joints)
    if (joint.name == "little_2_0") joint.coupling = Coupling{"ring_2_0", 1, 0};
  SkeletonOptions options;
  options.digits = {"little"};
  EXPECT_EQ(message([&] { (void)build_skeleton(subject, options); }),
            "joint 'little_2_0' is coupled to 'ring_2_0' of a digit left out: keep digit 'ring', "
            "too");
  options.digits = {"ring", "little"};
  EXPECT_EQ(build_skeleton(subject, options).coordinates(), 2 + 4 + 3);
}

TEST(Posture, PutsNamedAnglesInPlace) {
  const Skeleton skeleton = build_skeleton(sample::coupled_digit());
  EXPECT_EQ(posture(skeleton, {{"PIP", 0.5}, {"MCP_AA", -0.1}}), Eigen::Vector3d(-0.1, 0, 0.5));
}

TEST(Posture, NamesTheJointsThereAre) {
  const Skeleton skeleton = build_skeleton(sample::two_link());
  EXPECT_EQ(message([&] {
              (void)posture(skeleton, {{"J9", 0.5}});
            }),
            "no joint 'J9' to pose; there are J1, J2");
}

TEST(Posture, RejectsNaN) {
  const Skeleton skeleton = build_skeleton(sample::two_link());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message([&] {
              (void)posture(skeleton, {{"J1", nan}});
            }),
            "angle of joint 'J1' must be finite, got nan");
}

TEST(Tip, NamesTheDigitsThereAre) {
  const Skeleton skeleton = build_skeleton(sample::random_hand(1));
  EXPECT_EQ(message([&] { (void)tip(skeleton, "pinky"); }),
            "no digit 'pinky'; there are thumb, index, middle, ring, little");
}

}  // namespace
namespace {

struct SegmentMoments {
  double mass = 0, along = 0, across = 0;  // [kg], [kg m^2]
};

/// A capsule of length h and radius r about the origin, cut into thin discs across its axis.
/// Midpoint rule: the error falls with 1 / discs^2.
SegmentMoments sum_of_discs(double h, double r) {
  const int discs = 200000;
  const double dz = (h + 2 * r) / discs;
  SegmentMoments sum;
  for (int i = 0; i < discs; ++i) {
    const double z = -h / 2 - r + (i + 0.5) * dz;
    const double beyond = std::max(std::abs(z) - h / 2, 0.0);
    const double radius2 = r * r - beyond * beyond;
    const double mass = kHandDensity * kPi * radius2 * dz;
    sum.mass += mass;
    sum.along += mass * radius2 / 2;
    sum.across += mass * (radius2 / 4 + z * z);
  }
  return sum;
}

TEST(SegmentMass, CapsuleIsTheSumOfItsDiscs) {
  for (const double h : {0.0, 0.01, 0.05}) {
    const double r = 0.008;
    const LinkMass body = segment_mass(sample::bone("x", {0, 0, -h / 2}, {0, 0, h / 2}, r));
    const SegmentMoments expected = sum_of_discs(h, r);
    EXPECT_NEAR(body.mass / expected.mass, 1, 1e-9);
    EXPECT_NEAR(body.inertia(0, 0) / (h > 0 ? expected.across : expected.along), 1, 1e-9);
    EXPECT_NEAR(body.inertia(1, 1) / expected.across, 1, 1e-9);
    EXPECT_NEAR(body.inertia(2, 2) / (h > 0 ? expected.along : expected.across), 1, 1e-9);
  }
}

TEST(SegmentMass, CapsuleIsCentredAndTurnsWithItsBone) {
  const Eigen::Vector3d a(0.01, 0.02, 0.03), b(0.04, 0.01, 0.05);
  const LinkMass body = segment_mass(sample::bone("x", a, b, 0.008));
  const LinkMass upright =
      segment_mass(sample::bone("x", {0, 0, 0}, {0, 0, (b - a).norm()}, 0.008));
  EXPECT_TRUE(matrix_near(body.com, (a + b) / 2, 1e-17));
  const Eigen::Vector3d d = (b - a).normalized();
  EXPECT_NEAR(d.dot(body.inertia * d), upright.inertia(2, 2), 1e-20);
  EXPECT_NEAR(body.inertia.trace(), upright.inertia.trace(), 1e-20);
}

// No rigid body breaks it: each principal moment is at most the sum of the other two.
TEST(SegmentMass, CapsuleObeysTheTriangleInequality) {
  sample::Draw draw(41);
  for (int i = 0; i < 100; ++i) {
    const LinkMass body = segment_mass(
        sample::bone("x", draw.vector(0.05), draw.vector(0.05), draw.number(0.001, 0.02)));
    const Eigen::Vector3d m =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(body.inertia).eigenvalues();
    EXPECT_GT(m[0], 0);
    EXPECT_LE(m[2], (m[0] + m[1]) * (1 + 1e-12));
  }
}

TEST(SegmentMass, MeasuredValuesWin) {
  Segment segment = sample::bone("x", {0, 0, 0}, {0.05, 0, 0}, 0.01);
  segment.mass = 0.02;
  segment.com = {0.02, 0.001, 0};
  EXPECT_EQ(segment_mass(segment).mass, 0.02);
  EXPECT_EQ(segment_mass(segment).com, segment.com);
}

TEST(SegmentMass, MeasuredMassTakesTheSpreadOfTheCapsule) {
  Segment segment = sample::bone("x", {0, 0, 0}, {0.05, 0, 0}, 0.01);
  const LinkMass capsule = segment_mass(segment);
  segment.mass = 3 * capsule.mass;
  segment.com = {0.02, 0.001, 0};
  const LinkMass body = segment_mass(segment);
  EXPECT_TRUE(matrix_near(body.inertia, 3 * capsule.inertia, 1e-18));
  EXPECT_EQ(body.com, segment.com);
  EXPECT_EQ(body.segment_without_inertia, "");
}

TEST(SegmentMass, MassOfUnknownSpreadSaysSo) {
  Segment segment = sample::bone("x", {0, 0, 0}, {0.05, 0, 0}, 0);
  segment.mass = 0.02;
  const LinkMass body = segment_mass(segment),
                 known{0.1, {0, 0, 0}, Eigen::Matrix3d::Identity(), {}};
  EXPECT_EQ(body.segment_without_inertia, "x");
  EXPECT_EQ(combine(known, displace({}, body)).segment_without_inertia, "x");
  EXPECT_EQ(combine(body, known).segment_without_inertia, "x");
}

TEST(SegmentMass, UnknownIsZero) {
  const LinkMass body = segment_mass(sample::bone("x", {0, 0, 0}, {0.05, 0, 0}, 0));
  EXPECT_EQ(body.mass, 0);
  EXPECT_TRUE(body.inertia.isZero(0));
}

/// Point masses as one body, from the definitions.
LinkMass cloud(const std::vector<std::pair<double, Eigen::Vector3d>>& points) {
  LinkMass body;
  for (const auto& [mass, p] : points) {
    body.mass += mass;
    body.com += mass * p;
  }
  body.com /= body.mass;
  for (const auto& [mass, p] : points) {
    const Eigen::Vector3d r = p - body.com;
    body.inertia += mass * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
  }
  return body;
}

std::vector<std::pair<double, Eigen::Vector3d>> points(sample::Draw& draw, int count) {
  std::vector<std::pair<double, Eigen::Vector3d>> list;
  for (int i = 0; i < count; ++i) {
    const double mass = draw.number(0.1, 1);
    list.emplace_back(mass, draw.vector(1));
  }
  return list;
}

TEST(Combine, EqualsTheSumOverAllPoints) {
  sample::Draw draw(42);
  const auto a = points(draw, 5), b = points(draw, 7);
  auto both = a;
  both.insert(both.end(), b.begin(), b.end());
  const LinkMass combined = combine(cloud(a), cloud(b)), expected = cloud(both);
  EXPECT_NEAR(combined.mass, expected.mass, 1e-14);
  EXPECT_TRUE(matrix_near(combined.com, expected.com, 1e-14));
  EXPECT_TRUE(matrix_near(combined.inertia, expected.inertia, 1e-14));
}

TEST(Combine, WithNothingChangesNothing) {
  sample::Draw draw(43);
  const LinkMass body = cloud(points(draw, 5));
  const LinkMass combined = combine({}, body);
  EXPECT_TRUE(matrix_near(combined.com, body.com, 1e-16));
  EXPECT_TRUE(matrix_near(combined.inertia, body.inertia, 1e-16));
  EXPECT_EQ(combine({}, {}).mass, 0);
}

TEST(Displace, EqualsMovingEveryPoint) {
  sample::Draw draw(44);
  const auto before = points(draw, 6);
  const Pose<double> X = screw_motion<double>(draw.direction(), draw.vector(1), 0.9);
  auto after = before;
  for (auto& [mass, p] : after) p = X * p;
  const LinkMass displaced = displace(X, cloud(before)), expected = cloud(after);
  EXPECT_TRUE(matrix_near(displaced.com, expected.com, 1e-14));
  EXPECT_TRUE(matrix_near(displaced.inertia, expected.inertia, 1e-14));
}

}  // namespace
}  // namespace thenar
