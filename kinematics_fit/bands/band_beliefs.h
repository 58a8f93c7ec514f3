#pragma once

/// Sets of bands and single bands, with what the data say of them.

#include <optional>
#include <string>
#include <vector>

#include "kinematics_fit/bands/band_evidence.h"
#include "solvers/status.h"
#include "tendons/topology/assess_bands.h"

namespace thenar {

/// One set of bands with what the data say of it.
struct BandSet {
  Topology bands;  // of those in question
  BandEvidence evidence;
  double probability = 0;  // posterior, over all sets that were kept [1]
};

/// Returns the log Bayes factor of one set over another [nat]: by draws where both can, else by
/// Laplace's approximation of both. Infinite where one does not carry the loads; 0 where neither
/// does.
[[nodiscard]] double log_bayes_factor(const BandEvidence& a, const BandEvidence& b);

/// Reason why a band is not decided.
enum class WhyUntold {
  kTold,   // it is decided
  kSlack,  // it pulls in no trial of the best set that has it
  kOthers  // it pulls, and what it does others can do
};

/// Evidence of the data for one band.
struct BandBelief {
  std::string name;
  double probability = 0;  // that it exists, posterior [1]
  double error = 0;        // of the probability by chance, one sd; 0 if all sets were fitted [1]
  double log_odds = 0;     // log of posterior over prior odds: the log Bayes factor; infinite if no
                           // set without (or with) it carries the loads [nat]
  Verdict verdict = Verdict::kUndecided;  // by kDecidedProbability
  WhyUntold why = WhyUntold::kTold;
  double misfit_change = 0;     // chi^2 of the data in the best set without it, less that in the
                                // best with it; NaN where one is missing [1]
  double effective_change = 0;  // effective parameters with it, less those without [1]
  double tension = 0;           // largest in any trial, in the best set that has it [N]
  std::optional<SlackRange> slack;  // in the best set that has it; empty if not free
  bool doubtful = false;  // Laplace's approximation has no voucher in the best set with or without
                          // it, a search there did not end, or its slack length is at a bound
};

/// Probability from which a band exists, or is absent [1].
inline constexpr double kDecidedProbability = 0.95;

struct BandPosteriorOptions {
  int enumerated = 7;  // bands up to which every set is fitted; beyond, sets are sampled
  int sweeps = 12;     // of the sampling, each of which asks for every band once; the first quarter
                       // is not counted
  int kept = 24;       // sets kept for what follows, most probable first
  EvidenceOptions evidence;
};

/// Posterior over sets. Beforehand all sets that carry the loads are equally probable.
struct [[nodiscard]] BandPosterior {
  bool found = false;               // a set carries the loads; otherwise nothing else is meant
  bool enumerated = false;          // every set was fitted
  bool by_draws = false;            // all sets that matter were integrated by draws
  Status status = Status::kSolved;  // kStopped: the posterior of the sets fitted by then
  std::vector<BandSet> sets;        // kept, most probable first; probabilities sum to 1
  std::vector<BandBelief> bands;    // in the order of BandProblems::bands()
  std::size_t fitted = 0;           // sets
  std::size_t failed = 0;           // of these, sets that do not carry the loads
  double noise = 1;    // sqrt(chi^2 / (numbers - effective)) of the best set: its errors
                       // per stated noise [1]
  double entropy = 0;  // of the sets [bit]
};

}  // namespace thenar
