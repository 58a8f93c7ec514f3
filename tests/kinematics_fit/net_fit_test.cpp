// Tests for kinematics_fit/model/net_trials.cpp, specimen_net.cpp and the derivatives of fits with
// nets.

#include "kinematics_fit/model/net_trials.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/provenance.h"
#include "data/io/net_description.h"
#include "data/io/result_file.h"
#include "kinematics_fit/bands/hood_comparison.h"
#include "tendons/net/build_tendons.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar {
namespace {

FitInputs net_inputs(const std::string& net, const std::vector<std::string>& specimens) {
  FitInputs inputs = sample::finger_inputs("an_chao_middle", specimens);
  inputs.net = sample::source("nets/" + net);
  return inputs;
}

/// A fit with a net, and settings written in the test.
FitProblem net_problem(const std::string& net, const std::string& rows) {
  FitInputs inputs = net_inputs(net, {"H01"});
  inputs.settings = {"fit.toml", "source = 'Synek2019'\n" + rows};
  return build_problem(inputs);
}

// The bones' own lengths apart, under which a net would have to be laid anew.
const std::string kAllButLengths = R"(
[[parameter]]
match = "*"
state = "free"
[[parameter]]
match = "length/*"
state = "fixed"
[[parameter]]
match = "hold/out_of_plane"
mean_mm = 39
)";

/// A point near the prior means: each coordinate is drawn by its name, whatever others there are.
/// Bones grow no thicker, so that no band ends inside one, where it has no slope by the radius.
Eigen::VectorXd draw_point(const FitParameters& parameters) {
  Eigen::VectorXd u = 0.2 * sample::population_sds(parameters);
  for (int c = 0; c < parameters.coordinates(); ++c) {
    const std::string& name = parameters.all[parameters.leader[c]].name;
    std::seed_seq seed(name.begin(), name.end());
    std::mt19937 rng(seed);
    u[c] *= sample::normal(1, rng)[0];
    if (matches_glob("net/*/radius", name)) u[c] = -std::abs(u[c]);
  }
  return u;
}

/// How derivatives are compared with differences.
struct Differences {
  std::string settings = kAllButLengths;
  double step = 4e-4;       // of an sd, so that no band becomes slack on the way
  double tolerance = 5e-6;  // [N per sd]: 2e-9 N of the net's rest, over the step
};

/// Compares every column of the Jacobian, in newtons per sd, with Richardson's differences.
/// @param moved_by_net  parameters of the net that move forces by more than 1 mN per sd
void expect_exact(const std::string& net, int moved_by_net, const Differences& steps = {}) {
  const FitProblem problem = net_problem(net, steps.settings);
  const FitParameters& parameters = problem.parameters();
  const ExperimentPlan& plan = problem.plans().front();
  const Eigen::VectorXd sd = sample::population_sds(parameters), u = draw_point(parameters);
  const ForceJacobian exact = force_jacobian(problem.digit(), parameters, plan, u);
  const auto force = [&](Eigen::Index c, double by) -> Eigen::VectorXd {
    return force_values(problem.digit(), parameters, plan,
                        u + by * sd[c] * Eigen::VectorXd::Unit(u.size(), c))
        .reshaped();
  };
  EXPECT_TRUE(exact.force.isApprox(force_values(problem.digit(), parameters, plan, u), 1e-12));
  int moving = 0;
  for (Eigen::Index c = 0; c < u.size(); ++c) {
    const Eigen::VectorXd difference = (8 * (force(c, steps.step) - force(c, -steps.step)) -
                                        (force(c, 2 * steps.step) - force(c, -2 * steps.step))) /
                                       (12 * steps.step);
    const Parameter& p = parameters.all[parameters.leader[c]];
    EXPECT_LT((difference - sd[c] * exact.J.col(c)).cwiseAbs().maxCoeff(), steps.tolerance)
        << p.name;
    if (p.name.rfind("net/", 0) == 0 && difference.norm() > 1e-3) ++moving;
  }
  EXPECT_GE(moving, moved_by_net);
}

TEST(NetFit, JacobianIsExactForEveryParameterOfWinslow) { expect_exact("winslow", 20); }
TEST(NetFit, JacobianIsExactForEveryParameterOfChaoAndAn) { expect_exact("chao_an", 1); }

// Shares of RI, LU and UI among their pulls, and slopes of these; the share depends on the knuckle.
// A knot on the head of the phalanx may be held or lie above it by rounding, which changes forces
// by 2e-7 N (docs/theory/extensor_net.md), so that steps are longer than above.
TEST(NetFit, JacobianIsExactForSharesAmongPulls) {
  const std::string rows = R"(
[[parameter]]
match = "net/*/central"
state = "free"
[[parameter]]
match = "net/*/slope"
state = "free"
[[parameter]]
match = "net/RI/into"
state = "free"
[[parameter]]
match = "angle/MCP3_FE"
state = "free"
[[parameter]]
match = "hold/out_of_plane"
mean_mm = 39
)";
  expect_exact("extensor_hood", 5, {rows, 2e-2, 1e-5});
}

// Odds as stated hold at kHoodAngle; a slope of 0.5 per rad, 0.2 rad on, shifts the logit by 0.1.
TEST(NetFit, SharesOfTwoPullsFollowTheKnuckle) {
  const FitProblem problem = net_problem("extensor_hood", kAllButLengths);
  SpecimenNet<double> net = cast_net<double>(problem.digit().net);
  const BuiltNet& built = *net.built;
  net.slope.setConstant(0.5);
  int divided = 0;
  for (std::size_t m = 0; m < built.muscles.size(); ++m) {
    const int muscle = built.muscles[m].muscle;
    const std::optional<double> stated = first_share(built, static_cast<int>(m));
    std::vector<double> shares;
    const Eigen::VectorXd all = pull_shares(net, kHoodAngle + 0.2);
    for (std::size_t p = 0; p < built.pulls.size(); ++p)
      if (built.pulls[p].muscle == muscle) shares.push_back(all[static_cast<Eigen::Index>(p)]);
    const double into = built.muscles[m].to_net;
    if (!stated) {
      EXPECT_EQ(shares, std::vector<double>{into});
      continue;
    }
    ++divided;
    const double odds = *stated / (1 - *stated) * std::exp(0.1);
    ASSERT_EQ(shares.size(), 2U);
    EXPECT_NEAR(shares[0], into * odds / (1 + odds), 1e-15);
    EXPECT_NEAR(shares[1], into / (1 + odds), 1e-15);
  }
  EXPECT_EQ(divided, 3);  // RI, LU, UI; the extensor pulls at one place
}

// At the prior means the fit's model is the ladder's rung of the same net.
TEST(NetFit, StartsFromTheLaddersForces) {
  const SourceText text = sample::source("subjects/an_chao_middle");
  const SourceText net = sample::source("nets/winslow");
  const Experiment experiment = sample::experiment("H01");
  const FitProblem problem =
      net_problem("winslow", "[[parameter]]\nmatch = 'net/stiffness'\nstate = 'free'\n");
  TendonOptions options;
  options.hood = Hood::kFloatingNet;
  const NetDescription description = parse_net(net.text, net.path);
  const auto tendons =
      build_digit_tendons(parse_subject(text.text, text.path), "middle", options, &description);
  const Eigen::Matrix3Xd expected = trial_forces(*tendons, experiment).force;
  const Eigen::Matrix3Xd force = force_values(problem.digit(), problem.parameters(),
                                              problem.plans().front(), Eigen::VectorXd::Zero(1));
  for (Eigen::Index i = 0; i < force.cols(); ++i) {
    if (!pulls_net(*problem.digit().net, problem.plans().front().tension[i])) continue;
    EXPECT_LT((force.col(i) - expected.col(i)).norm(), 1e-6) << i;  // [N]
  }
}

// Forces are a function of the parameters: what was computed before leaves no trace.
TEST(NetFit, ForcesDoNotDependOnWhatWasComputedBefore) {
  const FitProblem problem = net_problem("winslow", kAllButLengths);
  std::mt19937 rng(2);
  const Eigen::VectorXd sd = sample::population_sds(problem.parameters());
  const Eigen::VectorXd u = 0.5 * sd.cwiseProduct(sample::normal(sd.size(), rng));
  const auto force = [&](const Eigen::VectorXd& at) {
    return force_values(problem.digit(), problem.parameters(), problem.plans().front(), at);
  };
  const Eigen::Matrix3Xd before = force(u);
  (void)force(-2 * u);
  EXPECT_EQ((force(u) - before).norm(), 0);
}

// Where nothing of it pulls, a net is nothing: derivatives are those of jets alone.
TEST(NetFit, FlexorsDoNotFeelTheNet) {
  const FitProblem problem = net_problem("winslow", kAllButLengths);
  const FitParameters& parameters = problem.parameters();
  const ExperimentPlan& plan = problem.plans().front();
  const Eigen::VectorXd u = Eigen::VectorXd::Zero(parameters.coordinates());
  const ForceJacobian with = force_jacobian(problem.digit(), parameters, plan, u);
  TendonDigit bare = problem.digit();
  bare.net = nullptr;
  FitParameters without = parameters;
  // The same parameters without those of the net.
  without.all.clear();
  without.coordinate.clear();
  without.ratio.clear();
  for (std::size_t p = 0; p < parameters.all.size(); ++p) {
    if (parameters.all[p].name.rfind("net/", 0) == 0) continue;
    without.all.push_back(parameters.all[p]);
    without.coordinate.push_back(parameters.coordinate[p]);
    without.ratio.push_back(parameters.ratio[p]);
  }
  const ForceJacobian jets = force_jacobian(bare, without, plan, u);
  int flexors = 0;
  for (Eigen::Index i = 0; i < plan.force.cols(); ++i) {
    if (pulls_net(*problem.digit().net, plan.tension[i])) continue;
    ++flexors;
    EXPECT_LT((with.J.middleRows(3 * i, 3) - jets.J.middleRows(3 * i, 3)).cwiseAbs().maxCoeff(),
              1e-10);
  }
  EXPECT_GT(flexors, 4);
}

// The result file has the net's text with its digest, and the fit is built from it alone.
TEST(NetFit, ComesBackFromItsFile) {
  FitInputs inputs = net_inputs("winslow", {"H01"});
  inputs.settings = {"fit.toml",
                     "source = 'Synek2019'\n[[parameter]]\nmatch = 'net/PIP_dorsum/radius'\n"
                     "state = 'free'\n"};
  SolveOptions options;
  options.max_evaluations = 3;
  const Fit fit = run_fit(inputs, options);
  const std::string path = testing::TempDir() + "net_fit.h5";
  write_fit(fit, path);
  const ResultFile file = read_result(path);
  EXPECT_EQ(file.text("inputs/net/text"), inputs.net->text);
  EXPECT_EQ(file.text("provenance/sha256/inputs/net"), sha256(inputs.net->text));
  const Fit back = read_fit(path);
  ASSERT_TRUE(back.problem.digit().net);
  EXPECT_EQ(predict_trials(back.problem, back.solution.z, 0),
            predict_trials(fit.problem, fit.solution.z, 0));
}

TEST(NetFit, RefusesBonesThatGrowUnderANet) {
  EXPECT_THROW(
      (void)net_problem("winslow", "[[parameter]]\nmatch = 'length/PIP3'\nstate = 'free'\n"),
      InputError);
}

}  // namespace
}  // namespace thenar
