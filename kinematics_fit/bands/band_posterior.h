#pragma once

/// Posterior over sets of bands: which of those in question a net has, when slack lengths, paths
/// and all else that is free may take their part of what was measured.

#include <random>

#include "base/progress.h"
#include "kinematics_fit/bands/band_beliefs.h"

namespace thenar {

class BandProblems;

/// Fits every set, or samples sets band by band: with p the evidence with a band and q without it,
/// all others as they are, it exists next with the chance p / (p + q) (a Gibbs sampler). The mean
/// of these chances is the band's probability. Every fit starts from that of the set before it.
/// Source: [MadiganYork1995].
/// @param random  of the sampling; not used where every set is fitted
BandPosterior band_posterior(const BandProblems& problems, std::mt19937& random,
                             const BandPosteriorOptions& options = {},
                             const Progress& progress = {});

}  // namespace thenar
