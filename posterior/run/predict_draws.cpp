#include "posterior/run/predict_draws.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/random_stream.h"
#include "kinematics_fit/model/shared_postures.h"
#include "kinematics_fit/predictive_moments.h"
#include "kinematics_fit/specimen_prior.h"
#include "posterior/force_density.h"
#include "posterior/hand_posterior.h"

namespace thenar {
namespace {

/// Purposes of random streams.
enum Purpose : std::uint32_t { kReplicate = 101, kNewSpecimen, kMeasure };

/// Returns the draw's factor on the sd between specimens of each coordinate (coordinates).
Eigen::VectorXd specimen_scale_of(const HandPosterior& posterior, const FitParameters& parameters,
                                  const PosteriorValues& values, Eigen::Index draw) {
  // Kinds without an inferred factor keep 1.
  const std::vector<std::string> kinds = posterior.specimen_scale_kinds();
  Eigen::VectorXd factor = Eigen::VectorXd::Ones(parameters.coordinates());
  for (int c = 0; c < parameters.coordinates(); ++c) {
    const ParameterKind kind = parameters.all[parameters.leader[c]].kind;
    const auto found = std::find(kinds.begin(), kinds.end(), name_of(kind));
    if (found != kinds.end()) factor[c] = values.specimen_scale(found - kinds.begin(), draw);
  }
  return factor;
}

/// Draws the deviation of a new specimen from the population [SI], until their sum is within the
/// bounds of the parameter.
double new_specimen(const Parameter& leader, double population, double sd, RandomStream& random) {
  // Maximum number of tries; bounds enclose the population, so that few are needed
  constexpr int kMaxTries = 1000;
  const double mean = leader.mean + population;
  double u = sd * random.normal();
  for (int k = 0; k < kMaxTries && !(leader.lower <= mean + u && mean + u <= leader.upper); ++k)
    u = sd * random.normal();
  return u;
}

/// Returns the displacements of one draw [SI] (coordinates); the deviation of a new specimen and
/// the errors of unknown postures are drawn from their priors.
Eigen::VectorXd displaced(const PosteriorRun& run, const PosteriorValues& values,
                          const FitParameters& parameters, const Eigen::VectorXd& x,
                          Eigen::Index draw, int specimen) {
  // Use a separate random stream for each draw.
  const FitProblem& problem = run.posterior->problem();
  const int known = problem.parameters().coordinates();
  RandomStream random(run.settings.run.sampler.seed, static_cast<std::uint32_t>(draw), 0,
                      kNewSpecimen);
  const Eigen::VectorXd factor = specimen_scale_of(*run.posterior, parameters, values, draw);
  const auto leader = [&](int c) -> const Parameter& {
    return parameters.all[parameters.leader[c]];
  };
  // Compute the population or specimen at this draw.
  Eigen::VectorXd u = Eigen::VectorXd::Zero(parameters.coordinates());
  u.head(known) = displacements(problem.coordinates(), run.posterior->fit_coordinates(x), specimen);
  // Add the deviation of a new specimen in the parameters that the posterior moves.
  const Eigen::VectorXd sd = unseen_variance(problem.coordinates()).cwiseSqrt();
  const std::vector<int> moving = run.posterior->moving_parameters();
  for (int c = 0; c < known && specimen < 0; ++c)
    if (std::binary_search(moving.begin(), moving.end(), parameters.leader[c]))
      u[c] += new_specimen(leader(c), u[c], factor[c] * sd[c], random);
  // Draw errors of unknown postures from their prior.
  for (int c = known; c < parameters.coordinates(); ++c)
    u[c] = factor[c] * leader(c).between_sd * random.normal();
  return u;
}

/// Returns the draw's factor on the noise of an experiment: its own if the experiment was fitted
/// with `specimen`, otherwise a new one from the prior, because experiments have independent
/// factors.
double noise_factor(const PosteriorRun& run, const PosteriorValues& values,
                    const std::string& experiment, int specimen, Eigen::Index draw,
                    RandomStream& random) {
  const std::vector<Experiment>& fitted = run.posterior->problem().experiments();
  for (std::size_t e = 0; e < fitted.size() && specimen >= 0; ++e)
    if (fitted[e].name == experiment) return values.noise(static_cast<Eigen::Index>(e), draw);
  const PosteriorOptions& options = run.posterior->options();
  return options.learn_noise ? std::exp(options.noise_sd * random.normal()) : 1;
}

/// Returns whether outliers dominate the mean of draws: their sd exceeds kMaxSdRatio times that of
/// the central 95 %, or the mean is kMaxSkewness of that from the median (Pearson's second
/// skewness).
bool has_long_tails(const Eigen::VectorXd& draws, double mean, const RobustMoments& middle) {
  // Largest ratio of the two sds: 1 for a normal, 1.07 for an exponential distribution [1]
  constexpr double kMaxSdRatio = 1.5;
  // Largest distance of the mean, in sds: 0 for a normal, 0.33 for an exponential distribution [1]
  constexpr double kMaxSkewness = 0.25;
  const double rounding = 1e-9 * std::abs(middle.median);  // rounding of equal numbers [N]
  const double sd = std::sqrt((draws.array() - mean).square().mean());
  return !(sd <= kMaxSdRatio * middle.sd + rounding &&
           std::abs(mean - middle.median) <= kMaxSkewness * middle.sd + rounding);
}

/// Variances of measured components [N^2] (3 trials): of the stated noise, and of the model error,
/// to which factors on the noise do not apply.
struct MeasuredVariance {
  Eigen::ArrayXd stated, missed;
};

/// Computes the variances of an experiment.
MeasuredVariance measured_variance(const ExperimentPlan& plan, const FitParameters& parameters,
                                   const Experiment& experiment) {
  MeasuredVariance out{plan.sd.reshaped().array().square(), Eigen::ArrayXd(plan.sd.size())};
  for (std::size_t i = 0; i < experiment.trials.size(); ++i)
    out.missed.segment<3>(3 * static_cast<Eigen::Index>(i)) =
        std::pow(missed_force_sd(parameters, experiment.trials[i].tension), 2);
  out.stated = (out.stated - out.missed).max(0);
  return out;
}

/// Adds measurement noise to the forces of each trial: normal or, for robust noise, Student's t,
/// whose components share one chi-square. Components that are not fitted stay 0.
void add_noise(const ForceNoise& noise, int components, const Eigen::VectorXd& sd,
               RandomStream& random, Eigen::Ref<Eigen::VectorXd> forces) {
  for (Eigen::Index trial = 0; trial < forces.size(); trial += 3) {
    const double scale =
        std::isinf(noise.c2) ? 1 : std::sqrt(noise.c2 / random.chi_square(noise.c2 - components));
    for (Eigen::Index i = trial; i < trial + components; ++i)
      forces[i] += scale * sd[i] * random.normal();
  }
}

}  // namespace

PredictedDraws predict_draws(const PosteriorRun& run, const Experiment& experiment, int specimen,
                             long draws) {
  require(run.draws.draws() > 0, "the posterior has no draws to predict with");
  // Prepare the experiment on the fitted digit, and select draws.
  const HandPosterior& posterior = *run.posterior;
  const TendonDigit& digit = posterior.problem().digit();
  const Experiment named = with_own_postures(experiment, posterior.problem().experiments());
  const FitParameters parameters = add_posture_errors(posterior.problem().parameters(), named);
  const ExperimentPlan plan = plan_experiment(digit, parameters, named);
  const Eigen::MatrixXd x = thinned(pooled(run.draws), draws);
  const PosteriorValues values = posterior.values(x);

  // Predict the expected forces of each draw.
  Eigen::MatrixXd u(parameters.coordinates(), x.cols());
  for (Eigen::Index k = 0; k < x.cols(); ++k)
    u.col(k) = displaced(run, values, parameters, x.col(k), k, specimen);
  PredictedDraws out{experiment,
                     specimen < 0 ? "" : posterior.problem().specimens()[specimen],
                     ForceKernel(digit, parameters, plan).forces(u),
                     {},
                     {},
                     calibrated_on_specimen(digit, experiment)};

  // Simulate repeated measurements by adding noise.
  out.replicated = out.expected;
  out.sd.resize(out.expected.rows(), out.expected.cols());
  const ForceNoise noise(posterior.problem().robust_scale());
  const MeasuredVariance measured = measured_variance(plan, parameters, experiment);
  for (Eigen::Index k = 0; k < x.cols(); ++k) {
    RandomStream random(run.settings.run.sampler.seed, static_cast<std::uint32_t>(k), 0, kMeasure);
    const double factor = noise_factor(run, values, experiment.name, specimen, k, random);
    out.sd.col(k) = (factor * factor * measured.stated + measured.missed).sqrt();
    add_noise(noise, plan.measured, out.sd.col(k), random, out.replicated.col(k));
  }
  return out;
}

Prediction summarise(const PredictedDraws& predicted) {
  // Compute means without noise, or medians if there are long tails; intervals include noise.
  Eigen::VectorXd centre = predicted.expected.rowwise().mean(), sd(centre.size());
  const Eigen::Index trials = centre.size() / 3;
  std::vector<bool> unsteady(static_cast<std::size_t>(trials));
  for (Eigen::Index i = 0; i < sd.size(); ++i) {
    const Eigen::VectorXd draws = predicted.expected.row(i);
    const RobustMoments middle = robust_moments(draws);
    if (has_long_tails(draws, centre[i], middle)) {
      centre[i] = middle.median;
      unsteady[i / 3] = true;
    }
    sd[i] = std::isinf(predicted.sd(i, 0)) ? predicted.sd(i, 0)
                                           : robust_moments(predicted.replicated.row(i)).sd;
  }
  Prediction out = compare_forces(
      predicted.experiment, Eigen::Map<const Eigen::Matrix3Xd>(centre.data(), 3, trials),
      Eigen::Map<const Eigen::Matrix3Xd>(sd.data(), 3, trials), predicted.calibrated_on_specimen);
  for (std::size_t i = 0; i < out.trials.size(); ++i) out.trials[i].by_draws = unsteady[i];
  return out;
}

Eigen::MatrixXd replicated_forces(const HandPosterior& posterior, const Eigen::MatrixXd& x,
                                  unsigned seed) {
  const std::vector<ExperimentPlan>& plans = posterior.problem().plans();
  const PosteriorValues values = posterior.values(x);
  const ForceNoise noise(posterior.problem().robust_scale());
  Eigen::Index rows = 0, first = 0;
  for (const ExperimentPlan& plan : plans) rows += plan.sd.size();
  Eigen::MatrixXd forces(rows, x.cols());
  for (std::size_t e = 0; e < plans.size(); ++e) {
    const Eigen::Index count = plans[e].sd.size();
    forces.middleRows(first, count) = posterior.forces(x, static_cast<int>(e));
    for (Eigen::Index k = 0; k < x.cols(); ++k) {
      RandomStream random(seed, static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(e),
                          kReplicate);
      add_noise(noise, plans[e].measured,
                values.noise(static_cast<Eigen::Index>(e), k) * plans[e].sd.reshaped(), random,
                forces.col(k).segment(first, count));
    }
    first += count;
  }
  return forces;
}

}  // namespace thenar
