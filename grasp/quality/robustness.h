#pragma once

/// Probability of force closure under uncertain friction, positions and normals (Monte Carlo).

#include <functional>
#include <random>
#include <vector>

#include "grasp/contact/wrench_set.h"

namespace thenar {

/// Standard deviations of contacts, independent for each contact region and each quantity.
struct ContactUncertainty {
  double friction = 0;  // standard deviation of log friction, also of log torsion [1]
  double position = 0;  // standard deviation along each tangent [m]
  double tilt = 0;      // standard deviation of the normal about each tangent [rad]
};

/// Samples disturbed contacts: log-normal friction, positions moved in the tangent plane, normals
/// rotated. Points of one region (contact_regions()) are one rigid face: they move and turn
/// together and share one friction factor.
[[nodiscard]] std::vector<Contact> disturb_contacts(const std::vector<Contact>& contacts,
                                                    const ContactUncertainty& uncertainty,
                                                    std::mt19937& rng);

/// Settings of robustness().
struct RobustnessOptions {
  int draws = 1000;                 // number of samples
  double gap = 1e-2;                // settings of epsilon(): gap for unit contact forces [1]
  Eigen::Vector3d centre{0, 0, 0};  // reference point of torques [m] (3)
  double torque_scale = 1;          // length that divides torques [m]
  ForceNorm limit = ForceNorm::kL1;
  int edges = 0;  // edges of friction_pyramids(); 0: cones
};

/// Distribution of epsilon over the samples.
struct Robustness {
  double closure = 0;        // share of samples with force closure [1]
  double closure_lower = 0;  // lower end of Wilson's 95 % interval of its probability [1]
  double closure_upper = 1;  // upper end [1]
  Eigen::VectorXd epsilon;   // certified lower bounds, ascending; -infinity for misses (draws)
  int misses = 0;            // number of samples without any contact

  /// Returns a quantile of epsilon, interpolated linearly; -infinity if that uses a miss.
  /// @param p  in [0, 1]
  [[nodiscard]] double quantile(double p) const;
};

/// Runs a Monte Carlo simulation over possible grasps, with the seed of `rng`.
///
/// @param draw  function that returns the contacts of one possible grasp: it finds contacts again
///              if the pose of the object is uncertain, or calls disturb_contacts() on given ones.
///              Without contacts the sample is a miss, worse than any grasp.
/// @throws InputError if draws or gap is not positive, or edges is neither 0 nor at least 3.
/// Source: [Weisz2012] for the measure, [Wilson1927] for the interval.
[[nodiscard]] Robustness robustness(const std::function<std::vector<Contact>(std::mt19937&)>& draw,
                                    std::mt19937& rng, const RobustnessOptions& options = {});

/// Confidence interval of a probability.
struct ConfidenceInterval {
  double lower, upper;  // [1]
};
/// Computes Wilson's 95 % interval of a probability, from `hits` in `trials`. Source: [Wilson1927].
[[nodiscard]] ConfidenceInterval wilson_interval(int hits, int trials);

/// Number of hits in a number of trials.
struct HitCount {
  int hits = 0, trials = 0;
};
/// Computes the p-value of Fisher's exact test, two-sided [1]: the probability of counts at most as
/// likely as these, given their sums, if both have the same hit probability. It is below 0.05 for
/// at most 5 % of pairs with equal probabilities, for any number of trials.
/// @throws InputError if a count has no trials, or its hits are not within 0 .. trials. Source:
/// [Fisher1935].
[[nodiscard]] double fisher_exact_p(const HitCount& a, const HitCount& b);

}  // namespace thenar
