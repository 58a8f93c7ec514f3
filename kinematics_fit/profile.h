#pragma once

/// Profile likelihood: how far one coordinate can go while all others make up for it.

#include <optional>
#include <string>
#include <vector>

#include "kinematics_fit/fit_problem.h"

namespace thenar {

/// The best cost with one coordinate held.
struct ProfilePoint {
  double z;                  // where it is held, in prior sds [1]
  double cost;               // 1/2 |r|^2, all others refitted [1]
  double rise;               // above the least cost of the profile [1]
  double without_own_prior;  // rise of cost - z^2/2: what data and the other priors say [1]
};

/// Where a profile has risen by ProfileOptions::rise; empty: nowhere within half_width, "open".
struct ProfileBounds {
  std::optional<double> lower, upper;  // in prior sds [1]
};

struct Profile {
  std::string name;                  // of the coordinate
  std::vector<ProfilePoint> points;  // by rising z
  ProfileBounds bounds;              // data and all priors
  ProfileBounds without_own_prior;   // without the coordinate's own prior
  int not_converged = 0;             // refits that did not converge [1]
};

struct ProfileOptions {
  double half_width = 4;  // to each side of the estimate, in prior sds; clipped to bounds [1]
  int steps = 8;          // to each side [1]
  double rise = 1.92;     // half the 95 % point of chi squared with one degree of freedom [1]
  SolveOptions solver;
};

/// Holds coordinate i on a grid around z, a minimum, and refits the others from the neighbouring
/// point. Bounds are exact where the profile is a parabola. Every coordinate's prior is z^2/2.
/// A stop request leaves points out; an estimate on its bound has no points beyond.
/// @param z  the fitted point (n)
/// @throws InputError if there is no coordinate i.
[[nodiscard]] Profile profile_likelihood(const LeastSquares& problem, const Eigen::VectorXd& z,
                                         int i, const ProfileOptions& options = {});

/// The same of a fit, with the coordinate's name.
[[nodiscard]] Profile profile_likelihood(const FitProblem& problem, const Eigen::VectorXd& z, int i,
                                         const ProfileOptions& options = {});

}  // namespace thenar
