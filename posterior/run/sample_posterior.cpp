#include "posterior/run/sample_posterior.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "base/error.h"
#include "base/provenance.h"
#include "kinematics_fit/fit_residuals.h"
#include "posterior/hand_posterior.h"
#include "posterior/run/posterior_quantities.h"
#include "posterior/run/predict_draws.h"
#include "sampling/methods/laplace_covariance.h"
#include "sampling/methods/parallel_tempering.h"
#include "sampling/run/communicator.h"

namespace thenar {
namespace {

// Maximum numbers of coordinates for a global search, and for the usual number of starts
constexpr int kGlobalSearch = 60, kManyCoordinates = 1000;
// Default numbers of starts of the mode search, and for many coordinates
constexpr int kUsualStarts = 16, kStartsOfMany = 4;
constexpr double kStartInflation = 2;  // inflation of the chains' starts [Laplace sds]

/// Returns a hash of everything that changes the density or the starts.
std::string fingerprint(const FitInputs& inputs, const PosteriorSettings& settings) {
  // Concatenate all texts, then the settings that change the density or the starts.
  std::string text = inputs.subject.text + '\n' + inputs.settings.text;
  for (const SourceText& source : inputs.experiments) text += '\n' + source.text;
  for (const std::string& free : inputs.also_free) text += '\n' + free;
  const PosteriorOptions& o = settings.posterior;
  text += fmt::format("\n{} {} {} {} {} {}", o.learn_noise, o.noise_sd, o.learn_specimen_scale,
                      o.specimen_scale_sd, o.sphere_priors, settings.mode_starts);
  return sha256(text);
}

FoundModes search_modes(const FitProblem& problem, const PosteriorSettings& settings) {
  // Add the prior means as a start.
  ModeSearchOptions search;
  search.starts = settings.mode_starts;
  // A derivative-free global search fails with more coordinates.
  if (problem.size() > kGlobalSearch) search.global_searches = 0;
  search.extra_starts = Eigen::VectorXd::Zero(problem.size());
  search.seed = settings.run.sampler.seed;
  search.progress = settings.run.progress;
  search.polish.progress.stop_requested = settings.run.progress.stop_requested;
  return find_modes(least_squares(problem), search);
}

/// Returns the number of factors of noise and between specimens, the last entries of x.
Eigen::Index count_factors(const HandPosterior& posterior) {
  const std::size_t noise_scales =
      posterior.options().learn_noise ? posterior.problem().experiments().size() : 0;
  return static_cast<Eigen::Index>(noise_scales + posterior.specimen_scale_kinds().size());
}

/// Finds points around the modes with nonzero density (size, count).
Eigen::MatrixXd find_starts(const HandPosterior& posterior, const std::vector<Mode>& modes,
                            int count, unsigned seed) {
  const LeastSquares problem = least_squares(posterior.problem());
  Eigen::MatrixXd starts(posterior.size(), count);
  // A fit has no factors of noise and between specimens: they start at draws from the prior.
  const Eigen::Index factors = count_factors(posterior);
  double inflation = kStartInflation;
  for (int found = 0, attempt = 0; found < count; ++attempt, inflation *= 0.7) {
    require(attempt < 20, "no start with a density above zero was found about {} modes",
            modes.size());
    // Draw points around the modes, closer at each attempt.
    const Eigen::MatrixXd z =
        dispersed_starts(problem, modes, count, inflation, seed + static_cast<unsigned>(attempt));
    for (int k = found; k < count; ++k) {
      // Keep points with positive density.
      Eigen::VectorXd x = posterior.from_fit_coordinates(z.col(k));
      x.tail(factors) = posterior.draw_prior(seed, static_cast<unsigned>(k)).tail(factors);
      const Densities at = posterior.evaluate(x, WithGradient::kNo);
      if (!std::isfinite(at.log_prior[0] + at.log_likelihood[0])) break;
      starts.col(found++) = x;
    }
  }
  return starts;
}

/// Returns the default number of chains of one sampler; for an ensemble two per entry, and two.
int min_walkers(SamplingMethod method, int n) {
  if (method == SamplingMethod::kStretchMove) return 2 * n + 2;
  return method == SamplingMethod::kDreamZs ? 3 : 1;
}

/// Checks before the search what run_chains() would refuse after it.
void check_chains(const RunOptions& options, int n) {
  (void)build_sampler(options.method, Eigen::MatrixXd::Zero(n, options.walkers), options.sampler);
  (void)temperature_ladder(options.temperatures, options.min_beta);
}

/// Starting points of chains, and the initial guess of their covariance.
struct Beginning {
  Eigen::MatrixXd starts, covariance;
};

/// Finds modes and starting points; nothing after a stop request, because an incomplete search
/// would give different starts.
std::optional<Beginning> begin(PosteriorRun& run, const RunOptions& options) {
  FoundModes found = search_modes(run.posterior->problem(), run.settings);
  if (found.status == Status::kStopped || options.progress.stop()) return {};
  require(!found.modes.empty(), "no search from {} starts ended at a finite cost",
          found.searches.size());
  run.modes = std::move(found.modes);
  return Beginning{
      find_starts(*run.posterior, run.modes, options.groups * options.walkers,
                  options.sampler.seed),
      laplace_covariance(*run.posterior, run.posterior->from_fit_coordinates(run.modes.front().z))};
}

/// Returns the matrix of rank 0 on all ranks.
Eigen::MatrixXd broadcast(const Communicator& ranks, const Eigen::MatrixXd& mine,
                          Eigen::Index rows) {
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
  if (!run.abandoned.empty())
    text += fmt::format(", at a target acceptance of {}, as trajectories diverged at {}",
                        options.sampler.target_acceptance, fmt::join(run.abandoned, " and "));
  return text + (run.draws.complete ? "" : "; stopped early");
}

Eigen::MatrixXd pooled(const Draws& draws) {
  Eigen::MatrixXd all(draws.size(), draws.chains() * draws.draws());
  for (int c = 0; c < draws.chains(); ++c)
    all.middleCols(c * draws.draws(), draws.draws()) = draws.x[c];
  return all;
}

Eigen::MatrixXd thinned(const Eigen::Ref<const Eigen::MatrixXd>& x, Eigen::Index max_count) {
  const Eigen::Index count = std::min(max_count, x.cols());
  Eigen::MatrixXd out(x.rows(), count);
  for (Eigen::Index k = 0; k < count; ++k) out.col(k) = x.col(k * x.cols() / count);
  return out;
}

PosteriorRun sample_posterior(const FitInputs& inputs, const PosteriorSettings& settings,
                              const Communicator& ranks) {
  // Build the posterior on every rank; search on the first only.
  PosteriorRun run;
  run.inputs = inputs;
  run.settings = settings;
  RunOptions options = settings.run;
  std::optional<Beginning> beginning;
  collective_call(ranks, [&] {
    // Infer the prior scales by a fit; a posterior with a net is refused anyway.
    if (!inputs.net) run.inputs = with_inferred_scales(inputs);
    run.posterior =
        std::make_shared<const HandPosterior>(build_problem(run.inputs), settings.posterior);
    if (options.walkers == 0) options.walkers = min_walkers(options.method, run.posterior->size());
    if (run.settings.mode_starts == 0)
      run.settings.mode_starts =
          run.posterior->problem().size() > kManyCoordinates ? kStartsOfMany : kUsualStarts;
    check_chains(options, run.posterior->size());
    // Only the first rank searches.
    if (ranks.rank() == 0) beginning = begin(run, options);
  });

  // Stop on all ranks, or broadcast the starts of the first.
  const bool stopped = ranks.all_gather(Eigen::VectorXd::Constant(1, beginning ? 0 : 1))[0] > 0;
  if (stopped) return run;
  if (!beginning) beginning.emplace();
  const Eigen::Index n = run.posterior->size();
  const Eigen::MatrixXd starts = broadcast(ranks, beginning->starts, n);
  options.sampler.covariance = broadcast(ranks, beginning->covariance, n);

  // Sample and assess the draws; draw more if that may help.
  options.fingerprint = fingerprint(run.inputs, run.settings);
  for (bool enough = false; !enough;) {
    RetriedDraws retried =
        retry_divergent(*run.posterior, starts, options, settings.retry_acceptances, ranks);
    run.draws = std::move(retried.draws);
    run.abandoned = std::move(retried.abandoned);
    run.settings.run.sampler.target_acceptance = retried.target_acceptance;
    run.settings.run.draws = options.draws;
    collective_call(ranks, [&] { assess_run(run); });

    // Only the first rank has draws to assess.
    const bool more = !options.folder.empty() && options.draws < settings.max_draws &&
                      run.draws.complete && run.convergence.draws_may_help;
    enough = ranks.all_gather(Eigen::VectorXd::Constant(1, more ? 1 : 0)).maxCoeff() == 0;
    if (!enough) options.draws = std::min(2 * options.draws, settings.max_draws);
  }
  return run;
}

PosteriorRun sample_posterior(const FitInputs& inputs, const PosteriorSettings& settings) {
  return sample_posterior(inputs, settings, *single_process());
}

namespace {

/// Estimates the forces of all fitted trials, of each specimen and of a new one [N].
std::vector<Estimate> force_estimates(const PosteriorRun& run) {
  const FitProblem& problem = run.posterior->problem();
  std::vector<Estimate> estimates;
  const auto add = [&](const Experiment& experiment, int specimen) {
    const Eigen::MatrixXd forces =
        predict_draws(run, experiment, specimen, run.draws.draws() * run.draws.chains()).expected;
    for (const auto& row : forces.rowwise())
      estimates.push_back(estimate(
          experiment.name, reshape_by_chain(row.transpose(), run.draws.chains()), run.draws.group));
  };
  for (const Experiment& experiment : problem.experiments()) {
    if (experiment.trials.empty()) continue;
    add(experiment, find_specimen(problem, experiment.specimen));
    if (problem.specimens().size() > 1) add(experiment, kUnfittedSpecimen);
  }
  return estimates;
}

}  // namespace

void assess_run(PosteriorRun& run) {
  if (run.draws.draws() == 0) return;
  // Assess convergence, if necessary by the answers only.
  ConvergenceLimits limits = run.settings.limits;
  limits.max_depth = run.settings.run.sampler.max_depth;
  run.convergence = assess(run.draws, run.posterior->names(), limits);
  if (run.convergence.draws_may_help) {
    const long groups = long(std::set<int>(run.draws.group.begin(), run.draws.group.end()).size());
    run.convergence = settled_by_answers(std::move(run.convergence), force_estimates(run),
                                         "forces of all fitted trials", groups, limits);
  }
  // Assign the draws to modes.
  std::vector<KnownMode> known;
  for (const Mode& mode : run.modes) {
    const Eigen::VectorXd centre = run.posterior->from_fit_coordinates(mode.z);
    known.push_back({centre, laplace_covariance(*run.posterior, centre), mode.laplace_mass});
  }
  run.mode_table = tabulate_modes(run.draws, known);
}

}  // namespace thenar
