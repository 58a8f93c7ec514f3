#include <cmath>

#include <fmt/ranges.h>

#include "report/answers/tendon_infer.h"
#include "report/pages/tendons.h"
#include "report/provenance.h"

namespace thenar {
namespace {

Json verdict_block(const InferNetResult& inference) {
  // One row for each candidate band: verdict, evidence and stiffness.
  Json rows = Json::array();
  for (std::size_t k = 0; k < inference.inferred.verdicts.size(); ++k) {
    const BandVerdict& band = inference.inferred.verdicts[k];
    const Json EA = band.EA == 0         ? Json("-")
                    : band.EA_determined ? Json(band.EA)
                                         : Json("not decided by the data");
    const bool known = band.EA != 0 && std::isfinite(band.EA_sd);
    rows.push_back({band.name, inference.ends[k].from, inference.ends[k].to,
                    to_string(band.verdict),
                    std::isfinite(band.evidence) ? Json(band.evidence)
                    : band.evidence > 0          ? Json("no net without it")
                                                 : Json("no net with it"),
                    EA, known ? Json(band.EA_sd) : Json("-")});
  }
  return with(
      table_block(
          "Every band that may exist. Evidence: by how much the forces are explained worse without "
          "the "
          "band (chi-square, in units of the errors that the best net leaves); above 6 it exists, "
          "below -6 it does not, between the forces leave it open. \"No net without it\": without "
          "the "
          "band no "
          "net carries the loads. EA: stiffness, tension per unit strain.",
          {"band", "from", "to", "exists", "evidence:1", "stiffness EA [N]:1", "sd of log EA:2"},
          rows),
      {{"search", true}});
}

Json next_block(const InferNetResult& inference) {
  Json rows = Json::array();
  for (const ProposedTest& test : inference.next) rows.push_back({test.name, test.disagreement});
  return table_block("What to measure next. " + next_in_words(inference),
                     {"posture and tensions [N]", "disagreement:2"}, rows);
}

Json belief_block(const InferNetResult& inference) {
  // Probabilities replace verdicts where other parameters were free.
  Json rows = Json::array();
  for (std::size_t k = 0; k < inference.free->posterior.bands.size(); ++k) {
    const BandBelief& band = inference.free->posterior.bands[k];
    const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json("-"); };
    rows.push_back({band.name, inference.ends[k].from, inference.ends[k].to, verdict_words(band),
                    probability_words(band), number(band.log_odds), number(band.misfit_change),
                    band.tension, slack_words(band), band.doubtful ? "doubtful" : ""});
  }
  return with(
      table_block(
          "Every band in question. From probability 0.95 it exists, below 0.05 it does not. Log "
          "Bayes "
          "factor: for the band, all that is free averaged out. Chi-square: how much worse the "
          "best "
          "set "
          "without the band explains the forces than the best with it. Slack length with its "
          "posterior "
          "sd, in the best set that has the band. Doubtful: nothing vouches for the approximation.",
          {"band", "from", "to", "exists", "probability", "log Bayes factor:1",
           "chi-square without:1", "largest tension [N]:2", "slack length [mm]", "doubtful"},
          rows),
      {{"search", true}});
}

Json next_free_block(const FreeInference& free) {
  Json rows = Json::array();
  for (const RankedTrial& trial : free.next)
    rows.push_back({trial.name, trial.information, trial.slack, trial.most_informed_band,
                    trial.band_information});
  return table_block("What to measure next. " + next_in_words(free),
                     {"posture and tensions [N]", "about the sets [bit]:3",
                      "about slack lengths [bit]:3", "tells most of", "of it [bit]:3"},
                     rows);
}

}  // namespace

Json page_of(const InferNetResult& inference) {
  // The method and its seed make the result repeatable.
  Json provenance = provenance_json(inference.sources, inference.fidelity);
  provenance["method"] =
      inference.request.method == InferMethod::kSparse
          ? name_of(inference.request.method)
          : fmt::format("{}, seed {}", name_of(inference.request.method), inference.request.seed);
  if (inference.free)
    provenance["method"] = fmt::format("{} free, seed {}", fmt::join(inference.free->freed, ", "),
                                       inference.request.seed);
  // Add words on the fit, then on bands that the data cannot distinguish.
  std::string text;
  for (const std::string& line :
       inference.free ? posterior_in_words(*inference.free) : fit_in_words(inference))
    text += line + " ";
  for (const std::string& line : groups_in_words(inference.inferred)) text += line + " ";
  Json blocks = Json::array();
  if (!inference.outcome.warnings.empty())
    blocks.push_back(
        banner_block("Some verdicts are not to be relied on", inference.outcome.warnings));
  blocks.push_back(inference.free ? belief_block(inference) : verdict_block(inference));
  blocks.push_back(inference.free ? next_free_block(*inference.free) : next_block(inference));
  return {
      {"title", fmt::format("Bands of the extensor hood: net {}", inference.net)},
      {"subtitle", fmt::format("from the fingertip forces of {}, subject {}", inference.experiment,
                               inference.subject)},
      {"provenance", provenance},
      {"sections", Json::array({section("bands", "Which bands the forces need", text, blocks)})}};
}

}  // namespace thenar
