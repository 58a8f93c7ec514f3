#include "contact/in_place_lu.h"

#include <cmath>

#include "base/stop_scope.h"

namespace thenar {

using Eigen::Index;

namespace {

// Size above which each column of a block checks for a stop; it then takes microseconds (rows)
constexpr Index kLargeBlock = 200;

}  // namespace

void InPlaceLu::find_blocks(const Eigen::Ref<const Eigen::MatrixXd>& R) {
  const Index n = R.rows();
  blocks_.clear();
  blocks_.reserve(static_cast<std::size_t>(n));
  Index begin = 0, end = 0;
  for (Index k = 0; k < n; ++k) {
    // Last row or column that couples with k.
    Index last = n - 1;
    while (last > k && last >= end && R(last, k) == 0 && R(k, last) == 0) --last;
    end = std::max(end, last + 1);
    // A block ends where no later row couples with any of its rows.
    if (end > k + 1) continue;
    blocks_.push_back({begin, end});
    begin = end;
  }
}

bool InPlaceLu::factor(Eigen::Ref<Eigen::MatrixXd> R) {
  pivots_.resize(static_cast<std::size_t>(R.rows()));
  find_blocks(R);
  for (const auto [begin, end] : blocks_)
    for (Index k = begin; k < end; ++k) {
      if (end - begin > kLargeBlock) end_if_stopped();
      // Partial pivoting: swap the largest remaining entry of the column to the diagonal.
      Index offset = 0;
      const double largest = R.col(k).segment(k, end - k).cwiseAbs().maxCoeff(&offset);
      if (!(largest > 0) || !std::isfinite(largest)) return false;
      pivots_[k] = k + offset;
      if (offset > 0)
        R.row(k).segment(begin, end - begin).swap(R.row(k + offset).segment(begin, end - begin));

      // Eliminate the column below the pivot.
      const Index rest = end - k - 1;
      R.col(k).segment(k + 1, rest) /= R(k, k);
      for (Index j = k + 1; j < end; ++j)
        R.col(j).segment(k + 1, rest) -= R(k, j) * R.col(k).segment(k + 1, rest);
    }
  return true;
}

void InPlaceLu::solve(const Eigen::Ref<const Eigen::MatrixXd>& factors,
                      Eigen::Ref<Eigen::VectorXd> y) const {
  for (const auto [begin, end] : blocks_) {
    // Permutation, then forward substitution with L, then back substitution with U.
    for (Index k = begin; k < end; ++k) std::swap(y(k), y(pivots_[k]));
    for (Index k = begin; k < end; ++k) {
      const Index rest = end - k - 1;
      y.segment(k + 1, rest) -= y(k) * factors.col(k).segment(k + 1, rest);
    }
    for (Index k = end - 1; k >= begin; --k) {
      y(k) /= factors(k, k);
      y.segment(begin, k - begin) -= y(k) * factors.col(k).segment(begin, k - begin);
    }
  }
}

}  // namespace thenar
