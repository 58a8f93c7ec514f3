#include "report/pages/measured_lessons.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/special_functions.h"
#include "base/units.h"
#include "report/pages/thumb_recovery.h"

namespace thenar {
namespace {

/// Mean and sd of a row of predictions, without those that are no number.
Json mean_and_sd(const Eigen::RowVectorXd& values) {
  double sum = 0, squares = 0, count = 0;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    sum += value;
    squares += value * value;
    ++count;
  }
  if (count == 0) return {nullptr, nullptr};
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

/// A row of the table of measurements: measured, and by the draws of each.
Json measured_row(const std::string& name, double measured, double sd, double truth,
                  const std::vector<Eigen::RowVectorXd>& by_draws, const std::string& source) {
  Json row{name, measured, sd, std::isnan(truth) ? Json(nullptr) : Json(truth)};
  for (const Eigen::RowVectorXd& values : by_draws)
    for (const Json& cell : mean_and_sd(values)) row.push_back(cell);
  row.push_back(source);
  return row;
}

Json measured_table(const MeasuredLessons& of) {
  const auto of_draws = [&](auto row) {
    std::vector<Eigen::RowVectorXd> rows;
    for (const ReweightedDraws& draws : of.reweighted) rows.push_back(row(draws.predicted));
    return rows;
  };
  Json rows = Json::array();
  // Components of the force, in the order of the file.
  const Trial& trial = of.force.trials.front();
  const Eigen::Vector3d sd = force_sd(of.force, trial);
  constexpr const char* kComponents[] = {"proximal", "palmar", "radial"};
  for (int i = 0; i < 3; ++i)
    rows.push_back(measured_row(fmt::format("FPL 10 N: force, {} [N]", kComponents[i]),
                                trial.force[i], sd[i], of.truth.force(i, 0),
                                of_draws([&](const MeasuredPredictions& p) -> Eigen::RowVectorXd {
                                  return p.force.row(i);
                                }),
                                of.force.source));
  // Losses of pinch.
  for (std::size_t b = 0; b < of.losses.blocks.size(); ++b) {
    const NerveBlock& block = of.losses.blocks[b];
    const auto row = static_cast<Eigen::Index>(b);
    rows.push_back(measured_row(fmt::format("pinch lost, {} block [1]", block.nerve), block.loss,
                                block.sd, of.truth.loss(row, 0),
                                of_draws([&](const MeasuredPredictions& p) -> Eigen::RowVectorXd {
                                  return p.loss.row(row);
                                }),
                                block.source));
  }
  std::vector<BlockColumn> columns{
      {"measured", ""}, {"value", "", 2}, {"sd, assumed", "", 2}, {"the shipped thumb", "", 2}};
  for (const ReweightedDraws& draws : of.reweighted) {
    columns.push_back({draws.name + ": mean", "", 2});
    columns.push_back({"sd", "", 2});
  }
  columns.push_back({"source", ""});
  return table_block(
      "What was measured in people, and what thumbs say of it: the shipped one, and the draws of "
      "prior and posterior, means and sds over draws. Of thumbs that cannot press in key pinch "
      "nothing is "
      "lost; they are left out of the means of losses",
      columns, std::move(rows));
}

Json update_table(const MeasuredLessons& of) {
  Json rows = Json::array();
  for (const ReweightedDraws& draws : of.reweighted)
    for (const DataUpdate& update : draws.updates) {
      const KeptShares kept = kept_shares(draws, update);
      rows.push_back({draws.name, update.added.name, update.weights.weight.size(),
                      update.weights.effective_size,
                      std::isfinite(update.weights.k) ? Json(update.weights.k) : Json(nullptr),
                      update.weights.good_k, update.weights.reliable() ? "yes" : "NO",
                      100 * kept.rms, 100 * kept.least, kept.least_name, 100 * kept.most,
                      kept.largest_shift, kept.largest_shift_name});
    }
  return table_block(
      "What each addition leaves of the sds of ten tilts, by self-normalised importance weights "
      "over draws. Effective size: 1 over the sum of squared weights. Where Pareto k is above its "
      "limit the row is not to be believed: too few draws say what was measured",
      {{"draws of", ""},
       {"added", ""},
       {"how many", "", 0},
       {"effective size", "", 0},
       {"Pareto k", "", 2},
       {"limit", "", 2},
       {"reliable", ""},
       {"sd kept, rms", "%", 0},
       {"least", "%", 0},
       {"of", ""},
       {"most", "%", 0},
       {"largest shift of a mean", "sds", 2},
       {"of", ""}},
      std::move(rows));
}

Json tilt_table(const MeasuredLessons& of) {
  std::vector<BlockColumn> columns{{"tilt", ""}};
  for (const ReweightedDraws& draws : of.reweighted) {
    columns.push_back({"sd " + draws.name, "deg", 1});
    columns.push_back({"with both measurements", "deg", 1});
    columns.push_back({"ratio", "", 2});
    columns.push_back({"its error", "", 2});
  }
  Json rows = Json::array();
  for (std::size_t i = 0; i < of.reweighted.front().names.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    Json row{words_of_axis_parameter(of.reweighted.front().names[i])};
    for (const ReweightedDraws& draws : of.reweighted) {
      const WeightedSpread& with = update_by_both(draws).tilts;
      row.push_back(degrees(with.sd[at] / with.sd_ratio[at]));
      row.push_back(degrees(with.sd[at]));
      row.push_back(with.sd_ratio[at]);
      row.push_back(with.sd_ratio_error[at]);
    }
    rows.push_back(std::move(row));
  }
  return table_block(
      "The sd of every tilt before and after both measurements; the error of a ratio is that of "
      "the draws (Monte Carlo)",
      columns, std::move(rows));
}

/// What is left of every tilt's sd, by the draws of each.
Json kept_chart(const MeasuredLessons& of) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < of.reweighted.front().names.size(); ++i)
    for (const ReweightedDraws& draws : of.reweighted) {
      const WeightedSpread& with = update_by_both(draws).tilts;
      const auto at = static_cast<Eigen::Index>(i);
      rows.push_back(
          {{"name", fmt::format("{}, {}", words_of_axis_parameter(draws.names[i]), draws.name)},
           {"estimate", with.sd_ratio[at]},
           {"low", with.sd_ratio[at] - kNormal95 * with.sd_ratio_error[at]},
           {"high", with.sd_ratio[at] + kNormal95 * with.sd_ratio_error[at]}});
    }
  return {
      {"type", "interval"},
      {"caption",
       "What both measurements leave of the sd of every tilt; bars are 95 % of Monte Carlo error"},
      {"key", "sd with the measurements over sd without"},
      {"x_label", "share of the sd that is left [1]"},
      {"rows", std::move(rows)},
      {"reference_lines", Json::array({{{"value", 1}, {"label", "nothing learnt"}}})}};
}

/// What the measurements are, and what is assumed of them.
std::string measurements_words(const MeasuredLessons& of) {
  const Trial& trial = of.force.trials.front();
  const Eigen::Vector3d f = trial.force, sd = force_sd(of.force, trial);
  std::vector<std::string> sds;
  for (const NerveBlock& block : of.losses.blocks)
    sds.push_back(fmt::format("{:.2f} ({})", block.sd, block.nerve));
  return fmt::format(
             "Two kinds of numbers are published. [Towles2004], of seven cadavers: in key pinch 10 "
             "N of FPL make {:.2f} N at the tip, {:.0f} degrees from proximal towards palmar. No "
             "sd was published; {:.1f} N of each component are ASSUMED: FPL's direction in eleven "
             "other thumbs was 66 (46) degrees [Towles2008], the bracket taken for the sd between "
             "thumbs, and 46 degrees over the root of seven are 17, which across the force are "
             "0.51 N. Nor was told how the tip was held, or at which angles: pinned, in the key "
             "pinch of the made-up data.\n\n",
             f.norm(), std::atan2(f.y(), f.x()) / kDegree, sd.x()) +
         fmt::format(
             "Losses of key pinch under blocks of the ulnar and the median nerve and of both "
             "[Kozin1999] were read in a third party, that under a radial block in an abstract "
             "[RadialBlock]. Their sds are ASSUMED too, {}: the wrist drops under a radial block, "
             "and none is here. So is that either of two nerves serves half of the one FPB of this "
             "thumb. A model's pinch is the largest palmar force of the pinned tip within {:.0f} "
             "degrees, every joint in balance, by linear programming; a block takes away the "
             "strength of its muscles.\n\n",
             fmt::join(sds, ", "), of.losses.tolerance / kDegree) +
         fmt::format(
             "Draws are weighed by how well they say these {} numbers: draws of the prior, to see "
             "what the measurements teach alone, and draws of the posterior of the made-up data.",
             3 + of.losses.blocks.size());
}

/// By how many assumed sds the thumb of the made-up data misses what was measured.
struct Misses {
  double rms = 0, worst = 0;  // [sd]
  std::string worst_name;
};
Misses misses_of_truth(const MeasuredLessons& of) {
  Misses misses;
  int count = 0;
  const auto add = [&](const std::string& name, double sds) {
    misses.rms += sds * sds;
    ++count;
    if (std::abs(sds) < misses.worst) return;
    misses.worst = std::abs(sds);
    misses.worst_name = name;
  };
  // Components of FPL's force, and losses.
  const Trial& trial = of.force.trials.front();
  const Eigen::Vector3d sd = force_sd(of.force, trial);
  for (int i = 0; i < 3; ++i) add("FPL's force", (of.truth.force(i, 0) - trial.force[i]) / sd[i]);
  for (std::size_t b = 0; b < of.losses.blocks.size(); ++b) {
    const NerveBlock& block = of.losses.blocks[b];
    add(fmt::format("the loss under the {} block", block.nerve),
        (of.truth.loss(static_cast<Eigen::Index>(b), 0) - block.loss) / block.sd);
  }
  misses.rms = std::sqrt(misses.rms / count);
  return misses;
}

/// " (NOT reliable ..)" where weights are not.
std::string doubt_of(const DataUpdate& update) {
  return update.weights.reliable() ? "" : " (NOT reliable: Pareto k is above its limit)";
}

/// Draws whose pinch linear programming did not decide; "" if there are none.
std::string undecided_words(const ReweightedDraws& draws) {
  const Eigen::Index undecided = (draws.predicted.undecided.array() > 0).count();
  return undecided == 0 ? ""
                        : fmt::format(
                              " Of {} draws {} the pinch is UNDECIDED (unbounded, or not found by "
                              "linear programming): they have no weight once losses are added.",
                              undecided, draws.name);
}

/// How little was learnt alone, in words.
std::string alone_words(const ThumbRecoveryResult& result) {
  const MeasuredLessons& of = result.lessons;
  const ReweightedDraws& prior = of.reweighted.front();
  const DataUpdate& both = update_by_both(prior);
  const KeptShares kept = kept_shares(prior, both);
  const KeptAxes made_up = kept_axes(result.recovery);
  return fmt::format(
      "Alone, the {} numbers leave {:.0f} to {:.0f} % of the prior's sd of ten tilts, {:.0f} % in "
      "the rms{}, where the {} made-up numbers leave {:.0f} to {:.0f} % of an axis. {} of {} tilts "
      "are narrower by two errors or more. The largest change is one of place: the mean of {} "
      "moves by {:.1f} prior sds. Of {} thumbs of the prior {} cannot press in key pinch at all "
      "and have no weight: that people can is a part of what is learnt.{}\n\n",
      3 + of.losses.blocks.size(), 100 * kept.least, 100 * kept.most, 100 * kept.rms,
      doubt_of(both), made_up_numbers(result.recovery), 100 * made_up.least, 100 * made_up.most,
      kept.narrower, prior.names.size(), kept.largest_shift_name, std::abs(kept.largest_shift),
      prior.tilts.cols(), (prior.predicted.intact.array() < kNoPinch).count(),
      undecided_words(prior));
}

/// What is added to the made-up data, and that both are not of one thumb.
std::string beside_words(const MeasuredLessons& of) {
  const ReweightedDraws& posterior = of.reweighted.back();
  const DataUpdate& both = update_by_both(posterior);
  const KeptShares kept = kept_shares(posterior, both);
  const Misses misses = misses_of_truth(of);
  return fmt::format(
      "Beside the made-up data they leave {:.0f} to {:.0f} % of what those had left ({:.0f} % in "
      "the rms{}); a ratio above 1 is no error, as numbers that disagree with a posterior may "
      "widen it. And they do disagree: the made-up data are of the shipped thumb, which misses the "
      "measured numbers by {:.1f} assumed sds (rms), most of all {} by {:.1f}. What moves there is "
      "conflict between two thumbs, not knowledge of one.{}\n\n",
      100 * kept.least, 100 * kept.most, 100 * kept.rms, doubt_of(both), misses.rms,
      misses.worst_name, misses.worst, undecided_words(posterior));
}

/// Additions whose weights are not to be believed, and what would have to be measured.
std::string limits_words(const MeasuredLessons& of) {
  std::vector<std::string> doubtful;
  for (const ReweightedDraws& draws : of.reweighted)
    for (const DataUpdate& update : draws.updates)
      if (!update.weights.reliable())
        doubtful.push_back(fmt::format("{} ({}, effective size {:.0f})", update.added.name,
                                       draws.name, update.weights.effective_size));
  const std::string unreliable =
      doubtful.empty() ? "All weights are reliable by their Pareto k."
                       : fmt::format("Not to be believed by their Pareto k are the weights of {}.",
                                     fmt::join(doubtful, "; "));
  return unreliable +
         " Five axes have ten tilts and ten shifts. A handful of numbers of one posture, with sds, "
         "angles and a hold that had to be assumed, does not find them. Whoever wants the founding "
         "way on a real thumb has to measure forces of single muscles, and tasks, in several "
         "postures, as the made-up data do.";
}

}  // namespace

const DataUpdate& update_by_both(const ReweightedDraws& draws) {
  return *std::find_if(draws.updates.begin(), draws.updates.end(), [](const DataUpdate& update) {
    return update.added.force && update.added.losses && update.added.sd_factor == 1 &&
           !update.added.clamped;
  });
}

KeptShares kept_shares(const ReweightedDraws& draws, const DataUpdate& update) {
  // Extremes over the tilts, by name.
  const WeightedSpread& tilts = update.tilts;
  Eigen::Index least = 0, shifted = 0;
  KeptShares kept{};
  kept.rms = std::sqrt(tilts.sd_ratio.array().square().mean());
  kept.least = tilts.sd_ratio.minCoeff(&least);
  kept.most = tilts.sd_ratio.maxCoeff();
  (void)tilts.mean_shift.cwiseAbs().maxCoeff(&shifted);
  kept.least_name = words_of_axis_parameter(draws.names[static_cast<std::size_t>(least)]);
  kept.largest_shift = tilts.mean_shift[shifted];
  kept.largest_shift_name = words_of_axis_parameter(draws.names[static_cast<std::size_t>(shifted)]);
  kept.narrower =
      static_cast<int>((tilts.sd_ratio.array() + 2 * tilts.sd_ratio_error.array() < 1).count());
  return kept;
}

Json measured_lessons_section(const ThumbRecoveryResult& result) {
  return section("measured-thumb", "The thumb, the founding way: with what was measured in people",
                 measurements_words(result.lessons),
                 Json::array({text_block(alone_words(result) + beside_words(result.lessons) +
                                         limits_words(result.lessons)),
                              kept_chart(result.lessons), tilt_table(result.lessons),
                              update_table(result.lessons), measured_table(result.lessons)}));
}

}  // namespace thenar
