#pragma once

/// Profile likelihood: minimum cost over all other coordinates as a function of one coordinate.

#include <optional>
#include <string>
#include <vector>

#include "kinematics_fit/fit_problem.h"

namespace thenar {

/// Minimum cost with one coordinate held fixed.
struct ProfilePoint {
  double z = 0;                  // fixed value, in prior sds [1]
  double cost = 0;               // 1/2 |r|^2 with all other coordinates refitted [1]
  double rise = 0;               // cost above the minimum of the profile [1]
  double without_own_prior = 0;  // rise of cost - z^2/2: data and the other priors only [1]
};

/// Values at which a profile has risen by ProfileOptions::rise; empty if it does not within
/// half_width ("open").
struct ProfileBounds {
  std::optional<double> lower, upper;  // crossings, in prior sds [1]
};

/// Profile of one coordinate.
struct Profile {
  std::string name;                  // name of the coordinate
  std::vector<ProfilePoint> points;  // points by ascending z
  ProfileBounds bounds;              // bounds from data and all priors
  ProfileBounds without_own_prior;   // bounds without the coordinate's own prior
  int not_converged = 0;             // number of refits that did not converge [1]
};

/// Grid of a profile, and the rise that defines its bounds.
struct ProfileOptions {
  /// Distance to each side of the estimate, in prior sds; clipped to bounds [1].
  double half_width = 4;
  int steps = 8;       // number of grid steps to each side [1]
  double rise = 1.92;  // half the 95 % point of chi squared with one degree of freedom [1]
  SolveOptions solver;
};

/// Fixes coordinate i on a grid around the minimum z, and refits the others from the neighbouring
/// point. Bounds are exact if the profile is a parabola. Every coordinate's prior is z^2/2. A stop
/// request leaves points out; an estimate on its bound has no points beyond.
/// @param z  the fitted point (n)
/// @throws InputError if there is no coordinate i.
[[nodiscard]] Profile profile_likelihood(const LeastSquares& problem, const Eigen::VectorXd& z,
                                         int i, const ProfileOptions& options = {});

/// Computes the profile of a fit's coordinate, with its name.
[[nodiscard]] Profile profile_likelihood(const FitProblem& problem, const Eigen::VectorXd& z, int i,
                                         const ProfileOptions& options = {});

}  // namespace thenar
