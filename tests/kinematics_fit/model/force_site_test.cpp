// Tests for kinematics_fit/model/force_site.h and the sites of experiment_plan.cpp.

#include "kinematics_fit/model/force_site.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "tests/kinematics_fit/fit_samples.h"
#include "tests/kinematics_fit/model/tip_force_map.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

ForceSite at(const std::string& segment) { return {segment, segment, {}, {}}; }

/// Predicted forces of the published middle finger in posture Hook, one trial a site (3, sites).
Eigen::Matrix3Xd forces_at(const TendonDigit& digit, const std::map<std::string, double>& tension,
                           const std::vector<std::optional<ForceSite>>& sites,
                           TipConstraint hold = TipConstraint::kPinned) {
  Experiment experiment = sample::experiment("H01");
  experiment.hold = hold;
  experiment.trials.clear();
  for (const std::optional<ForceSite>& site : sites)
    experiment.trials.push_back({"Hook", tension, {1, 1, 1}, {}, {}, site});
  const FitParameters parameters = choose_parameters(digit, {}, {});
  return force_values(digit, parameters, plan_experiment(digit, parameters, experiment),
                      VectorXd::Zero(parameters.coordinates()));
}

TendonDigit published_finger(const std::map<std::string, double>& frozen = {}) {
  const SourceText text = sample::source("subjects/synek2019_middle");
  TendonOptions options;
  options.frozen = frozen;
  return build_tendon_digit(parse_subject(text.text, text.path), "middle", options);
}

constexpr double kPip = radians(65), kDip = radians(50);  // of posture Hook

// Bones at 1 m steps along x, tip to base; one hinge about z at x = 2, a flexor whose path runs
// from (1, -0.5) on the phalanx to (3, -0.5) on the base; the tip at x = 0. Proximal is +x, dorsal
// +y.
TendonModel<double> hinge_by_hand() {
  TendonModel<double> digit;
  digit.tree.push_back({-1, 0, 1, 0, {0, 0, 1}, {2, 0, 0}});
  digit.coordinates = 1;
  digit.tip_link = 0;
  digit.tip.setZero();
  digit.tip_axes.setIdentity();
  digit.paths = {{{0, {1, -0.5, 0}}, {-1, {3, -0.5, 0}}}};
  digit.constant_arms = Eigen::MatrixXd::Zero(1, 1);
  digit.friction = VectorXd::Zero(1);
  digit.pulls = {0};
  return digit;
}

// The tendon runs 0.5 below the axis: torque 0.5 t about z turns the phalanx's far end, at 1 m from
// the axis, down with 0.5 t; half-way along it with 1 / 2 of the lever, so with twice the force.
// The mount is pulled with t along x and pushed up by the tip's cell.
TEST(ForceSites, MatchHandComputedHinge) {
  const TendonModel<double> digit = hinge_by_hand();
  const VectorXd q = VectorXd::Zero(1);
  const TreeState<double> state = pose_tree(digit.tree, q);
  const double arm = muscle_arms(digit, state, q)(0, 0);
  ASSERT_NEAR(std::abs(arm), 0.5, 1e-12);
  const PlannedSite middle{0, {1, 0, 0}, 0, TendonExit::kCrossing, {0}};
  const PlannedSite end{0, {0, 0, 0}, 0, TendonExit::kCrossing, {0}};
  const auto force = [&](const PlannedSite& site) -> Vector3d {
    return segment_force_map(digit, site, state, q, TipConstraint::kPinned,
                             DecidedForces::kInPlane);
  };
  EXPECT_TRUE(matrix_near(force(end), Vector3d(0, -0.25, 0), 1e-12));
  EXPECT_TRUE(matrix_near(force(middle), Vector3d(0, -0.5, 0), 1e-12));
  EXPECT_TRUE(
      matrix_near(leaving_pulls(digit, state, TendonExit::kCrossing), Vector3d(1, 0, 0), 1e-12));
}

// A cell at a phalanx is a tip there of a finger whose joints beyond are frozen where they are.
TEST(ForceSites, HeldPhalanxIsTheTipOfAShorterFinger) {
  const TendonDigit whole = published_finger();
  const TendonDigit frozen = published_finger({{"DIP3", kDip}});
  // Both flexors: what runs beyond the joint pulls the same strand.
  ForceSite site = at("MP3");
  site.fraction = 0.3;
  const Eigen::Matrix3Xd found = forces_at(whole, {{"FDS", 7.0}, {"FDP", 3.0}}, {site});
  // By hand: the frozen finger with its tip moved to that point of the middle phalanx.
  const int link = whole.skeleton.link_of_segment.at("MP3");
  TendonModel<double> shorter = frozen.model;
  const Vector3d pip = whole.model.tree[static_cast<std::size_t>(link)].point,
                 dip = whole.model.tree[static_cast<std::size_t>(link) + 1].point;
  shorter.tip = pip + 0.3 * (dip - pip);
  shorter.tip_axes =
      whole.model.tip_axes;  // those of the frozen finger are turned by its DIP joint
  shorter.tip_link = frozen.skeleton.link_of_segment.at("MP3");
  const VectorXd q = posture(frozen.skeleton, {{"PIP3", kPip}});
  const Eigen::MatrixXd map = tip_force_map(shorter, pose_tree(shorter.tree, q), q,
                                            TipConstraint::kPinned, DecidedForces::kInSpace, 0.0);
  VectorXd t = VectorXd::Zero(map.cols());
  for (std::size_t m = 0; m < frozen.names.muscles.size(); ++m)
    t[static_cast<Eigen::Index>(m)] = frozen.names.muscles[m] == "FDS"   ? 7
                                      : frozen.names.muscles[m] == "FDP" ? 3
                                                                         : 0;
  EXPECT_TRUE(matrix_near(found.col(0), map * t, 1e-9 * (map * t).norm()));
}

// Virtual work: the finger is carried by d without turning, tensions t held and the muscles' side
// of every tendon in place. Tendons do  -t dL,  cells  (f + f_mount) . d  in return.
TEST(ForceSites, MountBalancesTheFreeBody) {
  const TendonDigit digit = published_finger();
  const std::map<std::string, double> tension{{"FDS", 7}, {"EDC", 4}, {"RI", 3}, {"LU", 1}};
  const VectorXd q = posture(digit.skeleton, {{"PIP3", kPip}, {"DIP3", kDip}});
  const TreeState<double> state = pose_tree(digit.model.tree, q);
  ForceSite tip_in_base = at("DP3");
  tip_in_base.axes = "MC3";
  for (const TipConstraint hold : {TipConstraint::kPinned, TipConstraint::kRigid}) {
    ForceSite along = at("MC3");
    along.leave = TendonExit::kAlongBone;
    const Eigen::Matrix3Xd f = forces_at(digit, tension, {at("MC3"), along, std::nullopt}, hold);
    const Eigen::Matrix3d turn =
        state[static_cast<std::size_t>(digit.model.tip_link)].X.R;  // of the distal phalanx
    const Eigen::Matrix3d& axes = digit.model.tip_axes;
    const Vector3d f_tip = turn * axes * f.col(2), f_mount = axes * f.col(0);
    // Work of the tendons by differences of the lengths of their paths.
    Vector3d pulls = Vector3d::Zero();
    double sum = 0;
    for (std::size_t m = 0; m < digit.names.muscles.size(); ++m) {
      const auto pulled = tension.find(digit.names.muscles[m]);
      if (pulled == tension.end()) continue;
      sum += pulled->second;
      for (int k = 0; k < 3; ++k) {
        const auto length = [&](double by) {
          TendonPath<double> path =
              digit.model.paths[static_cast<std::size_t>(digit.model.pulls[m])];
          for (PathNode<double>& node : path)
            if (node.link < 0) node.p -= by * Vector3d::Unit(k);
          return path_length(state, path);
        };
        constexpr double kStep = 1e-6;  // [m]
        pulls[k] -= pulled->second * (length(kStep) - length(-kStep)) / (2 * kStep);
      }
    }
    EXPECT_TRUE(matrix_near(f_mount + f_tip, pulls, 1e-7));
    // Turned along the bone, they pull proximally with all their tension.
    EXPECT_TRUE(matrix_near(axes * f.col(1) + f_tip, sum * axes.col(0), 1e-9));
  }
}

// Parameters move the forces of every site as differences say.
TEST(ForceSites, DerivativesAgreeWithDifferences) {
  sample::FitSetup setup = sample::middle_finger(sample::kAxesAndPaths);
  Experiment& experiment = setup.experiments.front();
  experiment.trials.resize(3);
  experiment.trials[1].site = at("MC3");
  experiment.trials[2].site = at("MP3");
  const ExperimentPlan plan = plan_experiment(setup.digit, setup.parameters, experiment);
  VectorXd u = VectorXd::Constant(setup.parameters.coordinates(), 1e-3);
  const ForceJacobian exact = force_jacobian(setup.digit, setup.parameters, plan, u);
  for (Eigen::Index k = 0; k < u.size(); ++k) {
    constexpr double kStep = 1e-6;
    const auto force = [&](double by) -> VectorXd {
      const VectorXd moved = u + by * VectorXd::Unit(u.size(), k);
      return force_values(setup.digit, setup.parameters, plan, moved).reshaped();
    };
    const VectorXd slope = (force(kStep) - force(-kStep)) / (2 * kStep);
    EXPECT_TRUE(matrix_near(exact.J.col(k), slope, 1e-6 * (1 + slope.norm()))) << k;
  }
}

TEST(ForceSites, SayWhatTorquesDoNotDecide) {
  const TendonDigit digit = published_finger();
  Experiment experiment = sample::experiment("H01");
  experiment.trials.resize(1);
  experiment.trials[0].site = at("PP3");
  const FitParameters parameters = choose_parameters(digit, {}, {});
  const std::vector<std::string> warnings =
      experiment_warnings(digit, plan_experiment(digit, parameters, experiment), experiment);
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string& warning) {
    return warning.find("a load cell at PP3 carries 4 loads, but 2 joint angles") !=
           std::string::npos;
  }));
}

TEST(ForceSites, AreRefusedWhereTheyMeanNothing) {
  const TendonDigit digit = published_finger();
  ForceSite placed = at("MC3");
  placed.fraction = 0.2;
  EXPECT_NE(message_of([&] { (void)forces_at(digit, {}, {placed}); }).find("is the mount"),
            std::string::npos);
  EXPECT_NE(message_of([&] { (void)forces_at(digit, {}, {at("PP9")}); }).find("'PP9'"),
            std::string::npos);
}

}  // namespace
}  // namespace thenar
