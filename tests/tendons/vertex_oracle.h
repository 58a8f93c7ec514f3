#pragma once

/// Largest forces of a tip by trying every vertex: slow, and certain.

#include <algorithm>
#include <limits>
#include <vector>

#include <Eigen/Core>
#include <Eigen/LU>

#include "tendons/tip_statics.h"

namespace thenar {

/// Every choice of n basic variables among the amounts of loads and the tensions, with every other
/// tension at 0 or at F0, in long double. Knows no scaled balance, no simplex method and no price.
/// All F0 must be finite, and there must be few muscles: choices grow as C(m, n) 2^(m - n).
class VertexOracle {
 public:
  explicit VertexOracle(const TipStatics& statics)
      : tau_(statics.tau_0.cast<long double>()),
        J_t_(statics.J.transpose().cast<long double>()),
        pulls_((-statics.R.transpose() * statics.max_tension.asDiagonal()).cast<long double>()) {
    // Rows to the size of what tendons make of them, so that one tolerance serves all.
    const Vector scale = pulls_.cwiseAbs().rowwise().sum().cwiseMax(1e-9L).cwiseInverse();
    tau_ = tau_.cwiseProduct(scale);
    J_t_ = scale.asDiagonal() * J_t_;
    pulls_ = scale.asDiagonal() * pulls_;
  }

  /// maximise s >= 0  subject to  s J' d - R' t = tau_0,  0 <= t <= F0.
  /// @return s, or -1 if no vertex is feasible [N]
  [[nodiscard]] double along(const Eigen::Vector3d& direction) const {
    const Vector d = direction.normalized().cast<long double>();
    Search search{Matrix(tau_.size(), 1 + pulls_.cols()), tau_, Vector::Ones(1), 0, -1};
    search.columns << J_t_ * d, pulls_;
    search.choose(0, {});
    return static_cast<double>(search.best);
  }

  /// maximise u' f  subject to  J' f - R' t = tau_0,  0 <= t <= F0;  J must have rank 3.
  /// @return that, or -infinity if no vertex is feasible [N]
  [[nodiscard]] double support(const Eigen::Vector3d& u) const {
    Search search{Matrix(tau_.size(), 3 + pulls_.cols()), tau_, u.cast<long double>(), 3,
                  -std::numeric_limits<long double>::infinity()};
    search.columns << J_t_, pulls_;
    search.choose(3, {0, 1, 2});
    return static_cast<double>(search.best);
  }

 private:
  using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
  using Index = Eigen::Index;

  /// Columns of loads first: `free` of them, or one that must not be negative.
  struct Search {
    Matrix columns;  // (n, k + m)
    Vector tau;      // (n)
    Vector worth;    // of the loads (k)
    Index free;      // loads of any sign
    long double best;

    /// Every set of n columns that begins with `chosen`.
    void choose(Index from, std::vector<Index> chosen) {
      if (static_cast<Index>(chosen.size()) == columns.rows()) return try_bounds(chosen);
      chosen.push_back(0);
      for (Index k = from; k < columns.cols(); ++k) {
        chosen.back() = k;
        choose(k + 1, chosen);
      }
    }

    /// The chosen columns are basic; all other tensions run through their two bounds.
    void try_bounds(const std::vector<Index>& chosen) {
      Matrix B(columns.rows(), columns.rows());
      for (Index k = 0; k < B.cols(); ++k) B.col(k) = columns.col(chosen[size(k)]);
      const Eigen::FullPivLU<Matrix> lu(B);
      if (!lu.isInvertible()) return;
      std::vector<Vector> moves;  // of the basic variables, when one of the others rises to F0
      for (Index k = worth.size(); k < columns.cols(); ++k)
        if (std::count(chosen.begin(), chosen.end(), k) == 0)
          moves.emplace_back(lu.solve(columns.col(k)));
      const Vector start = lu.solve(tau);
      for (std::size_t bits = 0; bits < std::size_t{1} << moves.size(); ++bits) {
        Vector v = start;
        for (std::size_t k = 0; k < moves.size(); ++k)
          if ((bits >> k & 1U) != 0) v -= moves[k];
        take(chosen, v);
      }
    }

    /// Keeps what a vertex reaches, if it is inside its bounds.
    void take(const std::vector<Index>& chosen, const Vector& v) {
      constexpr long double kInside = 1e-12L;
      long double reached = 0;
      for (Index k = 0; k < v.size(); ++k) {
        const Index variable = chosen[size(k)];
        const bool load = variable < worth.size();
        if (variable >= free && v(k) < -kInside) return;
        if (!load && v(k) > 1 + kInside) return;
        if (load) reached += worth(variable) * v(k);
      }
      best = std::max(best, reached);
    }

    static std::size_t size(Index k) { return static_cast<std::size_t>(k); }
  };

  Vector tau_;
  Matrix J_t_, pulls_;
};

}  // namespace thenar
