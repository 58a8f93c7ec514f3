#include "studies/pages/measured_lessons.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/special_functions.h"
#include "base/units.h"
#include "data/io/toml_table.h"
#include "report/words.h"
#include "studies/pages/thumb_recovery.h"

namespace thenar {
namespace {

/// Mean and sd of a row of predictions, without those that are no number.
Json mean_and_sd(const Eigen::RowVectorXd& values) {
  // Thumbs that cannot press have no prediction, and are not counted.
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

/// First cells of a row of the table of measurements.
struct MeasuredNumber {
  std::string name;
  double value, sd, truth;  // `truth` is what the thumb of the made-up data says
  std::string source, assumed;
};

/// A row of the table of measurements: measured, and by the draws of each.
Json measured_row(const MeasuredNumber& of, const std::vector<Eigen::RowVectorXd>& by_draws) {
  Json row{of.name, of.value, of.sd, std::isnan(of.truth) ? Json(nullptr) : Json(of.truth)};
  for (const Eigen::RowVectorXd& values : by_draws)
    for (const Json& cell : mean_and_sd(values)) row.push_back(cell);
  row.push_back(of.assumed);
  row.push_back(of.source);
  return row;
}

/// Muscles that a trial pulls: "10 N of FPL".
std::string words_of_pull(const Trial& trial) {
  return each_in_words(trial.tension, [](const auto& pull) {
    return fmt::format("{:g} N of {}", pull.second, pull.first);
  });
}

/// "palmar" of component i of an experiment's forces.
std::string component_word(const Experiment& of, int i) {
  return direction_word(of.axes_of_digit.row(i));
}

/// Numbers that were measured: three of each trial, and one of each block [1].
std::size_t measured_numbers(const MeasuredLessons& of) {
  return 3 * of.force.trials.size() + of.losses.blocks.size();
}

Json measured_table(const MeasuredLessons& of) {
  const auto of_draws = [&](auto row) {
    return transformed(of.reweighted,
                       [&](const ReweightedDraws& draws) { return row(draws.predicted); });
  };
  Json rows = Json::array();
  // Components of the forces, in the order of the file, which argues what it cites itself for.
  const bool argued = !TomlFile(of.inputs.force.text, of.inputs.force.path).own_sources().empty();
  for (std::size_t t = 0; t < of.force.trials.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const Trial& trial = of.force.trials[t];
      const auto row = static_cast<Eigen::Index>(3 * t) + i;
      rows.push_back(measured_row(
          {fmt::format("{}: force, {} [N]", words_of_pull(trial), component_word(of.force, i)),
           trial.force[i], force_sd(of.force, trial)[i], of.truth.force(row, 0), of.force.source,
           argued ? "see its file" : ""},
          of_draws([&](const MeasuredPredictions& p) -> Eigen::RowVectorXd {
            return p.force.row(row);
          })));
    }
  // Losses of pinch.
  for (std::size_t b = 0; b < of.losses.blocks.size(); ++b) {
    const NerveBlock& block = of.losses.blocks[b];
    const auto row = static_cast<Eigen::Index>(b);
    rows.push_back(measured_row(
        {fmt::format("pinch lost, {} block [1]", block.nerve), block.loss, block.sd,
         of.truth.loss(row, 0), block.source, fmt::format("{}", fmt::join(block.assumed, ", "))},
        of_draws(
            [&](const MeasuredPredictions& p) -> Eigen::RowVectorXd { return p.loss.row(row); })));
  }
  std::vector<BlockColumn> columns{"measured", "value:2", "sd:2", "the shipped thumb:2"};
  for (const ReweightedDraws& draws : of.reweighted) {
    columns.push_back({draws.name + ": mean", "", 2});
    columns.emplace_back("sd:2");
  }
  columns.emplace_back("assumed");
  columns.emplace_back("source");
  return table_block(
      "What was measured in people, and what model thumbs predict: the shipped one, and the draws "
      "of prior and posterior (means and sds over draws). Thumbs that cannot press in key pinch "
      "are left out of the mean losses. What is assumed is named by its key in the file",
      columns, std::move(rows));
}

/// A row of the table of updates; without numbers where weights tell nothing.
Json update_row(const ReweightedDraws& draws, const DataUpdate& update) {
  // Numbers of the weights come first: without them nothing behind is to be believed.
  const bool told = update.message.empty();
  const ImportanceWeights& weights = update.weights;
  Json row{draws.name, update.added.name, draws.tilts.cols()};
  for (const double number : {weights.effective_size, weights.k, weights.good_k})
    row.push_back(weights.weight.size() > 0 && std::isfinite(number) ? Json(number)
                                                                     : Json(nullptr));
  row.push_back(!told ? "NO: " + update.message : weights.reliable() ? "yes" : "NO");
  if (!told) {
    for (int i = 0; i < 6; ++i) row.push_back(nullptr);
    return row;
  }
  // Shares of sds that are left, and how far means have moved, in sds of the draws.
  const KeptShares kept = kept_shares(draws, update);
  for (Json cell : {Json(100 * kept.rms), Json(100 * kept.least), Json(kept.least_name),
                    Json(100 * kept.most), Json(kept.largest_shift), Json(kept.largest_shift_name)})
    row.push_back(std::move(cell));
  return row;
}

Json update_table(const MeasuredLessons& of) {
  Json rows = Json::array();
  for (const ReweightedDraws& draws : of.reweighted)
    for (const DataUpdate& update : draws.updates) rows.push_back(update_row(draws, update));
  return table_block(
      "What each addition leaves of the sds of tilts, by self-normalised importance weights over "
      "draws. Effective size: 1 over the sum of squared weights; draws of the posterior are of "
      "chains, whose efficiency counts in Pareto k and in errors of ratios, not in this size. Do "
      "not trust a row whose Pareto k is above its limit: too few draws agree with what was "
      "measured",
      {"draws of", "added", "how many:0", "effective size:0", "Pareto k:2", "limit:2", "reliable",
       "sd kept, rms [%]:0", "least [%]:0", "of", "most [%]:0", "largest shift of a mean [sds]:2",
       "of"},
      std::move(rows));
}

Json tilt_table(const MeasuredLessons& of) {
  std::vector<BlockColumn> columns{"tilt"};
  for (const ReweightedDraws& draws : of.reweighted) {
    columns.push_back({"sd " + draws.name, "deg", 1});
    columns.emplace_back("with both measurements [deg]:1");
    columns.emplace_back("ratio:2");
    columns.emplace_back("its error:2");
  }
  Json rows = Json::array();
  for (std::size_t i = 0; i < of.reweighted.front().names.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    Json row{words_of_axis_parameter(of.reweighted.front().names[i])};
    for (const ReweightedDraws& draws : of.reweighted) {
      const Eigen::ArrayXd x = draws.tilts.row(at).transpose();
      row.push_back(degrees(std::sqrt((x - x.mean()).square().mean())));
      const WeightedSpread& with = update_by_both(draws).tilts;
      const bool told = with.sd.size() > 0;
      row.push_back(told ? Json(degrees(with.sd[at])) : Json(nullptr));
      row.push_back(told ? Json(with.sd_ratio[at]) : Json(nullptr));
      row.push_back(told ? Json(with.sd_ratio_error[at]) : Json(nullptr));
    }
    rows.push_back(std::move(row));
  }
  return table_block(
      "The sd of every tilt before and after both measurements; the error of a ratio is that of "
      "the draws (Monte Carlo)",
      columns, std::move(rows));
}

/// Returns a chart of the remaining share of every tilt's sd, by the draws of each.
Json kept_chart(const MeasuredLessons& of) {
  // A ratio of 1 means that the measurements say nothing about this tilt.
  Json rows = Json::array();
  for (std::size_t i = 0; i < of.reweighted.front().names.size(); ++i)
    for (const ReweightedDraws& draws : of.reweighted) {
      const WeightedSpread& with = update_by_both(draws).tilts;
      if (with.sd.size() == 0) continue;
      const auto at = static_cast<Eigen::Index>(i);
      rows.push_back(
          {{"name", fmt::format("{}, {}", words_of_axis_parameter(draws.names[i]), draws.name)},
           {"estimate", with.sd_ratio[at]},
           {"low", with.sd_ratio[at] - kNormal95HalfWidth * with.sd_ratio_error[at]},
           {"high", with.sd_ratio[at] + kNormal95HalfWidth * with.sd_ratio_error[at]}});
    }
  return with(interval_block("What both measurements leave of the sd of every tilt; bars are 95 % "
                             "of Monte Carlo error",
                             "share of the sd that is left [1]", std::move(rows)),
              {{"key", "sd with the measurements over sd without"},
               {"reference_lines", Json::array({{{"value", 1}, {"label", "nothing learnt"}}})}});
}

/// "10 N of FPL make 1.67 N at the tip, 46 degrees from proximal towards palmar", of all trials.
std::string words_of_forces(const Experiment& of) {
  const auto words = [&](const Trial& trial) {
    const Eigen::Vector3d& f = trial.force;
    return fmt::format("{} make {:.2f} N at the tip, {:.0f} degrees from {} towards {}",
                       words_of_pull(trial), f.norm(), degrees(std::atan2(f.y(), f.x())),
                       component_word(of, 0), component_word(of, 1));
  };
  return each_in_words(of.trials, words, "; ");
}

/// Returns the assumptions about the losses, as stated by the file.
std::string assumed_of_losses(const PinchLosses& losses) {
  // Name what the file marks as assumed rather than published.
  std::vector<std::string> sds, shares;
  for (const NerveBlock& block : losses.blocks) {
    if (contains(block.assumed, "sd"))
      sds.push_back(fmt::format("{:.2f} ({})", block.sd, block.nerve));
    if (contains(block.assumed, "left")) shares.push_back(block.nerve);
  }
  std::string words;
  if (!sds.empty()) words += fmt::format(" Their sds are ASSUMED too: {}.", fmt::join(sds, ", "));
  if (!shares.empty())
    words += fmt::format(
        " So are shares of strength that a muscle of two nerves keeps, under the blocks: {}.",
        fmt::join(shares, ", "));
  return words;
}

/// Describes the measurements and the assumptions about them.
std::string measurements_words(const MeasuredLessons& of) {
  const Eigen::Vector3d sd = force_sd(of.force, of.force.trials.front());
  return fmt::format(
             "Two kinds of numbers are published. [Towles2004], of seven cadavers: in key pinch "
             "{}. No sd was published; {:.1f} N of each component are ASSUMED: FPL's direction in "
             "eleven other thumbs was 66 (46) degrees [Towles2008], the bracket treated as the sd "
             "between thumbs, and 46 degrees over the root of seven are 17, which across the force "
             "are 0.51 N. Neither the hold of the tip nor the angles were reported: pinned, in the "
             "key pinch of the made-up data.\n\n",
             words_of_forces(of.force), sd.x()) +
         fmt::format(
             "Losses of key pinch under blocks of the ulnar and the median nerve and of both "
             "[Kozin1999] were taken from a secondary source, that under a radial block from an "
             "abstract [RadialBlock].{} The wrist drops under a radial block, and the model has "
             "none. A model's pinch is the largest palmar force of the pinned tip within {:.0f} "
             "degrees, every joint in balance, by linear programming; a block takes away the "
             "strength of its muscles.\n\n",
             assumed_of_losses(of.losses), degrees(of.losses.tolerance)) +
         fmt::format(
             "Draws are weighted by how well they predict these {} numbers: draws of the prior, to "
             "see what the measurements teach alone, and draws of the posterior of the made-up "
             "data.",
             measured_numbers(of));
}

/// Misses of the measurements by the thumb of the made-up data, in assumed sds.
struct Misses {
  double rms = 0, worst = 0;  // [sd]
  std::string worst_name;
};
Misses misses_of_truth(const MeasuredLessons& of) {
  // Differences of the shipped thumb from the measured numbers, in sds.
  Misses misses;
  int count = 0;
  const auto add = [&](const std::string& name, double sds) {
    if (std::isnan(sds)) return;
    misses.rms += sds * sds;
    ++count;
    if (std::abs(sds) < misses.worst) return;
    misses.worst = std::abs(sds);
    misses.worst_name = name;
  };
  // Components of forces, and losses.
  for (std::size_t t = 0; t < of.force.trials.size(); ++t) {
    const Trial& trial = of.force.trials[t];
    const Eigen::Vector3d sd = force_sd(of.force, trial);
    for (int i = 0; i < 3; ++i)
      add(fmt::format("the {} force under {}", component_word(of.force, i), words_of_pull(trial)),
          (of.truth.force(static_cast<Eigen::Index>(3 * t) + i, 0) - trial.force[i]) / sd[i]);
  }
  for (std::size_t b = 0; b < of.losses.blocks.size(); ++b) {
    const NerveBlock& block = of.losses.blocks[b];
    add(fmt::format("the loss under the {} block", block.nerve),
        (of.truth.loss(static_cast<Eigen::Index>(b), 0) - block.loss) / block.sd);
  }
  misses.rms = std::sqrt(misses.rms / count);
  return misses;
}

/// Draws whose pinch linear programming did not decide; "" if there are none.
std::string undecided_words(const ReweightedDraws& draws) {
  const Eigen::Index undecided = (draws.predicted.undecided.array() > 0).count();
  if (undecided == 0) return "";
  return fmt::format(
      " Draws {} whose pinch is UNDECIDED (unbounded, or not found by linear programming), so that "
      "they have no weight once losses are added: {}.",
      draws.name, undecided);
}

/// Describes what the measurements alone determine.
std::string alone_words(const ThumbRecoveryResult& result) {
  // Tell how many thumbs of the prior cannot pinch, which have no weight.
  const MeasuredLessons& of = result.lessons;
  const ReweightedDraws& prior = of.reweighted.front();
  const DataUpdate& both = update_by_both(prior);
  const std::string cannot = fmt::format(
      " Of {} thumbs of the prior {} cannot press in key pinch at all and have no weight.{}\n\n",
      prior.tilts.cols(), (prior.predicted.intact.array() < kMinPinchForce).count(),
      undecided_words(prior));
  if (!both.message.empty())
    return fmt::format("What the {} numbers teach alone is not known: {}.", measured_numbers(of),
                       both.message) +
           cannot;
  // Compare with what the made-up data leave of an axis.
  const KeptShares kept = kept_shares(prior, both);
  const KeptAxes made_up = kept_axes(result.recovery);
  const MadeUpNumbers numbers = made_up_numbers(result.recovery);
  return fmt::format(
             "Alone, the {} numbers leave {:.0f} to {:.0f} % of the prior's sd of {} tilts, {:.0f} "
             "% in the rms{}, where the made-up {} components of force and {} activations leave "
             "{:.0f} to {:.0f} % of an axis. {} of {} tilts are narrower by two errors or more; {} "
             "keep more than {:.0f} % of the prior's sd. The mean that moves most is that of {}, "
             "by {:.1f} prior sds.",
             measured_numbers(of), 100 * kept.least, 100 * kept.most, prior.names.size(),
             100 * kept.rms, doubt_of(both), numbers.forces, numbers.activations,
             100 * made_up.least, 100 * made_up.most, kept.narrower, prior.names.size(),
             kept.undecided, 100 * kUndecidedShare, kept.largest_shift_name,
             std::abs(kept.largest_shift)) +
         cannot;
}

/// Describes what the measurements add to the made-up data, and whether both are of one thumb.
std::string beside_words(const MeasuredLessons& of) {
  // Weigh draws of the posterior by measurements that it has not seen.
  const ReweightedDraws& posterior = of.reweighted.back();
  const DataUpdate& both = update_by_both(posterior);
  const Misses misses = misses_of_truth(of);
  std::string words;
  if (both.message.empty()) {
    const KeptShares kept = kept_shares(posterior, both);
    words = fmt::format(
        "Beside the made-up data they leave {:.0f} to {:.0f} % of what those had left ({:.0f} % in "
        "the rms{}); a ratio above 1 is not an error, as numbers that disagree with a posterior "
        "may widen it.",
        100 * kept.least, 100 * kept.most, 100 * kept.rms, doubt_of(both));
  } else {
    words = fmt::format("What they teach beside the made-up data is not known: {}.", both.message);
  }
  return words +
         fmt::format(
             " The made-up data are of the shipped thumb, which misses the measured numbers by "
             "{:.1f} of their sds (rms), most of all {} by {:.1f}.{}{}\n\n",
             misses.rms, misses.worst_name, misses.worst,
             misses.rms > 1 ? " So they disagree: what moves there may be conflict between two "
                              "thumbs as well as knowledge of one."
                            : "",
             undecided_words(posterior));
}

/// Additions whose weights are not to be believed, in words.
std::string limits_words(const MeasuredLessons& of) {
  std::vector<std::string> doubtful;
  for (const ReweightedDraws& draws : of.reweighted)
    for (const DataUpdate& update : draws.updates)
      if (!update.message.empty() || !update.weights.reliable())
        doubtful.push_back(fmt::format("{} ({}, effective size {:.0f})", update.added.name,
                                       draws.name, update.weights.effective_size));
  return (doubtful.empty() ? "All weights are reliable by their Pareto k."
                           : fmt::format("By their Pareto k the weights of {} are not reliable.",
                                         fmt::join(doubtful, "; "))) +
         " The measured numbers are of one posture, with sds, angles and a hold that had to be "
         "assumed; the made-up data are of single muscles, and of tasks, in several postures.";
}

}  // namespace

std::string doubt_of(const DataUpdate& update) {
  if (!update.message.empty()) return fmt::format(" (NOT known: {})", update.message);
  return update.weights.reliable() ? "" : " (NOT reliable: Pareto k is above its limit)";
}

const DataUpdate& update_by_both(const ReweightedDraws& draws) {
  return *find_where(draws.updates, [](const DataUpdate& update) {
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
  kept.least_name = words_of_axis_parameter(nth(draws.names, least));
  kept.largest_shift = tilts.mean_shift[shifted];
  kept.largest_shift_name = words_of_axis_parameter(nth(draws.names, shifted));
  kept.narrower =
      static_cast<int>((tilts.sd_ratio.array() + 2 * tilts.sd_ratio_error.array() < 1).count());
  kept.undecided = static_cast<int>((tilts.sd_ratio.array() > kUndecidedShare).count());
  return kept;
}

Json measured_lessons_section(const ThumbRecoveryResult& result) {
  return section("measured-thumb", "The thumb: what measurements in people add",
                 measurements_words(result.lessons),
                 Json::array({text_block(alone_words(result) + beside_words(result.lessons) +
                                         limits_words(result.lessons)),
                              kept_chart(result.lessons), tilt_table(result.lessons),
                              update_table(result.lessons), measured_table(result.lessons)}));
}

}  // namespace thenar
