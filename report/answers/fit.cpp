#include "report/answers/fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/numbers.h"
#include "base/units.h"
#include "base/words.h"
#include "kinematics_fit/trivial_prediction.h"
#include "report/answers/fitted_value.h"
#include "report/answers/hood_rows.h"
#include "report/parameter_words.h"
#include "report/words.h"

namespace thenar {
namespace {

constexpr std::size_t kLearntShown = 8, kOpenShown = 4;  // lines of the text

Fields error_fields(const Prediction& prediction) {
  const ForceError& error = prediction.error;
  return {{"experiment", prediction.experiment},
          {"rms_error", units::kNewton, error.rms},
          {"relative_error", error.relative},
          {"relative_error_flexion_plane", error.relative_flexion},
          {"start_has_seen_specimen", prediction.calibrated_on_specimen}};
}

/// Experiments in sample, with their misfits.
std::vector<Fields> in_sample_fields(const FitResult& result) {
  std::vector<Fields> list;
  for (std::size_t e = 0; e < result.in_sample.size(); ++e) {
    Fields& fields = list.emplace_back(error_fields(result.in_sample[e]));
    if (e >= result.misfits.size()) continue;
    const Misfit& misfit = result.misfits[e];
    fields.append({{"chi_square", misfit.chi_square},
                   {"numbers", misfit.numbers},
                   {"degrees_of_freedom", misfit.degrees_of_freedom},
                   {"times_noise", misfit.degrees_of_freedom > 0 ? misfit.times_noise : kNaN},
                   {"tail_probability", misfit.tail},
                   {"beyond_chance", misfit.beyond_chance}});
  }
  return list;
}

std::vector<Fields> left_out_fields(const FitResult& result) {
  std::vector<Fields> list;
  for (const CrossValidation& validation : result.left_out)
    for (const Prediction& prediction : validation.experiments)
      list.emplace_back(error_fields(prediction))
          .append({{"what", name_of(validation.what)},
                   {"covered_95", units::kOne, prediction.error.covered},
                   {"log_loss", units::kOne, prediction.error.log_loss},
                   trivial_field("mean_of_others", prediction),
                   {"folds_done", validation.folds_done},
                   {"folds", validation.folds.size()}});
  return list;
}

/// Every coordinate with its meaning, best known first.
std::vector<Fields> learnt_fields(const Fit& fit) {
  return fields_of_each(sorted_by_sd(fit.covariance), [&](const int i) {
    const CoordinateEstimate& one = nth(fit.covariance.learnt, i);
    Fields fields{{"name", one.name},
                  {"meaning", meaning_of(one.name, fit.problem.digit())},
                  {"estimate_prior_sds", one.z},
                  {"sd_prior_sds", one.sd},
                  {"at_bound", one.at_bound}};
    if (const auto value = value_in_unit(fit, i))
      fields.append({{"value", value->value},
                     {"sd", value->sd},
                     {"prior_sd", value->prior_sd},
                     {"unit", value->unit}});
    return fields;
  });
}

std::string learnt_text(const Fit& fit) {
  std::string text =
      "\nbest-determined parameters (estimate and SD in prior SDs; SD 1: nothing was learnt; "
      "value):\n";
  const std::vector<int> order = sorted_by_sd(fit.covariance);
  for (std::size_t k = 0; k < std::min(kLearntShown, order.size()); ++k) {
    const CoordinateEstimate& learnt = nth(fit.covariance.learnt, order[k]);
    const auto value = value_in_unit(fit, order[k]);
    text +=
        fmt::format("  {:<34} {:+6.2f} +- {:.2f}  {:<18}  {}{}\n", learnt.name, learnt.z, learnt.sd,
                    value ? words_of(*value) : "", meaning_of(learnt.name, fit.problem.digit()),
                    learnt.at_bound ? "; at its bound" : "");
  }
  return text;
}

/// Kind of the parameters in a direction that the data leave open.
enum class OpenKind {
  kTendons,  // arms, points, gains: what a fit is made for
  kOther,    // angles, shares, ..
  kTilts     // of axes and of the load cell alone: in a planar finger nobody can know them
};

/// Names of the coordinates that make up a direction, each with its share.
std::vector<std::pair<std::string, double>> shares_of(const Eigen::SparseVector<double>& direction,
                                                      const std::vector<std::string>& names) {
  constexpr double kMinNamedShare = 0.1;  // Least share of a coordinate that is named [1]
  std::vector<std::pair<std::string, double>> shares;
  for (Eigen::SparseVector<double>::InnerIterator at(direction); at; ++at)
    if (std::abs(at.value()) >= kMinNamedShare)
      shares.emplace_back(without_specimen(nth(names, at.index())), at.value());
  return shares;
}

OpenKind kind_of(const std::vector<std::pair<std::string, double>>& shares) {
  const auto starts = [](const std::string& name, const char* with) {
    return name.rfind(with, 0) == 0;
  };
  bool tilts = !shares.empty();  // many small shares are no tilt
  for (const auto& [name, share] : shares) {
    if (starts(name, "arm/") || starts(name, "path/") || starts(name, "gain/"))
      return OpenKind::kTendons;
    tilts = tilts && (starts(name, "axis/") || starts(name, "sensor/"));
  }
  return tilts ? OpenKind::kTilts : OpenKind::kOther;
}

/// "; the same shift of all these arms of DI4" of three or more arms of one strand.
std::string same_arms_words(const std::vector<std::pair<std::string, double>>& shares) {
  constexpr double kShareTolerance = 1e-3;  // Largest difference of equal shares [1]
  const std::string& first = shares.front().first;
  const std::string strand = first.substr(0, first.rfind('/') + 1);
  if (shares.size() < 3 || strand.rfind("arm/", 0) != 0) return "";
  for (const auto& [name, share] : shares)
    if (name.rfind(strand, 0) != 0 || std::abs(share - shares.front().second) > kShareTolerance)
      return "";
  return fmt::format(
      "; all arms of {} shift alike, which only a moment of the tip would tell, and it is not "
      "fitted",
      strand.substr(4, strand.size() - 5));
}

std::string open_text(const Fit& fit) {
  const auto& all = fit.covariance.null_directions;
  if (all.empty()) return "";
  // Tendons first; tilts are only counted.
  const std::vector<std::string> names = fit.problem.coordinates().names();
  std::vector<std::string> tendons, open;
  std::size_t tilts = 0;
  for (const NullDirection& null : all) {
    const auto shares = shares_of(null.direction, names);
    const OpenKind kind = kind_of(shares);
    if (kind == OpenKind::kTilts)
      ++tilts;
    else if (kind == OpenKind::kTendons)
      tendons.push_back(null.text + same_arms_words(shares));
    else
      open.push_back(null.text);
  }
  open.insert(open.begin(), tendons.begin(), tendons.end());
  std::string text = fmt::format(
      "\nthe data do not determine {} of {} directions; there the prior alone decides\n",
      all.size(), fit.problem.size());
  for (std::size_t i = 0; i < std::min(kOpenShown, open.size()); ++i)
    text += fmt::format("  {}\n", open[i]);
  if (tilts > 0)
    text += fmt::format("  {} only tilt or shift joint axes or turn the load cell\n", tilts);
  if (open.size() > kOpenShown) text += "  ... the result file has the full list\n";
  return text;
}

/// ", 0.8 times the stated noise", and what else is counted than the forces and their noise.
std::string noise_words(const FitResult& result, std::size_t e) {
  if (e >= result.misfits.size() || result.misfits[e].degrees_of_freedom == 0) return "";
  std::string words = fmt::format(", {:.1f} times the stated noise", result.misfits[e].times_noise);
  const FitProblem& problem = result.fit.problem;
  if (!problem.activations_of(static_cast<int>(e)).tasks.empty())
    words += " of forces and activations";
  // Sds that the settings widen, as those of several loads at once.
  const Experiment& experiment = problem.experiments()[e];
  const Eigen::Matrix3Xd& sd = problem.plans()[e].sd;
  for (std::size_t i = 0; i < experiment.trials.size(); ++i)
    if (sd(0, static_cast<Eigen::Index>(i)) > 1.001 * force_sd(experiment, experiment.trials[i])[0])
      return words + " and what the model is said to miss";
  return words;
}

/// "prior sds as the forces ask for: tendons x 0.01, .."; empty where they are as stated.
std::string scale_text(const Fit& fit) {
  const std::vector<ScaledPriors>& scales = fit.problem.parameters().scales;
  if (all_of(scales, [](const auto& each) { return each.factor == 1; })) return "";
  return fmt::format("prior sds as the forces ask for: {}\n",
                     each_in_words(scales, [](const ScaledPriors& scale) {
                       return fmt::format("{} x {:.4g}", scale.name, scale.factor);
                     }));
}

/// A value of a choice in the unit in which people write it: "4 deg".
std::string choice_words(const SettingChoice& choice, std::size_t at) {
  const double value = choice.values[at];
  if (choice.dimension == Dimension::kLength) return fmt::format("{:.4g} mm", 1e3 * value);
  if (choice.dimension == Dimension::kAngle) return fmt::format("{:.4g} deg", degrees(value));
  return fmt::format("{:.4g}", value);
}

std::string chosen_text(const FitResult& result) {
  if (!result.chosen) return "";
  const ChosenSettings& chosen = *result.chosen;
  if (chosen.tried.empty()) return "settings: stopped before the first had been tried\n";
  std::string text = fmt::format(
      "settings chosen by {}{}: log loss plus log relative error {:.3f}, {:.3f} before (relative "
      "error {:.3f}, {:.3f} before), {} settings tried\n",
      judged_words(chosen), chosen.status == Status::kStopped ? " (stopped)" : "", chosen.loss,
      chosen.tried.front().loss, chosen.error, chosen.tried.front().error, chosen.tried.size());
  for (const SettingChoice& choice : chosen.settings.choices) {
    std::string others;
    for (std::size_t i = 0; i < choice.values.size(); ++i)
      if (i != choice.chosen) others += (others.empty() ? "" : ", ") + choice_words(choice, i);
    text += fmt::format("  {:<44} {} (of {})\n", choice.name, choice_words(choice, choice.chosen),
                        others.empty() ? "nothing else" : others);
  }
  return text;
}

Fields choice_fields(const ChosenSettings& chosen) {
  std::vector<Fields> choices, tried;
  for (const SettingChoice& choice : chosen.settings.choices)
    choices.push_back({{"name", choice.name},
                       {"match", choice.match},
                       {"values", choice.values},
                       {"chosen", choice.value()}});
  for (const TriedSettings& one : chosen.tried)
    tried.push_back({{"chosen", one.chosen}, {"loss", one.loss}, {"relative_error", one.error}});
  const auto name = [](LeaveOut what) { return std::string(name_of(what)); };
  return {{"by", transformed(chosen.by, name)},
          {"loss", chosen.tried.empty() ? kNaN : chosen.loss},
          {"relative_error", chosen.tried.empty() ? kNaN : chosen.error},
          {"complete", chosen.status != Status::kStopped},
          {"choices", std::move(choices)},
          {"tried", std::move(tried)}};
}

std::string left_out_text(const CrossValidation& validation) {
  std::string text;
  for (const Prediction& p : validation.experiments)
    if (!p.trials.empty())
      text += fmt::format("  {:<20} {}: RMS error {:.3f} N, relative {:.3f}{}{}\n", p.experiment,
                          name_of(validation.what), p.error.rms, p.error.relative, trivial_words(p),
                          seen_words(p));
  if (validation.status == Status::kStopped)
    text += fmt::format("  {}: stopped after {} of {} folds; the errors are of those alone\n",
                        name_of(validation.what), validation.folds_done, validation.folds.size());
  return text;
}

/// One line for each experiment and subject, as published.
std::string published_text(const FitResult& result) {
  std::string text;
  for (const BaselinePrediction& one : result.published)
    text += fmt::format("  {:<20} {} as published: RMS error {:.3f} N, relative {:.3f}{}\n",
                        one.prediction.experiment, one.name, one.prediction.error.rms,
                        one.prediction.error.relative, seen_words(one.prediction));
  return text;
}

}  // namespace

std::string seen_words(const Prediction& prediction) {
  return prediction.calibrated_on_specimen ? " (the subject has seen this specimen)" : "";
}

std::string trivial_words(const Prediction& prediction, const std::string& who) {
  const std::optional<BesideTrivial> beside = beside_trivial(prediction);
  if (!beside) return "";
  const std::string share =
      beside->model.trials == prediction.error.trials
          ? ""
          : fmt::format(" (over {} of {} trials, {:.3f} by the model)", beside->model.trials,
                        prediction.error.trials, beside->model.relative);
  return fmt::format("; {} {:.3f}{}", who, beside->trivial.relative, share);
}

Field trivial_field(std::string key, const Prediction& prediction) {
  const std::optional<BesideTrivial> beside = beside_trivial(prediction);
  if (!beside) return {std::move(key), nullptr};
  return {std::move(key), Fields{{"trials", beside->trivial.trials},
                                 {"relative_error", beside->trivial.relative},
                                 {"relative_error_of_model", beside->model.relative}}};
}

std::string judged_words(const ChosenSettings& chosen) {
  return chosen.by.size() > 1 ? "postures and specimens left out" : "postures left out";
}

std::string refusal_of(const FitResult& result) {
  const Solution& found = result.fit.solution;
  if (found.converged() || result.outcome.stopped()) return "";
  std::string text =
      fmt::format("the fit has NOT converged: {} ({})", convergence_word(found), found.message);
  const bool told = found.message.find("is left") != std::string::npos;
  if (!told && std::isfinite(found.newton_step) && found.newton_step > 0)
    text += fmt::format("; a step of {:.2g} posterior sds is left", found.newton_step);
  return text + "; the best point found is given";
}

Fields fields_of(const FitResult& result) {
  const Fit& fit = result.fit;
  // State how the solver ended, and how much the data determine.
  Fields fields{{"status", convergence_word(fit.solution)},
                {"message", fit.solution.message},
                {"cost", fit.solution.cost},
                {"evaluations", fit.solution.evaluations},
                {"seconds", units::kMeasuredSeconds, fit.solution.seconds},
                {"free_coordinates", fit.problem.size()},
                {"effective_parameters", fit.covariance.effective_parameters},
                {"fidelity", describe(fit.problem.digit().fidelity)},
                {"warnings", result.outcome.warnings}};
  if (fit.solution.status == Status::kSolved) fields.add("learnt", learnt_fields(fit));
  fields.add_some("in_sample", in_sample_fields(result));
  std::vector<Fields> folds, published;
  fields.add_some("prior_scales",
                  fields_of_each(fit.problem.parameters().scales, [](const ScaledPriors& scale) {
                    return Fields{{"name", scale.name}, {"factor", scale.factor}};
                  }));
  if (result.chosen) fields.add("chosen_settings", choice_fields(*result.chosen));
  for (const FoldChoice& fold : result.fold_choices)
    folds.emplace_back(choice_fields(fold.settings)).add("fold", fold.fold);
  fields.add_some("fold_settings", std::move(folds));
  // Directions that the prior alone decides.
  if (const auto& open = fit.covariance.null_directions; !open.empty())
    fields.add("not_identifiable", transformed(open, &NullDirection::text));
  fields.add_some("left_out", left_out_fields(result));
  if (Fields rows = hood_row_fields(result); !rows.all().empty())
    fields.add("hood_rows", std::move(rows));
  for (const BaselinePrediction& one : result.published)
    published.emplace_back(error_fields(one.prediction)).add("subject", one.name);
  fields.add_some("published", std::move(published));
  return fields;
}

std::string text_of(const FitResult& result) {
  const Fit& fit = result.fit;
  std::string text =
      fmt::format("{}: {} after {}, {:.2f} s; {} free, the data determine {:.1f} parameters\n",
                  name_of(fit.method), convergence_word(fit.solution),
                  counted(fit.solution.evaluations, "evaluation"), fit.solution.seconds,
                  counted(fit.problem.size(), "coordinate"), fit.covariance.effective_parameters);
  for (std::size_t e = 0; e < result.in_sample.size(); ++e) {
    const Prediction& p = result.in_sample[e];
    const std::string error =
        p.error.trials > 0
            ? fmt::format("RMS error {:.3f} N, relative {:.3f}", p.error.rms, p.error.relative)
            : counted(fit.problem.experiments()[e].activations.size(), "row") + " of activations";
    text += fmt::format("  {:<20} in sample: {}{}\n", p.experiment, error, noise_words(result, e));
  }
  for (const CrossValidation& validation : result.left_out) text += left_out_text(validation);
  text += published_text(result);
  text += hood_row_text(result);
  text += chosen_text(result) + scale_text(fit);
  if (fit.solution.status == Status::kSolved) text += learnt_text(fit);
  return text + open_text(fit) + "\n";
}

Table choice_table(const FitResult& result) {
  Table table{{"setting", "tried", "at first", "chosen"}};
  if (!result.chosen || result.chosen->tried.empty()) return table;
  for (const FoldChoice& fold : result.fold_choices) table.header.push_back("without " + fold.fold);
  const std::vector<SettingChoice>& choices = result.chosen->settings.choices;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    // All values, then those in force: before, in the fit, and in every fold.
    std::string all;
    for (std::size_t k = 0; k < choices[i].values.size(); ++k)
      all += (k > 0 ? ", " : "") + choice_words(choices[i], k);
    const std::size_t first = result.chosen->tried.front().chosen[i];
    std::vector<std::string> row{choices[i].name, all, choice_words(choices[i], first),
                                 choice_words(choices[i], choices[i].chosen)};
    for (const FoldChoice& fold : result.fold_choices)
      row.push_back(choice_words(choices[i], fold.settings.settings.choices[i].chosen));
    table.add(std::move(row));
  }
  return table;
}

Table table_of(const FitResult& result) {
  const Fit& fit = result.fit;
  Table table{{"coordinate", "meaning", "estimate_prior_sds", "sd_prior_sds", "at_bound",
               "not_identifiable_share"}};
  for (const int i : sorted_by_sd(fit.covariance)) {
    const CoordinateEstimate& learnt = nth(fit.covariance.learnt, i);
    table.add({learnt.name, meaning_of(learnt.name, fit.problem.digit()), shown(learnt.z, 6),
               shown(learnt.sd, 6), learnt.at_bound ? "yes" : "no", shown(learnt.null_share, 6)});
  }
  return table;
}

}  // namespace thenar
