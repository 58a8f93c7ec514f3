#include "report/answers/tendon_infer.h"

#include <cmath>

#include <fmt/format.h>

#include "base/nearest_name.h"
#include "report/answers/free_inference.h"

namespace thenar {
namespace {

/// The band's stiffness, if the data decide it.
std::string stiffness(const BandVerdict& band) {
  if (band.EA == 0) return "-";
  return band.EA_told ? shown(band.EA, 1) : "not decided by the data";
}

/// Evidence as a number; what an infinite one means.
std::string evidence_words(double evidence) {
  if (std::isfinite(evidence)) return shown(evidence, 1);
  return evidence > 0 ? "no net without it" : "no net with it";
}

Table band_verdict_table(const NetInference& inference) {
  Table table{{"band", "from", "to", "exists", "evidence", "stiffness_EA_N", "sd_of_log_EA"}, {}};
  for (std::size_t k = 0; k < inference.inferred.verdicts.size(); ++k) {
    const BandVerdict& band = inference.inferred.verdicts[k];
    const bool known = band.EA != 0 && std::isfinite(band.EA_sd);
    table.rows.push_back({band.name, inference.ends[k].from, inference.ends[k].to,
                          to_string(band.verdict), evidence_words(band.evidence), stiffness(band),
                          known ? shown(band.EA_sd, 2) : "-"});
  }
  return table;
}

}  // namespace

std::vector<std::string> fit_in_words(const NetInference& inference) {
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

std::string next_in_words(const NetInference& inference) {
  const bool tells =
      !inference.next.empty() && inference.next.front().disagreement >= NetSearchOptions().enough;
  return tells ? "Tests on which the nets that fit disagree most; disagreement is the mean squared "
                 "difference of their tip forces, in noise sds."
               : "No test of this rig would tell the nets that fit apart: their tip forces differ "
                 "by less than the noise (disagreement below 1).";
}

std::vector<std::string> groups_in_words(const InferredNet& inferred) {
  std::vector<std::string> lines;
  for (const BandGroup& group : inferred.groups) {
    std::vector<std::string> names;
    for (const int c : group.bands)
      names.push_back(inferred.verdicts[static_cast<std::size_t>(c)].name);
    lines.push_back(fmt::format("The data cannot tell apart: {} ({} ways to have them).",
                                listed(names), group.ways.size()));
  }
  return lines;
}

std::string text_of(const NetInference& inference) {
  if (inference.free) return text_of_free(inference);
  std::string text = fmt::format("Which bands of net {} do the forces of {} need? (subject {})\n\n",
                                 inference.net, inference.experiment, inference.subject);
  for (const std::string& line : fit_in_words(inference)) text += line + "\n";
  text += "\n" + titled(
                     "Bands of the hood: evidence above 6 says that the band exists, below -6 "
                     "that it does not",
                     band_verdict_table(inference));
  const std::vector<std::string> groups = groups_in_words(inference.inferred);
  for (const std::string& line : groups) text += line + "\n";
  if (!groups.empty()) text += "\n";
  Table next{{"posture_and_tensions_N", "disagreement"}, {}};
  for (const ProposedTest& test : inference.next)
    next.rows.push_back({test.name, shown(test.disagreement, 2)});
  return text + titled("Measure next. " + next_in_words(inference), next);
}

OrderedJson json_of(const NetInference& inference) {
  if (inference.free) return json_of_free(inference);
  const InferredNet& net = inference.inferred;
  OrderedJson bands = OrderedJson::array(), next = bands, groups = bands;
  // Bands.
  for (std::size_t k = 0; k < net.verdicts.size(); ++k) {
    const BandVerdict& band = net.verdicts[k];
    bands.push_back({{"band", band.name},
                     {"from", inference.ends[k].from},
                     {"to", inference.ends[k].to},
                     {"verdict", to_string(band.verdict)},
                     {"evidence", number_or_null(band.evidence)},
                     {"converged", band.converged},
                     {"EA_N", band.EA_told || band.EA == 0 ? Json(band.EA) : Json()},
                     {"sd_of_log_EA", number_or_null(band.EA_sd)}});
  }
  for (const BandGroup& group : net.groups) {
    Json names = Json::array();
    for (const int c : group.bands) names.push_back(net.verdicts[static_cast<std::size_t>(c)].name);
    groups.push_back({{"bands", names}, {"ways", group.ways.size()}});
  }
  // Tests.
  for (const ProposedTest& test : inference.next)
    next.push_back({{"test", test.name}, {"disagreement", test.disagreement}});
  return {{"experiment", inference.experiment},
          {"subject", inference.subject},
          {"net", inference.net},
          {"method", name_of(inference.method)},
          {"search_ended", inference.stop ? Json(to_string(*inference.stop)) : Json()},
          {"best_fit_converged", net.converged},
          {"out_of_balance_N", net.residual},
          {"readings", net.rows},
          {"chi2", net.misfit},
          {"noise_inflated_by", net.inflation},
          {"topologies_alike", net.alike.size()},
          {"topologies_tried", net.tried},
          {"blind_directions", net.blind.size()},
          {"bands", bands},
          {"groups", groups},
          {"next_tests", next},
          {"warnings", inference.warnings}};
}

Table table_of(const NetInference& inference) {
  if (inference.free) return table_of_free(inference);
  Table table{{"band", "from", "to", "verdict", "evidence", "EA_N", "sd_of_log_EA", "converged"},
              {}};
  for (std::size_t k = 0; k < inference.inferred.verdicts.size(); ++k) {
    const BandVerdict& band = inference.inferred.verdicts[k];
    table.rows.push_back({band.name, inference.ends[k].from, inference.ends[k].to,
                          to_string(band.verdict), fmt::format("{:.10g}", band.evidence),
                          band.EA_told || band.EA == 0 ? fmt::format("{:.10g}", band.EA) : "",
                          fmt::format("{:.10g}", band.EA_sd), band.converged ? "1" : "0"});
  }
  return table;
}

std::string refusal_of(const NetInference& inference) {
  if (inference.free ? inference.free->posterior.found : inference.inferred.found) return "";
  return fmt::format("no set of bands of net {} carries the loads of {}", inference.net,
                     inference.experiment);
}

}  // namespace thenar
