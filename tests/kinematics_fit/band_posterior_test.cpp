// Tests for kinematics_fit/bands/band_posterior.cpp and rank_trials.cpp.

#include "kinematics_fit/bands/band_posterior.h"

#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "kinematics_fit/bands/band_problems.h"
#include "kinematics_fit/bands/rank_trials.h"
#include "kinematics_fit/fit_residuals.h"
#include "tests/kinematics_fit/planted_bands.h"

namespace thenar {
namespace {

const std::vector<std::string> kBands{"crossing_u", "transverse_u"};

/// How many truths: few, or THENAR_TRIALS.
int truths(int few) {
  const char* wanted = std::getenv("THENAR_TRIALS");
  return wanted ? std::atoi(wanted) : few;
}

/// Slack lengths and places away from their means: held, both bands get the wrong verdict.
TEST(BandPosterior, IsRightWhereHeldSlackLengthsMislead) {
  std::mt19937 random(2);
  const Experiment plan = planted::experiment();
  const BandProblems problems = planted::problems(plan, kBands);
  const planted::Truth truth = planted::draw_truth(problems, random);
  const Experiment measured = planted::measured(problems, truth, plan, random);
  ASSERT_EQ(truth.bands, (Topology{true, false}));
  // Held: the band that exists is denied, the other one asserted.
  const std::vector<BandVerdict> held = planted::verdicts_when_held(measured, kBands);
  EXPECT_EQ(held[0].verdict, Verdict::kNo);
  EXPECT_EQ(held[1].verdict, Verdict::kYes);
  // Free: the first one exists, the second one does not, or cannot be told.
  const BandPosterior found = band_posterior(planted::problems(measured, kBands), random);
  ASSERT_TRUE(found.found && found.enumerated);
  EXPECT_EQ(found.fitted, 4U);
  EXPECT_EQ(found.bands[0].verdict, Verdict::kYes);
  EXPECT_LT(found.bands[1].probability, 0.2);
  EXPECT_EQ(found.sets.front().bands, truth.bands);
  EXPECT_NEAR(found.noise, 1, 0.5);
}

TEST(BandPosterior, CannotTellABandThatIsSlackThroughout) {
  std::mt19937 random(3);
  const Experiment plan = planted::experiment();
  const std::vector<std::string> bands{"sagittal_oblique_u"};
  const BandProblems problems = planted::problems(plan, bands);
  planted::Truth truth{{true}, Eigen::VectorXd::Zero(problems.full_problem().size())};
  const Experiment measured = planted::measured(problems, truth, plan, random);
  const BandPosterior found = band_posterior(planted::problems(measured, bands), random);
  ASSERT_TRUE(found.found);
  EXPECT_NEAR(found.bands[0].probability, 0.5, 0.02);  // modes are found to 0.05 nat
  EXPECT_EQ(found.bands[0].verdict, Verdict::kUndecided);
  EXPECT_EQ(found.bands[0].why, UndecidedReason::kSlack);
  EXPECT_NEAR(found.entropy, 1, 0.02);
}

// The sampler's chances against probabilities by all sets.
TEST(BandPosterior, SamplesWhatItWouldEnumerate) {
  std::mt19937 random(4);
  const Experiment plan = planted::experiment();
  const BandProblems problems = planted::problems(plan, kBands);
  const planted::Truth truth = planted::draw_truth(problems, random);
  const BandProblems fitted =
      planted::problems(planted::measured(problems, truth, plan, random), kBands);
  const BandPosterior all = band_posterior(fitted, random);
  BandPosteriorOptions sample;
  sample.enumerated = 0;
  sample.sweeps = 400;
  const BandPosterior some = band_posterior(fitted, random, sample);
  EXPECT_TRUE(all.enumerated && !some.enumerated);
  EXPECT_LE(some.fitted, 4U);
  // Seeds differ in where searches start, which leaves 0.05 nat; the rest is chance.
  for (std::size_t b = 0; b < kBands.size(); ++b)
    EXPECT_NEAR(some.bands[b].probability, all.bands[b].probability, 0.08) << kBands[b];
}

TEST(BandPosterior, SaysThatItWasStopped) {
  Progress progress;
  progress.stop_requested = [] { return true; };
  std::mt19937 random(1);
  const BandProblems problems = planted::problems(planted::experiment(), kBands);
  const BandPosterior found = band_posterior(problems, random, {}, progress);
  EXPECT_EQ(found.status, Status::kStopped);
  EXPECT_EQ(found.fitted, 1U);
}

// Of bands that exist with the stated probabilities p, sum (exists - p) has the variance sum p (1 -
// p). Truths are drawn from the prior. THENAR_TRIALS=60 prints counts by stated probability.
TEST(BandPosterior, StatesProbabilitiesThatHold) {
  const std::vector<std::string> bands{"transverse_u"};
  const Experiment plan = planted::experiment();
  const BandProblems problems = planted::problems(plan, bands);
  double excess = 0, variance = 0;
  int wrong = 0, told = 0, held_wrong = 0, held_told = 0;
  std::map<int, std::pair<int, double>> bins;  // of exists, by the tenth of the probability
  std::map<int, int> counts;
  for (int i = 0; i < truths(5); ++i) {
    std::mt19937 random(9000 + static_cast<unsigned>(i));
    const planted::Truth truth = planted::draw_truth(problems, random);
    const Experiment measured = planted::measured(problems, truth, plan, random);
    const BandPosterior found = band_posterior(planted::problems(measured, bands), random);
    ASSERT_TRUE(found.found);
    const double p = found.bands[0].probability;
    excess += (truth.bands[0] ? 1 : 0) - p;
    variance += p * (1 - p);
    const Verdict right = truth.bands[0] ? Verdict::kYes : Verdict::kNo;
    const auto count = [&](Verdict verdict, int& given, int& amiss) {
      given += verdict == Verdict::kUndecided ? 0 : 1;
      amiss += verdict == Verdict::kUndecided || verdict == right ? 0 : 1;
    };
    count(found.bands[0].verdict, told, wrong);
    count(planted::verdicts_when_held(measured, bands)[0].verdict, held_told, held_wrong);
    auto& bin = bins[static_cast<int>(std::min(9.0, 10 * p))];
    bin.first += truth.bands[0] ? 1 : 0;
    bin.second += p;
    ++counts[static_cast<int>(std::min(9.0, 10 * p))];
  }
  if (std::getenv("THENAR_TRIALS")) {
    fmt::print("free: {} told, {} wrong; held: {} told, {} wrong\n", told, wrong, held_told,
               held_wrong);
    for (const auto& [tenth, bin] : bins)
      fmt::print("stated {:.2f} on average, {} of {} exist\n", bin.second / counts[tenth],
                 bin.first, counts[tenth]);
  }
  // Three sds, and one truth that a poor approximation gets wrong.
  EXPECT_LT(std::abs(excess), 3 * std::sqrt(variance) + 1);
  EXPECT_LE(wrong, 1 + told / 10);
}

TEST(RankTrials, TellsMoreByTheBestTrialThanByTheWorst) {
  const Experiment plan = planted::experiment();
  Experiment before = plan;
  before.trials = {plan.trials[0], plan.trials[4]};  // the extensor alone
  double best = 0, worst = 0, chance = 0, expected = 0;
  const int count = truths(2);
  for (int i = 0; i < count; ++i) {
    std::mt19937 random(1 + static_cast<unsigned>(i));
    const BandProblems problems = planted::problems(before, kBands);
    const planted::Truth truth = planted::draw_truth(problems, random);
    const Experiment measured = planted::measured(problems, truth, before, random);
    const BandProblems known = planted::problems(measured, kBands);
    const BandPosterior posterior = band_posterior(known, random);
    const std::vector<RankedTrial> ranked = rank_trials(known, posterior, plan.trials);
    ASSERT_EQ(ranked.size(), plan.trials.size());
    // Each trial measured in turn on the truth.
    const auto entropy_after = [&](const RankedTrial& next) {
      Experiment one = before, more = measured;
      one.trials = {next.trial};
      std::mt19937 noise(777 + static_cast<unsigned>(i));
      more.trials.push_back(planted::measured(problems, truth, one, noise).trials.front());
      return band_posterior(planted::problems(more, kBands), noise).entropy;
    };
    best += entropy_after(ranked.front());
    worst += entropy_after(ranked.back());
    if (std::getenv("THENAR_TRIALS")) chance += entropy_after(ranked[random() % ranked.size()]);
    expected += posterior.entropy - ranked.front().information;
    EXPECT_LE(ranked.front().information, posterior.entropy + 1e-9);
    EXPECT_FALSE(ranked.front().most_informed_band.empty());
  }
  if (std::getenv("THENAR_TRIALS"))
    fmt::print("entropy after the best {:.3f} bit, expected {:.3f}, chance {:.3f}, worst {:.3f}\n",
               best / count, expected / count, chance / count, worst / count);
  EXPECT_LT(best, worst);
}

// What a reading tells of slack lengths, by the covariance before and after it.
TEST(RankTrials, CountsSlackByTheFallOfTheirCovariance) {
  const Experiment plan = planted::experiment();
  Experiment before = plan;
  before.trials = {plan.trials[0]};
  std::mt19937 random(5);
  const std::vector<std::string> bands{"triangular"};
  const BandProblems problems = planted::problems(before, bands);
  const planted::Truth truth{{true}, Eigen::VectorXd::Zero(problems.full_problem().size())};
  const Experiment measured = planted::measured(problems, truth, before, random);
  const BandProblems known = planted::problems(measured, bands);
  BandPosterior posterior = band_posterior(known, random);
  // One set alone, so that there is one covariance.
  posterior.sets.resize(1);
  posterior.sets[0].probability = 1;
  const std::vector<RankedTrial> ranked = rank_trials(known, posterior, {plan.trials[5]});
  EXPECT_NEAR(ranked[0].information, 0, 1e-9);
  // The same by the information matrix: of data so far, and with the trial at the same mode.
  const auto log2_det = [&](const Experiment& experiment) {
    const FitProblem problem =
        planted::problems(experiment, bands).problem_with(posterior.sets[0].bands);
    const Eigen::MatrixXd J =
        fit_residuals(problem, posterior.sets[0].evidence.z, WithJacobian::kYes).J;
    const Eigen::MatrixXd C = (J.transpose() * J).inverse();
    std::vector<int> slack;
    const std::vector<std::string> names = problem.coordinates().names();
    for (std::size_t i = 0; i < names.size(); ++i)
      if (matches_glob("*net/*/slack", names[i])) slack.push_back(static_cast<int>(i));
    return std::log2(Eigen::MatrixXd(C(slack, slack)).determinant());
  };
  Experiment more = measured;
  more.trials.push_back(plan.trials[5]);
  // Its noise is that of the force that is expected.
  const FitProblem at = known.problem_with(posterior.sets[0].bands);
  const Eigen::Matrix3Xd force =
      force_values(at.digit(), at.parameters(), plan_experiment(at.digit(), at.parameters(), more),
                   displacements(at.coordinates(), posterior.sets[0].evidence.z, 0));
  more.trials.back().force = force.col(1);
  EXPECT_NEAR(ranked[0].slack, 0.5 * (log2_det(measured) - log2_det(more)), 1e-6);
}

}  // namespace
}  // namespace thenar
