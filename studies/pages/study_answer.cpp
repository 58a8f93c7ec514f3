#include "studies/pages/study_answer.h"

#include <fmt/format.h>

#include "base/units.h"
#include "report/parameter_words.h"

namespace thenar {
namespace {

Json scores_json(const TaskScores& tasks) {
  return {{"direction_deg", degrees(tasks.direction)},
          {"direction_sd_deg", degrees(tasks.direction_sd)},
          {"torque_Nm", tasks.torque},
          {"torque_sd_Nm", tasks.torque_sd},
          {"explained", tasks.explained}};
}

Json types_json(const ThumbFit& fit, DigitDirection toward) {
  Json list = Json::array();
  for (const TypeProbability& each : fit.types)
    list.push_back({{"type", describe_type(each.type, toward)},
                    {"prior", each.prior},
                    {"posterior", each.posterior},
                    {"mcse", each.mcse}});
  return list;
}

/// "flexion distal, ulnar": the order of the MCP axes, and the side of the normal.
std::string short_type(const ThumbType& type, DigitDirection toward) {
  const std::string all = describe_type(type, toward);
  return fmt::format("{} distal, {}", type.flexion_distal ? "flexion" : "abduction",
                     all.substr(all.rfind(' ') + 1));
}

/// Types of the thumbs of all skewed fits, after the forces with Monte Carlo errors, and before
/// them [%].
Table type_table(const ThumbStudy& study) {
  Table table{{"fit"}, {}};
  for (const ThumbFit& fit : study.fits) {
    if (fit.types.empty()) continue;
    std::vector<std::string> line{describe_fit(fit.settings)}, before{"  before the forces"};
    if (table.header.size() == 1)
      for (const TypeProbability& each : fit.types)
        table.header.push_back(short_type(each.type, study.criteria.toward));
    for (const TypeProbability& each : fit.types) {
      line.push_back(fmt::format("{:.1f} +- {:.1f}", 100 * each.posterior, 100 * each.mcse));
      before.push_back(fmt::format("{:.1f}", 100 * each.prior));
    }
    table.rows.push_back(std::move(line));
    table.rows.push_back(std::move(before));
  }
  return table;
}

Json fit_json(const ThumbFit& fit, DigitDirection toward) {
  const TendonDigit& digit = fit.run.posterior->problem().digit();
  Json out{{"axes", fit.settings.skewed ? "skewed" : "orthogonal"},
           {"arms", fit.settings.arms == Arms::kFixed ? "known" : "free"},
           {"noise", fit.settings.noise},
           {"postures", fit.settings.postures},
           {"skewness", fit.settings.skewness},
           {"tasks_fitted", fit.settings.with_tasks},
           {"prior_width", fit.settings.prior_width},
           {"converged", fit.converged()},
           {"reasons", fit.run.convergence.warnings},
           {"pulls_direction_deg", degrees(fit.direction)},
           {"pulls_direction_sd_deg", degrees(fit.direction_sd)},
           {"pulls_off_truth", fit.relative_error},
           {"tasks", scores_json(fit.tasks)},
           {"elpd", fit.left_out.elpd},
           {"elpd_se", fit.left_out.se},
           {"modes", fit.run.modes.size()}};
  if (!fit.types.empty()) out["types"] = types_json(fit, toward);
  for (const LearntNumber& number : fit.learnt)
    out["learnt"].push_back({{"name", number.name},
                             {"meaning", meaning_of(number.name, digit)},
                             {"unit", number.unit},
                             {"mean", number.mean},
                             {"sd", number.sd},
                             {"prior_sd", number.prior_sd},
                             {"truth", number.truth ? Json(*number.truth) : Json(nullptr)}});
  return out;
}

Json study_json(const ThumbStudy& study, const std::optional<ThumbCalibration>& calibration) {
  Json out{{"complete", study.complete}, {"fits", Json::array()}, {"not_fitted", Json::array()}};
  for (const ThumbFit& fit : study.fits)
    out["fits"].push_back(fit_json(fit, study.criteria.toward));
  for (const ThumbReference& reference : study.references)
    out["not_fitted"].push_back({{"noise", reference.noise},
                                 {"skewness", reference.skewness},
                                 {"start_pulls_direction_deg", degrees(reference.direction)},
                                 {"start_tasks", scores_json(reference.start)},
                                 {"truth_tasks", scores_json(reference.truth)}});
  if (!calibration) return out;
  Json& judged = out["calibration"];
  judged = {{"simulations", calibration->rank.cols()},
            {"not_converged", calibration->not_converged},
            {"covered_90", calibration->covered},
            {"reasons", calibration->judged.warnings}};
  for (const ParameterCalibration& parameter : calibration->judged.parameters)
    judged["parameters"].push_back({{"name", parameter.name},
                                    {"band_p", parameter.band_p},
                                    {"chi_square_p", parameter.chi_square_p}});
  return out;
}

}  // namespace

OrderedJson json_of(const ThumbStudyResult& result) {
  return OrderedJson(study_json(result.study, result.calibration));
}

Table table_of(const ThumbStudyResult& result) {
  Table table{{"fit", "pulls_deg", "off_truth_percent", "tasks_deg", "torque_Nm",
               "explained_percent", "elpd", "modes", "R_hat", "chains_agree"},
              {}};
  for (const ThumbFit& fit : result.study.fits)
    table.rows.push_back(
        {describe_fit(fit.settings), shown(degrees(fit.direction), 1),
         shown(100 * fit.relative_error, 1), shown(degrees(fit.tasks.direction), 1),
         shown(fit.tasks.torque, 3), shown(100 * fit.tasks.explained, 0),
         shown(fit.left_out.elpd, 1), fmt::format("{}", fit.run.modes.size()),
         shown(fit.run.convergence.worst_r_hat, 4), fit.converged() ? "yes" : "NO"});
  return table;
}

std::string text_of(const ThumbStudyResult& result) {
  const Table types = type_table(result.study);
  return titled("Thumbs fitted to forces of a skewed one", table_of(result)) +
         (types.rows.empty() ? "" : titled("Which type of thumb it may be", types));
}

std::string study_complaint(const ThumbStudyResult& result) {
  const std::size_t doubtful = unconverged_fits(result.study);
  if (doubtful == 0) return "";
  return fmt::format(
      "{} of {} fits have NOT converged; they are marked (more --draws may help; "
      "--allow-unconverged accepts them)",
      doubtful, result.study.fits.size());
}

}  // namespace thenar
