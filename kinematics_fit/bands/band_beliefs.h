#pragma once

/// Sets of bands and single bands, with the evidence of the data for them.

#include <optional>
#include <string>
#include <vector>

#include "kinematics_fit/bands/band_evidence.h"
#include "solvers/status.h"
#include "tendons/topology/assess_bands.h"

namespace thenar {

/// Set of bands with its evidence.
struct BandSet {
  Topology bands;  // bands of the set, among those in question
  BandEvidence evidence;
  double probability = 0;  // posterior probability among all sets kept [1]
};

/// Returns the log Bayes factor of one set over another [nat]: by draws if both have them,
/// otherwise by Laplace's approximation of both. Infinite if one does not carry the loads; 0 if
/// neither does.
[[nodiscard]] double log_bayes_factor(const BandEvidence& a, const BandEvidence& b);

/// Reason why the data do not decide about a band.
enum class UndecidedReason {
  kDecided,  // the band is decided
  kSlack,    // it is slack in all trials of the best set that has it
  kOthers    // it is taut, but other bands can have the same effect
};

/// Evidence of the data for one band.
struct BandBelief {
  std::string name;
  double probability = 0;  // posterior probability that it exists [1]
  double error = 0;     // sampling error of the probability, one sd; 0 if all sets were fitted [1]
  double log_odds = 0;  // log Bayes factor: posterior over prior odds; infinite if no set without
                        // (or with) it carries the loads [nat]
  Verdict verdict = Verdict::kUndecided;  // decision by kDecidedProbability
  UndecidedReason why = UndecidedReason::kDecided;
  double misfit_change = 0;  // chi^2 of the data in the best set without it, minus that in the best
                             // set with it; NaN if one is missing [1]
  double effective_change = 0;      // effective parameters with it, minus those without [1]
  double tension = 0;               // maximum over the trials, in the best set that has it [N]
  std::optional<SlackRange> slack;  // slack length in the best set that has it; empty if not free
  bool doubtful =
      false;  // Laplace's approximation was not verified in the best set with or without it, a
              // search there did not converge, or its slack length is at a bound
};

/// Probability above which a band is decided to exist, or to be absent [1].
inline constexpr double kDecidedProbability = 0.95;

/// Options of band_posterior().
struct BandPosteriorOptions {
  int enumerated =
      7;  // maximum number of bands for which every set is fitted; with more, sets are sampled
  int sweeps =
      12;         // number of sweeps of the sampler over all bands; the first quarter is discarded
  int kept = 24;  // maximum number of sets kept, most probable first
  EvidenceOptions evidence;
};

/// Posterior over sets. In the prior, all sets that carry the loads are equally probable.
struct [[nodiscard]] BandPosterior {
  bool found = false;               // a set carries the loads; otherwise no other field is valid
  bool enumerated = false;          // every set was fitted
  bool by_draws = false;            // all relevant sets were integrated by draws
  Status status = Status::kSolved;  // kStopped: the result covers the sets fitted until then
  std::vector<BandSet> sets;        // sets kept, most probable first; probabilities sum to 1
  std::vector<BandBelief> bands;    // evidence for each band, in the order of BandProblems::bands()
  std::size_t fitted = 0;           // number of sets fitted
  std::size_t failed = 0;           // number of these that do not carry the loads
  double noise = 1;    // sqrt(chi^2 / (numbers - effective)) of the best set: its errors over the
                       // stated noise [1]
  double entropy = 0;  // entropy of the sets [bit]
};

}  // namespace thenar
