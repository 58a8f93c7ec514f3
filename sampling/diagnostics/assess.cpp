// Whether to believe a run, and why not.

#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>

#include "base/error.h"
#include "sampling/diagnostics/convergence.h"

namespace thenar {
namespace {

/// Quantities on the wrong side of a limit: the worst, by name, and how many share its trouble.
struct Offence {
  const Estimate* worst = nullptr;
  double figure = 0;
  long others = -1;

  /// "tau and 3 more"
  [[nodiscard]] std::string who() const {
    return others > 0 ? fmt::format("{} and {} more", worst->name, others) : worst->name;
  }
  /// What to add to the worst figure.
  [[nodiscard]] std::string more() const {
    return others > 0 ? fmt::format(" (as is that of {} more)", others) : "";
  }
};

/// @param badness  of an estimate; above `limit` offends, NaN is passed over
template <typename Badness>
Offence find_offence(const std::vector<Estimate>& estimates, double limit, Badness badness) {
  Offence found;
  for (const Estimate& of : estimates) {
    const double figure = badness(of);
    if (!(figure > limit)) continue;
    ++found.others;
    if (found.worst && figure <= found.figure) continue;
    found.worst = &of;
    found.figure = figure;
  }
  return found;
}

/// Draws about which no figure can be told.
void judge_draws(const std::vector<Estimate>& estimates, std::vector<std::string>& reasons) {
  const auto find = [&](auto holds) {
    return find_offence(estimates, 0, [&](const Estimate& of) { return holds(of) ? 1.0 : 0.0; });
  };
  const Offence broken = find([](const Estimate& of) { return !std::isfinite(of.mean); });
  if (broken.worst)
    reasons.push_back(fmt::format("there are draws that are not finite, of {}", broken.who()));
  const Offence still = find([](const Estimate& of) { return of.sd == 0; });
  if (still.worst)
    reasons.push_back(
        fmt::format("all draws of {} are alike: no chain has moved there", still.who()));
  const Offence mute = find([](const Estimate& of) {
    return of.sd > 0 && std::isnan(of.r_hat + of.bulk_ess + of.tail_ess);
  });
  if (mute.worst)
    reasons.push_back(
        fmt::format("draws of {} are too few, or too many are alike, to be judged", mute.who()));
}

void judge_agreement(const std::vector<Estimate>& estimates, double limit,
                     std::vector<std::string>& reasons) {
  const Offence apart = find_offence(estimates, limit, [](const Estimate& of) { return of.r_hat; });
  if (apart.worst)
    reasons.push_back(fmt::format("R-hat of {} is {:.4g}, above {:.4g}{}: chains disagree",
                                  apart.worst->name, apart.figure, limit, apart.more()));
}

/// @param size  member of Estimate: bulk or tail ESS
void judge_size(const std::vector<Estimate>& estimates, const char* what, double Estimate::*size,
                double least, std::vector<std::string>& reasons) {
  const Offence few =
      find_offence(estimates, -least, [size](const Estimate& of) { return -(of.*size); });
  if (few.worst)
    reasons.push_back(fmt::format("{} effective sample size of {} is {:.0f}, below {:.0f}{}", what,
                                  few.worst->name, -few.figure, least, few.more()));
}

void judge_steps(const Convergence& result, long steps, double allowed,
                 std::vector<std::string>& reasons) {
  if (double(result.divergent) > allowed * double(steps))
    reasons.push_back(fmt::format(
        "{} of {} draws ended a divergent trajectory ({:.3g} %, allowed {:.3g} %): the sampler "
        "cannot follow the density there",
        result.divergent, steps, 100 * double(result.divergent) / double(steps), 100 * allowed));
}

void judge_swaps(const Draws& draws, double least, std::vector<std::string>& reasons) {
  if (draws.swap_rate.size() == 0) return;
  Eigen::Index rung, group;
  const double rate = draws.swap_rate.minCoeff<Eigen::PropagateNaN>(&rung, &group);
  if (!(rate >= least))
    reasons.push_back(
        fmt::format("temperatures {} and {} of group {} swap in {:.2g} % of attempts, below "
                    "{:.2g} %: hot chains do not help cold ones",
                    rung + 1, rung + 2, group + 1, 100 * rate, 100 * least));
}

void count_steps(const Draws& draws, int max_depth, Convergence& result) {
  for (const auto& chain : draws.stats)
    for (const StepStats& step : chain) {
      result.divergent += step.divergent;
      result.broken += step.broken;
      result.depth_limit += step.depth >= max_depth;
    }
}

/// The worst figures; one that cannot be told makes all of them NaN.
void find_worst(Convergence& result) {
  result.worst_r_hat = 0;
  result.least_bulk_ess = result.least_tail_ess = std::numeric_limits<double>::infinity();
  const auto worse = [](double a, double b) { return std::isnan(a) || a > b ? a : b; };
  for (const Estimate& of : result.estimates) {
    result.worst_r_hat = worse(result.worst_r_hat, of.r_hat);
    result.least_bulk_ess = -worse(-result.least_bulk_ess, -of.bulk_ess);
    result.least_tail_ess = -worse(-result.least_tail_ess, -of.tail_ess);
  }
}

}  // namespace

Convergence assess(const Draws& draws, const std::vector<std::string>& names,
                   const ConvergenceLimits& limits) {
  require(int(names.size()) == draws.size(), "{} names for {} coordinates", names.size(),
          draws.size());
  Convergence result;
  for (int i = 0; i < draws.size(); ++i)
    result.estimates.push_back(estimate(names[i], draws.coordinate(i), draws.group));
  find_worst(result);
  count_steps(draws, limits.max_depth, result);

  const long groups = long(std::set<int>(draws.group.begin(), draws.group.end()).size());
  if (draws.draws() < 4)
    result.reasons.push_back(
        fmt::format("there are {} draws a chain, diagnostics need 4", draws.draws()));
  if (groups < 2)
    result.reasons.push_back(
        fmt::format("independent chains or ensembles: {}; one that is stuck shows only beside "
                    "another, so 2 are needed",
                    groups));
  const double least = limits.ess_per_chain * double(groups);
  judge_draws(result.estimates, result.reasons);
  judge_agreement(result.estimates, limits.r_hat, result.reasons);
  judge_size(result.estimates, "bulk", &Estimate::bulk_ess, least, result.reasons);
  judge_size(result.estimates, "tail", &Estimate::tail_ess, least, result.reasons);
  judge_steps(result, draws.draws() * draws.chains(), limits.divergent_share, result.reasons);
  judge_swaps(draws, limits.swap_rate, result.reasons);
  return result;
}

}  // namespace thenar
