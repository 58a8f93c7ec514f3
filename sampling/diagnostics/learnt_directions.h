#pragma once

/// Combinations of parameters that the data decided, and combinations that stay as in the prior.

#include <string>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// A combination v'x, scaled to one prior sd: v' P v = 1.
struct LearntDirection {
  double sd_ratio = 1;    // posterior sd over prior sd, by the other draws; 1: nothing learnt [1]
  Eigen::VectorXd v;      // [1 / unit of x] (n)
  Eigen::VectorXd share;  // of each entry in it: v_i^2 P_ii over their sum, 0..1 (n)
  std::string text;       // "0.62 a - 0.31 b: sd 0.04 of the prior's": signed shares, largest first
};

struct LearntDirections {
  std::vector<LearntDirection> directions;  // best learnt first (n)
  int decided = 0;                          // directions whose sd_ratio is below the limit [1]
  double effective_parameters = 0;          // n - tr(P^-1 S), at least 0 [1]
};

/// Posterior covariances: of all draws, and of two halves that share no chain (n, n).
struct PosteriorCovariances {
  Eigen::MatrixXd all, first, second;
};

/// Solves the generalised eigenproblem  S v = r^2 P v  of posterior against prior covariance. The
/// result does not depend on units or linear coordinates of x. Covariances describe straight
/// directions only: two separate modes and a bent ridge both appear as one wide direction.
///
/// Covariances of draws are uncertain, and the least ratio of n directions is the least by luck as
/// well: of draws from the prior alone it comes out as 1 - sqrt(n / N). So directions are found in
/// one half of the draws and measured in the other, where luck does not follow them; each r is then
/// uncertain by 1 / sqrt(2 N). The number of effective parameters is a trace, which is linear in S
/// and hence unbiased; a sum over directions that leaves out those above 1 is not.
/// @param S, P           posterior and prior covariance; P positive definite (n, n). One S stands
/// for
///                       an exact covariance, in both halves
/// @param decided_below  sd ratio at which a direction counts as decided [1]
/// @throws InputError if shapes disagree, or P is not positive definite.
/// Source: [Cui2014] sec. 3.1, where r^2 = 1 / (1 + eigenvalue).
[[nodiscard]] LearntDirections learnt_directions(const std::vector<std::string>& names,
                                                 const Eigen::Ref<const Eigen::MatrixXd>& S,
                                                 const Eigen::Ref<const Eigen::MatrixXd>& P,
                                                 double decided_below = 0.5);
[[nodiscard]] LearntDirections learnt_directions(const std::vector<std::string>& names,
                                                 const PosteriorCovariances& S,
                                                 const Eigen::Ref<const Eigen::MatrixXd>& P,
                                                 double decided_below = 0.5);

/// Covariance of the columns of x (n, n). @param x  at least two draws (n, N)
[[nodiscard]] Eigen::MatrixXd covariance_of(const Eigen::Ref<const Eigen::MatrixXd>& x);

}  // namespace thenar
