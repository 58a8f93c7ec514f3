#pragma once

/// Experimental design: the expected information of further trials about which bands exist, and
/// about their slack lengths, given the measurements so far.

#include <string>
#include <vector>

#include "base/progress.h"
#include "kinematics_fit/bands/band_beliefs.h"

namespace thenar {

class BandProblems;

/// Trial with its expected information.
struct RankedTrial {
  Trial trial;             // trial without a reading
  std::string name;        // posture and tensions, see trial_name()
  double information = 0;  // expected decrease of the entropy of the set of bands [bit]
  double slack = 0;  // expected information about slack lengths given the set: mean over sets [bit]
  std::string most_informed_band;  // band with the largest information; empty if all are decided
  double band_information = 0;  // expected decrease of the entropy of that band's existence [bit]
};

/// Ranks trials by `information`, then by `slack`, best first. Each set k of the posterior predicts
/// the reading as
///   y ~ N(f_k, J_k C_k J_k' + S),
/// with f_k and J_k its forces and their derivatives by z at the mode, C_k its Laplace covariance,
/// and S the variance of noise and model error of such a force. They determine
/// expected_information() and, with V_k the block of slack lengths of C_k, the information about
/// these: the mean of 1/2 log2 det V_k / det V_k|y.
/// @param trials  trials in postures and with muscles of the experiment
/// @throws InputError if a trial does not fit the digit, or the posterior has no sets.
[[nodiscard]] std::vector<RankedTrial> rank_trials(const BandProblems& problems,
                                                   const BandPosterior& posterior,
                                                   const std::vector<Trial>& trials,
                                                   const Progress& progress = {});

}  // namespace thenar
