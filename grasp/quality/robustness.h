#pragma once

/// How sure a grasp is, if friction and places are not.

#include <functional>
#include <random>
#include <vector>

#include "grasp/contact/wrench_set.h"

namespace thenar {

/// What is not known of contacts, each region of contact and each quantity by itself.
struct ContactUncertainty {
  double friction = 0;  // standard deviation of log friction, also of log torsion [1]
  double place = 0;     // standard deviation along each tangent [m]
  double tilt = 0;      // standard deviation of the normal about each tangent [rad]
};

/// Contacts as they might be: friction log-normal, so never negative; places moved along the
/// tangent plane; normals turned. Points of one region (contact_regions()) are one rigid face: they
/// are moved and turned alike, and have the same factor of friction.
[[nodiscard]] std::vector<Contact> disturbed(const std::vector<Contact>& contacts,
                                             const ContactUncertainty& uncertainty,
                                             std::mt19937& rng);

struct RobustnessOptions {
  int draws = 1000;
  double gap = 1e-2;                // of each epsilon, in unit forces [1]
  Eigen::Vector3d centre{0, 0, 0};  // torques are about it [m] (3)
  double torque_scale = 1;          // they are divided by it [m]
  ForceNorm limit = ForceNorm::kL1;
  int edges = 0;  // of friction pyramids, as pyramids(); 0: cones
};

struct Robustness {
  double closure;           // share of draws with force closure [1]
  double closure_lower;     // Wilson's 95 % interval of its probability [1]
  double closure_upper;     // [1]
  Eigen::VectorXd epsilon;  // certified lower bounds, ascending; -infinity of misses (draws)
  int misses = 0;           // draws without any contact

  /// Quantile of epsilon by linear interpolation; -infinity where a miss has part in it.
  /// @param p  in [0, 1]
  [[nodiscard]] double quantile(double p) const;
};

/// Seeded Monte Carlo over what a grasp might be.
///
/// @param draw  contacts of one possible grasp; finds them anew where the pose of the object is
///              what is not known, or calls disturbed() on those there are. It may find none: a
///              miss, worse than any grasp.
/// @throws InputError if draws or gap is not positive, or edges is neither 0 nor 3 and more.
/// Source: [Weisz2012] for the measure, [Wilson1927] for the interval.
[[nodiscard]] Robustness robustness(const std::function<std::vector<Contact>(std::mt19937&)>& draw,
                                    std::mt19937& rng, const RobustnessOptions& options = {});

/// Wilson's interval of a probability seen `hits` times in `trials`, 95 %.
struct ConfidenceInterval {
  double lower, upper;
};
[[nodiscard]] ConfidenceInterval wilson_interval(int hits, int trials);

}  // namespace thenar
