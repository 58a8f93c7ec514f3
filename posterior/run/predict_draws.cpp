#include "posterior/run/predict_draws.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "sampling/random_stream.h"

namespace thenar {
namespace {

enum Purpose : std::uint32_t { kReplicate = 101, kStranger, kMeasure };

/// Columns evenly spread over all draws (size, columns).
Eigen::MatrixXd spread_columns(const Eigen::MatrixXd& all, long count) {
  const long kept = std::min<long>(count, all.cols());
  Eigen::MatrixXd x(all.rows(), kept);
  for (long k = 0; k < kept; ++k) x.col(k) = all.col(k * all.cols() / kept);
  return x;
}

/// Factor of the draw on the sd between specimens of each coordinate
/// (coordinates).
Eigen::VectorXd spread_of(const HandPosterior& posterior, const PosteriorValues& values,
                          Eigen::Index draw) {
  const FitParameters& parameters = posterior.problem().parameters();
  const std::vector<std::string> kinds = posterior.spread_kinds();
  Eigen::VectorXd factor = Eigen::VectorXd::Ones(parameters.coordinates());
  for (int c = 0; c < parameters.coordinates(); ++c) {
    const ParameterKind kind = parameters.all[static_cast<std::size_t>(parameters.leader[c])].kind;
    const auto found = std::find(kinds.begin(), kinds.end(), name_of(kind));
    if (found != kinds.end()) factor[c] = values.spread(found - kinds.begin(), draw);
  }
  return factor;
}

/// Displacements of one draw, a stranger's deviation and unknown postures drawn
/// (coordinates).
Eigen::VectorXd displaced(const PosteriorRun& run, const PosteriorValues& values,
                          const FitParameters& parameters, const Eigen::VectorXd& x,
                          Eigen::Index draw, int specimen) {
  const FitProblem& problem = run.posterior->problem();
  const int known = problem.parameters().coordinates();
  RandomStream random(run.settings.run.sampler.seed, static_cast<std::uint32_t>(draw), 0,
                      kStranger);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(parameters.coordinates());
  u.head(known) = problem.displacements(run.posterior->fit_coordinates(x), specimen);
  if (specimen < 0) {
    const Eigen::VectorXd sd = problem.unseen_variance().cwiseSqrt();
    const Eigen::VectorXd factor = spread_of(*run.posterior, values, draw);
    for (int c = 0; c < known; ++c) u[c] += factor[c] * sd[c] * random.normal();
  }
  for (int c = known; c < parameters.coordinates(); ++c)
    u[c] =
        parameters.all[static_cast<std::size_t>(parameters.leader[c])].between_sd * random.normal();
  return u;
}

/// The draw's factor on the noise of an experiment.
double noise_factor(const HandPosterior& posterior, const PosteriorValues& values,
                    const std::string& experiment, Eigen::Index draw) {
  const std::vector<Experiment>& fitted = posterior.problem().experiments();
  for (std::size_t e = 0; e < fitted.size(); ++e)
    if (fitted[e].name == experiment) return values.noise(static_cast<Eigen::Index>(e), draw);
  return std::exp(values.noise.col(draw).array().log().mean());
}

}  // namespace

PredictedDraws predict_draws(const PosteriorRun& run, const Experiment& experiment, int specimen,
                             long draws) {
  require(run.draws.draws() > 0, "the posterior has no draws to predict with");
  const HandPosterior& posterior = *run.posterior;
  const TendonDigit& digit = posterior.problem().digit();
  const FitParameters parameters =
      with_postures(posterior.problem().parameters(), experiment, digit.model.coordinates);
  const ExperimentPlan plan = plan_experiment(digit, parameters, experiment);
  const Eigen::MatrixXd x = spread_columns(pooled(run.draws), draws);
  const PosteriorValues values = posterior.values(x);

  Eigen::MatrixXd u(parameters.coordinates(), x.cols());
  for (Eigen::Index k = 0; k < x.cols(); ++k)
    u.col(k) = displaced(run, values, parameters, x.col(k), k, specimen);
  PredictedDraws out{experiment,
                     specimen < 0 ? "" : posterior.problem().specimens()[specimen],
                     ForceKernel(digit, parameters, plan).forces(u),
                     {}};
  out.replicated = out.expected;
  for (Eigen::Index k = 0; k < x.cols(); ++k) {
    RandomStream random(run.settings.run.sampler.seed, static_cast<std::uint32_t>(k), 0, kMeasure);
    const double factor = noise_factor(posterior, values, experiment.name, k);
    for (Eigen::Index i = 0; i < out.replicated.rows(); ++i)
      out.replicated(i, k) += factor * plan.sd.data()[i] * random.normal();
  }
  return out;
}

Prediction summarise(const PredictedDraws& predicted) {
  const auto draws = static_cast<double>(predicted.replicated.cols());
  const Eigen::VectorXd mean = predicted.expected.rowwise().mean();
  const Eigen::VectorXd centre = predicted.replicated.rowwise().mean();
  const Eigen::VectorXd sd =
      ((predicted.replicated.colwise() - centre).rowwise().squaredNorm() / (draws - 1)).cwiseSqrt();
  const Eigen::Index trials = mean.size() / 3;
  return compare(predicted.experiment, Eigen::Map<const Eigen::Matrix3Xd>(mean.data(), 3, trials),
                 Eigen::Map<const Eigen::Matrix3Xd>(sd.data(), 3, trials));
}

Eigen::MatrixXd replicated_forces(const HandPosterior& posterior, const Eigen::MatrixXd& x,
                                  unsigned seed) {
  const std::vector<ExperimentPlan>& plans = posterior.problem().plans();
  const PosteriorValues values = posterior.values(x);
  Eigen::Index rows = 0, first = 0;
  for (const ExperimentPlan& plan : plans) rows += plan.sd.size();
  Eigen::MatrixXd forces(rows, x.cols());
  for (std::size_t e = 0; e < plans.size(); ++e) {
    const Eigen::Index count = plans[e].sd.size();
    forces.middleRows(first, count) = posterior.forces(x, static_cast<int>(e));
    for (Eigen::Index k = 0; k < x.cols(); ++k) {
      RandomStream random(seed, static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(e),
                          kReplicate);
      const double factor = values.noise(static_cast<Eigen::Index>(e), k);
      for (Eigen::Index i = 0; i < count; ++i)
        forces(first + i, k) += factor * plans[e].sd.data()[i] * random.normal();
    }
    first += count;
  }
  return forces;
}

}  // namespace thenar
