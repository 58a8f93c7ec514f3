#include "report/pages/fit.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/units.h"
#include "base/words.h"
#include "kinematics_fit/fit_residuals.h"
#include "kinematics_fit/trivial_prediction.h"
#include "report/answers/fit.h"
#include "report/answers/fitted_value.h"
#include "report/answers/hood_rows.h"
#include "report/pages/prediction.h"
#include "report/parameter_words.h"
#include "report/picture/digit_layers.h"
#include "report/picture/skin_layer.h"
#include "report/words.h"

namespace thenar {
namespace {

Json interval_row(const Fit& fit, int entry) {
  const CoordinateEstimate& learnt = nth(fit.covariance.learnt, entry);
  Json row{{"name", learnt.name},
           {"estimate", learnt.z},
           {"low", learnt.z - 1.96 * learnt.sd},
           {"high", learnt.z + 1.96 * learnt.sd},
           {"prior_low", -1.96},
           {"prior_high", 1.96},
           {"null", learnt.null_share > 0.99}};
  if (const auto value = value_in_unit(fit, entry)) row["display"] = words_of(*value);
  return row;
}

Json coordinate_table(const Fit& fit) {
  // Order by the remaining sd: the best-determined coordinates first.
  Json rows = Json::array();
  for (const int i : sorted_by_sd(fit.covariance)) {
    const CoordinateEstimate& learnt = nth(fit.covariance.learnt, i);
    const auto value = value_in_unit(fit, i);
    rows.push_back({learnt.name, meaning_of(learnt.name, fit.problem.digit()), learnt.z, learnt.sd,
                    value ? words_of(*value) : "", learnt.at_bound ? "yes" : ""});
  }
  return with(
      table_block(
          "Every coordinate of the fit, the best known first; sd 1: nothing was learnt about it",
          {"coordinate", "meaning", "estimate [prior sd]:2", "sd [prior sd]:2", "value",
           "at its bound"},
          rows),
      {{"search", true}});
}

/// The largest misfit that chance cannot explain, in sds of the stated noise; 0 without one.
double worst_misfit(const FitResult& result) {
  double worst = 0;
  for (const Misfit& misfit : result.misfits)
    if (misfit.beyond_chance) worst = std::max(worst, misfit.times_noise);
  return worst;
}

/// The banner of a fit: green if it has converged to what noise allows, amber if it misses the
/// forces, red if it has not converged or misses them by far.
Json ending_banner(const FitResult& result) {
  // Largest misfit that a wrong noise explains, over the stated noise [1]
  constexpr double kMaxMisfit = 3;
  // Judge convergence and misfit apart: a fit may converge to forces that it does not explain.
  const Solution& found = result.fit.solution;
  const bool converged = found.converged();
  const double missed = worst_misfit(result);
  std::string title = converged ? "The fit has converged" : "The fit has NOT converged";
  if (missed > 0)
    title += fmt::format("{} misses the forces by {:.1f} times the stated noise",
                         converged ? ", but" : ", and", missed);
  Json banner{
      {"type", "banner"},
      {"ok", converged && missed <= kMaxMisfit},
      {"title", title},
      {"text",
       fmt::format("{} by {} after {}, {:.2f} s: {}. {} free; the data determine as much as "
                   "{:.1f} parameters",
                   convergence_word(found), name_of(result.fit.method),
                   counted(found.evaluations, "evaluation"), found.seconds, found.message,
                   counted(result.fit.problem.size(), "coordinate"),
                   result.fit.covariance.effective_parameters)}};
  if (converged && missed > 0 && missed <= kMaxMisfit) banner["caution"] = true;
  return banner;
}

/// Returns the banners about the ending of the fit and its warnings.
Json ending_blocks(const FitResult& result) {
  Json blocks = Json::array({ending_banner(result)});
  if (!result.outcome.warnings.empty()) blocks.push_back(caution_banner(result.outcome.warnings));
  return blocks;
}

/// @param noise  misfit in stated noises, or null
Json error_row(const Prediction& prediction, const std::string& what, const Json& noise) {
  const ForceError& error = prediction.error;
  const std::optional<BesideTrivial> beside = beside_trivial(prediction);
  return {prediction.experiment + seen_words(prediction),
          what,
          error.trials,
          error.rms,
          error.relative,
          error.relative_flexion,
          beside ? Json(beside->trivial.relative) : Json(nullptr),
          degrees(error.direction),
          noise,
          error.covered ? Json(100 * *error.covered) : Json(nullptr)};
}

Json error_table(const FitResult& result) {
  // Add errors in sample first, then left out, then of published models.
  Json rows = Json::array();
  for (std::size_t e = 0; e < result.in_sample.size(); ++e)
    rows.push_back(
        error_row(result.in_sample[e], "in sample",
                  e < result.misfits.size() ? Json(result.misfits[e].times_noise) : Json(nullptr)));
  for (const CrossValidation& validation : result.left_out) {
    std::string what = name_of(validation.what);
    if (validation.status == Status::kStopped)
      what += fmt::format(", {} of {} folds", validation.folds_done, validation.folds.size());
    for (const Prediction& prediction : validation.experiments)
      if (!prediction.trials.empty()) rows.push_back(error_row(prediction, what, nullptr));
  }
  for (const BaselinePrediction& one : result.published)
    rows.push_back(error_row(one.prediction, one.name + " as published", nullptr));
  return table_block(
      "Errors of predicted forces: in space, in the flexion plane alone, and the median angle "
      "between predicted and measured. Mean of others: relative error of what others measured "
      "under the same load, taken as it is (of one specimen alone: at its other postures). Times "
      "the noise: root of chi-square per degree of freedom, near 1 where model and stated noise "
      "are right",
      {"experiment", "predicted", "trials:0", "RMS error [N]:3", "relative error:3", "in plane:3",
       "mean of others:3", "angle [deg]:1", "times the noise:1", "within 95 % band [%]:0"},
      rows);
}

/// A table whose cells stay texts.
Json text_table_block(const std::string& caption, const Table& table) {
  return table_block(caption, columns_of(table), table.rows);
}

/// Errors of the hood's muscles, beside those with fractions; none where the digit has no hood.
std::optional<Json> hood_row_block(const FitResult& result) {
  const Table table = hood_row_table(result);
  if (table.rows.empty()) return std::nullopt;
  std::string caption =
      "Relative errors of the trials under one muscle of the extensor hood, alone. " +
      hood_count_words(result.fit);
  if (result.fractions) caption += ". " + hood_count_words(result.fractions->fit);
  return text_table_block(caption, table);
}

Json force_section(const FitResult& result) {
  Json blocks = Json::array();
  if (std::optional<Json> hood = hood_row_block(result)) blocks.push_back(*hood);
  const std::vector<Experiment>& experiments = result.fit.problem.experiments();
  // Forces in sample, then those of folds that have not seen them.
  for (std::size_t e = 0; e < result.in_sample.size(); ++e)
    if (!result.in_sample[e].trials.empty())
      blocks.push_back(force_panels(
          in_digit_axes(result.in_sample[e], experiments[e]),
          result.in_sample[e].experiment +
              ", in sample. Measured solid, predicted dashed; ellipses hold 95 % of the "
              "predictive distribution"));
  for (const CrossValidation& validation : result.left_out)
    for (std::size_t e = 0; e < validation.experiments.size(); ++e) {
      if (validation.experiments[e].trials.empty()) continue;
      const Prediction turned = in_digit_axes(validation.experiments[e], experiments[e]);
      blocks.push_back(
          force_panels(turned, fmt::format("{}, {}: each predicted by a fit that has not seen it",
                                           turned.experiment, name_of(validation.what))));
      if (std::optional<Json> table = beside_trivial_table(turned)) blocks.push_back(*table);
    }
  return section("forces", "Measured and predicted forces",
                 "Forces of the fingertip in the axes of the distal phalanx.", blocks);
}

/// Returns the section about chosen settings: values, the criterion, and the agreement of the
/// folds.
Json choice_section(const FitResult& result) {
  const ChosenSettings& chosen = *result.chosen;
  return section(
      "settings", "Settings that left-out data chose",
      fmt::format("One after the other, until none was bettered: {} settings were tried, each "
                  "judged by log loss plus logarithm of the relative error of {}, {:.3f} nat at "
                  "first and {:.3f} of those chosen (relative error {:.3f} and {:.3f}). Errors "
                  "that guided a choice look better than they are. Those of the tables above did "
                  "not guide it: there every fold chose again, from the trials that it kept.",
                  chosen.tried.size(), judged_words(chosen), chosen.tried.front().loss, chosen.loss,
                  chosen.tried.front().error, chosen.error),
      Json::array(
          {text_table_block("Settings, and what each fold chose. Folds that disagree do not "
                            "know better than chance",
                            choice_table(result))}));
}

/// "synek2019_H01, synek2019_H02".
std::string names_of(const FitResult& result) {
  return each_in_words(result.in_sample, [](const Prediction& one) { return one.experiment; });
}

/// "thumb", "middle finger".
std::string digit_words(const Fit& fit) {
  const std::string& digit = fit.problem.experiments().front().digit;
  return digit == "thumb" ? digit : digit + " finger";
}

std::string introduction(const FitResult& result) {
  const Fit& fit = result.fit;
  const std::string text = fmt::format(
      "The {} of {} was fitted to {} measured force components of {}. A fit moves the "
      "parameters of the digit within their priors until the predicted forces agree with the "
      "measured ones.",
      digit_words(fit), fit.inputs.subject.path, measured_numbers(fit.problem), names_of(result));
  return text + (result.left_out.empty()
                     ? " All errors are in sample: of forces that the fit has seen. "
                       "--cross-validate posture, tendon or specimen asks for errors of forces "
                       "that it has not seen."
                     : " What counts is the error of forces that a fit has not seen.");
}

Json opening_of(const FitResult& result) {
  // Sum up by the relative error, or by the reason why the fit is not to be used.
  const Fit& fit = result.fit;
  std::vector<std::string> errors;
  for (const Prediction& each : result.in_sample)
    if (!each.trials.empty())
      errors.push_back(fmt::format("{:.3f} ({})", each.error.relative, each.experiment));
  std::string found =
      fmt::format("The data determine {:.1f} parameters.", fit.covariance.effective_parameters);
  if (!errors.empty())
    found = fmt::format("The relative error in sample is {}; the data determine {:.1f} parameters.",
                        fmt::join(errors, ", "), fit.covariance.effective_parameters);
  return opening_json(fmt::format("What do measured forces tell about {} {}?",
                                  digit_words(fit).front() == 'i' ? "an" : "a", digit_words(fit)),
                      fmt::format("{} were fitted by {}, within priors, with {} free, in {}.",
                                  counted(measured_numbers(fit.problem), "force component"),
                                  name_of(fit.method), counted(fit.problem.size(), "coordinate"),
                                  counted(fit.solution.evaluations, "evaluation")),
                      fit.solution.status == Status::kSolved
                          ? found
                          : "The fit did not converge (" + convergence_word(fit.solution) +
                                "): its numbers are those of where it stopped.");
}

Json digit_section(const Fit& fit, MeshTable& meshes) {
  Json scenes = Json::array();
  for (int s = 0; s < static_cast<int>(fit.problem.specimens().size()); ++s)
    scenes.push_back(fitted_scene(fit, s, meshes));
  return section("digit", "The fitted digit",
                 "Joint axes and tendon runs; the layers can be switched. Scenes turn together.",
                 Json::array({row_block(scenes)}));
}

}  // namespace

std::string name_rules(const Fit& fit) {
  // Explain only the names that occur.
  struct Rule {
    std::vector<ParameterKind> kinds;
    const char* text;
  };
  using Kind = ParameterKind;
  static const std::vector<Rule> rules{
      {{Kind::kPathPoint},
       "path/RI/2/dorsal is how far the second point of the radial interosseous, counted from its "
       "insertion, lies dorsal of where the subject file has it"},
      {{Kind::kArm}, "arm/FDP/PIP3 is the moment arm of FDP at the PIP joint, flexion positive"},
      {{Kind::kAxisDirection}, "axis/DIP3/direction/1 tilts a joint axis"},
      {{Kind::kAxisPoint}, "axis/DIP3/point/1 shifts a joint axis"},
      {{Kind::kHoodEntry, Kind::kHoodCentral, Kind::kHoodSlope},
       "hood/EDC/central and /slope say how much of a tension goes to the central slip, and how "
       "that changes as the MCP joint flexes (both on the logit scale)"},
      {{Kind::kFriction}, "friction/FDP is Euler's belt coefficient of a tendon in its sheath"},
      {{Kind::kAngle, Kind::kPostureAngle},
       "angle/DIP3/Hook is the error of one joint in one posture"},
      {{Kind::kGain}, "gain/FDP multiplies the stated tension of a muscle"},
      {{Kind::kTipForce},
       "force/FDP/radial is the force of the tip per newton of tension that the geometry does not "
       "explain"},
      {{Kind::kSensorTilt}, "sensor/ tilts the load cell"}};
  const FitParameters& parameters = fit.problem.parameters();
  std::string text;
  for (const Rule& rule : rules) {
    const bool occurs = any_of(parameters.leader, [&](int p) {
      return contains(rule.kinds, nth(parameters.all, p).kind);
    });
    if (occurs) text += (text.empty() ? "Names: " : "; ") + std::string(rule.text);
  }
  return text.empty() ? text : text + ".";
}

Json learnt_forest(const Fit& fit, const std::string& whose, std::size_t shown) {
  // The best known parameters, and a few of the least known to compare with.
  const std::vector<int> order = sorted_by_sd(fit.covariance);
  Json rows = Json::array();
  for (std::size_t k = 0; k < std::min(shown, order.size()); ++k)
    rows.push_back(interval_row(fit, order[k]));
  for (std::size_t k = order.size() - std::min<std::size_t>(4, order.size()); k < order.size(); ++k)
    if (k >= shown) rows.push_back(interval_row(fit, order[k]));
  const std::string which =
      order.size() <= shown
          ? fmt::format("all {} parameters, the best known first", order.size())
          : fmt::format(
                "the {} parameters that the forces determine best, and four that they "
                "determine least",
                shown);
  return interval_block(fmt::format("{}: {}. Bars are 95 % intervals in prior sds; at the right "
                                    "estimate and sd",
                                    whose, which),
                        "estimate in prior standard deviations", rows);
}

Json open_directions(const Fit& fit, const std::string& whose) {
  const Json rows = list_of_each(fit.covariance.null_directions, [](const NullDirection& null) {
    return Json::array({null.text});
  });
  return table_block(
      fmt::format("{}: along {} of {} directions no measured force changes, and the prior alone "
                  "decides them ({} force components were measured)",
                  whose, rows.size(), fit.problem.size(), measured_numbers(fit.problem)),
      {"direction, in prior sds"}, rows);
}

Json fitted_scene(const Fit& fit, int specimen, MeshTable& meshes) {
  // Draw the digit before and after the fit, in one posture.
  const TendonDigit& before = fit.problem.digit_of(specimen);
  const TendonDigit after = fitted_digit(fit, specimen);
  const std::string& name = nth(fit.problem.specimens(), specimen);
  // The first posture of an experiment of the specimen.
  const std::vector<Experiment>& experiments = fit.problem.experiments();
  const Experiment* own =
      find_where(experiments, [&](const Experiment& e) { return e.specimen == name; });
  const ExperimentPlan& plan = nth(fit.problem.plans(), own - experiments.data());
  const Eigen::VectorXd q = plan.postures.front();
  // Skin is that of the subject, so it is drawn only where the fit keeps the subject's size.
  Json layers = Json::array({bone_layer(before, q, "#b8a48a"),
                             axis_layer(before, q, "axes before", "#999999", 0.03, false),
                             axis_layer(after, q, "axes fitted", "#0072b2", 0.03, true),
                             tendon_layer(before, q, "tendons before", "#999999", false),
                             tendon_layer(after, q, "tendons fitted", "#d55e00", true)});
  if (fit.inputs.scaling == Scaling::kSubject) {
    const SourceText& source = fit.inputs.subject;
    const Subject subject = parse_subject(source.text, source.path);
    add_skin({subject, before, pose_tree(before.model.tree, q)}, meshes, layers);
  }
  return with(
      digit_scene_block(
          fmt::format(
              "{} in posture {}: grey before the fit; tendons orange and axes blue after it", name,
              plan.posture_names.front()),
          before.model.tip_axes, std::move(layers)),
      {{"link", "fingers"}});
}

Json page_of(const FitResult& result) {
  const Fit& fit = result.fit;
  // Tell first how the fit ended, as all else depends on it.
  const std::string whose = names_of(result);
  Json first = ending_blocks(result);
  first.push_back(error_table(result));
  Json sections = Json::array(
      {section("fit", "How well the fit explains the forces", introduction(result), first),
       force_section(result),
       section("learnt", "What the forces tell about the digit",
               "Every parameter has a prior from anatomy; its sd is the unit here, and an interval "
               "as wide as the prior means that nothing was learnt.\n\n" +
                   name_rules(fit),
               Json::array({learnt_forest(fit, whose), coordinate_table(fit)}))});
  if (result.chosen && !result.chosen->tried.empty()) sections.push_back(choice_section(result));
  // Name the directions that the prior alone decides.
  if (!fit.covariance.null_directions.empty())
    sections.push_back(section("open", "What the prior alone decides",
                               "Directions along which no measured force changes are named, not "
                               "hidden.",
                               Json::array({open_directions(fit, whose)})));
  MeshTable meshes;
  sections.push_back(digit_section(fit, meshes));
  // write_page() adds the run that fitted and wrote the page.
  Json provenance = fit_provenance(fit.inputs, {}, fit.problem.digit().fidelity, {});
  provenance["seed"] = fmt::format("{}", fit.seed);
  return {
      {"title", "thenar: fit of " + whose},
      {"subtitle", fmt::format("{}, started from {}", digit_words(fit), fit.inputs.subject.path)},
      {"opening", opening_of(result)},
      {"provenance", provenance},
      {"meshes", meshes.json()},
      {"sections", sections}};
}

}  // namespace thenar
