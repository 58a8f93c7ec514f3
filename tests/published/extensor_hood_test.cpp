// The rungs of the extensor hood on the middle fingers of [Synek2019], and what is published of how
// a hood shares tension. The places and slack lengths of net `extensor_hood` were searched by
// bench/net_calibration.cpp, whose targets in use the tests of its sharing name; nothing else here
// was used to choose a net.

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "base/units.h"
#include "kinematics_fit/bands/hood_comparison.h"
#include "tendons/linear_tendons.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"
#include "tests/tendons/net/sweep_net.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

Subject subject(const std::string& name) {
  return read_subject(kData + "/subjects/" + name + ".toml");
}
NetDescription net(const std::string& name) { return read_net(kData + "/nets/" + name + ".toml"); }
Experiment hood_experiment(const std::string& specimen) {
  return read_experiment(kData + "/experiments/synek2019_" + specimen + ".toml");
}

const HoodRung& rung(const HoodComparison& comparison, const std::string& name) {
  for (const HoodRung& r : comparison.rungs)
    if (r.name == name) return r;
  throw std::runtime_error("no rung " + name);
}

// -- Measured fingertip forces ----------------------------------------------------------------

struct Finger {
  const char* subject;
  const char* specimen;
};
void PrintTo(const Finger& finger, std::ostream* out) {
  *out << finger.subject << " " << finger.specimen;
}

class HoodForces : public testing::TestWithParam<Finger> {
 protected:
  HoodComparison compare() const {
    return compare_hoods(
        subject(GetParam().subject), hood_experiment(GetParam().specimen),
        {net("chao_an"), net("dogadov2017"), net("winslow"), net("extensor_hood")});
  }
};

// A net whose runs are straight, through bone, may be drawn in where one over its surfaces holds.
TEST_P(HoodForces, EveryNetRestsOverItsSurfaces) {
  for (const HoodRung& r : compare().rungs) {
    if (r.name.find("straight runs") != std::string::npos) continue;
    EXPECT_TRUE(r.warning.empty()) << r.name << ": " << r.warning.front();
  }
}

// The flexors do not pull on the hood, so no rung may change what they do; the idle net is out of
// balance by 1e-9 N a knot at the most, and has a dozen.
TEST_P(HoodForces, FlexorsAreTheSameOnEveryRung) {
  const HoodComparison comparison = compare();
  const auto& first = comparison.rungs.front().prediction.trials;
  for (const HoodRung& r : comparison.rungs)
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (first[i].loads[0] != 'F') continue;
      EXPECT_TRUE(matrix_near(r.prediction.trials[i].predicted, first[i].predicted, 1e-8));
    }
}

// The figures of the page on nets; they are stated, not demanded.
TEST_P(HoodForces, StatesTheErrorOfEveryRung) {
  const HoodComparison comparison = compare();
  EXPECT_EQ(comparison.hood_muscles, (std::vector<std::string>{"EDC", "LU", "RI", "UI"}));
  for (const HoodRung& r : comparison.rungs) {
    EXPECT_EQ(r.prediction.error.trials, 24);
    EXPECT_EQ(r.hood_muscles.trials, 16);
    RecordProperty(r.name, fmt::format("{:.3f}", r.prediction.error.relative));
    RecordProperty(r.name + ", hood", fmt::format("{:.3f}", r.hood_muscles.relative));
  }
}

INSTANTIATE_TEST_SUITE_P(Human, HoodForces,
                         testing::Values(Finger{"synek2019_middle", "H01"},
                                         Finger{"synek2019_middle", "H02"},
                                         Finger{"an_chao_middle", "H01"},
                                         Finger{"an_chao_middle", "H02"}));

// Published: 0.32 and 0.49 for the calibrated fractions [Synek2019].
TEST(HoodBaseline, FixedFractionsErrAsPublished) {
  const auto error = [](const char* specimen) {
    const auto comparison =
        compare_hoods(subject("synek2019_middle"), hood_experiment(specimen), {});
    return rung(comparison, "fixed fractions").prediction.error.relative;
  };
  EXPECT_NEAR(error("H01"), 0.32, 0.005);
  EXPECT_NEAR(error("H02"), 0.49, 0.005);
}

// -- How slips share an extensor's pull -------------------------------------------------------

NetTendons winslow(const std::string& digit = "index") {
  const Subject finger = subject("an_chao_" + digit);
  auto separate = build_linear_tendons(finger, digit, {Path::kViaPoint, Hood::kSeparate});
  BuiltNet built = build_net(finger, separate->digit(), net("winslow"));
  return {std::move(separate), std::move(built)};
}

/// Slips under 2.9 N of the common extensor, with the finger bent from straight (MCP, PIP, DIP).
SlipTension slips_at(const NetTendons& tendons, double mcp, double pip, double dip) {
  VectorXd t = VectorXd::Zero(static_cast<Eigen::Index>(tendons.digit().names.muscles.size()));
  t[0] = 2.9;
  VectorXd q = tendons.net().frame.straight;
  q += (VectorXd(4) << mcp, 0, pip, dip).finished();
  return sweep_net(tendons, postures_between(tendons.net().frame.straight, q, 30), t).back().slips;
}

// [Lee2008]: both slips carry the extensor's pull, the terminal one more, 1.7 to 1.
TEST(PublishedSlips, TerminalSlipCarriesMoreThanTheCentralInTheStraightFinger) {
  const SlipTension slips = slips_at(winslow(), 0, 0, 0);
  EXPECT_GT(slips.terminal, slips.central);
  EXPECT_GT(slips.central, 0);
  RecordProperty("ratio", fmt::format("{:.2f}", slips.terminal / slips.central));
}

// [Lee2008]: less reaches the terminal slip as the interphalangeal joints bend.
TEST(PublishedSlips, TerminalSlipLosesTensionAsTheFingerBends) {
  const NetTendons tendons = winslow();
  EXPECT_LT(slips_at(tendons, 0, 60 * kDegree, 40 * kDegree).terminal,
            slips_at(tendons, 0, 0, 0).terminal);
}

// Bending the end joint alone draws on the lateral bands, bending the middle joint alone frees
// them.
TEST(PublishedSlips, EndJointTightensAndMiddleJointFreesTheTerminalSlip) {
  const NetTendons tendons = winslow();
  const double straight = slips_at(tendons, 0, 0, 0).terminal;
  EXPECT_GT(slips_at(tendons, 0, 0, 15 * kDegree).terminal, straight);
  EXPECT_LT(slips_at(tendons, 0, 15 * kDegree, 0).terminal, straight);
}

// -- Lateral bands beside the middle joint ------------------------------------------------------

/// A finger bent as living ones bend, the end joint by two thirds of the middle one, in steps of a
/// degree of the middle joint up to 60 degrees, under 2.9 N of the common extensor.
std::vector<SweepPoint> natural_flexion(const NetTendons& tendons) {
  VectorXd t = VectorXd::Zero(static_cast<Eigen::Index>(tendons.digit().names.muscles.size()));
  t[0] = 2.9;
  const VectorXd straight = tendons.net().frame.straight;
  VectorXd bent = straight;
  bent.tail<2>() += Eigen::Vector2d(60, 40) * kDegree;
  return sweep_net(tendons, postures_between(straight, bent, 60), t);
}

/// Moment arm of the run that crosses the middle joint, extension positive [m].
double extension_arm(const NetTendons& tendons, const SweepPoint& point, const std::string& band) {
  const Net& net = tendons.net().net;
  const NetBand& run = net.bands[static_cast<std::size_t>(band_index(net, band))];
  const TreeState<double> state = pose_tree(tendons.digit().model.tree, point.q);
  const auto& joint =
      state[static_cast<std::size_t>(tendons.net().frame.bone(BoneRole::kMiddle).link)];
  const Eigen::Vector3d p = point.rest.x.col(run.a), along = point.rest.x.col(run.b) - p;
  return -along.normalized().dot(joint.axis.cross(p - joint.point));
}

class LateralBands : public testing::TestWithParam<std::string> {};

/// Arm of the subject's own straight strand, finger straight, extension positive [m].
double normative_arm(const NetTendons& tendons, const std::string& strand) {
  const auto& names = tendons.digit().names.strands;
  const auto s =
      static_cast<std::size_t>(std::find(names.begin(), names.end(), strand) - names.begin());
  const TendonModel<double>& model = tendons.digit().model;
  const TreeState<double> state = pose_tree(model.tree, tendons.net().frame.straight);
  return -moment_arms(model.tree, state, model.paths[s], model.coordinates)[2];
}

// The net's knots float, one side a little against the other, beside the points of [An1979].
TEST_P(LateralBands, KeepTheirNormativeArmInTheStraightFinger) {
  const NetTendons tendons = winslow(GetParam());
  const SweepPoint straight = natural_flexion(tendons).front();
  constexpr double kBeside = 0.5e-3;  // [m]
  EXPECT_NEAR((extension_arm(tendons, straight, "lateral_beyond_r") +
               extension_arm(tendons, straight, "lateral_beyond_u")) /
                  2,
              (normative_arm(tendons, "RB") + normative_arm(tendons, "UB")) / 2, kBeside);
}

TEST_P(LateralBands, ExtendTheJointThroughNaturalFlexion) {
  const NetTendons tendons = winslow(GetParam());
  for (const SweepPoint& point : natural_flexion(tendons))
    for (const char* band : {"lateral_beyond_r", "lateral_beyond_u"}) {
      EXPECT_GT(extension_arm(tendons, point, band), 1.0e-3);
      EXPECT_LT(extension_arm(tendons, point, band), 4.0e-3);
    }
}

// Both ways to the end joint lengthen alike as a finger bends naturally: neither slip goes slack.
TEST_P(LateralBands, BothSlipsStayTautInNaturalFlexion) {
  const NetTendons tendons = winslow(GetParam());
  for (const SweepPoint& point : natural_flexion(tendons)) {
    EXPECT_GT(point.slips.central, 0);
    EXPECT_GT(point.slips.terminal, 0);
    EXPECT_FALSE(point.snapped);
  }
}

INSTANTIATE_TEST_SUITE_P(Normative, LateralBands, testing::Values("index", "middle"));

// -- The hood with sagittal bands ----------------------------------------------------------------

NetTendons extensor_hood(const std::string& digit) {
  const Subject finger = subject("an_chao_" + digit);
  auto separate = build_linear_tendons(finger, digit, {Path::kViaPoint, Hood::kSeparate});
  BuiltNet built = build_net(finger, separate->digit(), net("extensor_hood"));
  return {std::move(separate), std::move(built)};
}

/// Tensions with one muscle that pulls, the first: the common extensor (muscles).
VectorXd extensor_alone(const NetTendons& tendons, double tension) {
  VectorXd t = VectorXd::Zero(static_cast<Eigen::Index>(tendons.digit().names.muscles.size()));
  t[0] = tension;
  return t;
}

/// The finger bent from straight (MCP, PIP, DIP) in steps of a degree of its widest joint.
std::vector<SweepPoint> bend(const NetTendons& tendons, const Eigen::Vector3d& degrees,
                             double tension, double step_degrees = 1) {
  const VectorXd straight = tendons.net().frame.straight;
  VectorXd bent = straight;
  bent[0] += degrees[0] * kDegree;
  bent.tail<2>() += degrees.tail<2>() * kDegree;
  const double widest = degrees.cwiseAbs().maxCoeff();
  const int steps = std::max(1, static_cast<int>(std::lround(widest / step_degrees)));
  return sweep_net(tendons, postures_between(straight, bent, steps),
                   extensor_alone(tendons, tension));
}

double both(const SlipTension& slips) { return slips.terminal + slips.central; }

// [Lee2008] measured 1.7 in all postures; the fractions of [Synek2019], 0.4945 to the central slip,
// make 1.02. The distance of these two, a factor of 1.66, is how well the number is known.
constexpr double kShared = 1.7, kKnownTo = 1.7 / ((1 - 0.4945) / 0.4945);

testing::AssertionResult shares_as_measured(const SlipTension& slips) {
  const double ratio = slips.terminal / slips.central;
  if (ratio > kShared / kKnownTo && ratio < kShared * kKnownTo) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "terminal / central " << ratio;
}

class ExtensorHood : public testing::TestWithParam<std::string> {};

// Calibrated on: the ratio in the straight finger. Winslow's net runs from 9 to 0.5 here.
TEST_P(ExtensorHood, SharesAlikeUnderAnyLoad) {
  const NetTendons tendons = extensor_hood(GetParam());
  for (const double load : {0.3, 1.0, 3.0, 10.0, 30.0})  // [N]
    EXPECT_TRUE(shares_as_measured(bend(tendons, {0, 0, 0}, load).back().slips)) << load << " N";
}

// Calibrated on: 20, 40 and 60 degrees. Winslow's net runs from 16 to 1.3 here.
TEST_P(ExtensorHood, SharesAlikeThroughNaturalFlexion) {
  for (const SweepPoint& point : bend(extensor_hood(GetParam()), {0, 60, 40}, 2.9))
    EXPECT_TRUE(shares_as_measured(point.slips)) << point.q.transpose();
}

// Kept for judging: other loads than 2.9 N while the knuckle is bent.
TEST_P(ExtensorHood, SharesAlikeWithABentKnuckle) {
  const NetTendons tendons = extensor_hood(GetParam());
  for (const double load : {1.0, 5.0, 10.0})
    EXPECT_TRUE(shares_as_measured(bend(tendons, {60, 0, 0}, load).back().slips)) << load << " N";
}

// [Lee2008]: more than 30 % of the slips' force is lost as the knuckle bends, interphalangeal
// joints straight. Calibrated on: 60 degrees under 2.9 N.
TEST_P(ExtensorHood, LosesSlipForceAsTheKnuckleBends) {
  const NetTendons tendons = extensor_hood(GetParam());
  EXPECT_LT(both(bend(tendons, {60, 0, 0}, 2.9).back().slips),
            0.7 * both(bend(tendons, {0, 0, 0}, 2.9).back().slips));
}

// [Lee2008]: the knuckle matters that much only while the interphalangeal joints are straight. Kept
// for judging.
TEST_P(ExtensorHood, LosesLessOnABentFinger) {
  const NetTendons tendons = extensor_hood(GetParam());
  const double straight = both(bend(tendons, {60, 0, 0}, 2.9).back().slips) /
                          both(bend(tendons, {0, 0, 0}, 2.9).back().slips);
  const double bent = both(bend(tendons, {60, 45, 30}, 2.9).back().slips) /
                      both(bend(tendons, {0, 45, 30}, 2.9).back().slips);
  EXPECT_GT(bent, straight + 0.1);
}

// What the slips lose is in the bands to the phalanx: the torque at the knuckle does not fall.
TEST_P(ExtensorHood, HandsTheLossToTheProximalPhalanx) {
  const NetTendons tendons = extensor_hood(GetParam());
  const SweepPoint straight = bend(tendons, {0, 0, 0}, 2.9).front();
  const SweepPoint bent = bend(tendons, {60, 0, 0}, 2.9).back();
  const auto held = [&](const SweepPoint& point) {
    double sum = 0;
    for (const char* band : {"sagittal_oblique_u", "sagittal_oblique_r"})
      sum += point.rest.tension[band_index(tendons.net().net, band)];
    return sum;
  };
  EXPECT_GT(held(bent), held(straight) + 0.5);  // [N]
  const VectorXd t = extensor_alone(tendons, 2.9);
  EXPECT_LT(tendons.torque(bent.q, t, bent.rest)[0],
            tendons.torque(straight.q, t, straight.rest)[0]);
}

// Steps of the slips halve with the steps of the posture, so nothing jumps; and no knot snaps.
TEST_P(ExtensorHood, JumpsNowhereInTheJointBox) {
  const NetTendons tendons = extensor_hood(GetParam());
  const auto largest_step = [&](const Eigen::Vector3d& to, double step) {
    double most = 0;
    const std::vector<SweepPoint> points = bend(tendons, to, 2.9, step);
    for (std::size_t i = 1; i < points.size(); ++i) {
      EXPECT_FALSE(points[i].snapped) << to.transpose() << " at " << points[i].q.transpose();
      most = std::max({most, std::abs(points[i].slips.central - points[i - 1].slips.central),
                       std::abs(points[i].slips.terminal - points[i - 1].slips.terminal)});
    }
    return most;
  };
  for (const Eigen::Vector3d& to :
       {Eigen::Vector3d(90, 0, 0), Eigen::Vector3d(-30, 0, 0), Eigen::Vector3d(0, 90, 60),
        Eigen::Vector3d(0, 60, 0), Eigen::Vector3d(0, 0, 40), Eigen::Vector3d(80, 90, 60),
        Eigen::Vector3d(-20, 60, 40)})
    EXPECT_LT(largest_step(to, 0.25), 0.75 * largest_step(to, 0.5)) << to.transpose();
}

/// Tensions of some muscles (muscles) [N].
VectorXd tensions(const NetTendons& tendons,
                  const std::vector<std::pair<std::string, double>>& pulling) {
  const std::vector<std::string>& muscles = tendons.digit().names.muscles;
  VectorXd t = VectorXd::Zero(static_cast<Eigen::Index>(muscles.size()));
  for (const auto& [muscle, tension] : pulling)
    t[std::find(muscles.begin(), muscles.end(), muscle) - muscles.begin()] = tension;
  return t;
}

// A lumbrical alone leaves the extensor's half of the net loose. It once went over into another
// rest on the way, as loose knots drifted: bent to 80 degrees and straightened again, the finger
// must be in the rest that it has without the way.
TEST_P(ExtensorHood, ComesBackUnderALoneLumbrical) {
  const NetTendons tendons = extensor_hood(GetParam());
  const VectorXd t = tensions(tendons, {{"LU", 2.9}});
  const VectorXd straight = tendons.net().frame.straight;
  VectorXd bent = straight;
  bent[0] += 80 * kDegree;
  const NetContinuation there = follow_from_straight(tendons, bent, t);
  const NetContinuation back = follow_net(tendons, there.rest, {bent, t}, {straight, t});
  EXPECT_EQ(there.snaps.size() + back.snaps.size(), 0U);
  const NetEquilibrium direct = tendons.rest(straight, t, {});
  EXPECT_NEAR(back.rest.energy, direct.energy, 1e-9);  // [J], of 0.06
  EXPECT_TRUE(matrix_near(tendons.torque(straight, t, back.rest),
                          tendons.torque(straight, t, direct), 1e-7));  // [N m], of 0.01
}

/// A load of the hood: muscles with their tensions [N].
using HoodLoad = std::vector<std::pair<std::string, double>>;
const std::vector<HoodLoad> kHoodLoads{{{"EDC", 2.9}},
                                       {{"RI", 5}},
                                       {{"LU", 0.4}},
                                       {{"UI", 4}},
                                       {{"EDC", 3}, {"RI", 5}, {"LU", 0.4}, {"UI", 4}}};

/// A posture of the joint box [rad] (4); every other one has the end joint at two thirds of the
/// middle joint.
VectorXd in_joint_box(const VectorXd& straight, std::mt19937& rng, bool coupled) {
  const auto angle = [&](double low, double high) {
    return kDegree * std::uniform_real_distribution<double>(low, high)(rng);
  };
  VectorXd q(4);
  q << angle(-20, 80), angle(-15, 15), angle(0, 90), angle(0, 60);
  if (coupled) q[3] = q[2] * 2 / 3;
  return straight + q;
}

// Two ways to a posture, through another one and from the straight finger, end in the same rest,
// without a snap, but for 0.2 % of torque where the idle extensor's loose half may catch on the
// phalanx; and no slip changes by more than a tenth of the pull in a degree.
TEST_P(ExtensorHood, DoesNotDependOnTheWayThroughTheJointBox) {
  const NetTendons tendons = extensor_hood(GetParam());
  const VectorXd straight = tendons.net().frame.straight;
  for (const HoodLoad& load : kHoodLoads) {
    const VectorXd t = tensions(tendons, load);
    std::mt19937 rng(7);
    for (int i = 0; i < 6; ++i) {
      const VectorXd from = in_joint_box(straight, rng, i % 2 == 0),
                     to = in_joint_box(straight, rng, i % 2 == 0);
      const int steps = static_cast<int>((to - from).cwiseAbs().maxCoeff() / kDegree) + 1;
      SweepPoint at;
      at.q = from;
      at.rest = follow_from_straight(tendons, from, t).rest;
      at.slips = slip_tension(tendons.net(), at.rest);
      for (const VectorXd& q : postures_between(from, to, steps)) {
        const SweepPoint next = next_sweep_point(tendons, &at, q, t);
        EXPECT_FALSE(next.snapped) << load[0].first << " at " << q.transpose();
        EXPECT_LT(std::abs(next.slips.central - at.slips.central), 0.1 * t.sum());
        EXPECT_LT(std::abs(next.slips.terminal - at.slips.terminal), 0.1 * t.sum());
        at = next;
      }
      const VectorXd other = tendons.torque(to, t, follow_from_straight(tendons, to, t).rest);
      EXPECT_LT((at.tau - other).norm(), 2e-3 * other.norm())
          << load[0].first << " at " << to.transpose();
    }
  }
}

// [Park2020], nine middle fingers: intrinsic muscles extend the middle joint with 0.79 of the
// extensor's effect, and with 0.71 where the knuckle is bent to 60 degrees. Calibrated on: the
// share of their pull that goes to the middle line.
TEST_P(ExtensorHood, LetsIntrinsicMusclesExtendTheMiddleJoint) {
  const NetTendons tendons = extensor_hood(GetParam());
  const auto arm = [&](const std::string& muscle, double knuckle) {
    VectorXd q = tendons.net().frame.straight;
    q[0] += knuckle * kDegree;
    q.tail<2>() += Eigen::Vector2d(30, 10) * kDegree;
    const VectorXd t = tensions(tendons, {{muscle, 2.9}});
    return tendons.torque(q, t, follow_from_straight(tendons, q, t).rest)[2];
  };
  for (const char* muscle : {"LU", "UI"}) {
    EXPECT_NEAR(arm(muscle, 0) / arm("EDC", 0), 0.79, 0.15) << muscle;
    EXPECT_NEAR(arm(muscle, 60) / arm("EDC", 60), 0.71, 0.15) << muscle;
  }
}

// [GarciaElias1991]: 275 N/mm for the segments of the central band, 40 for the fibres that cross.
// Lengths of fingers differ from the reference by less than the fifth that is left.
TEST_P(ExtensorHood, HasThePublishedStiffness) {
  const NetTendons tendons = extensor_hood(GetParam());
  const Net& hood = tendons.net().net;
  const auto stiffness = [&](const std::string& name) {  // [N/mm]
    const NetBand& band = hood.bands[static_cast<std::size_t>(band_index(hood, name))];
    return band.EA / band.slack * 1e-3;
  };
  EXPECT_NEAR(stiffness("central_slip_u") + stiffness("central_slip_r"), 275, 55);
  EXPECT_NEAR(stiffness("crossing_u"), 40, 8);
  EXPECT_NEAR(stiffness("crossing_r"), 40, 8);
}

// The arm of the extensor at the middle joint depends on the knuckle and on the end joint: no path
// of one joint does that.
TEST_P(ExtensorHood, GivesTheExtensorAnArmOfSeveralJoints) {
  const NetTendons tendons = extensor_hood(GetParam());
  const VectorXd t = extensor_alone(tendons, 2.9);
  const auto arm = [&](const Eigen::Vector3d& posture) {  // extension, at the middle joint [m]
    const SweepPoint at = bend(tendons, posture, 2.9).back();
    return -tendons.torque(at.q, t, at.rest)[2] / t[0];
  };
  const double straight = arm({0, 0, 0});
  EXPECT_LT(arm({60, 0, 0}), 0.8 * straight);
  EXPECT_GT(arm({60, 0, 15}), 1.2 * arm({60, 0, 0}));
}

INSTANTIATE_TEST_SUITE_P(Normative, ExtensorHood, testing::Values("index", "middle"));

}  // namespace
}  // namespace thenar
