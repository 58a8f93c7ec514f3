#pragma once

/// The experiment to do next: how much a trial is expected to tell of which bands exist, and of
/// their slack lengths, given what was measured so far.

#include <string>
#include <vector>

#include "base/progress.h"
#include "kinematics_fit/bands/band_beliefs.h"

namespace thenar {

class BandProblems;

/// Trial with the information that it is expected to give.
struct RankedTrial {
  Trial trial;              // without a reading
  std::string name;         // posture and tensions, trial_name()
  double information = 0;   // about the set of bands: expected fall of its entropy [bit]
  double slack = 0;         // about slack lengths, once the set is known: mean over sets [bit]
  std::string most_told;    // the band that it tells most of; empty where none is open
  double of_most_told = 0;  // expected fall of the entropy of that band's existence [bit]
};

/// Ranks trials by `information`, then by `slack`, best first. Each set k of the posterior expects
/// the reading to be
///   y ~ N(f_k, J_k C_k J_k' + S),
/// f_k and J_k its forces and their slopes by z at the mode, C_k its Laplace covariance, S the
/// noise of such a force with what the model misses. expected_information() follows from these, and
/// with V_k the block of slack lengths of C_k, that about them, mean of 1/2 log2 det V_k / det
/// V_k|y.
/// @param trials  of the experiment's postures and muscles
/// @throws InputError if a trial does not fit the digit, or the posterior has no sets.
[[nodiscard]] std::vector<RankedTrial> rank_trials(const BandProblems& problems,
                                                   const BandPosterior& posterior,
                                                   const std::vector<Trial>& trials,
                                                   const Progress& progress = {});

}  // namespace thenar
