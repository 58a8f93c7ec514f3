#include "studies/thumb/thumb_calibration.h"

#include <algorithm>
#include <cmath>

#include "base/random_stream.h"
#include "posterior/hand_posterior.h"
#include "studies/thumb/thumb_fit.h"

namespace thenar {
namespace {

// Purpose of the random stream of readings
constexpr std::uint32_t kCalibrationReadingStream = 221;
constexpr unsigned kTruthSeedOffset = 7919;  // Offset of the seeds of truths from those of chains

/// A thumb from the prior and what a load cell read of it.
struct Simulation {
  Eigen::VectorXd truth;  // x (size)
  Experiment pulls;
};

Simulation simulate(const HandPosterior& prior, const Experiment& base, unsigned seed, int number) {
  // A thumb from the prior, and its forces.
  Simulation out{prior.draw_prior(seed + kTruthSeedOffset, static_cast<unsigned>(number)), base};
  const Eigen::MatrixXd forces = prior.forces(out.truth, 0);
  const double factor = prior.values(out.truth).noise(0, 0);
  // Read with noise of the stated sd times a factor from its prior.
  RandomStream random(seed, static_cast<std::uint32_t>(number), 0, kCalibrationReadingStream);
  for (std::size_t i = 0; i < base.trials.size(); ++i)
    for (int k = 0; k < 3; ++k)
      out.pulls.trials[i].force[k] = forces(3 * static_cast<Eigen::Index>(i) + k, 0) +
                                     factor * (*base.trials[i].sd)[k] * random.normal();
  return out;
}

/// Ranks of all entries of x, and of the log likelihood.
Eigen::VectorXi ranks_of(const Simulation& simulation, const PosteriorRun& run, int ranked) {
  // Ranks of the entries of x.
  const Draws& draws = run.draws;
  Eigen::VectorXi rank(draws.size() + 1);
  for (int i = 0; i < draws.size(); ++i)
    rank[i] = rank_of_truth(simulation.truth[i], draws.coordinate(i), ranked);
  // Rank of the log likelihood.
  Eigen::MatrixXd likelihood(draws.draws(), draws.chains());
  for (int c = 0; c < draws.chains(); ++c)
    for (long k = 0; k < draws.draws(); ++k)
      likelihood(k, c) =
          draws.stats[static_cast<std::size_t>(c)][static_cast<std::size_t>(k)].log_likelihood;
  const double truth =
      run.posterior->evaluate(simulation.truth, WithGradient::kNo).log_likelihood[0];
  rank[draws.size()] = rank_of_truth(truth, likelihood, ranked);
  return rank;
}

/// Coverage of the central 90 % by the share of each simulation; the last row is no parameter.
void judge(ThumbCalibration& out) {
  // Are the ranks uniform?
  const Eigen::Index runs = out.rank.cols();
  CalibrationOptions options;
  options.bins = std::min<int>(20, static_cast<int>(runs) / 5);
  out.judged = judge_calibration(out.names, out.rank, out.ranked, options);
  // Share of the truths within central 90 % intervals; runs are independent, parameters are not.
  const Eigen::ArrayXXd share =
      (out.rank.topRows(out.rank.rows() - 1).cast<double>().array() + 0.5) / (out.ranked + 1);
  const Eigen::ArrayXd within =
      ((share > 0.05) && (share < 0.95)).cast<double>().colwise().mean().transpose();
  out.covered = within.mean();
  out.covered_error =
      std::sqrt((within - out.covered).square().sum() / static_cast<double>(runs * (runs - 1)));
}

}  // namespace

ThumbCalibration calibrate_thumb(const ThumbStudyInputs& inputs,
                                 const ThumbCalibrationSettings& settings) {
  // Set up the sampling that all posteriors share.
  const SourceText& file = settings.thumb.skewed ? inputs.skewed : inputs.orthogonal;
  PosteriorSettings sampling;
  sampling.posterior = posterior_options(file);
  sampling.run.draws = settings.draws;
  sampling.run.sampler.warm_up = settings.warm_up;
  sampling.mode_starts = settings.mode_starts;

  // The protocol, its sds from the thumb at the start, and the prior of the fit.
  const TendonDigit start = internal::thumb_of(inputs.start);
  SimulatedPullOptions pulls;
  pulls.noise = settings.thumb.noise;
  pulls.postures = settings.thumb.postures;
  pulls.add_noise = false;
  internal::ThumbData data{start, start, simulate_pulls(start, pulls), {}};
  const Experiment base = data.pulls;
  const HandPosterior prior(build_problem(internal::thumb_fit_inputs(inputs, settings.thumb, data)),
                            sampling.posterior);

  // Simulate, sample and rank.
  ThumbCalibration out;
  out.ranked = settings.ranked;
  out.names = prior.names();
  out.names.emplace_back("log likelihood");
  out.rank.resize(prior.size() + 1, settings.simulations);
  int done = 0;
  for (; done < settings.simulations && !settings.progress.stop(); ++done) {
    settings.progress(static_cast<double>(done) / settings.simulations, "calibration");
    // A truth and its data.
    const Simulation simulation = simulate(prior, base, settings.seed, done);
    data.pulls = simulation.pulls;
    // Its posterior, and the truth's ranks among the draws.
    sampling.run.sampler.seed = settings.seed + static_cast<unsigned>(done);
    const PosteriorRun run = internal::sample_with_retries(
        internal::thumb_fit_inputs(inputs, settings.thumb, data), sampling, settings.retries);
    out.rank.col(done) = ranks_of(simulation, run, settings.ranked);
    if (!run.convergence.warnings.empty()) ++out.not_converged;
  }

  // Judged only where there are enough runs.
  out.rank.conservativeResize(Eigen::NoChange, done);
  if (done >= 20) judge(out);
  return out;
}

}  // namespace thenar
