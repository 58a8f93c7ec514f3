// Tests for posterior/posterior_parts.cpp and hand_posterior.cpp: priors, and x against z.

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "posterior/bounded_table.h"
#include "posterior/hand_posterior.h"
#include "posterior/tilt_density.h"
#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using sample::FitSetup;
using sample::middle_finger;
using sample::moving_axes;

PosteriorOptions options(bool noise, bool specimen_scale, bool sphere) {
  PosteriorOptions chosen;
  chosen.learn_noise = noise;
  chosen.learn_specimen_scale = specimen_scale;
  chosen.sphere_priors = sphere;
  return chosen;
}

FitProblem without_data(const std::string& rows, bool two = false) {
  FitSetup setup = middle_finger(rows);
  if (two) setup.experiments.push_back(sample::experiment("H02"));
  for (Experiment& experiment : setup.experiments) experiment.trials.clear();
  return setup.problem();
}

/// Points of a grid with `count` nodes from -reach to reach in each of n dimensions.
MatrixXd grid(int n, int count, double reach) {
  MatrixXd x(n, static_cast<Eigen::Index>(std::pow(count, n)));
  for (Eigen::Index p = 0; p < x.cols(); ++p)
    for (Eigen::Index i = 0, rest = p; i < n; ++i, rest /= count)
      x(i, p) = reach * (2.0 * static_cast<double>(rest % count) / (count - 1) - 1);
  return x;
}

/// Density times volume at the points of grid(): the trapezoidal rule, which is exact to rounding
/// for densities that die out like a normal one.
VectorXd weights(const HandPosterior& posterior, const MatrixXd& x, int count, double reach) {
  const Densities at = posterior.evaluate(x, WithGradient::kNo);
  EXPECT_EQ(at.log_likelihood.cwiseAbs().maxCoeff(), 0) << "there are no data";
  return at.log_prior.array().exp() *
         std::pow(2 * reach / (count - 1), static_cast<double>(x.rows()));
}

const std::string kGain = "[[parameter]]\nmatch='gain/LU'\nstate='free'\nsd=0.1\nbetween_sd=0\n";

// Without data a bounded parameter has its truncated normal: mean of N(1, 0.1^2) on 0.9 .. 1.25.
TEST(HandPrior, OfABoundedParameterIsTruncatedNormal) {
  const HandPosterior posterior(without_data(kGain + "lower=0.9\nupper=1.25\n"),
                                options(false, false, false));
  ASSERT_EQ(posterior.size(), 1);
  const MatrixXd x = grid(1, 161, 8);
  const VectorXd weight = weights(posterior, x, 161, 8);
  EXPECT_NEAR(weight.sum(), 1, 1e-12);
  const double l = -1, h = 2.5;
  const auto density = [](double z) { return std::exp(-0.5 * z * z) / std::sqrt(2 * kPi); };
  const double mean =
      1 + 0.1 * (density(l) - density(h)) / (normal_probability(h) - normal_probability(l));
  EXPECT_NEAR(weight.dot(posterior.values(x).population.row(0)), mean, 1e-9);
}

// With two specimens and their specimen_scale: three dimensions, specimen_scale log-normal
// beforehand.
TEST(HandPrior, OfSpecimensIsTruncatedAtEverySpread) {
  const HandPosterior posterior(
      without_data("[[parameter]]\nmatch='gain/LU'\nstate='free'\nsd=0\nbetween_sd=0.1\n"
                   "range=0.15\n",
                   true),
      options(false, true, false));
  ASSERT_EQ(posterior.names(),
            (std::vector<std::string>{"H01: gain/LU", "H02: gain/LU", "spread/gain"}));
  const MatrixXd x = grid(3, 29, 7);
  const VectorXd weight = weights(posterior, x, 29, 7);
  EXPECT_NEAR(weight.sum(), 1, 1e-10);
  const PosteriorValues values = posterior.values(x);
  EXPECT_NEAR(weight.dot(values.specimen_scale.row(0)), std::exp(0.5 * 0.25), 1e-9);
  // E (gain - 1)^2 of a normal cut off at +-h sds: k^2 (1 - 2 h phi(h) / (2 Phi(h) - 1)).
  double expected = 0;
  for (double g = -8; g <= 8; g += 0.05) {
    const double k = std::exp(0.5 * g), h = 1.5 / k;
    const double phi = std::exp(-0.5 * h * h) / std::sqrt(2 * kPi);
    expected += 0.05 * std::exp(-0.5 * g * g) / std::sqrt(2 * kPi) * 0.01 * k * k *
                (1 - 2 * h * phi / (2 * normal_probability(h) - 1));
  }
  const VectorXd squares = (values.specimens[0].row(0).array() - 1).square();
  EXPECT_NEAR(weight.dot(squares), expected, 1e-5 * expected);
}

/// One axis, 20 degrees of doubt, at most 45.
const std::string kOneAxis = R"([[parameter]]
match = "axis/PIP3/direction/*"
state = "free"
sd_deg = 20
between_sd_deg = 0
range_deg = 45
)";

// The sphere's density in x is that of the directions: mass and mean cosine over the box of tilts.
TEST(HandPrior, OfAnAxisIsThatOfTheSphere) {
  const HandPosterior posterior(without_data(kOneAxis), options(false, false, true));
  constexpr int kCount = 81;
  const MatrixXd x = grid(2, kCount, 8);
  const VectorXd weight = weights(posterior, x, kCount, 8);
  const MatrixXd tilts = posterior.values(x).population;
  const auto cosine = [](const Eigen::Vector2d& t) { return 1 / std::sqrt(1 + t.squaredNorm()); };
  double mean = 0;
  for (Eigen::Index p = 0; p < x.cols(); ++p) mean += weight[p] * cosine(tilts.col(p));

  constexpr int kCells = 300;
  const double edge = 45 * kDegree, cell = 2 * edge / kCells, sd = 20 * kDegree;
  double mass = 0, expected = 0;
  for (int i = 0; i < kCells; ++i)
    for (int j = 0; j < kCells; ++j) {
      const Eigen::Vector2d t(-edge + (i + 0.5) * cell, -edge + (j + 0.5) * cell);
      const double here =
          std::exp(tilt_density(t, {0, 0}, 1 / (sd * sd)).log_density) * cell * cell;
      mass += here;
      expected += here * cosine(t);
    }
  const double within = normal_probability(2.25) - normal_probability(-2.25);
  EXPECT_NEAR(weight.sum(), mass / (within * within), 1e-5);
  EXPECT_NEAR(mean / weight.sum(), expected / mass, 1e-6);
}

// Stein: E dlog p/dx = 0 and E x dlog p/dx = -1 over draws from p, for every entry.
TEST(HandPrior, DrawsAreOfItsDensity) {
  const HandPosterior posterior(without_data(R"([[parameter]]
match = "axis/PIP3/direction/*"
state = "free"
sd_deg = 12
between_sd_deg = 9
[[parameter]]
match = "axis/DIP3/direction/*"
state = "free"
sd_deg = 0
between_sd_deg = 6
[[parameter]]
match = "path/FDS/1/dorsal"
state = "free"
range_mm = 2
)",
                                             true),
                                options(true, true, true));
  constexpr int kDraws = 6000;
  MatrixXd x(posterior.size(), kDraws);
  for (int i = 0; i < kDraws; ++i) x.col(i) = posterior.draw_prior(3, static_cast<unsigned>(i));
  const MatrixXd gradient = posterior.evaluate(x, WithGradient::kYes).prior_gradient;
  const MatrixXd moment = gradient.cwiseProduct(x);
  const std::vector<std::string> names = posterior.names();
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    const auto error = [](const Eigen::ArrayXd& a) {
      return std::sqrt((a - a.mean()).square().mean() / kDraws);
    };
    EXPECT_NEAR(gradient.row(i).mean(), 0, 4 * error(gradient.row(i))) << names[i];
    EXPECT_NEAR(moment.row(i).mean(), -1, 4 * error(moment.row(i))) << names[i];
  }
  EXPECT_TRUE(matrix_near(posterior.draw_prior(3, 7), x.col(7), 0)) << "same seed, same draw";
}

// -- Moment arms of thumbs --------------------------------------------------------------------

/// Arms of a thumb by name, with the built-in settings.
std::map<std::string, Parameter> thumb_arms(const std::string& subject) {
  const SourceText text = sample::source("subjects/" + subject);
  const TendonDigit digit = build_tendon_digit(parse_subject(text.text, text.path), "thumb");
  const SourceText settings = sample::source("fits/thumb");
  const FitParameters chosen =
      choose_parameters(digit, {}, parse_fit_settings(settings.text, settings.path));
  std::map<std::string, Parameter> arms;
  for (std::size_t p = 0; p < chosen.all.size(); ++p)
    if (chosen.all[p].kind == ParameterKind::kArm && chosen.coordinate[p] >= 0)
      arms[chosen.all[p].name] = chosen.all[p];
  return arms;
}

TEST(ThumbSettings, BelieveBothSourcesOfMomentArms) {
  const auto ours = thumb_arms("arms_thumb"), theirs = thumb_arms("graspit_skewed_thumb");
  double sum = 0, compared = 0;
  for (const auto& [name, arm] : ours) {
    const auto other = theirs.find(name);
    if (other == theirs.end()) continue;
    // The difference of two draws has twice the variance.
    const double z =
        (arm.mean - other->second.mean) / (std::sqrt(2) * std::hypot(arm.sd, arm.between_sd));
    EXPECT_LT(std::abs(z), 2) << name;
    sum += z * z;
    ++compared;
  }
  EXPECT_EQ(compared, 22);         // FPL and EPL at four joints, OPP at two, four others at three
  EXPECT_LT(sum / compared, 1);    // wide enough,
  EXPECT_GT(sum / compared, 0.3);  // and no wider than need be
}

TEST(ThumbSettings, MoveNoJointBeyondAnInsertion) {
  for (const char* subject : {"arms_thumb", "graspit_skewed_thumb"}) {
    const auto arms = thumb_arms(subject);
    for (const char* name : {"arm/OPP/MCP1_FE", "arm/OPP/MCP1_AA", "arm/FPB/IP1", "arm/ADPt/IP1"})
      EXPECT_EQ(arms.count(name), 0U) << name;
    EXPECT_EQ(arms.count("arm/FPL/IP1"), 1U);
  }
}

// -- x and the fit's z ------------------------------------------------------------------------

TEST(HandPosteriorValues, GoThereAndBack) {
  FitSetup setup = moving_axes("axis/MCP3_*/point/?");
  setup.experiments.push_back(sample::experiment("H02"));
  const FitProblem problem = setup.problem();
  const HandPosterior posterior(problem);
  std::mt19937 rng(9);
  const VectorXd z = 0.7 * sample::normal(problem.size(), rng);
  const VectorXd x = posterior.from_fit_coordinates(z);
  EXPECT_TRUE(matrix_near(posterior.fit_coordinates(x), z, 1e-12));
  EXPECT_TRUE(matrix_near(x.tail(4), VectorXd::Zero(4), 0)) << "factors are one";
  EXPECT_EQ(posterior.names().size(), static_cast<std::size_t>(posterior.size()));
  // Values in the order of moving_parameters(), of the population and both specimens.
  const PosteriorValues values = posterior.values(x);
  const std::vector<int> moving = posterior.moving_parameters();
  const auto fitted =
      parameter_values<double>(problem.parameters(), displacements(problem.coordinates(), z, 1));
  for (std::size_t i = 0; i < moving.size(); ++i)
    EXPECT_NEAR(values.specimens[1](static_cast<Eigen::Index>(i), 0), fitted[moving[i]], 1e-14);
  EXPECT_EQ(values.noise, (MatrixXd::Ones(2, 1)));
}

TEST(HandPosteriorValues, FollowTies) {
  const FitProblem problem = middle_finger(R"([[parameter]]
match = "friction/FDP"
state = "free"
mean = 0.1
sd = 0.05
between_sd = 0
lower = 0
upper = 0.5
[[parameter]]
match = "friction/FDS"
state = "tied"
tie_to = "friction/FDP"
tie_ratio = 0.5
mean = 0.1
lower = 0
upper = 0.5
)")
                                 .problem();
  const HandPosterior posterior(problem, options(false, false, false));
  EXPECT_EQ(posterior.size(), 1);
  const MatrixXd values = posterior.values(VectorXd::Constant(1, 0.8)).population;
  ASSERT_EQ(values.rows(), 2);
  EXPECT_NEAR(values(1, 0) - 0.1, 0.5 * (values(0, 0) - 0.1), 1e-15);
  EXPECT_GT(values(0, 0), 0.13);
}

TEST(HandPosterior, RefusesToSampleNothing) {
  try {
    (void)HandPosterior(moving_axes("axis/PIP3/point/along").problem(), {});
    const FitProblem problem =
        middle_finger("[[parameter]]\nmatch='axis/PIP3/point/along'\nstate='free'\n").problem();
    (void)HandPosterior(problem, {});
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "nothing to sample: every free parameter shifts an axis along itself, or is held "
                 "by its bounds");
  }
}

}  // namespace
}  // namespace thenar
