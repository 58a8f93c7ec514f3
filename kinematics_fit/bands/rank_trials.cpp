#include "kinematics_fit/bands/rank_trials.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Cholesky>

#include "base/error.h"
#include "kinematics_fit/bands/band_problems.h"
#include "kinematics_fit/bands/expected_information.h"
#include "kinematics_fit/bands/net_records.h"
#include "kinematics_fit/covariance.h"
#include "kinematics_fit/force_jacobian.h"
#include "kinematics_fit/specimen_prior.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Predictions of all trials by one set of bands. Entries are those of z that move the specimen.
struct Forecast {
  Eigen::Matrix3Xd force;  // [N] (3, trials)
  MatrixXd J;              // Jacobian of the forces by the entries [N] (3 trials, entries)
  MatrixXd C;              // covariance of the entries (entries, entries)
  std::vector<int> slack;  // entries that move slack lengths
};

/// Returns the entries that move free slack lengths.
std::vector<int> slack_entries(const FitProblem& problem, const std::vector<int>& entries) {
  const FitParameters& parameters = problem.parameters();
  std::vector<int> found;
  for (std::size_t p = 0; p < parameters.all.size(); ++p) {
    const int c = parameters.coordinate[p];
    if (parameters.all[p].kind != ParameterKind::kNetSlack || c < 0) continue;
    const CoordinateEntries& coordinate = problem.coordinates().entries(c);
    for (std::size_t k = 0; k < entries.size(); ++k)
      if (entries[k] == coordinate.population || entries[k] == coordinate.deviation)
        found.push_back(static_cast<int>(k));
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

Forecast forecast_of(const FitProblem& problem, const VectorXd& z, const Experiment& pool) {
  const int specimen = problem.specimen_of(0);
  const TendonDigit& digit = problem.digit_of(specimen);
  const ExperimentPlan plan = plan_experiment(digit, problem.parameters(), pool);
  const ForceJacobian at = force_jacobian(digit, problem.parameters(), plan,
                                          displacements(problem.coordinates(), z, specimen));
  return {at.force, at.J * displacement_jacobian(problem.coordinates(), z, specimen),
          laplace_blocks(problem, z).block_entries(specimen),
          slack_entries(problem, problem.coordinates().entries_of_specimen(specimen))};
}

/// Returns the information in a reading of slope J and noise S about slack lengths: log2 det V /
/// det V|y over 2 [bit].
double slack_information(const Forecast& at, const MatrixXd& J, const MatrixXd& S) {
  if (at.slack.empty()) return 0;
  // Compute it in the space of readings: det V / det V|y = det(J C J' + S) / det(the same with
  // slack known).
  const MatrixXd JC = J * at.C;
  const MatrixXd before = JC * J.transpose() + S;
  const MatrixXd V = at.C(at.slack, at.slack);
  const MatrixXd cross = JC(Eigen::all, at.slack);
  const MatrixXd known = before - cross * V.llt().solve(cross.transpose());
  const auto log2_det = [](const MatrixXd& A) {
    return 2 * MatrixXd(A.llt().matrixL()).diagonal().array().log().sum() / std::log(2.0);
  };
  return 0.5 * (log2_det(before) - log2_det(known));
}

/// Returns the variance of each component of a future trial's force: noise and model error [N^2]
/// (3, trials).
Eigen::Matrix3Xd noise_variance(const BandProblems& problems, const Experiment& pool,
                                const Eigen::Matrix3Xd& force) {
  const FitParameters& parameters = problems.full_problem().parameters();
  Eigen::Matrix3Xd variance(3, force.cols());
  for (Eigen::Index i = 0; i < force.cols(); ++i) {
    Trial trial = pool.trials[i];
    trial.force = force.col(i);
    const double missed = missed_force_sd(parameters, trial.tension);
    variance.col(i) = force_sd(pool, trial).array().square() + missed * missed;
  }
  return variance;
}

/// Returns the questions about a posterior: which set, and of each band whether it exists.
std::vector<HypothesisAnswers> questions_of(const BandPosterior& posterior) {
  std::vector<HypothesisAnswers> questions(1 + posterior.bands.size());
  questions[0].resize(posterior.sets.size());
  std::iota(questions[0].begin(), questions[0].end(), 0);
  for (std::size_t b = 0; b < posterior.bands.size(); ++b)
    for (const BandSet& set : posterior.sets) questions[b + 1].push_back(set.bands[b] ? 1 : 0);
  return questions;
}

}  // namespace

std::vector<RankedTrial> rank_trials(const BandProblems& problems, const BandPosterior& posterior,
                                     const std::vector<Trial>& trials, const Progress& progress) {
  require(!posterior.sets.empty(), "no set of bands carries the loads: nothing to rank trials by");
  // Collect all trials in one experiment on the same rig.
  Experiment pool = problems.full_problem().experiments().front();
  pool.trials = trials;
  pool.activations.clear();
  // Predict the trials by every set, and the mean force, which determines the noise.
  std::vector<Forecast> forecasts;
  Eigen::Matrix3Xd mean = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(trials.size()));
  for (std::size_t k = 0; k < posterior.sets.size() && !(k > 0 && progress.stop()); ++k) {
    progress(static_cast<double>(k) / static_cast<double>(posterior.sets.size()), "next trials");
    const BandSet& set = posterior.sets[k];
    forecasts.push_back(forecast_of(problems.problem_with(set.bands), set.evidence.z, pool));
    mean += set.probability * forecasts.back().force;
  }
  if (forecasts.size() < posterior.sets.size()) return {};
  const Eigen::Matrix3Xd noise = noise_variance(problems, pool, mean);
  const std::vector<HypothesisAnswers> questions = questions_of(posterior);

  // Compute the information of each trial.
  std::vector<RankedTrial> ranked;
  const Eigen::Index rows = pool.components;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    const MatrixXd S = noise.col(column).head(rows).asDiagonal();
    RankedTrial out{trials[i], trial_name(problems.full_problem().digit(), trials[i]), 0, 0, {}, 0};
    // Predict the reading by every set, with the information about slack lengths.
    std::vector<PredictedReading> readings;
    for (std::size_t k = 0; k < forecasts.size(); ++k) {
      const Forecast& at = forecasts[k];
      const MatrixXd J = at.J.middleRows(3 * column, rows);
      const double p = posterior.sets[k].probability;
      readings.push_back({p, at.force.col(column).head(rows), J * at.C * J.transpose() + S});
      out.slack += p * slack_information(at, J, S);
    }
    // Find the information about sets, and the band about which the trial is most informative.
    const VectorXd bits = expected_information(readings, questions);
    out.information = bits(0);
    Eigen::Index best_band = 0;
    out.band_information = bits.tail(bits.size() - 1).maxCoeff(&best_band);
    if (out.band_information > 0) out.most_informed_band = posterior.bands[best_band].name;
    ranked.push_back(std::move(out));
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const RankedTrial& a, const RankedTrial& b) {
    return a.information != b.information ? a.information > b.information : a.slack > b.slack;
  });
  return ranked;
}

}  // namespace thenar
