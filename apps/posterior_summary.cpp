#include "apps/posterior_summary.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "apps/print_table.h"
#include "base/error.h"
#include "kinematics_fit/prediction.h"
#include "posterior/run/predict_draws.h"
#include "posterior/run/run_quantities.h"

namespace thenar {
namespace {

/// Quantities from the one that was learnt most about to the least, by sd over
/// the prior's.
std::vector<std::size_t> by_knowledge(const std::vector<ReadQuantity>& quantities,
                                      const std::vector<Estimate>& estimates) {
  std::vector<double> left;
  for (std::size_t i = 0; i < quantities.size(); ++i)
    left.push_back(estimates[i].sd / prior_sd(quantities[i]));
  std::vector<std::size_t> order(quantities.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return left[a] < left[b]; });
  return order;
}

void print_banner(const PosteriorRun& run) {
  if (run.convergence.reasons.empty()) return;
  const std::string line(78, '!');
  fmt::print("{}\n!! NOT CONVERGED: do not use these draws.\n", line);
  for (const std::string& reason : run.convergence.reasons) fmt::print("!!  * {}\n", reason);
  fmt::print("{}\n", line);
}

void print_quantities(const PosteriorRun& run, std::size_t rows) {
  const std::vector<ReadQuantity> quantities = read_quantities(run);
  const std::vector<Estimate> estimates = estimates_of(quantities, run.draws.group);
  Table table{{"parameter", "unit", "mean", "sd", "prior_sd", "q05", "median", "q95", "mcse",
               "r_hat", "bulk_ess", "tail_ess"},
              {}};
  const std::vector<std::size_t> order = by_knowledge(quantities, estimates);
  for (std::size_t k = 0; k < std::min(rows, order.size()); ++k) {
    const Estimate& e = estimates[order[k]];
    const ReadQuantity& q = quantities[order[k]];
    table.rows.push_back({q.name, q.unit, shown(e.mean), shown(e.sd), shown(prior_sd(q)),
                          shown(e.q05), shown(e.median), shown(e.q95), shown(e.mcse_mean),
                          shown(e.r_hat, 3), shown(e.bulk_ess, 0), shown(e.tail_ess, 0)});
  }
  print_table(fmt::format("learnt most ({} of {})", table.rows.size(), order.size()), table);
}

void print_modes(const PosteriorRun& run) {
  Table table{{"mode", "cost", "searches", "laplace_mass"}, {}};
  for (std::size_t m = 0; m < run.modes.size(); ++m)
    table.rows.push_back({fmt::format("{}", m + 1), shown(run.modes[m].cost, 2),
                          fmt::format("{}", run.modes[m].hits),
                          shown(run.modes[m].laplace_mass, 3)});
  print_table("modes found before sampling", table);
}

nlohmann::json estimate_json(const ReadQuantity& q, const Estimate& e) {
  return {{"name", q.name},          {"unit", q.unit},
          {"mean", e.mean},          {"sd", e.sd},
          {"prior_sd", prior_sd(q)}, {"mcse_mean", e.mcse_mean},
          {"mcse_sd", e.mcse_sd},    {"q05", e.q05},
          {"median", e.median},      {"q95", e.q95},
          {"r_hat", e.r_hat},        {"bulk_ess", e.bulk_ess},
          {"tail_ess", e.tail_ess}};
}

}  // namespace

nlohmann::json summary_json(const PosteriorRun& run) {
  const Convergence& c = run.convergence;
  nlohmann::json out{{"sampler", name_of(run.settings.run.method)},
                     {"chains", run.draws.chains()},
                     {"draws", run.draws.draws()},
                     {"warm_up", run.draws.warm_up},
                     {"complete", run.draws.complete},
                     {"seconds", run.draws.seconds},
                     {"converged", c.reasons.empty()},
                     {"reasons", c.reasons},
                     {"worst_r_hat", c.worst_r_hat},
                     {"least_bulk_ess", c.least_bulk_ess},
                     {"least_tail_ess", c.least_tail_ess},
                     {"divergent", c.divergent},
                     {"broken", c.broken}};
  const std::vector<ReadQuantity> quantities = read_quantities(run);
  const std::vector<Estimate> estimates = estimates_of(quantities, run.draws.group);
  for (std::size_t i = 0; i < quantities.size(); ++i)
    out["parameters"].push_back(estimate_json(quantities[i], estimates[i]));
  for (const Mode& mode : run.modes)
    out["modes"].push_back(
        {{"cost", mode.cost}, {"searches", mode.hits}, {"laplace_mass", mode.laplace_mass}});
  return out;
}

void print_summary(const PosteriorRun& run, std::size_t rows) {
  print_banner(run);
  fmt::print("{}\n", describe_run(run));
  const Convergence& c = run.convergence;
  fmt::print(
      "worst R-hat {:.4f}, least ESS {:.0f} (bulk) and {:.0f} (tail), "
      "{} divergent, "
      "{} broken densities\n",
      c.worst_r_hat, c.least_bulk_ess, c.least_tail_ess, c.divergent, c.broken);
  for (const Experiment& experiment : run.posterior->problem().experiments()) {
    const ForceError error =
        summarise(predict_draws(run, experiment,
                                find_specimen(run.posterior->problem(), experiment.specimen)))
            .error;
    fmt::print(
        "  {:<20} in sample: RMS error {:.3f} N, relative {:.3f}, "
        "{:.0f} % within 95 %\n",
        experiment.name, error.rms, error.relative, 100 * error.covered.value_or(0));
  }
  fmt::print("\n");
  print_quantities(run, rows);
  print_modes(run);
  print_banner(run);
}

void require_converged(const PosteriorRun& run, bool allowed) {
  if (run.convergence.reasons.empty() || allowed) return;
  std::string text =
      "the chains have NOT converged; the file holds them, but do not use them "
      "(--allow-unconverged to go on):";
  for (const std::string& reason : run.convergence.reasons) text += "\n  * " + reason;
  throw Error(text);
}

}  // namespace thenar
