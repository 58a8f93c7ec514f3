#pragma once

/// Posterior over sets of bands: which of the bands in question a net has, with slack lengths,
/// paths and other free parameters integrated out.

#include <random>

#include "base/progress.h"
#include "kinematics_fit/bands/band_beliefs.h"

namespace thenar {

class BandProblems;

/// Fits every set, or samples sets band by band: with p the evidence with a band and q without it,
/// the other bands unchanged, the band exists next with probability p / (p + q) (Gibbs sampling).
/// The mean of these probabilities is the band's probability. Every fit starts from that of the
/// previous set.
/// Source: [MadiganYork1995].
/// @param random  random numbers for sampling; not used if every set is fitted
BandPosterior band_posterior(const BandProblems& problems, std::mt19937& random,
                             const BandPosteriorOptions& options = {},
                             const Progress& progress = {});

}  // namespace thenar
