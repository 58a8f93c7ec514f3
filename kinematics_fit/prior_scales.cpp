#include "kinematics_fit/prior_scales.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <random>
#include <utility>

#include <Eigen/Cholesky>

#include "base/lists.h"
#include "kinematics_fit/fit_residuals.h"

namespace thenar {
namespace {

/// Preferred numbers of a decade, R10 of ISO 3: ten steps to the decade, in few digits [1].
constexpr std::array kPreferredNumbers{1.0, 1.25, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0};
constexpr int kStepsPerDecade = kPreferredNumbers.size();  // number of steps in a factor of 10
constexpr int kSmallestStep = -2 * kStepsPerDecade;        // step of the smallest factor, 0.01

/// Returns the preferred number that is `step` steps from 1.
double preferred(int step) {
  const int decade =
      step >= 0 ? step / kStepsPerDecade : -((kStepsPerDecade - 1 - step) / kStepsPerDecade);
  return kPreferredNumbers[step - decade * kStepsPerDecade] * std::pow(10.0, decade);
}

std::vector<double> factors_at(const std::vector<int>& steps) {
  return transformed(steps, [&](const int step) { return preferred(step); });
}

/// Returns the largest step whose factor is no more than `max_factor`.
int last_step(double max_factor) {
  int step = kSmallestStep;
  while (preferred(step + 1) <= max_factor * (1 + 1e-12)) ++step;
  return step;
}

/// Returns the step whose preferred number is nearest to a factor.
int nearest_step(double factor) {
  const int step = static_cast<int>(std::lround(kStepsPerDecade * std::log10(factor)));
  return std::max(step, kSmallestStep);
}

/// Log evidence of specimens as a function of the factors' steps.
class Evidence {
 public:
  Evidence(const std::vector<LinearForces>& specimens, const std::vector<ScaledPriors>& scales)
      : specimens_(specimens), scales_(scales) {}

  /// Returns the log evidence plus the log prior of the factors [nat].
  [[nodiscard]] double log_posterior(const std::vector<int>& steps, int noise_step) const {
    std::vector<double> factors;
    double belief = 0;
    for (std::size_t g = 0; g < scales_.size(); ++g) {
      factors.push_back(preferred(steps[g]));
      belief -= 0.5 * std::pow(std::log(factors[g] / scales_[g].likeliest) / scales_[g].spread, 2);
    }
    return belief + data_log_evidence(factors, preferred(noise_step));
  }

  /// Returns the log evidence of the forces, without the prior of the factors [nat].
  [[nodiscard]] double data_log_evidence(const std::vector<double>& factors,
                                         double noise = 1) const {
    double sum = 0;
    for (const LinearForces& one : specimens_) sum += log_evidence(one, factors, noise);
    return sum;
  }

  [[nodiscard]] std::size_t scales() const { return scales_.size(); }
  [[nodiscard]] int max_step(std::size_t scale) const { return last_step(scales_[scale].largest); }

  /// Returns initial steps: the likeliest factor of each scale, or `step` where the prior is flat.
  [[nodiscard]] std::vector<int> initial_steps(int step) const {
    std::vector<int> steps;
    for (std::size_t g = 0; g < scales_.size(); ++g)
      steps.push_back(
          std::min(std::isfinite(scales_[g].spread) ? nearest_step(scales_[g].likeliest) : step,
                   max_step(g)));
    return steps;
  }

 private:
  const std::vector<LinearForces>& specimens_;
  const std::vector<ScaledPriors>& scales_;
};

/// A maximum of the evidence.
struct EvidencePeak {
  std::vector<int> steps;  // steps of the factors
  int noise = 0;           // step of the noise factor
  double evidence = 0;     // [nat]
};

/// Range of steps of the noise factor; a single one fixes the noise.
struct NoiseRange {
  int first = 0, last = 0;
};

/// Maximizes the evidence from a start by coordinate ascent over all steps of each factor.
EvidencePeak climb(const Evidence& evidence, EvidencePeak from, NoiseRange noise = {}) {
  from.evidence = evidence.log_posterior(from.steps, from.noise);
  const std::size_t scales = from.steps.size();
  std::size_t since_change = 0;
  for (std::size_t g = 0; since_change <= scales; g = (g + 1) % (scales + 1)) {
    // Try all values of one factor, or of the noise.
    EvidencePeak best = from;
    const int first = g < scales ? kSmallestStep : noise.first;
    const int last = g < scales ? evidence.max_step(g) : noise.last;
    for (int step = first; step <= last; ++step) {
      EvidencePeak other = from;
      (g < scales ? other.steps[g] : other.noise) = step;
      other.evidence = evidence.log_posterior(other.steps, other.noise);
      if (other.evidence > best.evidence) best = std::move(other);
    }
    since_change = best.evidence > from.evidence ? 1 : since_change + 1;
    from = std::move(best);
  }
  return from;
}

/// Returns the higher of the maxima from two starts: wide priors with little noise, and narrow ones
/// with much.
EvidencePeak find_peak(const Evidence& evidence, NoiseRange noise = {}) {
  EvidencePeak wide = climb(evidence, {evidence.initial_steps(0), 0}, noise);
  EvidencePeak narrow =
      climb(evidence,
            {evidence.initial_steps(kSmallestStep), std::min(kStepsPerDecade, noise.last)}, noise);
  return wide.evidence >= narrow.evidence ? wide : narrow;
}

FitProblem with_factors(const FitProblem& problem, const std::vector<double>& factors) {
  return {problem.digit(),          with_scale_factors(problem.parameters(), factors),
          problem.experiments(),    problem.robust_scale(),
          problem.axis_distances(), problem.scaling()};
}

Solution fitted(const FitProblem& problem, const SolveOptions& options) {
  return solve(least_squares(problem), Eigen::VectorXd::Zero(problem.size()), options);
}

/// Refits by the requested method, from the solution of Ceres.
ScaledFit refit_by_method(ScaledFit fit, const SolveOptions& options) {
  if (options.method != LeastSquaresMethod::kCeres && fit.solution.status != Status::kStopped)
    fit.solution = solve(least_squares(fit.problem), fit.solution.z, options);
  return fit;
}

/// Converts z to other factors of the scales, so that displacements stay the same.
Eigen::VectorXd rescaled_entries(const FitProblem& from, Eigen::VectorXd z, const FitProblem& to) {
  const FitCoordinates& coordinates = from.coordinates();
  const std::vector<int> scale = scale_of_entries(coordinates);
  for (int specimen = 0; specimen < static_cast<int>(from.specimens().size()); ++specimen) {
    const std::vector<int> entries = coordinates.entries_of_specimen(specimen);
    const int first = specimen == 0 ? 0 : coordinates.population_entries();
    for (std::size_t k = static_cast<std::size_t>(first); k < entries.size(); ++k)
      if (scale[k] >= 0)
        z[entries[k]] *=
            from.parameters().scales[scale[k]].factor / to.parameters().scales[scale[k]].factor;
  }
  return z;
}

/// Returns the lowest minimum of rough fits from the prior means and from draws of the prior.
/// Narrow priors leave few ways out of a local minimum, such as axes tilted to the wrong side.
Eigen::VectorXd best_start(const FitProblem& problem, const SolveOptions& options) {
  constexpr int kMaxStartDraws =
      40;  // largest number of draws of the prior that are tried as starts
  SolveOptions rough = options;
  rough.max_evaluations = 40;
  rough.tolerance = 1e-4;
  const double numbers = measured_numbers(problem);
  const double chance_cost =
      0.5 * (numbers + 3 * std::sqrt(2 * numbers));  // largest cost that noise alone explains
  std::mt19937 rng(1);
  std::normal_distribution<double> normal;
  Solution best = fitted(problem, rough);
  // Try draws of the prior until a cost is explained by noise.
  for (int k = 0; k < kMaxStartDraws && best.cost > chance_cost && best.status != Status::kStopped;
       ++k) {
    const Eigen::VectorXd draw =
        Eigen::VectorXd::NullaryExpr(problem.size(), [&] { return normal(rng); });
    Solution other = solve(least_squares(problem), draw, rough);
    if (other.cost < best.cost) best = std::move(other);
  }
  return best.z;
}

/// Fit by some factors, and its evidence with the prior of the factors.
struct FittedScales {
  ScaledFit fit;
  std::vector<int> steps;
  double evidence = -HUGE_VAL;  // [nat]
};

/// Alternates fits by given factors and the choice of factors from their slopes, until these no
/// longer change.
/// @param z  initial point of the first fit, under these factors
FittedScales iterate_scales(const FitProblem& start, std::vector<int> steps,
                            const Eigen::VectorXd& z, const SolveOptions& options) {
  constexpr int kMaxChoiceRounds = 12;  // largest number of rounds
  FittedScales out{{start, solve(least_squares(start), z, options)}, std::move(steps)};
  for (int round = 1;; ++round) {
    if (out.fit.solution.status == Status::kStopped) return out;
    const std::vector<LinearForces> forces = linear_forces(out.fit.problem, out.fit.solution.z);
    const Evidence evidence(forces, start.parameters().scales);
    out.evidence = evidence.log_posterior(out.steps, 0);
    EvidencePeak peak = find_peak(evidence);
    out.fit.settled = peak.steps == out.steps;
    if (out.fit.settled || round == kMaxChoiceRounds) return out;
    // Continue from this fit with the new factors.
    out.steps = std::move(peak.steps);
    FitProblem next = with_factors(start, factors_at(out.steps));
    const Eigen::VectorXd from = rescaled_entries(out.fit.problem, out.fit.solution.z, next);
    out.fit.solution = solve(least_squares(next), from, options);
    out.fit.problem = std::move(next);
  }
}

}  // namespace

std::vector<int> scale_of_entries(const FitCoordinates& coordinates) {
  const FitParameters& parameters = coordinates.parameters();
  std::vector<int> scale(coordinates.population_entries() + coordinates.deviations(), -1);
  for (int c = 0; c < parameters.coordinates(); ++c) {
    const CoordinateEntries& coordinate = coordinates.entries(c);
    const int at = parameters.scale[parameters.leader[c]];
    if (coordinate.population >= 0) scale[coordinate.population] = at;
    if (coordinate.deviation >= 0) scale[coordinate.deviation] = at;
  }
  return scale;
}

std::vector<LinearForces> linear_forces(const FitProblem& problem, const Eigen::VectorXd& z) {
  const std::vector<ScaledPriors>& scales = problem.parameters().scales;
  const std::vector<int> scale = scale_of_entries(problem.coordinates());
  std::vector<LinearForces> all;
  for (int specimen = 0; specimen < static_cast<int>(problem.specimens().size()); ++specimen) {
    const Residuals data = specimen_residuals(problem, z, specimen);
    const Eigen::VectorXd own_z = z(problem.coordinates().entries_of_specimen(specimen));
    // Compute the covariances that the entries of each scale add, at a factor of 1.
    const auto covariance_of = [&](int wanted, double factor) -> Eigen::MatrixXd {
      std::vector<int> columns;
      for (std::size_t k = 0; k < scale.size(); ++k)
        if (scale[k] == wanted) columns.push_back(static_cast<int>(k));
      const Eigen::MatrixXd part = data.J(Eigen::all, columns) / factor;
      return part * part.transpose();
    };
    LinearForces one{data.J * own_z - data.r, covariance_of(-1, 1), {}};
    for (std::size_t g = 0; g < scales.size(); ++g)
      one.scaled.push_back(covariance_of(static_cast<int>(g), scales[g].factor));
    all.push_back(std::move(one));
  }
  return all;
}

double log_evidence(const LinearForces& forces, const std::vector<double>& factors, double noise) {
  Eigen::MatrixXd V = forces.unscaled;
  V.diagonal().array() += noise * noise;
  for (std::size_t g = 0; g < factors.size(); ++g) V += factors[g] * factors[g] * forces.scaled[g];
  const Eigen::LLT<Eigen::MatrixXd> factor(std::move(V));
  if (factor.info() != Eigen::Success) return -HUGE_VAL;
  return -0.5 * factor.matrixL().solve(forces.b).squaredNorm() -
         factor.matrixLLT().diagonal().array().log().sum();
}

namespace {

/// Computes the result of fit_with_scales(); its time is that of the last fit.
ScaledFit chosen_scales(const FitProblem& problem, const SolveOptions& options) {
  const std::vector<ScaledPriors>& scales = problem.parameters().scales;
  if (scales.empty()) return {problem, fitted(problem, options)};

  // Fit by the stated factors.
  SolveOptions rounds = options;
  rounds.method = LeastSquaresMethod::kCeres;
  const std::vector<double> ones(scales.size(), 1);
  ScaledFit out{with_factors(problem, ones), {}};
  out.solution = fitted(out.problem, rounds);
  if (out.solution.status == Status::kStopped) return out;
  const std::vector<LinearForces> forces = linear_forces(out.problem, out.solution.z);
  const Evidence stated(forces, scales);

  // Fit by inferred factors, starting from the stated fit.
  const std::vector<int> wide_steps = find_peak(stated).steps;
  const FitProblem wide = with_factors(problem, factors_at(wide_steps));
  FittedScales best =
      iterate_scales(wide, wide_steps, rescaled_entries(out.problem, out.solution.z, wide), rounds);
  out.gain = best.evidence - stated.data_log_evidence(ones);
  if (best.fit.solution.status == Status::kStopped || out.gain <= kScaleGain)
    return refit_by_method(std::move(out), options);
  // Fit again from the narrowest priors, and keep the fit of higher evidence.
  const std::vector<int> narrow_steps = stated.initial_steps(kSmallestStep);
  const FitProblem narrow = with_factors(problem, factors_at(narrow_steps));
  FittedScales other = iterate_scales(narrow, narrow_steps, best_start(narrow, rounds), rounds);
  if (other.fit.solution.status == Status::kStopped) return out;
  if (other.evidence > best.evidence) best = std::move(other);
  out = std::move(best.fit);
  out.gain = best.evidence - stated.data_log_evidence(ones);
  return refit_by_method(std::move(out), options);
}

}  // namespace

ScaledFit fit_with_scales(const FitProblem& problem, const SolveOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  ScaledFit out = chosen_scales(problem, options);
  out.solution.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return out;
}

std::vector<NoiseEvidence> noise_evidence(const FitProblem& problem, const Eigen::VectorXd& z) {
  // Steps of 1/2 to 100 times the stated noise
  constexpr NoiseRange kNoiseSteps{-3, 2 * kStepsPerDecade};
  std::vector<NoiseEvidence> all;
  for (const LinearForces& one : linear_forces(problem, z)) {
    const std::vector<LinearForces> alone{one};
    const Evidence evidence(alone, problem.parameters().scales);
    const EvidencePeak stated = find_peak(evidence), free = find_peak(evidence, kNoiseSteps);
    all.push_back({preferred(free.noise), free.evidence - stated.evidence});
  }
  return all;
}

}  // namespace thenar
