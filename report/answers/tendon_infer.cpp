#include "report/answers/tendon_infer.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/nearest_name.h"
#include "base/words.h"
#include "tendons/topology/search_nets.h"

namespace thenar {

// Where slack lengths, paths and the like are free.

namespace {

constexpr double kMmPerMetre = 1e3;  // Millimetres in a metre [1]

/// "+1.3"; "-" where there is no such number.
std::string change_words(double value) {
  return std::isfinite(value) ? fmt::format("{:+.1f}", value) : "-";
}

Table belief_table(const InferNetResult& inference) {
  Table table{{"band", "from", "to", "exists", "probability", "log_Bayes_factor", "chi2_without",
               "parameters_with", "tension_N", "slack_mm", "prior_sd_mm"}};
  for (std::size_t k = 0; k < inference.free->posterior.bands.size(); ++k) {
    const BandBelief& band = inference.free->posterior.bands[k];
    table.add({band.name, inference.ends[k].from, inference.ends[k].to, verdict_words(band),
               probability_words(band) + (band.doubtful ? " ?" : ""), change_words(band.log_odds),
               change_words(band.misfit_change), change_words(band.effective_change),
               shown(band.tension, 2), slack_words(band),
               band.slack ? shown(kMmPerMetre * band.slack->prior_sd, 2) : "-"});
  }
  return table;
}

Fields belief_fields(const BandBelief& band, const BandEnds& ends) {
  Fields fields{{"band", band.name},
                {"from", ends.from},
                {"to", ends.to},
                {"verdict", to_string(band.verdict)},
                {"why", verdict_words(band)},
                {"probability", band.probability},
                {"probability_error", band.error},
                {"log_bayes_factor", band.log_odds},
                {"chi2_without", band.misfit_change},
                {"effective_parameters_with", band.effective_change},
                {"doubtful", band.doubtful},
                {"largest_tension", units::kNewton, band.tension}};
  if (band.slack)
    fields.add("slack", Fields{{"length", units::kMillimetre, band.slack->length},
                               {"sd", units::kMillimetre, band.slack->sd},
                               {"prior_sd", units::kMillimetre, band.slack->prior_sd},
                               {"at_bound", band.slack->at_bound}});
  else
    fields.add("slack", nullptr);
  return fields;
}

}  // namespace

std::string verdict_words(const BandBelief& band) {
  if (band.verdict != Verdict::kUndecided) return to_string(band.verdict);
  return band.why == UndecidedReason::kSlack ? "undetermined: slack throughout"
                                             : "undetermined: others can do its work";
}

std::string probability_words(const BandBelief& band) {
  if (std::isinf(band.log_odds))
    return band.log_odds > 0 ? "1 (no set without it)" : "0 (no set with it)";
  const std::string p = shown(band.probability, 3);
  constexpr double kMinShownError = 5e-4;  // Least error that is shown [1]
  return band.error >= kMinShownError ? fmt::format("{} +- {}", p, shown(band.error, 3)) : p;
}

std::string slack_words(const BandBelief& band) {
  if (!band.slack) return "held";
  return fmt::format("{} +- {}", shown(kMmPerMetre * band.slack->length, 2),
                     shown(kMmPerMetre * band.slack->sd, 2));
}

std::vector<std::string> posterior_in_words(const FreeInference& free) {
  const BandPosterior& posterior = free.posterior;
  const BandEvidence& best = posterior.sets.front().evidence;
  return {
      fmt::format("Forces: {} components; {} parameters are free with all bands, by the priors of "
                  "{}.",
                  free.numbers, free.parameters, free.settings),
      fmt::format(
          "{} of bands {}, of which {} the loads.", counted(posterior.fitted, "set"),
          posterior.enumerated ? "fitted, which are all there are" : "fitted, by sampling",
          posterior.failed == 0 ? "all carry" : fmt::format("{} do not carry", posterior.failed)),
      fmt::format("Most probable set: chi-square {:.1f}, of which the data determine {:.1f} "
                  "parameters; the best set's errors are {:.2f} times the stated noise.",
                  best.misfit, best.effective, posterior.noise)};
}

std::string next_in_words(const FreeInference& free) {
  if (free.pool == 0) return "No trial was ranked.";
  return fmt::format(
      "Trials of this rig by what they are expected to tell: of {:.2f} bit that are open about the "
      "sets of bands, a trial tells {:.3f} bit on average.",
      free.posterior.entropy, free.next_mean);
}

namespace {

std::string text_of_free(const InferNetResult& inference) {
  const FreeInference& free = *inference.free;
  std::string text =
      fmt::format("Which bands of net {} do the forces of {} need, with {} free? (subject {})\n\n",
                  inference.net, inference.experiment, listed(free.freed), inference.subject);
  text += fmt::format("{}\n\n", fmt::join(posterior_in_words(free), "\n"));
  text += titled(
      "Bands of the hood: from probability 0.95 a band exists, below 0.05 it "
      "does not; chi2_without: how much worse the forces are explained without "
      "it",
      belief_table(inference));
  Table next{{"posture_and_tensions_N", "sets_bit", "slack_bit", "tells_most_of", "of_it_bit"}};
  for (const RankedTrial& trial : free.next)
    next.add({trial.name, shown(trial.information, 3), shown(trial.slack, 3),
              trial.most_informed_band.empty() ? "-" : trial.most_informed_band,
              shown(trial.band_information, 3)});
  return text + titled("Measure next. " + next_in_words(free), next);
}

Fields fields_of_free(const InferNetResult& inference) {
  const FreeInference& free = *inference.free;
  const BandPosterior& posterior = free.posterior;
  // Add bands, kept sets, and trials.
  std::vector<Fields> bands, sets, next;
  for (std::size_t k = 0; k < posterior.bands.size(); ++k)
    bands.push_back(belief_fields(posterior.bands[k], inference.ends[k]));
  for (const BandSet& set : posterior.sets) {
    std::vector<std::string> absent;
    for (std::size_t b = 0; b < set.bands.size(); ++b)
      if (!set.bands[b]) absent.push_back(posterior.bands[b].name);
    sets.push_back({{"without", absent},
                    {"probability", set.probability},
                    {"log_integral", set.evidence.integral},
                    {"laplace", set.evidence.laplace},
                    {"draws_left", set.evidence.draws_left},
                    {"by_draws", set.evidence.by_draws},
                    {"chi2", set.evidence.misfit},
                    {"effective_parameters", set.evidence.effective},
                    {"converged", set.evidence.converged}});
  }
  // Trials by the information that they would give about all bands.
  for (const RankedTrial& trial : free.next)
    next.push_back({{"test", trial.name},
                    {"information", units::kBit, trial.information},
                    {"slack", units::kBit, trial.slack},
                    {"tells_most_of", trial.most_informed_band},
                    {"of_it", units::kBit, trial.band_information}});
  return {{"experiment", inference.experiment},
          {"subject", inference.subject},
          {"net", inference.net},
          {"free", free.freed},
          {"settings", free.settings},
          {"parameters", free.parameters},
          {"readings", free.numbers},
          {"sets_fitted", posterior.fitted},
          {"sets_that_do_not_carry", posterior.failed},
          {"all_sets", posterior.enumerated},
          {"all_by_draws", posterior.by_draws},
          {"errors_per_noise", posterior.noise},
          {"entropy", units::kBit, posterior.entropy},
          {"bands", std::move(bands)},
          {"sets", std::move(sets)},
          {"trials_ranked", free.pool},
          {"mean_information", units::kBit, free.next_mean},
          {"next_tests", std::move(next)},
          {"warnings", inference.outcome.warnings}};
}

Table table_of_free(const InferNetResult& inference) {
  Table table{{"band", "from", "to", "verdict", "probability", "probability_error",
               "log_bayes_factor", "tension_N", "slack_mm", "slack_sd_mm", "slack_prior_sd_mm",
               "doubtful"}};
  const auto number = [](double value) { return fmt::format("{:.10g}", value); };
  for (std::size_t k = 0; k < inference.free->posterior.bands.size(); ++k) {
    const BandBelief& band = inference.free->posterior.bands[k];
    const auto slack = [&](double SlackRange::*what) {
      return band.slack ? number(kMmPerMetre * (*band.slack).*what) : "";
    };
    table.add({band.name, inference.ends[k].from, inference.ends[k].to, to_string(band.verdict),
               number(band.probability), number(band.error), number(band.log_odds),
               number(band.tension), slack(&SlackRange::length), slack(&SlackRange::sd),
               slack(&SlackRange::prior_sd), band.doubtful ? "1" : "0"});
  }
  return table;
}

// Where nothing but bands is open.

/// The band's stiffness, if the data decide it.
std::string stiffness(const BandVerdict& band) {
  if (band.EA == 0) return "-";
  return band.EA_determined ? shown(band.EA, 1) : "not decided by the data";
}

/// Evidence as a number; what an infinite one means.
std::string evidence_words(double evidence) {
  if (std::isfinite(evidence)) return shown(evidence, 1);
  return evidence > 0 ? "no net without it" : "no net with it";
}

std::vector<std::string> names_of(const BandGroup& group, const InferredNet& inferred) {
  return transformed(group.bands, [&](int c) { return nth(inferred.verdicts, c).name; });
}

Table band_verdict_table(const InferNetResult& inference) {
  Table table{{"band", "from", "to", "exists", "evidence", "stiffness_EA_N", "sd_of_log_EA"}};
  for (std::size_t k = 0; k < inference.inferred.verdicts.size(); ++k) {
    const BandVerdict& band = inference.inferred.verdicts[k];
    const bool known = band.EA != 0 && std::isfinite(band.EA_sd);
    table.add({band.name, inference.ends[k].from, inference.ends[k].to, to_string(band.verdict),
               evidence_words(band.evidence), stiffness(band), known ? shown(band.EA_sd, 2) : "-"});
  }
  return table;
}

}  // namespace

std::vector<std::string> fit_in_words(const InferNetResult& inference) {
  const InferredNet& net = inference.inferred;
  std::vector<std::string> lines{
      fmt::format("Forces: {} components, of the trials in which a muscle pulls the hood.",
                  net.rows),
      fmt::format("Best net: chi-square {:.1f}; its errors are {:.2f} times the stated noise, and "
                  "evidence is counted in these errors.",
                  net.misfit, net.inflation),
      fmt::format("{} of bands tried, {} {} the forces about as well as the best.",
                  counted(net.tried, "set"), net.alike.size(),
                  net.alike.size() == 1 ? "explains" : "explain")};
  if (!net.blind.empty())
    lines.push_back(fmt::format("{} of stiffness {} no measured force.",
                                counted(net.blind.size(), "combination"),
                                net.blind.size() == 1 ? "changes" : "change"));
  if (inference.stop)
    lines.push_back(fmt::format("The search ended: {}.", to_string(*inference.stop)));
  return lines;
}

std::string next_in_words(const InferNetResult& inference) {
  const bool tells =
      !inference.next.empty() && inference.next.front().disagreement >= NetSearchOptions().enough;
  return tells ? "Tests on which the nets that fit disagree most; disagreement is the mean squared "
                 "difference of their tip forces, in noise sds."
               : "No test of this rig would tell the nets that fit apart: their tip forces differ "
                 "by less than the noise (disagreement below 1).";
}

std::vector<std::string> groups_in_words(const InferredNet& inferred) {
  return transformed(inferred.groups, [&](const BandGroup& group) {
    return fmt::format("The data cannot tell apart: {} ({} ways to have them).",
                       listed(names_of(group, inferred)), group.ways.size());
  });
}

std::string text_of(const InferNetResult& inference) {
  if (inference.free) return text_of_free(inference);
  std::string text = fmt::format("Which bands of net {} do the forces of {} need? (subject {})\n\n",
                                 inference.net, inference.experiment, inference.subject);
  text += fmt::format("{}\n\n", fmt::join(fit_in_words(inference), "\n"));
  text += titled(
      "Bands of the hood: evidence above 6 says that the band exists, below -6 "
      "that it does not",
      band_verdict_table(inference));
  const std::vector<std::string> groups = groups_in_words(inference.inferred);
  if (!groups.empty()) text += fmt::format("{}\n\n", fmt::join(groups, "\n"));
  Table next{{"posture_and_tensions_N", "disagreement"}};
  for (const ProposedTest& test : inference.next)
    next.add({test.name, shown(test.disagreement, 2)});
  return text + titled("Measure next. " + next_in_words(inference), next);
}

Fields fields_of(const InferNetResult& inference) {
  if (inference.free) return fields_of_free(inference);
  const InferredNet& net = inference.inferred;
  std::vector<Fields> bands, groups, next;
  // Bands.
  for (std::size_t k = 0; k < net.verdicts.size(); ++k) {
    const BandVerdict& band = net.verdicts[k];
    bands.push_back(
        {{"band", band.name},
         {"from", inference.ends[k].from},
         {"to", inference.ends[k].to},
         {"verdict", to_string(band.verdict)},
         {"evidence", band.evidence},
         {"converged", band.converged},
         {"EA", units::kNewton, band.EA_determined || band.EA == 0 ? band.EA : std::nan("")},
         {"sd_of_log_EA", band.EA_sd}});
  }
  for (const BandGroup& group : net.groups)
    groups.push_back({{"bands", names_of(group, net)}, {"ways", group.ways.size()}});
  // Tests.
  for (const ProposedTest& test : inference.next)
    next.push_back({{"test", test.name}, {"disagreement", test.disagreement}});
  // The method, and how well the best net explains the forces.
  return {
      {"experiment", inference.experiment},
      {"subject", inference.subject},
      {"net", inference.net},
      {"method", name_of(inference.request.method)},
      {"search_ended", inference.stop ? OrderedJson(to_string(*inference.stop)) : OrderedJson()},
      {"best_fit_converged", net.converged},
      {"out_of_balance", units::kNewton, net.residual},
      {"readings", net.rows},
      {"chi2", net.misfit},
      {"noise_inflated_by", net.inflation},
      {"topologies_alike", net.alike.size()},
      {"topologies_tried", net.tried},
      {"blind_directions", net.blind.size()},
      {"bands", std::move(bands)},
      {"groups", std::move(groups)},
      {"next_tests", std::move(next)},
      {"warnings", inference.outcome.warnings}};
}

Table table_of(const InferNetResult& inference) {
  if (inference.free) return table_of_free(inference);
  Table table{{"band", "from", "to", "verdict", "evidence", "EA_N", "sd_of_log_EA", "converged"}};
  for (std::size_t k = 0; k < inference.inferred.verdicts.size(); ++k) {
    const BandVerdict& band = inference.inferred.verdicts[k];
    table.add({band.name, inference.ends[k].from, inference.ends[k].to, to_string(band.verdict),
               fmt::format("{:.10g}", band.evidence),
               band.EA_determined || band.EA == 0 ? fmt::format("{:.10g}", band.EA) : "",
               fmt::format("{:.10g}", band.EA_sd), band.converged ? "1" : "0"});
  }
  return table;
}

std::string refusal_of(const InferNetResult& inference) {
  if (inference.free ? inference.free->posterior.found : inference.inferred.found) return "";
  return fmt::format("no set of bands of net {} carries the loads of {}", inference.net,
                     inference.experiment);
}

}  // namespace thenar
