#include "studies/pages/thumb_recovery.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "base/numbers.h"
#include "base/special_functions.h"
#include "base/units.h"
#include "posterior/hand_posterior.h"
#include "report/pages/posterior.h"
#include "report/words.h"

namespace thenar {
namespace {

/// Prior sd of the first parameter of a kind that was free [display unit].
double stated_sd(const ThumbRecovery& of, ParameterKind kind) {
  const Parameter* first = find_where(of.fit->problem.parameters().all,
                                      [&](const Parameter& p) { return p.kind == kind; });
  return first == nullptr ? 0 : first->sd * display_scale(*first);
}

/// "five_axis_skewed" of "data/fits/five_axis_skewed.toml".
std::string stem_of(const SourceText& file) {
  return std::filesystem::path(file.path).stem().string();
}

/// "10 N" on each muscle of the trials, or "5 to 10 N".
std::string pulled_with(const std::vector<Trial>& trials) {
  double least = kInfinity, most = 0;
  for (const Trial& trial : trials)
    for (const auto& [muscle, tension] : trial.tension) {
      least = std::min(least, tension);
      most = std::max(most, tension);
    }
  return least < most ? fmt::format("{:g} to {:g} N", least, most) : fmt::format("{:g} N", most);
}

/// Describes the thumb of the made-up data, and how the data were generated.
std::string introduction(const ThumbRecovery& of) {
  // Numbers of the text are read from the settings, so that it stays true when they change.
  const std::vector<ActivationRow>& tasks = of.made_up.activations;
  const double activation_sd = tasks.empty() ? 0 : tasks.front().sd.begin()->second;
  const MadeUpNumbers numbers = made_up_numbers(of);
  return fmt::format(
             "[Miller2005] (sec. 3.2) came to the axes of its thumb by Markov chain Monte Carlo, "
             "fitted in a least-squares sense to thumbtip forces and electromyography. Those data "
             "are not at hand, so such data are made up here, with a thumb whose axes are known: "
             "the shipped {} [McFarland2023] [Hollister1995], {} muscles with constant moment arms "
             "and {} skew axes.\n\nData: {} on one muscle at a time, tip pinned, in {} postures "
             "({} trials), and {} tasks of {} people who push in several directions and postures, "
             "their muscles read by electromyography. The sd of a force is {:.0f} % of it, that of "
             "an activation {:.2f}; the seed is {}. In all {} components of force and {} "
             "activations.\n\n",
             stem_of(of.inputs.truth), of.truth.names.muscles.size(), of.axes.size(),
             pulled_with(of.made_up.trials), of.settings.postures, of.made_up.trials.size(),
             tasks.size(), of.settings.people, 100 * of.settings.noise, activation_sd,
             of.settings.seed, numbers.forces, numbers.activations) +
         fmt::format(
             "Both methods start from a thumb with axes at right angles and free all of them: two "
             "tilts (prior sd {:.0f} degrees) and two shifts ({:.0f} mm) each, moment arms being "
             "known. Least squares has the priors of {}, not those of the default fit, and its "
             "sds are those of the covariance; chains are NUTS on the same data and priors, with "
             "a factor on the noise. What the data were made with is marked as the truth.",
             stated_sd(of, ParameterKind::kAxisDirection), stated_sd(of, ParameterKind::kAxisPoint),
             stem_of(of.inputs.skewed));
}

/// "a, b" or "none".
std::string listed_parameters(const std::vector<std::string>& names) {
  return names.empty() ? "none" : each_in_words(names, words_of_axis_parameter);
}

Json axis_table(const ThumbRecovery& of) {
  // Angles between the true axis and that of the start, of least squares and of the chains.
  Json rows = Json::array();
  for (const RecoveredAxis& axis : of.axes)
    rows.push_back({axis.joint, degrees(axis.start_error), degrees(axis.fit_error),
                    degrees(axis.drawn_error), degrees(axis.drawn_within),
                    axis.covered() ? "yes" : "NO", 100 * axis.fit_left, 100 * axis.drawn_left});
  return table_block(
      "Directions of the axes: angles from the true axis, before and after. 95 % of the draws "
      "lie within the stated angle of their mean. What is left of the prior's sd is the rms of "
      "both tilts",
      {"axis", "start is off [deg]:1", "least squares is off [deg]:1", "chains are off [deg]:1",
       "95 % of draws within [deg]:1", "truth among them", "least squares keeps [% of prior sd]:0",
       "chains keep [% of prior sd]:0"},
      std::move(rows));
}

/// A row of an interval chart: one method's word on one number.
Json interval_of(const RecoveredNumber& number, const char* method, const RecoveredValue& of) {
  return {{"name", fmt::format("{}, {}", words_of_axis_parameter(number.name), method)},
          {"estimate", of.value},
          {"low", of.low},
          {"high", of.high},
          {"prior_low", -kNormal95HalfWidth * number.prior_sd},
          {"prior_high", kNormal95HalfWidth * number.prior_sd},
          {"truth", number.truth},
          {"unit", number.unit}};
}

/// Tilts or shifts by both methods.
Json interval_chart(const ThumbRecovery& of, const char* unit, const char* what) {
  // One interval for each method, beside the prior and the truth.
  Json rows = Json::array();
  for (const RecoveredNumber& number : of.numbers) {
    if (number.unit != unit) continue;
    rows.push_back(interval_of(number, "least squares", number.fit));
    rows.push_back(interval_of(number, "chains", number.drawn));
  }
  return interval_block(
      fmt::format("{} of the axes from those of the start, with 95 % intervals of both methods, of "
                  "the prior, and the truth",
                  what),
      fmt::format("from the start [{}]", unit), std::move(rows));
}

/// The start states its places to 0.01 mm: what is less is its rounding, and no truth.
double to_hundredths(double value) { return std::round(100 * value) / 100; }

Json number_table(const ThumbRecovery& of) {
  // An sd near the prior's means that the data say nothing about this number.
  Json rows = Json::array();
  for (const RecoveredNumber& number : of.numbers)
    rows.push_back({words_of_axis_parameter(number.name), number.unit, to_hundredths(number.truth),
                    number.fit.value, number.fit.sd, number.drawn.value, number.drawn.sd,
                    100 * number.fit.sd / number.prior_sd,
                    100 * number.drawn.sd / number.prior_sd});
  return table_block(
      "Every tilt and shift beside the truth",
      {"number", "unit", "truth:2", "least squares:2", "sd:2", "mean of draws:2", "sd:2",
       "least squares keeps [% of prior sd]:0", "chains keep [% of prior sd]:0"},
      std::move(rows));
}

/// Describes the asymmetry of the draws of a number: their reach to either side of the mean.
std::string skew_words(const ThumbRecovery& of, const std::string& name) {
  // Draws may be skewed, which an sd from a covariance cannot show.
  const RecoveredNumber* worst = find_named(of.numbers, name);
  if (worst == nullptr) return "";
  const RecoveredValue& drawn = worst->drawn;
  return fmt::format(
      " There 95 % of the draws reach from {:.1f} sds below their mean to {:.1f} above it (a "
      "normal distribution: {:.1f} both).",
      (drawn.value - drawn.low) / drawn.sd, (drawn.high - drawn.value) / drawn.sd,
      kNormal95HalfWidth);
}

/// Agreement of both methods and what they could not tell, in words.
std::string agreement_words(const ThumbRecovery& of) {
  // Differences are measured in sds of the posterior, as sds of least squares hold for a linear
  // model alone.
  const MethodAgreement& a = of.agreement;
  return fmt::format(
      "Agreement: the best point of least squares and the mean of the chains differ by {:.2f} sds "
      "of the posterior (rms over {} numbers), at most by {:.2f}, in {}; sds of least squares are "
      "{:.2f} to {:.2f} times those of the chains.{}{} Of the {} true numbers {} lie within the 95 "
      "% intervals of least squares and {} within those of the chains.\n\nWhat could not be told "
      "(more than {:.0f} % of the prior's sd is left): by least squares {}; by the chains {}.",
      a.rms, of.numbers.size(), a.worst, words_of_axis_parameter(a.worst_name), a.least_sd_ratio,
      a.most_sd_ratio,
      a.rms < kMethodsAgree ? std::string()
                            : fmt::format(" They do NOT agree to {:.1f} sds.", kMethodsAgree),
      skew_words(of, a.worst_name), of.numbers.size(), a.fit_covered, a.drawn_covered,
      100 * kUndecidedShare, listed_parameters(a.fit_undecided),
      listed_parameters(a.drawn_undecided));
}

/// Says whether the search of least squares ended at a minimum.
Json fit_banner(const ThumbRecovery& of) {
  const Solution& solution = of.fit->solution;
  const bool ok = solution.status == Status::kSolved;
  return with(
      banner_block(ok ? "Least squares has converged" : "Least squares has NOT converged",
                   ok ? Json::array() : Json::array({solution.message}), ok),
      {{"text", fmt::format("{} evaluations, {:.1f} s", solution.evaluations, solution.seconds)}});
}

Json clouds_of(const ThumbRecovery& of) {
  const HandPosterior& posterior = *of.run.posterior;
  const AxisCloud cloud = axis_cloud(
      "chains", posterior.problem().digit(), posterior.problem().parameters(),
      posterior.moving_parameters(), posterior.values(pooled(of.run.draws)).specimens.front());
  return axis_cloud_picture(
      of.start, Eigen::VectorXd::Zero(of.start.model.coordinates), {cloud}, of.truth.model,
      "Axes of the thumb at draws of the posterior of made-up forces and muscle activity; the axes "
      "of the start by name, and the true ones");
}

}  // namespace

std::string words_of_axis_parameter(const std::string& name) {
  // "axis", the joint, what of it, which.
  const std::size_t joint = name.find('/') + 1, what = name.find('/', joint) + 1,
                    which = name.rfind('/') + 1;
  if (name.rfind("axis/", 0) != 0 || what == 0 || which == what) return name;
  return fmt::format("{} {} {}", name.substr(joint, what - 1 - joint),
                     name.substr(what, which - 1 - what) == "direction" ? "tilt" : "shift",
                     name.substr(which));
}

MadeUpNumbers made_up_numbers(const ThumbRecovery& of) {
  MadeUpNumbers numbers;
  numbers.forces = 3 * (of.made_up.trials.size() + of.made_up.activations.size());
  for (const ActivationRow& row : of.made_up.activations)
    numbers.activations += row.activation.size();
  return numbers;
}

std::string recovery_doubts(const ThumbRecovery& recovery) {
  std::string doubts;
  if (!recovery.run.convergence.warnings.empty()) doubts += " The chains have NOT converged.";
  if (recovery.fit->solution.status != Status::kSolved)
    doubts += " Least squares has NOT converged.";
  return doubts;
}

KeptAxes kept_axes(const ThumbRecovery& recovery) {
  KeptAxes kept{1, 0};
  for (const RecoveredAxis& axis : recovery.axes) {
    kept.least = std::min(kept.least, axis.drawn_left);
    kept.most = std::max(kept.most, axis.drawn_left);
  }
  return kept;
}

Json thumb_recovery_section(const ThumbRecovery& recovery) {
  return section(
      "founding-thumb", "The thumb: its axes from made-up data", introduction(recovery),
      Json::array({convergence_banner(recovery.run.convergence, describe_run(recovery.run)),
                   fit_banner(recovery), axis_table(recovery),
                   text_block(agreement_words(recovery)), interval_chart(recovery, "deg", "Tilts"),
                   interval_chart(recovery, "mm", "Shifts"), number_table(recovery),
                   clouds_of(recovery)}));
}

}  // namespace thenar
