#include "posterior/run/sample_posterior.h"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/error.h"
#include "base/provenance.h"
#include "posterior/run/agreed_work.h"
#include "posterior/run/assess_run.h"
#include "posterior/run/laplace.h"
#include "sampling/swap_temperatures.h"

namespace thenar {
namespace {

constexpr int kGlobalSearch = 60;  // coordinates [1]
constexpr double kInflation = 2;   // of the starts, in Laplace sds [1]

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
  // A global search without derivatives finds nothing among more coordinates than this.
  if (problem.size() > kGlobalSearch) search.global_searches = 0;
  search.also = Eigen::VectorXd::Zero(problem.size());
  search.seed = settings.run.sampler.seed;
  search.progress = settings.run.progress;
  search.polish.progress.stop_requested = settings.run.progress.stop_requested;
  return find_modes(least_squares(problem), search);
}

/// Entries at the end of x that are factors of noise and spread.
Eigen::Index count_factors(const HandPosterior& posterior) {
  const std::size_t noises =
      posterior.options().learn_noise ? posterior.problem().experiments().size() : 0;
  return static_cast<Eigen::Index>(noises + posterior.spread_kinds().size());
}

/// Points about the modes where the density is not zero (size, count).
Eigen::MatrixXd find_starts(const HandPosterior& posterior, const std::vector<Mode>& modes,
                            int count, unsigned seed) {
  const LeastSquares problem = least_squares(posterior.problem());
  Eigen::MatrixXd starts(posterior.size(), count);
  // A fit knows no factors of noise and spread: they begin where the prior has them.
  const Eigen::Index factors = count_factors(posterior);
  double inflation = kInflation;
  for (int found = 0, attempt = 0; found < count; ++attempt, inflation *= 0.7) {
    require(attempt < 20, "no start with a density above zero was found about {} modes",
            modes.size());
    const Eigen::MatrixXd z =
        dispersed_starts(problem, modes, count, inflation, seed + static_cast<unsigned>(attempt));
    for (int k = found; k < count; ++k) {
      Eigen::VectorXd x = posterior.from_fit(z.col(k));
      x.tail(factors) = posterior.draw_prior(seed, static_cast<unsigned>(k)).tail(factors);
      const Densities at = posterior.evaluate(x, WithGradient::kNo);
      if (!std::isfinite(at.log_prior[0] + at.log_likelihood[0])) break;
      starts.col(found++) = x;
    }
  }
  return starts;
}

/// Chains of one sampler, where nobody says how many: of an ensemble two for each entry, and two.
int least_walkers(SamplingMethod method, int n) {
  if (method == SamplingMethod::kStretchMove) return 2 * n + 2;
  return method == SamplingMethod::kDreamZs ? 3 : 1;
}

/// What run_chains() would refuse, said before the search rather than after it.
void check_chains(const RunOptions& options, int n) {
  (void)build_sampler(options.method, Eigen::MatrixXd::Zero(n, options.walkers), options.sampler);
  (void)temperature_ladder(options.temperatures, options.least_temper);
}

/// Where chains begin, and the first guess of how far they reach.
struct Beginning {
  Eigen::MatrixXd starts, covariance;
};

/// Finds the modes, unless asked to stop: half a search would give other starts than the whole one.
std::optional<Beginning> begin(PosteriorRun& run, const RunOptions& options) {
  FoundModes found = search_modes(run.posterior->problem(), run.settings);
  if (found.stopped || options.progress.stop()) return {};
  require(!found.modes.empty(), "no search from {} starts ended at a finite cost",
          found.searches.size());
  run.modes = std::move(found.modes);
  return Beginning{
      find_starts(*run.posterior, run.modes, options.groups * options.walkers,
                  options.sampler.seed),
      laplace_covariance(*run.posterior, run.posterior->from_fit(run.modes.front().z))};
}

/// What rank 0 has, on all ranks.
Eigen::MatrixXd shared_out(const Ranks& ranks, const Eigen::MatrixXd& mine, Eigen::Index rows) {
  return ranks.all_gather(ranks.rank() == 0 ? Eigen::VectorXd(mine.reshaped()) : Eigen::VectorXd())
      .reshaped(rows, Eigen::AutoSize);
}

}  // namespace

PosteriorOptions posterior_options(const SourceText& settings) {
  return posterior_options(parse_fit_settings(settings.text, settings.path).posterior);
}

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
  RunOptions options = settings.run;
  std::optional<Beginning> beginning;
  agreed_work(ranks, [&] {
    run.posterior =
        std::make_shared<const HandPosterior>(build_problem(inputs), settings.posterior);
    if (options.walkers == 0)
      options.walkers = least_walkers(options.method, run.posterior->size());
    check_chains(options, run.posterior->size());
    // The others need not search for what they are told.
    if (ranks.rank() == 0) beginning = begin(run, options);
  });
  const bool stopped = ranks.all_gather(Eigen::VectorXd::Constant(1, !beginning))[0] > 0;
  if (stopped) return run;
  if (!beginning) beginning.emplace();
  const Eigen::Index n = run.posterior->size();
  const Eigen::MatrixXd starts = shared_out(ranks, beginning->starts, n);
  options.sampler.covariance = shared_out(ranks, beginning->covariance, n);
  options.fingerprint = fingerprint(inputs, settings);
  run.draws = run_chains(*run.posterior, starts, options, ranks);
  agreed_work(ranks, [&] { assess_run(run); });
  return run;
}

PosteriorRun sample_posterior(const FitInputs& inputs, const PosteriorSettings& settings) {
  return sample_posterior(inputs, settings, *one_rank());
}

}  // namespace thenar
