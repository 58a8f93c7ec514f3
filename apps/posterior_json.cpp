#include <fmt/format.h>

#include "apps/posterior_advice.h"
#include "apps/posterior_summary.h"
#include "posterior/run/posterior_summary.h"
#include "report/json.h"

namespace thenar {
namespace {

Json vector_json(const Eigen::VectorXd& values) {
  return std::vector<double>(values.data(), values.data() + values.size());
}

Json convergence_json(const PosteriorRun& run) {
  const Convergence& c = run.convergence;
  return {{"sampler", name_of(run.settings.run.method)},
          {"chains", run.draws.chains()},
          {"draws", run.draws.draws()},
          {"warm_up", run.draws.warm_up},
          {"complete", run.draws.complete},
          {"seconds", run.draws.seconds},
          {"converged", c.warnings.empty()},
          {"reasons", c.warnings},
          {"advice", advise(run)},
          {"warnings", run.posterior->problem().warnings()},
          {"worst_r_hat", c.worst_r_hat},
          {"least_bulk_ess", c.min_bulk_ess},
          {"least_tail_ess", c.min_tail_ess},
          {"divergent", c.divergent},
          {"depth_limit", c.depth_limit},
          {"broken", c.non_finite},
          {"temper", vector_json(run.draws.beta)}};
}

Json estimate_json(const PosteriorQuantity& q, const Estimate& e) {
  return {{"name", q.name},          {"unit", q.unit},
          {"mean", e.mean},          {"sd", e.sd},
          {"prior_sd", prior_sd(q)}, {"mcse_mean", e.mcse_mean},
          {"mcse_sd", e.mcse_sd},    {"q05", e.q05},
          {"median", e.median},      {"q95", e.q95},
          {"r_hat", e.r_hat},        {"bulk_ess", e.bulk_ess},
          {"tail_ess", e.tail_ess}};
}

Json modes_json(const PosteriorRun& run) {
  Json out = Json::array();
  for (const ModeMass& mode : run.mode_table.modes) {
    out.push_back({{"mass", mode.mass},
                   {"mcse", mode.mcse},
                   {"crossings", mode.crossings},
                   {"visits", vector_json(mode.visits)}});
    if (mode.known < 0) continue;
    const Mode& found = run.modes[static_cast<std::size_t>(mode.known)];
    out.back()["cost"] = found.cost;
    out.back()["searches"] = found.hits;
    out.back()["laplace_mass"] = found.laplace_mass;
  }
  return out;
}

Json directions_json(const LearntDirections& found) {
  Json out{{"decided", found.decided},
           {"effective_parameters", found.effective_parameters},
           {"directions", Json::array()}};
  for (const LearntDirection& direction : found.directions)
    out["directions"].push_back({{"sd_ratio", direction.sd_ratio}, {"text", direction.text}});
  return out;
}

Json check_json(const ExperimentCheck& of) {
  Json out{{"experiment", of.prediction.experiment},
           {"rms_error_N", of.prediction.error.rms},
           {"relative_error", of.prediction.error.relative},
           {"chi_square", of.check.mean_chi_square},
           {"numbers", of.check.rank_share.size()},
           {"p", of.check.p},
           {"trial_p", vector_json(of.check.trial_p)},
           {"doubts", of.check.warnings},
           {"start_has_seen_specimen", of.prediction.calibrated_on_specimen}};
  for (const Coverage& coverage : of.check.coverage)
    out["coverage"].push_back(
        {{"level", coverage.level}, {"share", coverage.share}, {"error", coverage.error}});
  return out;
}

Json left_out_json(const LeftOutObservations& of) {
  Json out{{"elpd", of.result.elpd},
           {"se", of.result.se},
           {"effective_parameters", of.result.effective_parameters},
           {"good_k", of.result.good_k},
           {"above_good_k", (of.result.k.array() > of.result.good_k).count()},
           {"doubts", of.result.warnings},
           {"observations", Json::array()}};
  for (std::size_t i = 0; i < of.observations.size(); ++i)
    out["observations"].push_back({{"name", of.observations[i]},
                                   {"elpd", of.result.pointwise[static_cast<Eigen::Index>(i)]},
                                   {"k", of.result.k[static_cast<Eigen::Index>(i)]}});
  return out;
}

}  // namespace

Json summary_json(const PosteriorRun& run) {
  const PosteriorSummary summary = summarise_posterior(run);
  Json out = convergence_json(run);
  out["swap_rates"] = Json::array();  // of each group, coldest pair first
  for (const auto& group : run.draws.swap_rate.colwise())
    out["swap_rates"].push_back(vector_json(group));
  for (std::size_t i = 0; i < summary.quantities.size(); ++i)
    out["parameters"].push_back(estimate_json(summary.quantities[i], summary.estimates[i]));
  out["learnt"] = directions_json(summary.directions);
  for (const ExperimentCheck& experiment : summary.experiments)
    out["experiments"].push_back(check_json(experiment));
  if (summary.left_out) out["leave_one_out"] = left_out_json(*summary.left_out);
  out["modes"] = modes_json(run);
  out["mode_doubts"] = run.mode_table.warnings;
  return out;
}

}  // namespace thenar
