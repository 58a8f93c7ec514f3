// Potential scale reduction.

#include "sampling/diagnostics/convergence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>

#include "base/error.h"
#include "base/numbers.h"
#include "base/special_functions.h"
#include "sampling/diagnostics/effective_sample_size.h"
#include "sampling/diagnostics/order_statistics.h"
#include "sampling/diagnostics/split_chains.h"

namespace thenar {
namespace {

/// Returns sqrt((B / W + n - 1) / n), with between- and within-chain variance [Vehtari2021 eqs.
/// 1-4].
double r_hat(const Eigen::MatrixXd& x) {
  const auto n = double(x.rows()), m = double(x.cols());
  const Eigen::RowVectorXd mean = x.colwise().mean();
  const double between = n * (mean.array() - mean.mean()).square().sum() / (m - 1);
  const double within = (x.rowwise() - mean).squaredNorm() / ((n - 1) * m);
  return std::sqrt((between / within + n - 1) / n);
}

}  // namespace

double split_r_hat(const Eigen::Ref<const Eigen::MatrixXd>& x) {
  const Eigen::MatrixXd halves = split_chains(x);
  return finite_and_varying(x) ? r_hat(halves) : kNaN;
}

double rank_r_hat(const Eigen::Ref<const Eigen::MatrixXd>& x) {
  const Eigen::MatrixXd halves = split_chains(x);
  if (!finite_and_varying(halves)) return kNaN;
  const double bulk = r_hat(normal_scores(halves));

  // Folding about the median turns different sds of chains into different locations.
  const Eigen::MatrixXd folded = (halves.array() - quantile(sorted(halves), 0.5)).abs();
  return finite_and_varying(folded) ? std::max(bulk, r_hat(normal_scores(folded))) : bulk;
}

// Monte Carlo standard errors.

double mean_mcse(const Eigen::Ref<const Eigen::MatrixXd>& x) { return mean_mcse(x, {}); }

double mean_mcse(const Eigen::Ref<const Eigen::MatrixXd>& x, const std::vector<int>& group) {
  const double variance = (x.array() - x.mean()).square().sum() / double(x.size() - 1);
  return std::sqrt(variance / mean_ess(x, group));
}

double sd_mcse(const Eigen::Ref<const Eigen::MatrixXd>& x) {
  const Eigen::ArrayXXd square = (x.array() - x.mean()).square();
  const double variance = square.mean();
  const double of_variance = (square.square().mean() - variance * variance) / sd_ess(x);
  return std::sqrt(of_variance / variance) / 2;
}

double quantile_mcse(const Eigen::Ref<const Eigen::MatrixXd>& x, double share) {
  const double ess = quantile_ess(x, share);
  if (std::isnan(ess)) return ess;

  // Interval of the quantile in shares of the draws: 16 and 84 % of its posterior.
  constexpr double kOneSigma = 0.15865525393145707;
  const double a = ess * share + 1, b = ess * (1 - share) + 1;
  const double low = beta_quantile(kOneSigma, a, b), high = beta_quantile(1 - kOneSigma, a, b);

  // Convert the shares to order statistics.
  const Eigen::VectorXd rising = sorted(x);
  const auto n = double(rising.size());
  const auto first = Eigen::Index(std::floor(std::max(0.0, low * n - 1)));
  const auto last = Eigen::Index(std::ceil(std::min(n - 1, high * n - 1)));
  return (rising[last] - rising[first]) / 2;
}

// Estimate of one quantity.
namespace {

/// Replaces figures by the worse of those over chains and over ensembles, whose walkers are
/// dependent.
void heed_ensembles(const Eigen::MatrixXd& x, const std::vector<int>& group,
                    const Eigen::MatrixXd& pooled, Estimate& out) {
  const auto below = [&x](double limit) -> Eigen::MatrixXd {
    return (x.array() <= limit).cast<double>();
  };
  out.r_hat = std::max(out.r_hat, rank_r_hat(pooled));
  out.bulk_ess = std::min(out.bulk_ess, ensemble_ess(normal_scores(x), group));
  out.tail_ess = std::min(
      {out.tail_ess, ensemble_ess(below(out.q05), group), ensemble_ess(below(out.q95), group)});
}

}  // namespace

Estimate estimate(const std::string& name, const Eigen::Ref<const Eigen::MatrixXd>& x,
                  const std::vector<int>& group) {
  const Eigen::MatrixXd pooled = pool_groups(x, group);
  Estimate out{name, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN};
  if (x.size() == 0 || !x.allFinite()) return out;

  // Compute moments and quantiles.
  const Eigen::VectorXd rising = sorted(x);
  out.mean = x.mean();
  out.sd = std::sqrt((x.array() - out.mean).square().sum() / double(x.size() - 1));
  out.q05 = quantile(rising, 0.05);
  out.median = quantile(rising, 0.5);
  out.q95 = quantile(rising, 0.95);
  if (!finite_and_varying(x)) out.sd = 0;  // all equal: avoid rounding of the mean
  if (x.rows() < 4 || out.sd == 0) return out;

  // Compute errors, R-hat and effective sizes.
  out.mcse_mean = mean_mcse(x, group);
  out.mcse_sd = sd_mcse(x);
  out.r_hat = rank_r_hat(x);
  out.bulk_ess = bulk_ess(x);
  out.tail_ess = tail_ess(x);
  if (pooled.cols() < x.cols()) heed_ensembles(x, group, pooled, out);
  return out;
}

// Assessment of a run.
namespace {

/// Quantities that violate a limit: the worst one, and the number of others.
struct Offence {
  const Estimate* worst = nullptr;
  double figure = 0;  // diagnostic of the worst one
  long others = -1;   // number of further quantities

  /// Returns the names of the quantities: "tau and 3 more".
  [[nodiscard]] std::string who() const {
    return others > 0 ? fmt::format("{} and {} more", worst->name, others) : worst->name;
  }
  /// Returns the text that follows the figure of the worst one.
  [[nodiscard]] std::string more() const {
    return others > 0 ? fmt::format(" (as is that of {} more)", others) : "";
  }
};

/// Finds the quantities with a diagnostic above a limit.
/// @param badness  diagnostic of an estimate; NaN is ignored
template <typename Badness>
Offence find_offence(const std::vector<Estimate>& estimates, double limit, Badness badness) {
  Offence found;
  for (const Estimate& each : estimates) {
    // NaN is ignored.
    const double figure = badness(each);
    if (!(figure > limit)) continue;
    ++found.others;
    if (found.worst && figure <= found.figure) continue;
    found.worst = &each;
    found.figure = figure;
  }
  return found;
}

/// Warns about draws for which diagnostics cannot be computed.
void judge_draws(const std::vector<Estimate>& estimates, std::vector<std::string>& warnings) {
  const auto find = [&](auto holds) {
    return find_offence(estimates, 0,
                        [&](const Estimate& each) { return holds(each) ? 1.0 : 0.0; });
  };
  // Draws that are not finite.
  const Offence non_finite = find([](const Estimate& each) { return !std::isfinite(each.mean); });
  if (non_finite.worst)
    warnings.push_back(fmt::format("there are draws that are not finite, of {}", non_finite.who()));
  // Draws that are all equal.
  const Offence still = find([](const Estimate& each) { return each.sd == 0; });
  if (still.worst)
    warnings.push_back(
        fmt::format("all draws of {} are alike: no chain has moved there", still.who()));
  // Draws without diagnostics.
  const Offence mute = find([](const Estimate& each) {
    return each.sd > 0 && std::isnan(each.r_hat + each.bulk_ess + each.tail_ess);
  });
  if (mute.worst)
    warnings.push_back(
        fmt::format("draws of {} are too few, or too many are alike, to be judged", mute.who()));
}

/// Warns about quantities with an R-hat above the limit.
void judge_agreement(const std::vector<Estimate>& estimates, double limit,
                     std::vector<std::string>& warnings) {
  const Offence apart =
      find_offence(estimates, limit, [](const Estimate& each) { return each.r_hat; });
  if (apart.worst)
    warnings.push_back(fmt::format("R-hat of {} is {:.4g}, above {:.4g}{}: chains disagree",
                                   apart.worst->name, apart.figure, limit, apart.more()));
}

/// Warns about effective sizes below `min_size`.
/// @param size  member of Estimate: bulk or tail ESS
void judge_size(const std::vector<Estimate>& estimates, const char* what, double Estimate::*size,
                double min_size, std::vector<std::string>& warnings) {
  const Offence few =
      find_offence(estimates, -min_size, [size](const Estimate& each) { return -(each.*size); });
  if (few.worst)
    warnings.push_back(fmt::format("{} effective sample size of {} is {:.0f}, below {:.0f}{}", what,
                                   few.worst->name, -few.figure, min_size, few.more()));
}

/// Reports divergent steps. Call it last: few divergent draws are only a caution if nothing else is
/// wrong.
void judge_steps(long steps, double allowed, Convergence& result) {
  if (result.divergent == 0) return;
  const double share = double(result.divergent) / double(steps);
  const std::string sentence = fmt::format("{} of {} draws ended a divergent trajectory ({:.3g} %",
                                           result.divergent, steps, 100 * share);
  if (share <= allowed && result.warnings.empty())
    result.cautions.push_back(sentence +
                              "): a narrow part of the density there may have too few draws");
  else
    result.warnings.push_back(
        fmt::format("{}, allowed {:.3g} %): the sampler cannot follow the density there", sentence,
                    100 * allowed));
}

/// Warns about a swap rate below `min_rate`.
void judge_swaps(const Draws& draws, double min_rate, std::vector<std::string>& warnings) {
  if (draws.swap_rate.size() == 0) return;
  // Find the pair of neighbours with the lowest rate.
  Eigen::Index temperature_index, group;
  const double rate = draws.swap_rate.minCoeff<Eigen::PropagateNaN>(&temperature_index, &group);
  if (!(rate >= min_rate))
    warnings.push_back(fmt::format(
        "temperatures {} and {} of group {} swap in {:.2g} % of attempts, below "
        "{:.2g} %: hot chains do not help cold ones",
        temperature_index + 1, temperature_index + 2, group + 1, 100 * rate, 100 * min_rate));
}

/// Counts divergent and non-finite steps, and those at the depth limit.
void count_steps(const Draws& draws, int max_depth, Convergence& result) {
  for (const auto& chain : draws.stats)
    for (const StepStats& step : chain) {
      result.divergent += step.divergent ? 1 : 0;
      result.non_finite += step.non_finite;
      result.depth_limit += step.depth >= max_depth ? 1 : 0;
    }
}

/// Finds the worst figures; if one is NaN, the result is NaN.
void find_worst(Convergence& result) {
  result.worst_r_hat = 0;
  result.min_bulk_ess = result.min_tail_ess = std::numeric_limits<double>::infinity();
  const auto worse = [](double a, double b) { return std::isnan(a) || a > b ? a : b; };
  for (const Estimate& each : result.estimates) {
    result.worst_r_hat = worse(result.worst_r_hat, each.r_hat);
    result.min_bulk_ess = -worse(-result.min_bulk_ess, -each.bulk_ess);
    result.min_tail_ess = -worse(-result.min_tail_ess, -each.tail_ess);
  }
}

/// Returns whether an estimate satisfies the limits of R-hat and of both effective sizes; false for
/// NaN.
bool keeps_limits(const Estimate& each, double r_hat, double min_size) {
  return each.r_hat <= r_hat && each.bulk_ess >= min_size && each.tail_ess >= min_size;
}

}  // namespace

Convergence assess(const Draws& draws, const std::vector<std::string>& names,
                   const ConvergenceLimits& limits) {
  require(int(names.size()) == draws.size(), "{} names for {} coordinates", names.size(),
          draws.size());
  // Estimate every coordinate, and find the worst figures.
  Convergence result;
  for (int i = 0; i < draws.size(); ++i)
    result.estimates.push_back(estimate(names[i], draws.coordinate(i), draws.group));
  find_worst(result);
  count_steps(draws, limits.max_depth, result);

  // Check that there are enough draws and groups.
  const long groups = long(std::set<int>(draws.group.begin(), draws.group.end()).size());
  if (draws.draws() < 4)
    result.warnings.push_back(
        fmt::format("there are {} draws a chain, diagnostics need 4", draws.draws()));
  if (groups < 2)
    result.warnings.push_back(
        fmt::format("independent chains or ensembles: {}; one that is stuck shows only beside "
                    "another, so 2 are needed",
                    groups));
  // Compare the figures with their limits.
  const double min_size = limits.ess_per_chain * double(groups);
  judge_draws(result.estimates, result.warnings);
  judge_swaps(draws, limits.swap_rate, result.warnings);
  const bool sound = result.warnings.empty();
  judge_agreement(result.estimates, limits.r_hat, result.warnings);
  judge_size(result.estimates, "bulk", &Estimate::bulk_ess, min_size, result.warnings);
  judge_size(result.estimates, "tail", &Estimate::tail_ess, min_size, result.warnings);
  for (const Estimate& each : result.estimates)
    if (!keeps_limits(each, limits.r_hat, min_size)) result.unsettled.push_back(each.name);
  const std::size_t of_coordinates = result.warnings.size();
  judge_steps(draws.draws() * draws.chains(), limits.divergent_share, result);
  result.draws_may_help = sound && of_coordinates > 0 && result.warnings.size() == of_coordinates;
  return result;
}

Convergence settled_by_answers(Convergence convergence, const std::vector<Estimate>& answers,
                               const std::string& what, long groups,
                               const ConvergenceLimits& limits) {
  // Check the answers.
  const double min_size = limits.ess_per_chain * double(groups);
  const bool answered =
      !answers.empty() && std::all_of(answers.begin(), answers.end(), [&](const Estimate& answer) {
        return answer.sd == 0 || keeps_limits(answer, limits.r_hat, min_size);
      });
  if (!convergence.draws_may_help || !answered ||
      !(convergence.worst_r_hat <= limits.nuisance_r_hat))
    return convergence;

  // Replace the warnings by one caution, with the figures of the answers.
  double worst = 0, size = std::numeric_limits<double>::infinity();
  for (const Estimate& answer : answers) {
    if (answer.sd == 0) continue;
    worst = std::max(worst, answer.r_hat);
    size = std::min({size, answer.bulk_ess, answer.tail_ess});
  }
  std::string caution;
  for (const std::string& warning : convergence.warnings) caution += warning + "; ";
  convergence.cautions.push_back(fmt::format(
      "{}the {} have converged all the same (R-hat at most {:.4f}, effective sizes at least "
      "{:.0f}): use "
      "them, but not {}",
      caution, what, worst, size,
      convergence.unsettled.size() == 1
          ? convergence.unsettled.front()
          : fmt::format("these {} numbers themselves", convergence.unsettled.size())));
  convergence.warnings.clear();
  convergence.draws_may_help = false;
  return convergence;
}

}  // namespace thenar
