#include "kinematics_fit/bands/band_posterior.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/error.h"
#include "base/lists.h"
#include "base/numbers.h"
#include "kinematics_fit/bands/band_problems.h"
#include "kinematics_fit/bands/expected_information.h"
#include "kinematics_fit/fit_residuals.h"

namespace thenar {
namespace {

constexpr double kSlackTension = 1e-6;  // tension below which a band counts as slack [N]

/// Sets of bands that were fitted, so that none is fitted twice.
class KnownSets {
 public:
  KnownSets(const BandProblems& problems, const EvidenceOptions& options)
      : problems_(problems), options_(options) {}

  /// Returns the evidence of a set; fits it, if new, from the prior means and from the mode of
  /// `near`.
  const BandEvidence& evidence(const Topology& bands, const Topology& near) {
    const auto known = sets_.find(bands);
    if (known != sets_.end()) return known->second;
    const FitProblem problem = problems_.problem_with(bands);
    // Start from the prior means, and from the mode of `near` if it was fitted.
    std::vector<Eigen::VectorXd> starts{Eigen::VectorXd::Zero(problem.size())};
    if (const auto before = sets_.find(near); before != sets_.end() && before->second.holds)
      starts.push_back(transfer_point(names_.at(near), before->second.z, problem));
    names_[bands] = problem.coordinates().names();
    return sets_.emplace(bands, band_evidence(problem, starts, options_)).first->second;
  }

  /// Searches again from the mode of another set, and keeps the better result.
  void improve(const Topology& bands, const Topology& near) {
    const auto other = sets_.find(near);
    BandEvidence& here = sets_.at(bands);
    if (near == bands || other == sets_.end() || !other->second.holds) return;
    const FitProblem problem = problems_.problem_with(bands);
    BandEvidence again = band_evidence(
        problem, {transfer_point(names_.at(near), other->second.z, problem)}, options_);
    if (!again.holds) return;
    // Smallest gain of the log density at the mode that replaces a result [nat]
    constexpr double kMinLogGain = 0.05;
    const auto cost = [](const BandEvidence& at) { return 0.5 * (at.misfit + at.z.squaredNorm()); };
    if (!here.holds || cost(again) < cost(here) - kMinLogGain) here = std::move(again);
  }

  [[nodiscard]] const std::map<Topology, BandEvidence>& sets() const { return sets_; }

  /// Returns the best set that has, or lacks, a band; null if there is none.
  [[nodiscard]] const std::pair<const Topology, BandEvidence>* best_where(std::size_t band,
                                                                          bool present) const {
    const std::pair<const Topology, BandEvidence>* best = nullptr;
    for (const auto& each : sets_)
      if (each.second.holds && each.first[band] == present &&
          (!best || log_bayes_factor(each.second, best->second) > 0))
        best = &each;
    return best;
  }

 private:
  const BandProblems& problems_;
  EvidenceOptions options_;
  std::map<Topology, BandEvidence> sets_;
  std::map<Topology, std::vector<std::string>> names_;  // names of the coordinates of each set
};

/// Fits every set, each starting from a neighbour: in the order of Gray's code from the full set.
void fit_all_sets(KnownSets& known, std::size_t bands, const Progress& progress) {
  Topology here(bands, true), before = here;
  const unsigned ways = 1U << bands;
  for (unsigned way = 0; way < ways && !(progress.stop() && way > 0); ++way) {
    progress(0.5 * way / ways, "sets of bands");
    // Flip the band that Gray's code changes next.
    if (way > 0) {
      std::size_t changed = 0;
      while ((way >> changed & 1U) == 0) ++changed;
      here[changed] = !here[changed];
    }
    if (known.evidence(here, before).holds) before = here;
  }

  // Fit each again from the best of its neighbours: a search may have missed the mode.
  const std::vector<Topology> sets = map_keys(known.sets());
  for (std::size_t i = 0; i < sets.size() && !progress.stop(); ++i) {
    progress(0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(sets.size()),
             "sets of bands again");
    Topology best = sets[i];
    for (std::size_t b = 0; b < bands; ++b) {
      const Topology other = flipped(sets[i], static_cast<int>(b));
      if (best == sets[i] || log_bayes_factor(known.sets().at(other), known.sets().at(best)) > 0)
        best = other;
    }
    known.improve(sets[i], best);
  }
}

/// Conditional probabilities of each band in every sweep after burn-in, and visits of each set.
struct Sampled {
  std::vector<std::vector<double>> chances;  // probability that the band is present (bands, sweeps)
  std::map<Topology, int> visits;
};

/// Samples sets of bands by Gibbs sweeps over the bands.
Sampled sample_sets(KnownSets& known, std::size_t bands, std::mt19937& random,
                    const BandPosteriorOptions& options, const Progress& progress) {
  Sampled out;
  out.chances.resize(bands);
  Topology here(bands, true);
  (void)known.evidence(here, here);
  std::vector<std::size_t> order(bands);
  std::iota(order.begin(), order.end(), 0);
  const int unused = options.sweeps / 4;
  for (int sweep = 0; sweep < options.sweeps; ++sweep) {
    // Update the bands in random order, each by the probability that the evidence gives it.
    std::shuffle(order.begin(), order.end(), random);
    for (std::size_t i = 0; i < bands; ++i) {
      if (progress.stop()) return out;
      progress((sweep + static_cast<double>(i) / static_cast<double>(bands)) / options.sweeps,
               "sets of bands");
      const std::size_t band = order[i];
      Topology other = flipped(here, static_cast<int>(band));
      const BandEvidence& now = known.evidence(here, here);
      const BandEvidence& then = known.evidence(other, here);
      const double flip = 1 / (1 + std::exp(-log_bayes_factor(then, now)));
      const bool present = here[band];
      if (std::uniform_real_distribution<double>(0, 1)(random) < flip) here = std::move(other);
      // Record after the burn-in.
      if (sweep < unused) continue;
      out.chances[band].push_back(present ? 1 - flip : flip);
      ++out.visits[here];
    }
  }
  return out;
}

/// Returns whether draws integrated every set that matters: within kMinorEvidenceGap of the best by
/// Laplace.
bool all_by_draws(const std::map<Topology, BandEvidence>& sets) {
  // Difference from the best log evidence beyond which a set does not matter [nat]
  constexpr double kMinorEvidenceGap = 5;
  double largest = -kInfinity;
  for (const auto& [bands, evidence] : sets)
    if (evidence.holds) largest = std::max(largest, evidence.laplace);
  return std::all_of(sets.begin(), sets.end(), [&](const auto& each) {
    const BandEvidence& evidence = each.second;
    return !evidence.holds || evidence.by_draws || evidence.laplace < largest - kMinorEvidenceGap;
  });
}

/// Returns the probabilities of sets: by evidence where all are known, else by their visits.
std::vector<BandSet> weighted_sets(const KnownSets& known, const Sampled& sampled, bool by_draws) {
  const auto value = [&](const BandEvidence& at) { return by_draws ? at.integral : at.laplace; };
  std::vector<BandSet> sets;
  double largest = -kInfinity, sum = 0;
  // Find the largest log evidence.
  for (const auto& [bands, evidence] : known.sets())
    if (evidence.holds) largest = std::max(largest, value(evidence));
  for (const auto& [bands, evidence] : known.sets()) {
    // Weigh each set by its evidence, or by its visits.
    if (!evidence.holds) continue;
    double weight = std::exp(value(evidence) - largest);
    if (!sampled.visits.empty()) {
      const auto met = sampled.visits.find(bands);
      weight = met == sampled.visits.end() ? 0 : met->second;
    }
    if (weight > 0) sets.push_back({bands, evidence, weight});
    sum += weight;
  }
  // Normalize, and sort by probability.
  for (BandSet& set : sets) set.probability /= sum;
  std::stable_sort(sets.begin(), sets.end(), [](const BandSet& a, const BandSet& b) {
    return a.probability > b.probability;
  });
  return sets;
}

/// Sets a band's probability from those of the sets.
void believe_from_sets(const std::vector<BandSet>& sets, std::size_t band, BandBelief& belief) {
  double with = 0, without = 0;
  for (const BandSet& set : sets) (set.bands[band] ? with : without) += set.probability;
  belief.probability = with / (with + without);
}

/// Sets a band's probability to the mean of its chances, and the error from the two halves of the
/// sweeps.
void believe_from_chances(const std::vector<double>& chances, BandBelief& belief) {
  const auto half = static_cast<std::ptrdiff_t>(chances.size() / 2);
  const auto n = static_cast<double>(chances.size());
  const double all = std::accumulate(chances.begin(), chances.end(), 0.0);
  belief.probability = all / n;
  if (half == 0) return;
  const double first = std::accumulate(chances.begin(), chances.begin() + half, 0.0);
  const double a = first / static_cast<double>(half);
  const double b = (all - first) / (n - static_cast<double>(half));
  belief.error = 0.5 * std::abs(a - b);
}

/// Compares the best sets with and without a band, and reads the band's tension and slack length
/// from the former.
void compare_best(const BandProblems& problems, const KnownSets& known, std::size_t band,
                  BandBelief& belief) {
  const auto* with = known.best_where(band, true);
  const auto* without = known.best_where(band, false);
  belief.misfit_change = belief.effective_change = std::numeric_limits<double>::quiet_NaN();
  // Compare misfits and effective parameters, where both sets exist.
  if (with && without) {
    belief.misfit_change = without->second.misfit - with->second.misfit;
    belief.effective_change = with->second.effective - without->second.effective;
  }
  for (const auto* best : {with, without})
    if (best)
      belief.doubtful = belief.doubtful || !best->second.by_draws || !best->second.converged;
  // Read the largest tension and the slack length.
  if (!with) return;
  const FitProblem problem = problems.problem_with(with->first);
  const Eigen::VectorXd& z = with->second.z;
  for (const BandTension& each : largest_tensions(problem, z))
    if (each.band == belief.name) belief.tension = each.tension;
  for (const auto& [name, range] : slack_ranges(problem, z))
    if (name == belief.name) belief.slack = range;
  belief.doubtful = belief.doubtful || (belief.slack && belief.slack->at_bound);
}

/// Decides about the existence of a band, and gives the reason if the data do not decide.
void decide_band(const KnownSets& known, std::size_t band, BandBelief& belief) {
  const auto* with = known.best_where(band, true);
  const auto* without = known.best_where(band, false);
  // Compute the log odds; where the probability rounds to 0 or 1, from the best set of each side.
  const bool rounds = belief.probability <= 0 || belief.probability >= 1;
  belief.log_odds = !without ? kInfinity
                    : !with  ? -kInfinity
                    : rounds ? log_bayes_factor(with->second, without->second)
                             : std::log(belief.probability) - std::log1p(-belief.probability);
  // Decide.
  if (belief.probability >= kDecidedProbability)
    belief.verdict = Verdict::kYes;
  else if (belief.probability <= 1 - kDecidedProbability)
    belief.verdict = Verdict::kNo;
  else
    belief.why =
        belief.tension < kSlackTension ? UndecidedReason::kSlack : UndecidedReason::kOthers;
}

}  // namespace

double log_bayes_factor(const BandEvidence& a, const BandEvidence& b) {
  if (!a.holds || !b.holds) return a.holds == b.holds ? 0 : a.holds ? kInfinity : -kInfinity;
  return a.by_draws && b.by_draws ? a.integral - b.integral : a.laplace - b.laplace;
}

BandPosterior band_posterior(const BandProblems& problems, std::mt19937& random,
                             const BandPosteriorOptions& options, const Progress& progress) {
  const std::size_t bands = problems.bands().size();
  require(options.kept > 0 && options.sweeps > 0 && options.enumerated < 20,
          "wanted sets to keep, sweeps, and fewer than 20 bands to enumerate, got {}, {} and {}",
          options.kept, options.sweeps, options.enumerated);
  // Fit all sets, or sample them.
  KnownSets known(problems, options.evidence);
  Sampled sampled;
  BandPosterior out;
  const bool enumerates = static_cast<int>(bands) <= options.enumerated;
  if (enumerates)
    fit_all_sets(known, bands, progress);
  else
    sampled = sample_sets(known, bands, random, options, progress);
  if (progress.stop()) out.status = Status::kStopped;
  out.fitted = known.sets().size();
  out.enumerated = enumerates && known.sets().size() == std::size_t{1} << bands;
  for (const auto& [set, evidence] : known.sets()) out.failed += evidence.holds ? 0 : 1;
  out.by_draws = all_by_draws(known.sets());
  out.sets = weighted_sets(known, sampled, out.by_draws);
  out.found = !out.sets.empty();
  if (!out.found) return out;

  // Judge every band.
  for (std::size_t b = 0; b < bands; ++b) {
    BandBelief belief;
    belief.name = problems.bands()[b];
    if (enumerates || sampled.chances[b].empty())
      believe_from_sets(out.sets, b, belief);
    else
      believe_from_chances(sampled.chances[b], belief);
    compare_best(problems, known, b, belief);
    decide_band(known, b, belief);
    out.bands.push_back(std::move(belief));
  }

  // Estimate the noise from the best set; keep the most probable sets and renormalize.
  const BandEvidence& best = out.sets.front().evidence;
  const double spare = measured_numbers(problems.full_problem()) - best.effective;
  out.noise = spare > 0 ? std::sqrt(best.misfit / spare) : kInfinity;
  if (out.sets.size() > static_cast<std::size_t>(options.kept))
    out.sets.resize(static_cast<std::size_t>(options.kept));
  double sum = 0;
  for (const BandSet& set : out.sets) sum += set.probability;
  std::vector<double> probability;
  HypothesisAnswers each(out.sets.size());
  std::iota(each.begin(), each.end(), 0);
  for (BandSet& set : out.sets) probability.push_back(set.probability /= sum);
  out.entropy = answer_entropy(probability, each);
  return out;
}

}  // namespace thenar
