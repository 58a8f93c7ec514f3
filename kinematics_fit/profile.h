#pragma once

/// Profile likelihood: least cost over all other coordinates as one coordinate is held.

#include <optional>
#include <string>
#include <vector>

#include "kinematics_fit/fit_problem.h"

namespace thenar {

/// Least cost with one coordinate held.
struct ProfilePoint {
  double z;                  // value at which it is held, in prior sds [1]
  double cost;               // 1/2 |r|^2, all others refitted [1]
  double rise;               // above the least cost of the profile [1]
  double without_own_prior;  // rise of cost - z^2/2: data and the other priors alone [1]
};

/// Values at which a profile has risen by ProfileOptions::rise; empty: it does not within
/// half_width
/// ("open").
struct ProfileBounds {
  std::optional<double> lower, upper;  // in prior sds [1]
};

/// Profile of one coordinate.
struct Profile {
  std::string name;                  // of the coordinate
  std::vector<ProfilePoint> points;  // by rising z
  ProfileBounds bounds;              // data and all priors
  ProfileBounds without_own_prior;   // without the coordinate's own prior
  int not_converged = 0;             // refits that did not converge [1]
};

/// Grid of a profile, and the rise of its bounds.
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

/// Profile of a fit's coordinate, with its name.
[[nodiscard]] Profile profile_likelihood(const FitProblem& problem, const Eigen::VectorXd& z, int i,
                                         const ProfileOptions& options = {});

}  // namespace thenar
