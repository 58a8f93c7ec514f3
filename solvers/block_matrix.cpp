#include "solvers/block_matrix.h"

#include <algorithm>
#include <set>

namespace thenar::internal {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kMinPivot = 1e-13;  // minimum pivot over the trace of its block [1]

/// Neighbours of each row in the graph of nonzero blocks.
using Neighbours = std::vector<std::set<int>>;

/// Returns the remaining row with the fewest neighbours.
int min_degree_row(const Neighbours& neighbours, const std::vector<bool>& eliminated) {
  int best = -1;
  for (int i = 0; i < static_cast<int>(neighbours.size()); ++i)
    if (!eliminated[i] && (best < 0 || neighbours[i].size() < neighbours[best].size())) best = i;
  return best;
}

/// Eliminates rows in minimum-degree order; afterwards, neighbours[i] holds the later rows coupled
/// to i.
std::vector<int> eliminate(Neighbours& neighbours) {
  std::vector<int> order;
  std::vector<bool> eliminated(neighbours.size(), false);
  // Eliminate a row: its neighbours become neighbours of each other.
  while (order.size() < neighbours.size()) {
    const int k = min_degree_row(neighbours, eliminated);
    eliminated[k] = true;
    order.push_back(k);
    for (int i : neighbours[k]) {
      neighbours[i].erase(k);
      for (int j : neighbours[k])
        if (i != j) neighbours[i].insert(j);
    }
  }
  return order;
}

}  // namespace

BlockPattern::BlockPattern(int n, const std::vector<std::pair<int, int>>& edges)
    : place_(n), start_(n + 1, 0), update_start_(n + 1, 0) {
  // Order the rows of the graph.
  Neighbours neighbours(n);
  for (const auto& [i, j] : edges)
    if (i != j) neighbours[i].insert(j), neighbours[j].insert(i);
  const std::vector<int> order = eliminate(neighbours);
  for (int k = 0; k < n; ++k) place_[order[k]] = k;
  // List the blocks of each column, including fill-in.
  for (int k = 0; k < n; ++k) {
    for (int i : neighbours[order[k]]) row_.push_back(place_[i]), column_.push_back(k);
    std::sort(row_.begin() + start_[k], row_.end());
    start_[k + 1] = blocks();
  }
  // List the updates that each column makes to later blocks.
  for (int k = 0; k < n; ++k) {
    for (int left = start_[k]; left < start_[k + 1]; ++left)
      for (int right = start_[k]; right <= left; ++right)
        update_.push_back(
            {left, right, left == right ? ~row_[left] : slot(row_[left], row_[right])});
    update_start_[k + 1] = static_cast<int>(update_.size());
  }
}

int BlockPattern::slot(int i, int j) const {
  const auto first = row_.begin() + start_[j], last = row_.begin() + start_[j + 1];
  const auto found = std::lower_bound(first, last, i);
  return found != last && *found == i ? static_cast<int>(found - row_.begin()) : -1;
}

BlockFactor::BlockFactor(const BlockPattern& pattern)
    : pattern_(&pattern), A_(pattern), l_(pattern.size()), d_(pattern.size()) {
  int max_blocks = 0;
  for (int k = 0; k < pattern.size(); ++k)
    max_blocks = std::max(max_blocks, pattern.start_[k + 1] - pattern.start_[k]);
  W_.resize(max_blocks);
}

bool BlockFactor::factorise(const BlockMatrix& A, double absolute, double relative) {
  const BlockPattern& pattern = *pattern_;
  std::copy(A.diagonal.begin(), A.diagonal.end(), A_.diagonal.begin());
  std::copy(A.off.begin(), A.off.end(), A_.off.begin());
  bad_block_ = -1;
  std::vector<Matrix3d>& off = A_.off;
  // Factorise column by column.
  for (int k = 0; k < pattern.size(); ++k) {
    const Matrix3d& D = A_.diagonal[k];
    const double trace = std::abs(A.diagonal[k].trace()), shift = absolute + relative * trace;
    const double min_pivot = kMinPivot * (trace + 3 * shift);
    // Factorise the diagonal block.
    const double d0 = D(0, 0) + shift, l10 = D(1, 0) / d0, l20 = D(2, 0) / d0;
    const double d1 = D(1, 1) + shift - l10 * D(1, 0), m21 = D(2, 1) - l20 * D(1, 0),
                 l21 = m21 / d1;
    const double d2 = D(2, 2) + shift - l20 * D(2, 0) - l21 * m21;
    l_[k] << l10, l20, l21;
    d_[k] << d0, d1, d2;
    // Stop at a pivot that is not positive.
    for (int r = 0; r < 3; ++r) {
      if (d_[k](r) > min_pivot) continue;
      bad_block_ = k;
      bad_row_ = r;
      if (r == 0) l_[k].setZero();
      if (r == 1) l_[k].tail<2>().setZero();
      return false;
    }
    // Compute W = B l^-T in a copy of the column, and replace B by V = W / d.
    const int first = pattern.start_[k], last = pattern.start_[k + 1];
    for (int s = first; s < last; ++s) {
      Matrix3d& w = W_[s - first];
      w = off[s];
      w.col(1) -= l10 * w.col(0);
      w.col(2) -= l20 * w.col(0) + l21 * w.col(1);
      off[s].col(0) = w.col(0) / d0;
      off[s].col(1) = w.col(1) / d1;
      off[s].col(2) = w.col(2) / d2;
    }
    // Update later blocks.
    for (int u = pattern.update_start_[k]; u < pattern.update_start_[k + 1]; ++u) {
      const BlockPattern::Update& up = pattern.update_[u];
      Matrix3d& target = up.target < 0 ? A_.diagonal[~up.target] : off[up.target];
      target.noalias() -= W_[up.left - first] * off[up.right].transpose();
    }
  }
  return true;
}

void BlockFactor::solve(std::vector<Vector3d>& y) const {
  const BlockPattern& pattern = *pattern_;
  // Forward substitution.
  for (int k = 0; k < pattern.size(); ++k) {
    y[k](1) -= l_[k](0) * y[k](0);
    y[k](2) -= l_[k](1) * y[k](0) + l_[k](2) * y[k](1);
    for (int s = pattern.start_[k]; s < pattern.start_[k + 1]; ++s)
      y[pattern.row_[s]] -= A_.off[s] * y[k];
  }
  // Division by the diagonal and back substitution.
  for (int k = pattern.size() - 1; k >= 0; --k) {
    y[k] = y[k].cwiseQuotient(d_[k]);
    for (int s = pattern.start_[k]; s < pattern.start_[k + 1]; ++s)
      y[k] -= A_.off[s].transpose() * y[pattern.row_[s]];
    y[k](1) -= l_[k](2) * y[k](2);
    y[k](0) -= l_[k](0) * y[k](1) + l_[k](1) * y[k](2);
  }
}

bool BlockFactor::negative_direction(std::vector<Vector3d>& v) const {
  if (bad_block_ < 0) return false;
  // Solve L' v = e for the bad pivot: later rows are zero, earlier rows follow.
  for (Vector3d& row : v) row.setZero();
  Vector3d& bad = v[bad_block_];
  bad(bad_row_) = 1;
  const auto substitute_back = [](const Vector3d& l, Vector3d& y) {
    y(1) -= l(2) * y(2);
    y(0) -= l(0) * y(1) + l(1) * y(2);
  };
  substitute_back(l_[bad_block_], bad);
  const BlockPattern& pattern = *pattern_;
  for (int k = bad_block_ - 1; k >= 0; --k) {
    for (int s = pattern.start_[k]; s < pattern.start_[k + 1]; ++s)
      v[k] -= A_.off[s].transpose() * v[pattern.row_[s]];
    substitute_back(l_[k], v[k]);
  }
  return true;
}

}  // namespace thenar::internal
