#include "posterior/run/sample_posterior.h"

#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "base/provenance.h"
#include "posterior/run/assess_run.h"
#include "posterior/run/laplace.h"

namespace thenar {
namespace {

constexpr double kInflation = 2;  // of the starts, in Laplace sds [1]

std::string fingerprint(const FitInputs& inputs, const PosteriorSettings& settings) {
  std::string text = inputs.subject.text + '\n' + inputs.settings.text;
  for (const SourceText& source : inputs.experiments) text += '\n' + source.text;
  for (const std::string& free : inputs.also_free) text += '\n' + free;
  const PosteriorOptions& o = settings.posterior;
  text += fmt::format("\n{} {} {} {} {} {}", o.learn_noise, o.noise_sd, o.learn_spread, o.spread_sd,
                      o.sphere_priors, settings.mode_starts);
  return sha256(text);
}

FoundModes search_modes(const FitProblem& problem, const PosteriorSettings& settings) {
  ModeSearch search;
  search.starts = settings.mode_starts;
  search.also = Eigen::VectorXd::Zero(problem.size());
  search.seed = settings.run.sampler.seed;
  search.progress = settings.run.progress;
  return find_modes(least_squares(problem), search);
}

/// Points about the modes where the density is not zero (size, count).
Eigen::MatrixXd find_starts(const HandPosterior& posterior, const std::vector<Mode>& modes,
                            int count, unsigned seed) {
  const LeastSquares problem = least_squares(posterior.problem());
  Eigen::MatrixXd starts(posterior.size(), count);
  double inflation = kInflation;
  for (int found = 0, attempt = 0; found < count; ++attempt, inflation *= 0.7) {
    require(attempt < 20, "no start with a density above zero was found about {} modes",
            modes.size());
    const Eigen::MatrixXd z =
        dispersed_starts(problem, modes, count, inflation, seed + static_cast<unsigned>(attempt));
    for (int k = found; k < count; ++k) {
      const Eigen::VectorXd x = posterior.from_fit(z.col(k));
      const Densities at = posterior.evaluate(x, WithGradient::kNo);
      if (!std::isfinite(at.log_prior[0] + at.log_likelihood[0])) break;
      starts.col(found++) = x;
    }
  }
  return starts;
}

/// As few chains as one sampler of the method can be made of.
int least_walkers(SamplingMethod method, int n) {
  if (method == SamplingMethod::kStretchMove) return 2 * n + 2;
  return method == SamplingMethod::kDreamZs ? 3 : 1;
}

}  // namespace

std::string describe_run(const PosteriorRun& run) {
  const RunOptions& options = run.settings.run;
  std::string text = fmt::format("{}: {} {} of {} draws after {} steps of warm-up, {:.1f} s",
                                 name_of(options.method), run.draws.chains(),
                                 run.draws.chains() == 1 ? "chain" : "chains", run.draws.draws(),
                                 run.draws.warm_up, run.draws.seconds);
  if (options.temperatures > 1) text += fmt::format(", {} temperatures", options.temperatures);
  return text + (run.draws.complete ? "" : "; stopped early");
}

Eigen::MatrixXd pooled(const Draws& draws) {
  Eigen::MatrixXd all(draws.size(), draws.chains() * draws.draws());
  for (int c = 0; c < draws.chains(); ++c)
    all.middleCols(c * draws.draws(), draws.draws()) = draws.x[static_cast<std::size_t>(c)];
  return all;
}

PosteriorRun sample_posterior(const FitInputs& inputs, const PosteriorSettings& settings,
                              const Ranks& ranks) {
  PosteriorRun run;
  run.inputs = inputs;
  run.settings = settings;
  run.posterior = std::make_shared<const HandPosterior>(build_problem(inputs), settings.posterior);
  FoundModes found = search_modes(run.posterior->problem(), settings);
  require(!found.modes.empty(), "no search from {} starts ended at a finite cost",
          found.searches.size());
  run.modes = std::move(found.modes);

  RunOptions options = settings.run;
  if (options.walkers == 0) options.walkers = least_walkers(options.method, run.posterior->size());
  options.sampler.covariance =
      laplace_covariance(*run.posterior, run.posterior->from_fit(run.modes.front().z));
  options.fingerprint = fingerprint(inputs, settings);
  run.draws = run_chains(*run.posterior,
                         find_starts(*run.posterior, run.modes, options.groups * options.walkers,
                                     options.sampler.seed),
                         options, ranks);
  assess_run(run);
  return run;
}

PosteriorRun sample_posterior(const FitInputs& inputs, const PosteriorSettings& settings) {
  return sample_posterior(inputs, settings, *one_rank());
}

}  // namespace thenar
