#pragma once

/// Combinations of parameters that the data determine, and combinations that remain as in the
/// prior.

#include <string>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Combination v'x, scaled to one prior sd: v' P v = 1.
struct LearntDirection {
  double sd_ratio =
      1;  // posterior sd over prior sd, from the other half of the draws; 1: nothing learnt [1]
  Eigen::VectorXd v;      // [1 / unit of x] (n)
  Eigen::VectorXd share;  // share of each entry: v_i^2 P_ii over their sum, 0..1 (n)
  std::string text;       // "0.62 a - 0.31 b: sd 0.04 of the prior's": signed shares, largest first
};

/// Directions and the number of parameters that the data determine.
struct LearntDirections {
  std::vector<LearntDirection> directions;  // directions by ascending sd_ratio (n)
  int decided = 0;                  // number of directions whose sd_ratio is below the limit [1]
  double effective_parameters = 0;  // n - tr(P^-1 S), at least 0 [1]
};

/// Posterior covariances: of all draws, and of two halves that share no chain (n, n).
struct PosteriorCovariances {
  Eigen::MatrixXd all, first, second;
};

/// Solves the generalised eigenproblem  S v = r^2 P v  of posterior and prior covariance. The
/// result is invariant to units and linear transformations of x. Covariances only describe straight
/// directions: two separate modes and a curved ridge both appear as one wide direction.
///
/// Sample covariances are uncertain, and the smallest of n ratios is biased: for draws from the
/// prior it is 1 - sqrt(n / N). Therefore directions are computed from one half of the draws and
/// measured in the other half, which removes the bias; each r is then uncertain by 1 / sqrt(2 N).
/// The number of effective parameters is a trace, which is linear in S and hence unbiased; a sum
/// over directions that omits those above 1 would not be.
/// @param S, P           posterior and prior covariance; P positive definite (n, n). A single S is
///                       taken as exact, and used for both halves
/// @param decided_below  sd ratio below which a direction counts as determined by the data [1]
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

/// Computes the covariance of the columns of x (n, n). @param x  at least two draws (n, N)
[[nodiscard]] Eigen::MatrixXd covariance_of(const Eigen::Ref<const Eigen::MatrixXd>& x);

}  // namespace thenar
