#pragma once

/// Probability of force closure under uncertain friction, positions and normals (Monte Carlo).

#include <functional>
#include <random>
#include <vector>

#include "grasp/contact/wrench_set.h"

namespace thenar {

/// Uncertainty of contacts; independent for each region of contact and each quantity.
struct ContactUncertainty {
  double friction = 0;  // standard deviation of log friction, also of log torsion [1]
  double place = 0;     // standard deviation along each tangent [m]
  double tilt = 0;      // standard deviation of the normal about each tangent [rad]
};

/// Draws disturbed contacts: log-normal friction, positions moved in the tangent plane, normals
/// rotated. Points of one region (contact_regions()) are one rigid face: they move and turn alike
/// and share one factor of friction.
[[nodiscard]] std::vector<Contact> disturbed(const std::vector<Contact>& contacts,
                                             const ContactUncertainty& uncertainty,
                                             std::mt19937& rng);

/// Settings of robustness().
struct RobustnessOptions {
  int draws = 1000;
  double gap = 1e-2;                // of each epsilon, for unit contact forces [1]
  Eigen::Vector3d centre{0, 0, 0};  // reference point of torques [m] (3)
  double torque_scale = 1;          // length that divides torques [m]
  ForceNorm limit = ForceNorm::kL1;
  int edges = 0;  // of friction pyramids, as pyramids(); 0: cones
};

/// Distribution of epsilon over the draws.
struct Robustness {
  double closure;           // share of draws with force closure [1]
  double closure_lower;     // Wilson's 95 % interval of its probability [1]
  double closure_upper;     // [1]
  Eigen::VectorXd epsilon;  // certified lower bounds, ascending; -infinity of misses (draws)
  int misses = 0;           // draws without any contact

  /// Quantile of epsilon by linear interpolation; -infinity if a miss takes part in it.
  /// @param p  in [0, 1]
  [[nodiscard]] double quantile(double p) const;
};

/// Monte Carlo over possible grasps, with the seed of `rng`.
///
/// @param draw  contacts of one possible grasp: finds them anew if the pose of the object is
///              uncertain, or calls disturbed() on given contacts. It may find none: a miss, worse
///              than any grasp.
/// @throws InputError if draws or gap is not positive, or edges is neither 0 nor 3 and more.
/// Source: [Weisz2012] for the measure, [Wilson1927] for the interval.
[[nodiscard]] Robustness robustness(const std::function<std::vector<Contact>(std::mt19937&)>& draw,
                                    std::mt19937& rng, const RobustnessOptions& options = {});

/// Interval of a probability.
struct ConfidenceInterval {
  double lower, upper;  // [1]
};
/// Wilson's 95 % interval of a probability, from `hits` in `trials`. Source: [Wilson1927].
[[nodiscard]] ConfidenceInterval wilson_interval(int hits, int trials);

/// Two counts of hits in trials.
struct HitCount {
  int hits = 0, trials = 0;
};
/// Fisher's exact test, two-sided: how likely counts at least as unlikely as these are, given their
/// sums, if both have the same probability. Below 0.05 in at most 5 % of equal pairs, however few
/// the trials. [1]
/// @throws InputError if a count has no trials, or hits outside of them. Source: [Fisher1935].
[[nodiscard]] double fisher_exact_p(const HitCount& a, const HitCount& b);

}  // namespace thenar
