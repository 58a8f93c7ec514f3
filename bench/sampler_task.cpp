#include "bench/sampler_task.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

#include "bench/sampler_rivals/adaptive_metropolis.h"
#include "bench/sampler_rivals/thumb_density.h"
#include "kinematics_fit/fit_residuals.h"
#include "sampling/diagnostics/convergence.h"
#include "sampling/methods/laplace_covariance.h"
#include "tests/posterior/thumb_scene.h"

namespace thenar::bench {
namespace {

constexpr double kGuessSd = 0.001;  // of the rival's first guess [prior sds]
constexpr long kThin = 10;  // steps of the rival between draws kept: its memory is 80 steps long

/// Draws of a chain (n, draws), entries of x, after its warm-up.
Eigen::MatrixXd sample(HaarioMetropolis& chain, const HandPosterior& posterior,
                       const RivalRun& options, TimedRun& run) {
  const double start = processor_seconds();
  while (chain.steps() < options.warm_up) chain.step();
  const double warm = processor_seconds();
  Eigen::MatrixXd draws(posterior.size(), options.steps / kThin);
  for (Eigen::Index k = 0; k < draws.cols(); ++k) {
    for (long i = 0; i < kThin; ++i) chain.step();
    draws.col(k) = chain.position();
  }
  run.warm_up += warm - start;
  run.sampling += processor_seconds() - warm;
  for (Eigen::Index k = 0; k < draws.cols(); ++k)
    draws.col(k) = posterior.from_fit_coordinates(draws.col(k).eval());
  return draws;
}

}  // namespace

HandPosterior thumb_posterior() {
  PosteriorOptions options;
  options.learn_noise = options.sphere_priors = false;
  return HandPosterior(sample::thumb_problem(), options);
}

double processor_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

Prepared prepare(const HandPosterior& posterior, int chains, unsigned seed) {
  const double start = processor_seconds();
  const LeastSquares problem = least_squares(posterior.problem());
  ModeSearchOptions search;
  search.extra_starts = Eigen::VectorXd::Zero(posterior.problem().size());
  search.seed = seed;
  Prepared out;
  out.modes = find_modes(problem, search).modes;
  out.covariance =
      laplace_covariance(posterior, posterior.from_fit_coordinates(out.modes.front().z));
  const Eigen::MatrixXd z = dispersed_starts(problem, out.modes, chains, 2, seed);
  out.starts.resize(posterior.size(), chains);
  for (int k = 0; k < chains; ++k) out.starts.col(k) = posterior.from_fit_coordinates(z.col(k));
  out.seconds = processor_seconds() - start;
  return out;
}

void judge(const std::vector<Eigen::MatrixXd>& chains, TimedRun& run) {
  const Eigen::Index n = chains.front().rows(), draws = chains.front().cols();
  const auto count = static_cast<Eigen::Index>(chains.size());
  run.mean.resize(n);
  run.sd.resize(n);
  run.ess = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < n; ++i) {
    Eigen::MatrixXd x(draws, count);
    for (Eigen::Index c = 0; c < count; ++c) x.col(c) = chains[static_cast<std::size_t>(c)].row(i);
    run.r_hat = std::max(run.r_hat, rank_r_hat(x));
    run.ess = std::min(run.ess, bulk_ess(x));
    run.mean[i] = x.mean();
    run.sd[i] = std::sqrt((x.array() - x.mean()).square().mean());
  }
}

TimedRun run_ours(const HandPosterior& posterior, RunOptions options) {
  const Prepared prepared =
      prepare(posterior, options.groups * options.walkers, options.sampler.seed);
  options.sampler.covariance = prepared.covariance;
  options.threads = 1;
  TimedRun run;
  run.before = prepared.seconds;
  const double start = processor_seconds();
  const auto warm_up = static_cast<double>(options.sampler.warm_up);
  options.progress.report = [&](double done, const std::string&) {
    const double share = warm_up / (warm_up + double(options.draws * options.thin));
    if (run.warm_up == 0 && done >= share) run.warm_up = processor_seconds() - start;
  };
  const Draws draws = run_chains(posterior, prepared.starts, options);
  run.sampling = processor_seconds() - start - run.warm_up;
  judge(draws.x, run);
  return run;
}

TimedRun run_metropolis(const HandPosterior& posterior, const RivalRun& options) {
  TimedRun run;
  const int n = posterior.size();
  const Prepared prepared = prepare(posterior, options.chains, options.seed);
  run.before = prepared.seconds;
  const Eigen::MatrixXd guess =
      options.told == Told::kAll
          ? prepared.modes.front().curvature->covariance()
          : Eigen::MatrixXd(kGuessSd * kGuessSd * Eigen::MatrixXd::Identity(n, n));
  ThumbDensity density(posterior.problem());
  std::vector<Eigen::MatrixXd> chains;
  for (int k = 0; k < options.chains; ++k) {
    HaarioMetropolis::Options own;
    own.seed = 1000 * options.seed + static_cast<unsigned>(k);
    HaarioMetropolis chain([&](const Eigen::VectorXd& z) { return density(z); },
                           posterior.fit_coordinates(prepared.starts.col(k)), guess, own);
    chains.push_back(sample(chain, posterior, options, run));
  }
  judge(chains, run);
  return run;
}

}  // namespace thenar::bench
