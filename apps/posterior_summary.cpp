#include "apps/posterior_summary.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "apps/posterior_advice.h"
#include "base/error.h"
#include "posterior/run/posterior_summary.h"
#include "report/table.h"

namespace thenar {
namespace {

/// Quantities from the one that was learnt most about to the least, by sd over the prior's.
std::vector<std::size_t> sorted_by_sd(const PosteriorSummary& summary) {
  std::vector<double> left;
  for (std::size_t i = 0; i < summary.quantities.size(); ++i)
    left.push_back(summary.estimates[i].sd / prior_sd(summary.quantities[i]));
  std::vector<std::size_t> order(left.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return left[a] < left[b]; });
  return order;
}

void print_banner(const PosteriorRun& run) {
  if (run.convergence.warnings.empty()) return;
  const std::string line(78, '!');
  fmt::print("{}\n!! NOT CONVERGED: do not use these draws.\n", line);
  for (const std::string& reason : run.convergence.warnings) fmt::print("!!  * {}\n", reason);
  fmt::print("{}\n", line);
}

void print_figures(const PosteriorRun& run) {
  const Convergence& c = run.convergence;
  fmt::print(
      "{}\nworst R-hat {:.4f}, least ESS {:.0f} (bulk) and {:.0f} (tail), {} divergent, "
      "{} broken densities\n",
      describe_run(run), c.worst_r_hat, c.min_bulk_ess, c.min_tail_ess, c.divergent, c.non_finite);
  if (run.draws.swap_rate.size() > 0) {
    std::string rates;
    for (const double rate : run.draws.swap_rate.rowwise().mean())
      rates += fmt::format("{}{:.0f}", rates.empty() ? "" : ", ", 100 * rate);
    fmt::print("temperatures swap with the next hotter one in {} % of attempts\n", rates);
  }
}

void print_doubts(const std::string& about, const std::vector<std::string>& warnings) {
  for (const std::string& doubt : warnings) fmt::print("  ! {}: {}\n", about, doubt);
}

void print_checks(const PosteriorSummary& summary) {
  Table table{{"experiment", "rms_error_N", "relative", "within_50_pct", "within_80_pct",
               "within_95_pct", "chi_square", "numbers", "p"},
              {}};
  for (const auto& [prediction, check] : summary.experiments) {
    table.rows.push_back({prediction.experiment, shown(prediction.error.rms, 3),
                          shown(prediction.error.relative, 3)});
    for (const Coverage& coverage : check.coverage)
      table.rows.back().push_back(shown(100 * coverage.share, 0));
    for (const std::string& cell : {shown(check.mean_chi_square, 1),
                                    fmt::format("{}", check.rank_share.size()), shown(check.p, 3)})
      table.rows.back().push_back(cell);
  }
  fmt::print("{}", titled("forces as they would be measured again, beside those measured", table));
  for (const ExperimentCheck& experiment : summary.experiments)
    print_doubts(experiment.prediction.experiment, experiment.check.warnings);
  fmt::print("\n");
}

void print_left_out(const PosteriorSummary& summary) {
  if (!summary.left_out) return;
  const LeaveOneOut& loo = summary.left_out->result;
  fmt::print(
      "left out one by one (PSIS): elpd {:.1f} +- {:.1f}, {:.1f} effective parameters, "
      "{} of {} observations with k above {:.2f}\n",
      loo.elpd, loo.se, loo.effective_parameters, (loo.k.array() > loo.good_k).count(),
      loo.k.size(), loo.good_k);
  print_doubts("leave-one-out", loo.warnings);
  Eigen::Index worst;
  if (loo.k.maxCoeff(&worst) > loo.good_k)
    fmt::print("  ! number {} is {}\n", worst + 1,
               summary.left_out->observations[static_cast<std::size_t>(worst)]);
  fmt::print("\n");
}

void print_quantities(const PosteriorSummary& summary, std::size_t rows) {
  Table table{{"parameter", "unit", "mean", "sd", "prior_sd", "q05", "median", "q95", "mcse",
               "r_hat", "bulk_ess", "tail_ess"},
              {}};
  const std::vector<std::size_t> order = sorted_by_sd(summary);
  for (std::size_t k = 0; k < std::min(rows, order.size()); ++k) {
    const Estimate& e = summary.estimates[order[k]];
    const PosteriorQuantity& q = summary.quantities[order[k]];
    table.rows.push_back({q.name, q.unit, shown(e.mean), shown(e.sd), shown(prior_sd(q)),
                          shown(e.q05), shown(e.median), shown(e.q95), shown(e.mcse_mean),
                          shown(e.r_hat, 3), shown(e.bulk_ess, 0), shown(e.tail_ess, 0)});
  }
  fmt::print("{}",
             titled(fmt::format("learnt most ({} of {})", table.rows.size(), order.size()), table));
}

void print_directions(const PosteriorSummary& summary, std::size_t rows) {
  const LearntDirections& found = summary.directions;
  fmt::print("{} of {} directions are decided by the data, {:.1f} parameters in effect\n",
             found.decided, found.directions.size(), found.effective_parameters);
  for (std::size_t i = 0; i < std::min(rows, found.directions.size()); ++i)
    if (found.directions[i].sd_ratio < 1) fmt::print("  {}\n", found.directions[i].text);
  fmt::print("\n");
}

/// Masses by the draws beside those of Laplace's approximation before sampling.
void print_modes(const PosteriorRun& run) {
  Table table{{"mode", "mass", "mcse", "crossings", "cost", "searches", "laplace_mass"}, {}};
  for (const ModeMass& mode : run.mode_table.modes) {
    table.rows.push_back({fmt::format("{}", table.rows.size() + 1), shown(mode.mass, 3),
                          shown(mode.mcse, 3), fmt::format("{}", mode.crossings)});
    std::vector<std::string>& row = table.rows.back();
    if (mode.known < 0) {
      row.insert(row.end(), 3, "-");
      continue;
    }
    const Mode& found = run.modes[static_cast<std::size_t>(mode.known)];
    for (const std::string& cell :
         {shown(found.cost, 2), fmt::format("{}", found.hits), shown(found.laplace_mass, 3)})
      row.push_back(cell);
  }
  fmt::print("{}", titled("modes, by the draws in each and by the search before", table));
  print_doubts("modes", run.mode_table.warnings);
}

}  // namespace

void print_summary(const PosteriorRun& run, std::size_t rows) {
  const PosteriorSummary summary = summarise_posterior(run);
  print_banner(run);
  print_figures(run);
  print_doubts("warning", run.posterior->problem().warnings());
  fmt::print("\n");
  print_checks(summary);
  print_left_out(summary);
  print_quantities(summary, rows);
  print_directions(summary, std::min<std::size_t>(rows, 8));
  print_modes(run);
}

void require_converged(const PosteriorRun& run, bool allowed) {
  if (run.convergence.warnings.empty()) return;
  std::string text = "the chains have NOT converged; do not use these draws";
  if (!allowed) text += " (--allow-unconverged to exit without error)";
  text += ":";
  for (const std::string& reason : run.convergence.warnings) text += "\n  * " + reason;
  text += "\nWhat may help:";
  for (const std::string& sentence : advise(run)) text += "\n  * " + sentence;
  if (!allowed) throw Error(text);
  fmt::print(stderr, "thenar: warning: {}\n", text);
}

}  // namespace thenar
