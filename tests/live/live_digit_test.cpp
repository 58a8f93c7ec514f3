// Tests for live/live_digit.cpp: the answers of api/, whatever was asked before.

#include "live/live_digit.h"

#include <algorithm>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "api/moment_arms.h"
#include "api/named/data_folders.h"
#include "api/tendon_solve.h"
#include "base/error.h"
#include "base/units.h"
#include "tendons/muscle/contraction.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

DigitRequest middle(std::optional<Hood> hood, Path path = Path::kViaPoint) {
  DigitRequest request;
  request.subject = kData + "/subjects/synek2019_middle.toml";
  request.hood = hood;
  request.path = path;
  return request;
}

const std::map<std::string, double> kBent{{"MCP3_FE", 0.3}, {"PIP3", 0.5}, {"DIP3", 0.2}};
const std::map<std::string, double> kPull{{"EDC", 2.9}, {"LU", 0.4}, {"FDP", 5}};

TendonSolveResult solved(const std::optional<Hood>& hood) {
  TendonRequest request;
  request.digit = middle(hood);
  request.digit.posture.named = kBent;
  request.tension = kPull;
  return solve_tendons(request);
}

TEST(LiveDigit, AnswersAsTheQuestionDoesToTheBit) {
  for (const Hood hood : {Hood::kSeparate, Hood::kFractions, Hood::kFloatingNet}) {
    LiveDigit digit(middle(hood));
    EXPECT_THAT(digit.set({kBent, kPull, {}}), IsEmpty());
    const DigitPoint& here = digit.state().point;
    const DigitPoint there = solved(hood).point;
    EXPECT_EQ(here.q, there.q);
    EXPECT_EQ(here.pull.tau, there.pull.tau);
    EXPECT_EQ(here.pull.R, there.pull.R);
    EXPECT_EQ(here.tip.f_W, there.tip.f_W);
    EXPECT_EQ(here.rest.tension, there.rest.tension);
    EXPECT_EQ(here.pull.status, there.pull.status);
  }
}

// Net by net, over random ways there: what was asked before leaves no trace.
TEST(LiveDigit, ForgetsHowItCameToAPosture) {
  for (const char* net : {"extensor_hood", "winslow", "chao_an", "dogadov2017"}) {
    DigitRequest request = middle({});
    request.net = net;
    LiveDigit straight(request), wandered(request);
    std::mt19937 rng(3);
    std::uniform_real_distribution<double> angle(-0.2, 1.2), tension(0, 10);
    for (int k = 0; k < 10; ++k)
      wandered.set({{{"PIP3", angle(rng)}, {"MCP3_FE", angle(rng)}},
                    {{"EDC", tension(rng)}, {"RI", tension(rng)}},
                    {}});
    straight.set({kBent, kPull, {}});
    wandered.set({{{"MCP3_AA", 0}}, {{"RI", 0}}, {}});
    wandered.set({kBent, kPull, {}});
    EXPECT_EQ(wandered.state().point.rest.tension, straight.state().point.rest.tension) << net;
    EXPECT_EQ(wandered.state().point.tip.f_W, straight.state().point.tip.f_W) << net;
  }
}

TEST(LiveDigit, KeepsWhatIsNotNamed) {
  LiveDigit digit(middle(Hood::kSeparate));
  digit.set({kBent, {}, {}});
  digit.set({{}, kPull, {}});
  EXPECT_EQ(digit.state().point.tip.f_W, solved(Hood::kSeparate).point.tip.f_W);
  EXPECT_EQ(digit.changes(), 2U);
  EXPECT_EQ(digit.shape_changes(), 0U);
}

TEST(LiveDigit, EndsAtItsLimitsAndSaysWhere) {
  LiveDigit digit(middle(Hood::kSeparate));
  EXPECT_THAT(digit.set({{{"PIP3", 6}, {"DIP3", 0.1}}, {}, {}}), ElementsAre("PIP3"));
  const TendonDigit& bones = digit.digit_case().bones();
  for (std::size_t i = 0; i < bones.names.coordinates.size(); ++i)
    if (bones.names.coordinates[i] == "PIP3") {
      EXPECT_EQ(digit.state().point.q[static_cast<Eigen::Index>(i)],
                bones.skeleton.limits[i].upper);
    }
}

TEST(LiveDigit, RefusesWhatIsWrongAndStaysAsItWas) {
  LiveDigit digit(middle(Hood::kFloatingNet));
  digit.set({kBent, kPull, {}});
  const Eigen::VectorXd before = digit.state().point.rest.tension;
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  for (const DigitInputs& wrong : std::vector<DigitInputs>{{{{"PIP4", 0}}, {}, {}},
                                                           {{{"PIP3", nan}}, {}, {}},
                                                           {{{"PIP3", infinite}}, {}, {}},
                                                           {{}, {{"EDD", 1}}, {}},
                                                           {{}, {{"EDC", -1}}, {}},
                                                           {{}, {{"EDC", nan}}, {}},
                                                           {{}, {{"EDC", 1e5}}, {}},
                                                           {{}, {}, {{"EDC", 1.1}}},
                                                           {{}, {}, {{"EDC", nan}}},
                                                           {{}, {{"EDC", 1}}, {{"EDC", 1}}}}) {
    DigitInputs all = wrong;
    all.posture.emplace("DIP3", 0.9);
    EXPECT_THROW(digit.set(all), InputError);
  }
  EXPECT_EQ(digit.state().point.rest.tension, before);
  EXPECT_EQ(digit.changes(), 1U);
}

// Virtual work of the net: torque of the tendons is that of the tip's force and what is left.
TEST(LiveDigit, BalancesTheTip) {
  LiveDigit digit(middle(Hood::kFloatingNet));
  digit.set({kBent, kPull, {}});
  const DigitPoint& point = digit.state().point;
  const TendonDigit& bones = digit.digit_case().bones();
  const TipStatics statics = tip_statics(bones, point.q);
  EXPECT_TRUE(matrix_near(statics.J.transpose() * point.tip.f_W + point.tip.tau_residual,
                          point.pull.tau, 1e-12));
}

// Excitations.

DigitRequest index_with_fibres() {
  DigitRequest request;
  request.subject = kData + "/subjects/an_chao_index.toml";
  request.hood = Hood::kSeparate;
  return request;
}

// A muscle holds what Hill's curves say at its length; that length is an integral of its arms.
TEST(LiveDigit, ExcitedMusclesHoldWhatTheirLengthAllows) {
  LiveDigit digit(index_with_fibres());
  digit.set({{{"PIP2", 0.3}}, {}, {{"FDP", 0.6}, {"EDC", 0}}});
  const DigitCase& about = digit.digit_case();
  const Eigen::VectorXd& q = digit.state().point.q;
  const auto contraction = build_contraction(
      musculotendons(about.subject, about.bones(), Muscle::kRigidTendon), Muscle::kRigidTendon);
  const Excursion way = excursion(*about.tendons, Eigen::VectorXd::Zero(q.size()), q,
                                  Eigen::VectorXd::Zero(digit.state().tension.size()));
  for (std::size_t m = 0; m < about.bones().names.muscles.size(); ++m) {
    const std::string& name = about.bones().names.muscles[m];
    const double a = name == "FDP" ? 0.6 : 0;
    const double length = musculotendon_length_at_optimum(contraction->muscles()[m]) +
                          way.e[static_cast<Eigen::Index>(m)];
    const double expected = name == "FDP" || name == "EDC"
                                ? contraction->tension(static_cast<int>(m), {a, length, 0, 0})
                                : 0;
    // Gauss's rule leaves 1e-9 m, and a muscle has less than 1e5 N/m.
    EXPECT_NEAR(digit.state().tension[static_cast<Eigen::Index>(m)], expected, 1e-4) << name;
  }
  EXPECT_GT(digit.state().tension.maxCoeff(), 10);
}

TEST(LiveDigit, AnExcitationFollowsThePostureAndATensionEndsIt) {
  LiveDigit digit(index_with_fibres());
  const auto& names = digit.digit_case().bones().names.muscles;
  const Eigen::Index fdp = std::find(names.begin(), names.end(), "FDP") - names.begin();
  // 66 mm fibres that are 12.1 degrees oblique hold F0 cos 12.1 in the posture of their length.
  digit.set({{}, {}, {{"FDP", 1}}});
  const double straight = digit.state().tension[fdp];
  EXPECT_NEAR(straight, 4.79 * 30 * std::cos(radians(12.1)), 1e-2 * straight);
  digit.set({{{"PIP2", 0.6}}, {}, {}});
  EXPECT_LT(digit.state().tension[fdp], 0.99 * straight);
  EXPECT_EQ(digit.state().excitation[fdp], 1);
  digit.set({{}, {{"FDP", 7}}, {}});
  EXPECT_EQ(digit.state().tension[fdp], 7);
  EXPECT_TRUE(std::isnan(digit.state().excitation[fdp]));
}

TEST(LiveDigit, SaysWhatItAssumesOfMusclesWithoutFibres) {
  LiveDigit digit(middle(Hood::kFloatingNet));
  digit.set({{}, {}, {{"FDP", 0.25}}});
  const auto& names = digit.digit_case().bones().names.muscles;
  const Eigen::Index fdp = std::find(names.begin(), names.end(), "FDP") - names.begin();
  EXPECT_EQ(digit.state().tension[fdp], 0.25 * digit.digit_case().bones().max_tension[fdp]);
  EXPECT_THAT(digit.state().warnings,
              testing::Contains(HasSubstr("fibre length of FDP is unknown")));
}

// Curves.

TEST(LiveDigit, SweepsAsMomentArmsDo) {
  LiveDigit digit(middle(Hood::kFractions));
  digit.set({kBent, kPull, {}});
  const DigitCurves curves = digit.sweep("PIP3", 31);
  ASSERT_EQ(curves.angle.size(), 31);
  DigitRequest request = middle(Hood::kFractions);
  request.posture.named = kBent;
  request.vary = {
      {"PIP3", curves.angle[0], curves.angle[30], (curves.angle[30] - curves.angle[0]) / 30}};
  const MomentArmResult answer = compute_moment_arms(request);
  ASSERT_EQ(answer.points.size(), 31U);
  const int joint = answer.grid.varied.front();
  for (Eigen::Index k = 0; k < 31; ++k) {
    const MomentArmPoint& point = answer.points[static_cast<std::size_t>(k)];
    EXPECT_TRUE(matrix_near(curves.arms.col(k), point.arms.col(joint), 1e-12));
    EXPECT_TRUE(matrix_near(curves.lengths.col(k), point.length_change, 1e-12));
  }
}

// d length / d angle = -arm, by central differences over the sweep itself.
TEST(LiveDigit, ArmsAreTheSlopesOfLengths) {
  for (const Path path : {Path::kViaPoint, Path::kWrapped})
    for (const char* joint : {"MCP3_FE", "PIP3", "DIP3"}) {
      DigitRequest request;
      request.subject = kData + "/subjects/human_hand.toml";
      request.digit = "middle";
      request.hood = Hood::kSeparate;
      request.path = path;
      LiveDigit digit(request);
      const DigitCurves curves = digit.sweep(joint, 1000);
      const double step = curves.angle[1] - curves.angle[0];
      for (Eigen::Index k = 1; k + 1 < curves.angle.size(); ++k)
        for (Eigen::Index m = 0; m < curves.arms.rows(); ++m) {
          const double slope = (curves.lengths(m, k + 1) - curves.lengths(m, k - 1)) / (2 * step);
          // Where a wrap begins or ends, the arm has a corner: its slope there times the step.
          EXPECT_NEAR(curves.arms(m, k), -slope, 5e-5) << joint << ' ' << m << ' ' << k;
        }
    }
}

// The present posture lies on the curve, so that a cursor does.
TEST(LiveDigit, StandsOnItsCurves) {
  for (const Hood hood : {Hood::kSeparate, Hood::kFloatingNet}) {
    LiveDigit digit(middle(hood));
    digit.set({{{"MCP3_FE", 0.3}}, kPull, {}});
    const DigitCurves curves = digit.sweep("PIP3", 21);
    digit.set({{{"PIP3", curves.angle[7]}}, {}, {}});
    const auto pip = static_cast<Eigen::Index>(2);
    ASSERT_EQ(digit.digit_case().bones().names.coordinates[2], "PIP3");
    for (Eigen::Index m = 0; m < curves.lengths.rows(); ++m) {
      EXPECT_EQ(std::isnan(curves.arms(m, 7)), std::isnan(curves.lengths(m, 7))) << m;
      if (std::isnan(curves.lengths(m, 7))) continue;
      EXPECT_NEAR(digit.state().point.pull.R(m, pip), curves.arms(m, 7), 1e-9) << m;
      EXPECT_NEAR(digit.state().length[m], curves.lengths(m, 7), 1e-9) << m;
    }
  }
}

// Of a net: d torque / d tension by central differences at most postures; where it has a corner, an
// arm is unknown and not 0.
TEST(LiveDigit, ArmsOfANetAreSlopesOfTorqueOrUnknown) {
  DigitRequest request;
  request.subject = kData + "/subjects/human_hand.toml";
  request.digit = "index";
  request.hood = Hood::kFloatingNet;
  LiveDigit digit(request);
  int known = 0;
  for (const double pip : {-0.5, 0.1, 0.6, 1.1}) {
    digit.set({{{"PIP2", pip}}, {{"EDC2", 4}, {"FDP2", 6}}, {}});
    const DigitState now = digit.state();
    const auto& names = digit.digit_case().bones().names.muscles;
    for (const char* name : {"EDC2", "FDP2"}) {
      const Eigen::Index m = std::find(names.begin(), names.end(), name) - names.begin();
      if (now.arms.row(m).array().isNaN().any()) {
        EXPECT_THAT(now.warnings, testing::Not(IsEmpty()));
        continue;
      }
      ++known;
      constexpr double kStep = 1e-3;  // [N]
      digit.set({{}, {{name, now.tension[m] + kStep}}, {}});
      const Eigen::VectorXd more = digit.state().point.pull.tau;
      digit.set({{}, {{name, now.tension[m] - kStep}}, {}});
      const Eigen::VectorXd less = digit.state().point.pull.tau;
      digit.set({{}, {{name, now.tension[m]}}, {}});
      // 1e-9 N of the search for rest at arms of 1e-2 m, over the step.
      EXPECT_TRUE(matrix_near(now.arms.row(m).transpose(), (more - less) / (2 * kStep), 1e-6))
          << name << ' ' << pip;
    }
  }
  EXPECT_GE(known, 6);
}

// An arm of 0 would be a wrong number: pulled by ever so little, the extensor has one of
// millimetres.
TEST(LiveDigit, AMuscleThatIsSlackInANetHasNoArm) {
  LiveDigit digit(middle(Hood::kFloatingNet));
  const auto& names = digit.digit_case().bones().names.muscles;
  const Eigen::Index edc = std::find(names.begin(), names.end(), "EDC") - names.begin();
  digit.set({kBent, {{"EDC", 0}, {"FDP", 5}}, {}});
  EXPECT_TRUE(digit.state().arms.row(edc).array().isNaN().all());
  EXPECT_TRUE(digit.sweep("PIP3", 5).arms.row(edc).array().isNaN().all());
  digit.set({kBent, {{"EDC", 1e-3}, {"FDP", 5}}, {}});
  EXPECT_LT(digit.state().arms(edc, 0), -1e-3);
}

TEST(LiveDigit, SweepsNoJointThatIsNotThere) {
  const LiveDigit digit(middle(Hood::kSeparate));
  EXPECT_THAT(message_of([&] { (void)digit.sweep("PIP2", 10); }), HasSubstr("PIP3"));
  EXPECT_THROW((void)digit.sweep("PIP3", 1), InputError);
  EXPECT_THROW((void)digit.sweep("PIP3", 1001), InputError);
}

// The picture.

TEST(LiveDigit, HasAPictureThatFitsItsShape) {
  for (const Hood hood : {Hood::kSeparate, Hood::kFractions, Hood::kFloatingNet})
    for (const Path path : {Path::kViaPoint, Path::kFitted, Path::kWrapped}) {
      DigitRequest request;
      request.subject = kData + "/subjects/human_hand.toml";
      request.digit = "index";
      request.hood = hood;
      request.path = path;
      LiveDigit digit(request);
      check_instant(digit.shape(), digit.instant());
      digit.set({{{"PIP2", 1}, {"DIP2", 0.6}}, {{"FDP2", 10}, {"EDC2", 4}}, {}});
      check_instant(digit.shape(), digit.instant());
      EXPECT_GE(digit.shape().lines.size(), digit.digit_case().bones().names.muscles.size());
    }
}

// Turning a joint turns the body that it moves about the axis that is drawn.
TEST(LiveDigit, DrawsTheAxesAboutWhichBodiesTurn) {
  DigitRequest request;
  request.subject = kData + "/subjects/human_hand.toml";
  request.digit = "thumb";
  LiveDigit digit(request);
  constexpr double kTurn = 0.1;  // [rad]
  for (const LiveJoint& joint : digit.shape().joints) {
    if (!joint.led_by.empty()) continue;
    const LiveInstant before = digit.instant();
    const double from =
        before.joints[static_cast<std::size_t>(&joint - digit.shape().joints.data())];
    const double to = from + kTurn <= joint.upper ? from + kTurn : from - kTurn;
    digit.set({{{joint.name, to}}, {}, {}});
    const auto body = static_cast<std::size_t>(joint.body);
    const Pose<double> X0 = before.bodies[body], X1 = digit.instant().bodies[body];
    const Pose<double> turned =
        screw_motion(Eigen::Vector3d(X0.R * joint.axis), X0 * joint.point, to - from) * X0;
    EXPECT_TRUE(matrix_near(X1.R, turned.R, 1e-12)) << joint.name;
    EXPECT_TRUE(matrix_near(X1.p, turned.p, 1e-12)) << joint.name;
    digit.set({{{joint.name, from}}, {}, {}});
  }
}

// Its dorsal side is up and its distal direction along x, whatever frame the subject has.
TEST(LiveDigit, LiesFlatAndPointsAlongX) {
  const LiveDigit digit(middle(Hood::kSeparate));
  const Eigen::Matrix3d& axes = digit.digit_case().bones().model.tip_axes;
  const Eigen::Matrix3d& R = digit.subject_pose().R;
  EXPECT_TRUE(matrix_near(R * axes.col(1), Eigen::Vector3d(0, 0, 1), 1e-9));
  EXPECT_GT((R * axes.col(0)).dot(Eigen::Vector3d(-1, 0, 0)), 1 - 1e-9);
  EXPECT_TRUE(matrix_near(R * R.transpose(), Eigen::Matrix3d::Identity(), 1e-12));
  EXPECT_NEAR(R.determinant(), 1, 1e-12);
}

TEST(LiveDigit, DrawsTheForceOfTheTipWhereTheTipIs) {
  LiveDigit digit(middle(Hood::kFractions));
  digit.set({kBent, kPull, {}});
  const LiveVector force = digit.instant().arrows.back();
  const DigitPoint& point = digit.state().point;
  const TendonModel<double>& model = digit.digit_case().bones().model;
  EXPECT_NEAR(force.vector.norm(), point.tip.f_W.norm(), 1e-12);
  EXPECT_TRUE(matrix_near(digit.subject_pose().R.transpose() * force.vector, point.tip.f_W, 1e-12));
  EXPECT_TRUE(matrix_near(digit.subject_pose().inverse() * force.from,
                          moved(pose_tree(model.tree, point.q), model.tip_link, model.tip), 1e-12));
}

// Lines of a hood of fractions carry what its rule says: the terminal slip what both bands bring.
TEST(LiveDigit, ColoursLinesByTheTensionOfTheirStrands) {
  LiveDigit digit(middle(Hood::kFractions));
  digit.set({kBent, kPull, {}});
  const LiveInstant instant = digit.instant();
  const TendonDigit& bones = digit.digit_case().bones();
  const Eigen::VectorXd strands =
      strand_matrix(bones.model, digit.state().point.q) * digit.state().tension;
  for (std::size_t i = 0; i < instant.tensions.size(); ++i) {
    const auto& names = bones.names.strands;
    const auto s = std::find(names.begin(), names.end(), digit.shape().lines[i].name);
    ASSERT_NE(s, names.end());
    EXPECT_EQ(instant.tensions[i], strands[s - names.begin()]);
  }
}

// A frame: 52 bytes, 28 a body, 4 a joint and a line, 24 an arrow, 6 a point of a line.
std::size_t frame_bytes(const LiveInstant& instant) {
  return 52 + 28 * instant.bodies.size() + 4 * instant.joints.size() + 4 * instant.tensions.size() +
         44 * instant.contacts.size() + 24 * instant.arrows.size() + 6 * instant.line_points.size();
}

TEST(LiveDigit, FitsIntoASmallFrame) {
  for (const char* digit : {"index", "middle", "ring", "little"}) {
    DigitRequest request;
    request.subject = kData + "/subjects/human_hand.toml";
    request.digit = digit;
    request.hood = Hood::kFloatingNet;
    EXPECT_LT(frame_bytes(LiveDigit(request).instant()), 4000U) << digit;
  }
}

// What there is.

TEST(LiveDigit, TakesANetWhereItCan) {
  const LiveDigit finger(middle({}));
  EXPECT_NE(finger.digit_case().net, nullptr);
  DigitRequest request;
  request.subject = kData + "/subjects/human_hand.toml";
  request.digit = "thumb";
  const LiveDigit thumb(request);
  EXPECT_EQ(thumb.digit_case().net, nullptr);
  EXPECT_THAT(thumb.warnings().front(), HasSubstr("tendons without a net"));
}

// Every digit of every subject on every rung opens and moves, or says why it does not.
TEST(LiveDigit, OpensEveryDigitOrSaysWhyNot) {
  int opened = 0, refused = 0;
  for (const std::string& name : names_in(data_folders(kData), "subjects")) {
    const SourceText source = subject_source(name, kData);
    for (const Digit& digit : parse_subject(source.text, source.path).digits)
      for (const std::optional<Hood> hood :
           {std::optional<Hood>(), std::optional(Hood::kSeparate), std::optional(Hood::kFractions),
            std::optional(Hood::kFloatingNet)})
        for (const Path path : {Path::kViaPoint, Path::kWrapped}) {
          if (path == Path::kWrapped && hood != Hood::kSeparate) continue;
          DigitRequest request;
          request.subject = name;
          request.data = kData;
          request.digit = digit.name;
          request.hood = hood;
          request.path = path;
          try {
            LiveDigit live(request);
            DigitInputs inputs;
            const TendonDigit& bones = live.digit_case().bones();
            for (std::size_t i = 0; i < bones.names.coordinates.size(); ++i)
              inputs.posture[bones.names.coordinates[i]] =
                  0.7 * bones.skeleton.limits[i].lower + 0.3 * bones.skeleton.limits[i].upper;
            for (const std::string& muscle : bones.names.muscles) inputs.tension[muscle] = 3;
            EXPECT_THAT(live.set(inputs), IsEmpty());
            check_instant(live.shape(), live.instant());
            EXPECT_TRUE(is_trusted(live.state().point.pull.status) ||
                        !live.state().warnings.empty());
            ++opened;
          } catch (const Error& error) {
            // No net on a thumb, no muscle at a digit.
            EXPECT_THAT(error.what(),
                        testing::AnyOf(HasSubstr("cannot be used for the thumb"),
                                       HasSubstr("no muscle"), HasSubstr("none crosses")))
                << name << ' ' << digit.name;
            ++refused;
          }
        }
  }
  EXPECT_GT(opened, 60);
  EXPECT_GT(refused, 10);
}

TEST(LiveDigit, RefusesADigitWithoutBones) {
  DigitRequest request;
  request.subject = kData + "/subjects/valero_cuevas_index.toml";
  EXPECT_THAT(message_of([&] { const LiveDigit digit(request); }), HasSubstr("tip map"));
}

}  // namespace
}  // namespace thenar
