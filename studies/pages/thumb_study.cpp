#include "studies/pages/thumb_study.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "base/units.h"
#include "posterior/hand_posterior.h"
#include "report/pages/posterior.h"
#include "report/picture/axis_cloud.h"
#include "report/picture/hand_picture.h"
#include "report/provenance.h"

namespace thenar {
namespace {

const char* const kIntroduction =
    "The forces of a skewed thumb are made up, as a load cell would read them, and explained by "
    "two models that start from the same mechanical thumb: one keeps its axes in orthogonal "
    "crossing pairs, which move as wholes, the other lets each of the five axes tilt and shift by "
    "itself [GraspIt]. The true thumb is that of [McFarland2023] with a fifth axis "
    "[Hollister1995]; 10 N pull one of nine muscles at a time, tip pinned, in key and opposition "
    "pinch (two postures) and up to four. Arms are known to both models, or free with the same "
    "wide prior.\n\nTasks are 80 pinches as in [ValeroCuevas2003]: eight people push in five "
    "directions in two postures, their muscles read by electromyography to 0.05 of full "
    "activation; unless a row says so they are predicted, not fitted. A task is explained if the "
    "measured force is within the 95 % region of noise and activation errors. [ValeroCuevas2003] "
    "reports, of orthogonal thumbs that were not fitted to forces: misdirection 74.3 \u00b1 24.5 "
    "degrees, torque 0.64 \u00b1 0.28 N m, and at most half of 80 patterns.";

Json scores(const TaskScores& tasks) {
  return {degrees(tasks.direction), degrees(tasks.direction_sd), tasks.torque, tasks.torque_sd,
          100 * tasks.explained};
}

/// The orthogonal fit of the same data.
const ThumbFit* rival_of(const ThumbStudy& study, const ThumbFit& fit) {
  const ThumbFitSettings& s = fit.settings;
  return find_where(study.fits, [&](const ThumbFit& other) {
    const ThumbFitSettings& o = other.settings;
    return !o.skewed && s.skewed && o.arms == s.arms && o.noise == s.noise &&
           o.postures == s.postures && o.skewness == s.skewness && o.with_tasks == s.with_tasks &&
           o.prior_width == s.prior_width;
  });
}

Json fit_row(const ThumbStudy& study, const ThumbFit& fit) {
  // Errors of pulls, then scores of tasks.
  Json row{describe_fit(fit.settings), degrees(fit.direction), degrees(fit.direction_sd),
           100 * fit.relative_error};
  row = joined(std::move(row), scores(fit.tasks));
  Json gained{nullptr, nullptr};
  if (const ThumbFit* rival = rival_of(study, fit)) {
    const ElpdDifference gain = compare_elpd(fit.left_out, rival->left_out);
    gained = {gain.elpd, gain.se};
  }
  row = joined(std::move(row), gained);
  // Tell whether the left-out density and the chains may be believed.
  row.push_back((fit.left_out.k.array() > fit.left_out.good_k).count());
  row.push_back(fit.run.convergence.worst_r_hat);
  row.push_back(fit.converged() ? "yes" : "NO");
  return row;
}

Json reference_row(const char* name, const ThumbReference& reference, const Json& pulls,
                   const TaskScores& tasks) {
  Json row{
      fmt::format("{}, {:.0f} % noise{}", name, 100 * reference.noise,
                  reference.skewness == 1 ? "" : fmt::format(", {} x skew", reference.skewness))};
  row = joined(joined(std::move(row), pulls), scores(tasks));
  return joined(std::move(row), {nullptr, nullptr, nullptr, nullptr, "not fitted"});
}

Json convergence_block(const ThumbStudy& study) {
  // Collect the reasons why chains of a fit are not to be relied on.
  Json warnings = Json::array();
  for (const ThumbFit& fit : study.fits)
    for (const std::string& reason : fit.run.convergence.warnings)
      warnings.push_back(describe_fit(fit.settings) + ": " + reason);
  if (!study.complete) warnings.push_back("the study was stopped: some fits are missing");
  const bool ok = warnings.empty();
  return with(
      banner_block(ok ? "The chains of all fits agree" : "Some fits are NOT to be relied on",
                   warnings, ok),
      {{"text",
        fmt::format("{} fits by NUTS, 4 chains each, every number must have an R-hat below 1.01",
                    study.fits.size())}});
}

/// Both models' clouds of one fit at 10 % noise, with the true axes.
Json clouds_block(const ThumbStudy& study) {
  // Choose the fits whose settings are those of the main comparison.
  std::vector<AxisCloud> clouds;
  for (const ThumbFit& fit : study.fits) {
    if (!is_compared(fit.settings)) continue;
    const HandPosterior& posterior = *fit.run.posterior;
    clouds.push_back(axis_cloud(fit.settings.skewed ? "skewed" : "orthogonal",
                                posterior.problem().digit(), posterior.problem().parameters(),
                                posterior.moving_parameters(),
                                posterior.values(pooled(fit.run.draws)).specimens.front()));
  }
  if (clouds.empty()) return Json::array();
  return Json::array({axis_cloud_picture(
      study.start, Eigen::VectorXd::Zero(study.start.model.coordinates), clouds, study.truth.model,
      "Axes of the thumb at draws of the posteriors of both models, 10 % noise, two postures, arms "
      "known; the axes of the start by name, and the true ones")});
}

}  // namespace

Json thumb_comparison_table(const ThumbStudy& study) {
  const std::vector<BlockColumn> columns{"thumb",
                                         "pulls misdirected [deg]:1",
                                         "sd [deg]:1",
                                         "off the truth [%]:1",
                                         "tasks misdirected [deg]:1",
                                         "sd [deg]:1",
                                         "torque left [N m]:3",
                                         "sd [N m]:3",
                                         "explained [%]:0",
                                         "elpd gained:1",
                                         "se:1",
                                         "Pareto k too large:0",
                                         "R-hat:4",
                                         "chains agree"};
  Json rows = Json::array();
  // Thumbs without a fit come first: the start, and the truth, which no fit can beat.
  for (const ThumbReference& reference : study.references) {
    rows.push_back(reference_row(
        "orthogonal, as it stands", reference,
        {degrees(reference.direction), degrees(reference.direction_sd), nullptr}, reference.start));
    rows.push_back(reference_row("the truth", reference, {nullptr, nullptr, 0}, reference.truth));
  }
  for (const ThumbFit& fit : study.fits) rows.push_back(fit_row(study, fit));
  return table_block(
      "How well each model explains forces of one muscle at a time (pulls) and of whole "
      "coordination (tasks). Off the truth: rms of posterior mean less true force of pulls, over "
      "the rms force. elpd gained: expected log predictive density of left-out pulls over that of "
      "the orthogonal model on the same data, by PSIS; where Pareto k is too large for some "
      "trials it is a rough one",
      columns, std::move(rows));
}

/// Ratios of posterior to prior sd, summed over coordinates of an axis and over fits.
struct Learnt {
  double ratios = 0;
  int count = 0;
};
/// Sums of ratios by noise [%] or by number of postures.
using LearntOver = std::map<double, Learnt>;

/// Returns true if a fit is a point of the chart: one of the skewed thumb in which nothing else was
/// changed.
bool is_point(const ThumbFitSettings& s, Over over, Arms arms) {
  return s.skewed && s.arms == arms && s.skewness == 1 && !s.with_tasks && s.prior_width == 1 &&
         (over == Over::kNoise ? s.postures == 2 : s.noise == 0.1);
}

/// "IP1 point" of "axis/IP1/point/2"; "" of what is no axis.
std::string part_of_axis(const std::string& parameter) {
  if (parameter.rfind("axis/", 0) != 0) return "";
  const std::size_t joint = parameter.find('/', 5), end = parameter.rfind('/');
  return fmt::format("{} {}", parameter.substr(5, joint - 5),
                     parameter.substr(joint + 1, end - joint - 1));
}

/// Collects the ratio of sd to prior sd for each part of an axis, in the order of the parameters.
std::vector<std::pair<std::string, LearntOver>> learnt_axes(const ThumbStudy& study, Over over,
                                                            Arms arms) {
  // Average over the two tilts or shifts of an axis, at each noise or number of postures.
  std::vector<std::pair<std::string, LearntOver>> axes;
  for (const ThumbFit& fit : study.fits) {
    if (!is_point(fit.settings, over, arms)) continue;
    const double x = over == Over::kNoise ? 100 * fit.settings.noise : fit.settings.postures;
    for (const LearntNumber& number : fit.learnt) {
      const std::string part = part_of_axis(number.name);
      if (part.empty()) continue;
      auto of = std::find_if(axes.begin(), axes.end(),
                             [&](const auto& one) { return one.first == part; });
      if (of == axes.end()) of = axes.insert(axes.end(), {part, {}});
      Learnt& learnt = of->second[x];
      learnt.ratios += number.sd / number.prior_sd;
      ++learnt.count;
    }
  }
  return axes;
}

Json learnt_chart(const ThumbStudy& study, Over over, Arms arms) {
  // One line for each part of an axis.
  const auto mean = [](const auto& point) { return point.second.ratios / point.second.count; };
  const Json lines = list_of_each(learnt_axes(study, over, arms), [&](const auto& axis) {
    return curve_of_each(axis.first, axis.second, &LearntOver::value_type::first, mean, "both");
  });
  return with(
      lines_block(
          fmt::format("What is left of the prior's sd of each axis of the skewed thumb, over the "
                      "{}; arms {}. 1: nothing was learnt",
                      over == Over::kNoise ? "noise of the load cell, two postures"
                                           : "number of postures, 10 % noise",
                      arms == Arms::kFixed ? "known" : "free"),
          over == Over::kNoise ? "noise [%]" : "postures", "posterior sd / prior sd [1]", lines),
      {{"reference_lines", Json::array({{{"value", 1}, {"label", "nothing learnt"}}})}});
}

Json thumb_mode_table(const ThumbStudy& study) {
  // Laplace's approximation and the draws give each mode its share: they should agree.
  Json rows = Json::array();
  for (const ThumbFit& fit : study.fits)
    for (std::size_t m = 0; m < fit.run.mode_table.modes.size(); ++m) {
      const ModeMass& mode = fit.run.mode_table.modes[m];
      const bool known = mode.known >= 0;
      const Mode* found = known ? &nth(fit.run.modes, mode.known) : nullptr;
      rows.push_back(
          {describe_fit(fit.settings), m + 1, known ? Json(found->cost) : Json(nullptr),
           known ? Json(found->hits) : Json(nullptr),
           known ? Json(100 * found->laplace_mass) : Json(nullptr), 100 * mode.mass,
           100 * mode.mcse, mode.crossings,
           fit.run.mode_table.warnings.empty() ? "" : fit.run.mode_table.warnings.front()});
    }
  return table_block(
      "Modes of every posterior: searches from many starts that ended there, the share that "
      "Laplace's approximation gives it, and the share of the draws. A fit with a single row has "
      "one mode",
      {"fit", "mode:0", "cost:2", "searches:0", "Laplace [%]:1", "share of draws [%]:1",
       "MCSE [%]:1", "crossings:0", "doubt"},
      std::move(rows));
}

Json thumb_type_table(const ThumbStudy& study) {
  // Shares of types in the prior and in the posterior, with Monte Carlo errors.
  Json rows = Json::array();
  for (const ThumbFit& fit : study.fits)
    for (const TypeProbability& each : fit.types)
      rows.push_back({describe_fit(fit.settings), describe_type(each.type, study.criteria.toward),
                      100 * each.prior, 100 * each.posterior, 100 * each.mcse});
  return table_block(
      "Types of thumbs [SantosValeroCuevas2006] that the skewed model may be: by the order of the "
      "MCP axes, and by the side of the common normal of two successive axes. Shares of draws "
      "before the forces and after",
      {"fit", "type", "before [%]:1", "after [%]:1", "MCSE [%]:1"}, std::move(rows));
}

Json thumb_study_section(const ThumbStudy& study,
                         const std::optional<ThumbCalibration>& calibration) {
  // Charts of what was learnt, with known arms and with free ones.
  Json blocks = Json::array({convergence_block(study), thumb_comparison_table(study)});
  for (const Arms arms : {Arms::kFixed, Arms::kFree}) {
    Json charts = Json::array();
    for (const Over over : {Over::kNoise, Over::kPostures}) {
      Json chart = learnt_chart(study, over, arms);
      if (!chart["series"].empty()) charts.push_back(std::move(chart));
    }
    if (!charts.empty()) blocks.push_back(row_block(std::move(charts)));
  }
  blocks = joined(std::move(blocks), clouds_block(study));
  blocks.push_back(thumb_mode_table(study));
  Json types = thumb_type_table(study);
  if (!types["rows"].empty()) blocks.push_back(std::move(types));
  // Calibration tells whether the sampler finds the true thumb as often as it claims.
  if (calibration && !calibration->judged.parameters.empty()) {
    if (!calibration->judged.warnings.empty())
      blocks.push_back(
          banner_block("The sampler is not calibrated on thumbs", calibration->judged.warnings));
    blocks.push_back(calibration_chart({calibration->names, calibration->rank, calibration->ranked,
                                        calibration->judged.warnings}));
  }
  return section("thumb-study", "What forces tell of a thumb's axes", kIntroduction,
                 std::move(blocks));
}

Json page_of(const ThumbStudyResult& result) {
  const ThumbStudyInputs& inputs = result.study.inputs;
  Json provenance = provenance_json(
      {inputs.truth, inputs.start, inputs.orthogonal, inputs.skewed, inputs.criteria},
      result.study.truth.fidelity);
  provenance["seed"] = fmt::format("{}", result.seed);
  return {{"title", "thenar: what forces tell of a thumb"},
          {"subtitle", "Orthogonal and skewed axes on made-up forces of a skewed thumb"},
          {"provenance", provenance},
          {"sections", Json::array({thumb_study_section(result.study, result.calibration)})}};
}

}  // namespace thenar
