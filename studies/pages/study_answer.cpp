#include "studies/pages/study_answer.h"

#include <utility>

#include <fmt/format.h>

#include "base/units.h"
#include "posterior/hand_posterior.h"
#include "report/parameter_words.h"

namespace thenar {
namespace {

// Keys stand in alphabetic order, as in earlier versions.

Fields score_fields(const TaskScores& tasks) {
  return {{"direction", units::kDegree, tasks.direction},
          {"direction_sd", units::kDegree, tasks.direction_sd},
          {"explained", tasks.explained},
          {"torque", units::kNewtonMetre, tasks.torque},
          {"torque_sd", units::kNewtonMetre, tasks.torque_sd}};
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
  Table table{{"fit"}};
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
    table.add(std::move(line));
    table.add(std::move(before));
  }
  return table;
}

Fields fit_fields(const ThumbFit& fit, DigitDirection toward) {
  // Names and units are those of the answer in JSON.
  const TendonDigit& digit = fit.run.posterior->problem().digit();
  Fields fields{{"arms", fit.settings.arms == Arms::kFixed ? "known" : "free"},
                {"axes", fit.settings.skewed ? "skewed" : "orthogonal"},
                {"converged", fit.converged()},
                {"elpd", fit.left_out.elpd},
                {"elpd_se", fit.left_out.se}};
  fields.add_some("learnt", fields_of_each(fit.learnt, [&](const LearntNumber& number) {
                    return Fields{
                        {"mean", number.mean}, {"meaning", meaning_of(number.name, digit)},
                        {"name", number.name}, {"prior_sd", number.prior_sd},
                        {"sd", number.sd},     {"truth", units::kOne, number.truth},
                        {"unit", number.unit}};
                  }));
  fields.append({{"modes", fit.run.modes.size()},
                 {"noise", fit.settings.noise},
                 {"postures", fit.settings.postures},
                 {"prior_width", fit.settings.prior_width},
                 {"pulls_direction", units::kDegree, fit.direction},
                 {"pulls_direction_sd", units::kDegree, fit.direction_sd},
                 {"pulls_off_truth", fit.relative_error},
                 {"reasons", fit.run.convergence.warnings},
                 {"skewness", fit.settings.skewness},
                 {"tasks", score_fields(fit.tasks)},
                 {"tasks_fitted", fit.settings.with_tasks}});
  fields.add_some("types", fields_of_each(fit.types, [&](const TypeProbability& each) {
                    return Fields{{"mcse", each.mcse},
                                  {"posterior", each.posterior},
                                  {"prior", each.prior},
                                  {"type", describe_type(each.type, toward)}};
                  }));
  return fields;
}

Fields calibration_fields(const ThumbCalibration& calibration) {
  Fields fields{{"covered_90", calibration.covered}, {"not_converged", calibration.not_converged}};
  fields.add_some(
      "parameters",
      fields_of_each(calibration.judged.parameters, [](const ParameterCalibration& of) {
        return Fields{{"band_p", of.band_p}, {"chi_square_p", of.chi_square_p}, {"name", of.name}};
      }));
  fields.append(
      {{"reasons", calibration.judged.warnings}, {"simulations", calibration.rank.cols()}});
  return fields;
}

}  // namespace

Fields fields_of(const ThumbStudyResult& result) {
  // Calibration first if it was asked for, then fits, then thumbs that were not fitted.
  const ThumbStudy& study = result.study;
  Fields fields;
  if (result.calibration) fields.add("calibration", calibration_fields(*result.calibration));
  fields.append({{"complete", study.complete},
                 {"fits", fields_of_each(study.fits,
                                         [&](const ThumbFit& fit) {
                                           return fit_fields(fit, study.criteria.toward);
                                         })},
                 {"not_fitted", fields_of_each(study.references, [](const ThumbReference& of) {
                    return Fields{{"noise", of.noise},
                                  {"skewness", of.skewness},
                                  {"start_pulls_direction", units::kDegree, of.direction},
                                  {"start_tasks", score_fields(of.start)},
                                  {"truth_tasks", score_fields(of.truth)}};
                  })}});
  return fields;
}

Table table_of(const ThumbStudyResult& result) {
  Table table{{"fit", "pulls_deg", "off_truth_percent", "tasks_deg", "torque_Nm",
               "explained_percent", "elpd", "modes", "R_hat", "chains_agree"}};
  for (const ThumbFit& fit : result.study.fits)
    table.add({describe_fit(fit.settings), shown(degrees(fit.direction), 1),
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

FileDigests files_of(const ThumbStudyResult& result) {
  const ThumbStudyInputs& inputs = result.study.inputs;
  return source_digests(
      {inputs.truth, inputs.start, inputs.orthogonal, inputs.skewed, inputs.criteria});
}

std::string study_complaint(const ThumbStudyResult& result) {
  const std::size_t doubtful = unconverged_fits(result.study);
  if (doubtful == 0) return "";
  return fmt::format("{} of {} fits have NOT converged; they are marked (more draws may help)",
                     doubtful, result.study.fits.size());
}

}  // namespace thenar
