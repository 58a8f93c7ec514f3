#include "report/answers/posterior.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "posterior/hand_posterior.h"
#include "report/answers/prediction.h"
#include "report/parameter_words.h"
#include "report/sampling_advice.h"
#include "report/words.h"

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

std::string doubts_text(const std::string& about, const std::vector<std::string>& warnings) {
  std::string text;
  for (const std::string& doubt : warnings) text += fmt::format("  ! {}: {}\n", about, doubt);
  return text;
}

std::string banner_text(const PosteriorRun& run) {
  const Convergence& c = run.convergence;
  // Start with agreement, cautions, or a prominent frame.
  if (c.warnings.empty() && c.cautions.empty())
    return run.draws.complete ? "converged: the chains agree\n" : "";
  if (c.warnings.empty()) return doubts_text("converged, with a caution", c.cautions);
  const std::string line(78, '!');
  std::string text = line + "\n!! NOT CONVERGED: do not use these draws.\n";
  for (const std::string& reason : run.convergence.warnings)
    text += fmt::format("!!  * {}\n", reason);
  return text + line + "\n";
}

/// "the chains have NOT converged; do not use these draws:" and the reasons; "" if they have.
std::string unconverged_words(const PosteriorRun& run) {
  if (run.convergence.warnings.empty()) return "";
  std::string text = "the chains have NOT converged; do not use these draws:";
  for (const std::string& reason : run.convergence.warnings) text += "\n  * " + reason;
  return text;
}

std::string figures_text(const PosteriorRun& run) {
  const Convergence& c = run.convergence;
  std::string text = fmt::format(
      "{}\nworst R-hat {:.4f}, least ESS {:.0f} (bulk) and {:.0f} (tail), {} divergent, "
      "{} broken densities\n",
      describe_run(run), c.worst_r_hat, c.min_bulk_ess, c.min_tail_ess, c.divergent, c.non_finite);
  // Rates of swaps between temperatures, where there are several.
  if (run.draws.swap_rate.size() > 0) {
    const Eigen::VectorXd rates = run.draws.swap_rate.rowwise().mean();
    text += fmt::format(
        "temperatures swap with the next hotter one in {} % of attempts\n",
        each_in_words(rates, [](double rate) { return fmt::format("{:.0f}", 100 * rate); }));
  }
  return text;
}

std::string checks_text(const PosteriorSummary& summary) {
  Table table{{"experiment", "rms_error_N", "relative", "within_50_pct", "within_80_pct",
               "within_95_pct", "chi_square", "numbers", "p"}};
  for (const auto& [prediction, check] : summary.experiments) {
    const auto percent = [](const Coverage& each) { return shown(100 * each.share, 0); };
    table.add_parts({{prediction.experiment, shown(prediction.error.rms, 3),
                      shown(prediction.error.relative, 3)},
                     transformed(check.coverage, percent),
                     {shown(check.mean_chi_square, 1), std::to_string(check.rank_share.size()),
                      shown(check.p, 3)}});
  }
  std::string text = titled("forces as they would be measured again, beside those measured", table);
  for (const ExperimentCheck& experiment : summary.experiments)
    text += doubts_text(experiment.prediction.experiment, experiment.check.warnings);
  return text + "\n";
}

std::string left_out_text(const PosteriorSummary& summary) {
  if (!summary.left_out) return "";
  const LeaveOneOut& loo = summary.left_out->result;
  // Expected log predictive density; k above its limit means that the weights fail.
  std::string text = fmt::format(
      "left out one by one (PSIS): elpd {:.1f} +- {:.1f}, {:.1f} effective parameters, "
      "{} of {} observations with k above {:.2f}\n",
      loo.elpd, loo.se, loo.effective_parameters, (loo.k.array() > loo.good_k).count(),
      loo.k.size(), loo.good_k);
  text += doubts_text("leave-one-out", loo.warnings);
  Eigen::Index worst;
  if (loo.k.maxCoeff(&worst) > loo.good_k)
    text +=
        fmt::format("  ! number {} is {}\n", worst + 1, nth(summary.left_out->observations, worst));
  return text + "\n";
}

std::string quantities_text(const PosteriorResult& result) {
  const PosteriorSummary& summary = *result.summary;
  Table table{{"parameter", "unit", "mean", "sd", "prior_sd", "q05", "median", "q95", "mcse",
               "r_hat", "bulk_ess", "tail_ess", "meaning"}};
  const std::vector<std::size_t> order = sorted_by_sd(summary);
  for (std::size_t k = 0; k < std::min(result.rows, order.size()); ++k) {
    const Estimate& e = summary.estimates[order[k]];
    const PosteriorQuantity& q = summary.quantities[order[k]];
    table.add({q.name, q.unit, shown(e.mean), shown(e.sd), shown(prior_sd(q)), shown(e.q05),
               shown(e.median), shown(e.q95), shown(e.mcse_mean), shown(e.r_hat, 3),
               shown(e.bulk_ess, 0), shown(e.tail_ess, 0),
               meaning_of(q.name, result.run.posterior->problem().digit())});
  }
  return titled(
      fmt::format("best-determined parameters ({} of {})", table.rows.size(), order.size()), table);
}

/// "the MCP abduction axis lies distal of the MCP flexion axis".
std::string distal_words(const PosteriorAxes& of, const TendonDigit& digit) {
  const auto axis = [&](int hinge) {
    return joint_words(nth(digit.names.hinges, hinge)) + " axis";
  };
  return fmt::format("the {} lies distal of the {}", axis(of.axes.second), axis(of.axes.first));
}

std::string axes_text(const PosteriorResult& result) {
  const PosteriorSummary& summary = *result.summary;
  if (summary.axes.empty()) return "";
  Table table{{"axes", "angle_deg", "q05", "q95", "distance_mm", "q05", "q95", "second_distal_mm",
               "q05", "q95", "p_second_distal", "prior_p"}};
  for (const PosteriorAxes& of : summary.axes) {
    table.add({of.whose.empty() ? of.axes.name : of.whose + ": " + of.axes.name});
    for (const Estimate* e : {&of.angle, &of.distance, &of.beyond})
      for (const double value : {e->mean, e->q05, e->q95})
        table.rows.back().push_back(shown(value, 2));
    for (const double p : {of.second_distal, of.second_distal_prior})
      table.rows.back().push_back(shown(p, 3));
  }
  return titled(
      "neighbouring axes at the reference posture: angle, length of the common normal, how far it "
      "leads distally from the first axis to the second, and the probability that it does",
      table);
}

std::string directions_text(const PosteriorSummary& summary, std::size_t rows) {
  const LearntDirections& found = summary.directions;
  std::string text =
      fmt::format("{} of {} directions are decided by the data, {:.1f} parameters in effect\n",
                  found.decided, found.directions.size(), found.effective_parameters);
  for (std::size_t i = 0; i < std::min(rows, found.directions.size()); ++i)
    if (found.directions[i].sd_ratio < 1) text += fmt::format("  {}\n", found.directions[i].text);
  return text + "\n";
}

/// Masses by the draws beside those of Laplace's approximation before sampling.
std::string modes_text(const PosteriorRun& run) {
  Table table{{"mode", "mass", "mcse", "crossings", "cost", "searches", "laplace_mass"}};
  for (const ModeMass& mode : run.mode_table.modes) {
    std::vector<std::string> search(3, "-");
    if (mode.known >= 0) {
      const Mode& found = nth(run.modes, mode.known);
      search = {shown(found.cost, 2), fmt::format("{}", found.hits), shown(found.laplace_mass, 3)};
    }
    table.add_parts({{fmt::format("{}", table.rows.size() + 1), shown(mode.mass, 3),
                      shown(mode.mcse, 3), fmt::format("{}", mode.crossings)},
                     search});
  }
  return titled("modes, by the draws in each and by the search before", table) +
         doubts_text("modes", run.mode_table.warnings);
}

// As fields.

std::vector<std::string> advice_lines(const PosteriorRun& run) {
  return transformed(advise(run), [](const SamplingAdvice& one) {
    return one.command.empty() ? one.remedy : one.remedy + ": " + one.command;
  });
}

/// Returns warnings about the inputs, and about noise that the draws found to be far larger than
/// stated.
std::vector<std::string> all_warnings(const PosteriorResult& result) {
  std::vector<std::string> warnings = result.run.posterior->problem().warnings();
  for (std::string& warning : noise_cautions(result)) warnings.push_back(std::move(warning));
  return warnings;
}

Fields convergence_fields(const PosteriorRun& run) {
  const Convergence& c = run.convergence;
  return {{"sampler", name_of(run.settings.run.method)},
          {"chains", run.draws.chains()},
          {"draws", run.draws.draws()},
          {"warm_up", run.draws.warm_up},
          {"complete", run.draws.complete},
          {"seconds", units::kMeasuredSeconds, run.draws.seconds},
          {"target_acceptance", run.settings.run.sampler.target_acceptance},
          {"abandoned_target_acceptances", run.abandoned},
          {"converged", c.warnings.empty()},
          {"reasons", c.warnings},
          {"cautions", c.cautions},
          {"unsettled", c.unsettled},
          {"advice", advice_lines(run)},
          {"worst_r_hat", c.worst_r_hat},
          {"least_bulk_ess", c.min_bulk_ess},
          {"least_tail_ess", c.min_tail_ess},
          {"divergent", c.divergent},
          {"depth_limit", c.depth_limit},
          {"broken", c.non_finite},
          {"temper", units::kOne, run.draws.beta}};
}

Fields estimate_fields(const PosteriorQuantity& q, const Estimate& e, const std::string& meaning) {
  return {{"name", q.name},
          {"meaning", meaning},
          {"unit", q.unit},
          {"mean", e.mean},
          {"sd", e.sd},
          {"prior_sd", prior_sd(q)},
          {"mcse_mean", e.mcse_mean},
          {"mcse_sd", e.mcse_sd},
          {"q05", e.q05},
          {"median", e.median},
          {"q95", e.q95},
          {"r_hat", e.r_hat},
          {"bulk_ess", e.bulk_ess},
          {"tail_ess", e.tail_ess}};
}

/// An estimate whose key has the unit of its values.
/// @param e  in the printed unit
Field offset_field(std::string key, const FieldUnit& unit, const Estimate& e) {
  const FieldUnit inner{"", "", unit.numerator, unit.denominator};
  const double si = unit.denominator / unit.numerator;
  Field field(std::move(key), Fields{{"mean", inner, e.mean * si},
                                     {"sd", inner, e.sd * si},
                                     {"q05", inner, e.q05 * si},
                                     {"median", inner, e.median * si},
                                     {"q95", inner, e.q95 * si},
                                     {"bulk_ess", e.bulk_ess},
                                     {"r_hat", e.r_hat}});
  field.unit = unit;
  return field;
}

std::vector<Fields> axes_fields(const PosteriorResult& result) {
  return fields_of_each(result.summary->axes, [&](const PosteriorAxes& of) {
    Fields fields{{"axes", of.axes.name},
                  {"meaning", distal_words(of, result.run.posterior->problem().digit())},
                  {"second_distal_probability", of.second_distal},
                  {"second_distal_prior_probability", of.second_distal_prior},
                  offset_field("angle", units::kDegree, of.angle),
                  offset_field("distance", units::kMillimetre, of.distance),
                  offset_field("second_distal", units::kMillimetre, of.beyond)};
    if (!of.whose.empty()) fields.add("specimen", of.whose);
    return fields;
  });
}

std::vector<Fields> modes_fields(const PosteriorRun& run) {
  return fields_of_each(run.mode_table.modes, [&](const ModeMass& mode) {
    Fields fields{{"mass", mode.mass},
                  {"mcse", mode.mcse},
                  {"crossings", mode.crossings},
                  {"visits", units::kOne, mode.visits}};
    if (mode.known < 0) return fields;
    const Mode& found = nth(run.modes, mode.known);
    fields.append(
        {{"cost", found.cost}, {"searches", found.hits}, {"laplace_mass", found.laplace_mass}});
    return fields;
  });
}

Fields direction_fields(const LearntDirections& found) {
  return {{"decided", found.decided},
          {"effective_parameters", found.effective_parameters},
          {"directions", fields_of_each(found.directions, [](const LearntDirection& each) {
             return Fields{{"sd_ratio", each.sd_ratio}, {"text", each.text}};
           })}};
}

Fields check_fields(const ExperimentCheck& of) {
  Fields fields{{"experiment", of.prediction.experiment},
                {"rms_error", units::kNewton, of.prediction.error.rms},
                {"relative_error", of.prediction.error.relative},
                {"chi_square", of.check.mean_chi_square},
                {"numbers", of.check.rank_share.size()},
                {"p", of.check.p},
                {"trial_p", units::kOne, of.check.trial_p},
                {"doubts", of.check.warnings},
                {"start_has_seen_specimen", of.prediction.calibrated_on_specimen}};
  fields.add_some(
      "coverage", fields_of_each(of.check.coverage, [](const Coverage& each) {
        return Fields{{"level", each.level}, {"share", each.share}, {"error", each.error}};
      }));
  return fields;
}

Fields left_out_fields(const LeftOutObservations& of) {
  std::vector<Fields> list;
  for (std::size_t i = 0; i < of.observations.size(); ++i)
    list.push_back({{"name", of.observations[i]},
                    {"elpd", of.result.pointwise[static_cast<Eigen::Index>(i)]},
                    {"k", of.result.k[static_cast<Eigen::Index>(i)]}});
  return {{"elpd", of.result.elpd},
          {"se", of.result.se},
          {"effective_parameters", of.result.effective_parameters},
          {"good_k", of.result.good_k},
          {"above_good_k", (of.result.k.array() > of.result.good_k).count()},
          {"doubts", of.result.warnings},
          {"observations", std::move(list)}};
}

/// Adds what a summary has besides the run.
void add_summary(const PosteriorResult& result, Fields& fields) {
  const PosteriorSummary& summary = *result.summary;
  const TendonDigit& digit = result.run.posterior->problem().digit();
  std::vector<Fields> parameters;
  for (std::size_t i = 0; i < summary.quantities.size(); ++i)
    parameters.push_back(estimate_fields(summary.quantities[i], summary.estimates[i],
                                         meaning_of(summary.quantities[i].name, digit)));
  fields.add_some("parameters", std::move(parameters));
  fields.add("axes", axes_fields(result));
  fields.add("learnt", direction_fields(summary.directions));
  fields.add_some("experiments", fields_of_each(summary.experiments, check_fields));
  if (summary.left_out) fields.add("leave_one_out", left_out_fields(*summary.left_out));
}

}  // namespace

std::string text_of(const PosteriorResult& result) {
  const PosteriorRun& run = result.run;
  std::string text =
      banner_text(run) + figures_text(run) + doubts_text("warning", all_warnings(result)) + "\n";
  if (!result.summary) return text;
  const PosteriorSummary& summary = *result.summary;
  return text + checks_text(summary) + left_out_text(summary) + quantities_text(result) +
         axes_text(result) + directions_text(summary, std::min<std::size_t>(result.rows, 8)) +
         modes_text(run);
}

Fields fields_of(const PosteriorResult& result) {
  const PosteriorRun& run = result.run;
  Fields fields = convergence_fields(run);
  fields.add("warnings", all_warnings(result));
  // Of each group, the coldest pair first.
  fields.add("swap_rates", units::kOne, run.draws.swap_rate.transpose());
  fields.add("modes", modes_fields(run));
  fields.add("mode_doubts", run.mode_table.warnings);
  if (result.summary) add_summary(result, fields);
  return fields;
}

Table table_of(const PosteriorResult& result) {
  Table table{{"parameter", "meaning", "unit", "mean", "sd", "prior_sd", "q05", "median", "q95",
               "mcse_mean", "mcse_sd", "r_hat", "bulk_ess", "tail_ess"}};
  if (!result.summary) return table;
  const PosteriorSummary& summary = *result.summary;
  for (const std::size_t i : sorted_by_sd(summary)) {
    const Estimate& e = summary.estimates[i];
    const PosteriorQuantity& q = summary.quantities[i];
    table.add({q.name, meaning_of(q.name, result.run.posterior->problem().digit()), q.unit});
    for (const double value : {e.mean, e.sd, prior_sd(q), e.q05, e.median, e.q95, e.mcse_mean,
                               e.mcse_sd, e.r_hat, e.bulk_ess, e.tail_ess})
      table.rows.back().push_back(fmt::format("{:.8g}", value));
  }
  return table;
}

std::string text_of(const PosteriorPrediction& result) { return text_of(result.predicted); }

std::vector<Fields> fields_of(const PosteriorPrediction& result) {
  return fields_of(result.predicted);
}

Table table_of(const PosteriorPrediction& result) { return table_of(result.predicted); }

std::string refusal_of(const PosteriorResult& result) {
  return result.outcome.stopped() ? "" : unconverged_words(result.run);
}

std::string convergence_complaint(const PosteriorRun& run) {
  const std::string text = unconverged_words(run);
  return text.empty() ? "" : text + "\nWhat may help:" + advice_text(advise(run));
}

std::vector<std::string> noise_cautions(const PosteriorResult& result) {
  if (!result.summary) return {};
  return noise_warnings(result.summary->quantities, result.summary->estimates);
}

std::vector<std::string> convergence_cautions(const PosteriorRun& run) {
  if (!run.convergence.warnings.empty() || run.convergence.cautions.empty()) return {};
  std::string text = "the chains have converged, with a caution:";
  for (const std::string& caution : run.convergence.cautions) text += "\n  * " + caution;
  return {text + "\nTo be sure:" + advice_text(advise(run))};
}

}  // namespace thenar
