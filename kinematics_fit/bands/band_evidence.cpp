#include "kinematics_fit/bands/band_evidence.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Cholesky>

#include "base/numbers.h"
#include "kinematics_fit/covariance.h"
#include "kinematics_fit/fit_residuals.h"
#include "kinematics_fit/model/net_trials.h"
#include "kinematics_fit/specimen_prior.h"
#include "tendons/topology/net_forward_model.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Returns the upper triangular R with J'J = R'R (size, size).
MatrixXd factor_of(const Residuals& at) {
  return Eigen::LLT<MatrixXd>(at.J.transpose() * at.J).matrixU();
}

/// Returns the length of Newton's step at z, over coordinates that no bound blocks, in posterior
/// sds [1].
/// @param R  result of factor_of()
double newton_step_length(const FitProblem& problem, const VectorXd& z, const Residuals& at,
                          const MatrixXd& R) {
  VectorXd gradient = at.J.transpose() * at.r;
  for (Eigen::Index i = 0; i < z.size(); ++i)
    if ((z[i] <= problem.coordinates().lower()[i] && gradient[i] > 0) ||
        (z[i] >= problem.coordinates().upper()[i] && gradient[i] < 0))
      gradient[i] = 0;
  return R.triangularView<Eigen::Upper>().transpose().solve(gradient).norm();
}

/// Searches for the mode until the Newton step is short, with at most `slopes` Jacobians, which
/// take most of the time.
VectorXd find_mode(const FitProblem& problem, const VectorXd& start, int slopes) {
  // Length of a Newton step below which the search ends [posterior sds]
  constexpr double kLastStepLength = 0.1;
  // Count the Jacobians, and stop when the step is short or none is left.
  LeastSquares counted = least_squares(problem);
  int jacobians_left = slopes;
  counted.residuals = [&](const VectorXd& z, WithJacobian want) {
    Residuals at = fit_residuals(problem, z, want);
    if (want == WithJacobian::kNo) return at;
    const bool near =
        at.J.allFinite() && newton_step_length(problem, z, at, factor_of(at)) < kLastStepLength;
    jacobians_left = near ? 0 : jacobians_left - 1;
    return at;
  };
  SolveOptions search;
  search.progress.stop_requested = [&] { return jacobians_left <= 0; };
  return solve(counted, start, search).z;
}

/// Returns the equilibria of the net in all trials of the only experiment.
NetTrials trials_at(const FitProblem& problem, const VectorXd& z) {
  const VectorXd u = displacements(problem.coordinates(), z, problem.specimen_of(0));
  const SpecimenModel<double> model =
      specimen_model(problem.digit_of(problem.specimen_of(0)), problem.parameters(),
                     parameter_values<double>(problem.parameters(), u));
  return net_trials(model, problem.plans().front());
}

/// Draws standard normal numbers, each coordinate from a stream seeded by its name (size, draws).
MatrixXd named_draws(const FitProblem& problem, int draws, unsigned seed) {
  const std::vector<std::string> names = problem.coordinates().names();
  MatrixXd v(static_cast<Eigen::Index>(names.size()), draws);
  for (Eigen::Index i = 0; i < v.rows(); ++i) {
    std::vector<unsigned> words{seed};
    for (const char letter : names[i]) words.push_back(static_cast<unsigned char>(letter));
    std::seed_seq mixed(words.begin(), words.end());
    std::mt19937 random(mixed);
    std::normal_distribution<double> normal;
    for (int k = 0; k < draws; ++k) v(i, k) = normal(random);
  }
  return v;
}

/// Computes the log weight of each draw about the mode; -inf beyond a bound, or where forces are
/// not finite.
std::vector<double> log_weights(const FitProblem& problem, const VectorXd& z, const MatrixXd& R,
                                const EvidenceOptions& options) {
  const double at_mode = fit_residuals(problem, z, WithJacobian::kNo).r.squaredNorm();
  const MatrixXd v = named_draws(problem, (options.draws + 1) / 2, options.seed);
  const VectorXd &lower = problem.coordinates().lower(), &upper = problem.coordinates().upper();
  std::vector<double> weights;
  for (Eigen::Index k = 0; k < v.cols(); ++k)
    for (const double sign : {1.0, -1.0}) {
      const VectorXd there = z + sign * R.triangularView<Eigen::Upper>().solve(VectorXd(v.col(k)));
      double weight = -std::numeric_limits<double>::infinity();
      if ((there.array() >= lower.array()).all() && (there.array() <= upper.array()).all()) {
        const double cost = fit_residuals(problem, there, WithJacobian::kNo).r.squaredNorm();
        if (std::isfinite(cost)) weight = 0.5 * (at_mode - cost + v.col(k).squaredNorm());
      }
      weights.push_back(weight);
    }
  return weights;
}

/// Corrects the evidence by the mean weight, if the effective number of draws suffices.
void correct_by_draws(const std::vector<double>& log_weight, BandEvidence& out) {
  const double largest = *std::max_element(log_weight.begin(), log_weight.end());
  double sum = 0, squares = 0;
  for (const double each : log_weight) {
    const double w = std::isfinite(largest) ? std::exp(each - largest) : 0;
    sum += w;
    squares += w * w;
  }
  const auto n = static_cast<double>(log_weight.size());
  out.draws_left = sum > 0 ? sum * sum / (n * squares) : 0;
  out.by_draws = out.draws_left >= kFewDraws;
  if (out.by_draws) out.integral = out.laplace + largest + std::log(sum / n);
}

}  // namespace

bool carries_loads(const FitProblem& problem, const VectorXd& z) {
  const NetTrials found = trials_at(problem, z);
  return std::all_of(found.trials.begin(), found.trials.end(),
                     [&](const std::optional<NetTrial>& trial) {
                       return !trial || carries_loads(found.net, trial->rest);
                     });
}

std::vector<BandTension> largest_tensions(const FitProblem& problem, const VectorXd& z) {
  const NetTrials found = trials_at(problem, z);
  std::vector<BandTension> out;
  for (std::size_t b = 0; b < found.net.bands.size(); ++b) {
    if (found.net.bands[b].muscle >= 0) continue;
    out.push_back({found.net.bands[b].name, 0});
    for (const std::optional<NetTrial>& trial : found.trials)
      if (trial)
        out.back().tension =
            std::max(out.back().tension, trial->rest.tension(static_cast<Eigen::Index>(b)));
  }
  return out;
}

BandEvidence band_evidence(const FitProblem& problem, const std::vector<VectorXd>& starts,
                           const EvidenceOptions& options) {
  BandEvidence out;
  // Find the mode: the best of all starts.
  double min_cost = kInfinity;
  for (const VectorXd& start : starts) {
    if (!carries_loads(problem, start)) continue;
    const VectorXd z = find_mode(problem, start, options.slopes);
    const double cost = fit_residuals(problem, z, WithJacobian::kNo).r.squaredNorm();
    if (!(cost < min_cost) || !carries_loads(problem, z)) continue;
    min_cost = cost;
    out.z = z;
  }
  out.holds = std::isfinite(min_cost);
  if (!out.holds) return out;
  // Apply Laplace's approximation at the mode.
  const Residuals at = fit_residuals(problem, out.z, WithJacobian::kYes);
  const MatrixXd R = factor_of(at);
  const MatrixXd inverse =
      R.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(R.rows(), R.cols()));
  out.converged = newton_step_length(problem, out.z, at, R) < kSettledStep;
  out.misfit = at.r.head(data_rows(problem)).squaredNorm();
  out.effective = static_cast<double>(R.rows()) - inverse.squaredNorm();
  out.laplace = out.integral = -0.5 * at.r.squaredNorm() - R.diagonal().array().log().sum();
  // Correct it by draws.
  if (options.draws > 0) correct_by_draws(log_weights(problem, out.z, R, options), out);
  return out;
}

std::vector<std::pair<std::string, SlackRange>> slack_ranges(const FitProblem& problem,
                                                             const VectorXd& z) {
  const FitParameters& parameters = problem.parameters();
  const FitCoordinates& coordinates = problem.coordinates();
  const int specimen = problem.specimen_of(0);
  const VectorXd u = displacements(coordinates, z, specimen);
  const MatrixXd by_z = displacement_jacobian(coordinates, z, specimen);
  const std::vector<int> entries = coordinates.entries_of_specimen(specimen);
  const MatrixXd own = laplace_blocks(problem, z).block_entries(specimen);
  std::vector<std::pair<std::string, SlackRange>> out;
  // List the free slack lengths.
  for (std::size_t p = 0; p < parameters.all.size(); ++p) {
    const Parameter& parameter = parameters.all[p];
    const int c = parameters.coordinate[p];
    if (parameter.kind != ParameterKind::kNetSlack || c < 0) continue;
    // Convert the log factor on the length, and its sds before and after the data.
    const NetBand& band = problem.digit().net->net.bands[parameter.item];
    const double ratio = parameters.ratio[p];
    const Eigen::RowVectorXd slope = ratio * by_z.row(c);
    SlackRange range;
    range.length = band.slack * std::exp(parameter.mean + ratio * u[c]);
    range.sd = range.length * std::sqrt((slope * own).dot(slope));
    range.prior_sd = range.length * slope.norm();
    // Check whether an entry that moves it is at a bound.
    for (std::size_t k = 0; k < entries.size(); ++k)
      if (slope[k] != 0)
        range.at_bound = range.at_bound || z[entries[k]] <= coordinates.lower()[entries[k]] ||
                         z[entries[k]] >= coordinates.upper()[entries[k]];
    out.emplace_back(band.name, range);
  }
  return out;
}

}  // namespace thenar
