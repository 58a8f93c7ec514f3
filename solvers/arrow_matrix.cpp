#include "solvers/arrow_matrix.h"

#include <utility>

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Puts rows and columns of the identity where coordinates from `first` on are not free.
void hold(MatrixXd& A, const std::vector<bool>& free, int first) {
  for (Index i = 0; i < A.rows(); ++i) {
    if (free[static_cast<std::size_t>(first + i)]) continue;
    A.row(i).setZero();
    A.col(i).setZero();
    A(i, i) = 1;
  }
}

}  // namespace

ArrowMatrix::ArrowMatrix(const ArrowLayout& of)
    : layout(of),
      shared(MatrixXd::Zero(of.shared, of.shared)),
      own(static_cast<std::size_t>(of.blocks), MatrixXd::Zero(of.own, of.own)),
      cross(static_cast<std::size_t>(of.blocks), MatrixXd::Zero(of.own, of.shared)) {}

void ArrowMatrix::add(int block, const MatrixXd& part) {
  shared += part.topLeftCorner(layout.shared, layout.shared);
  if (block < 0) return;
  own[static_cast<std::size_t>(block)] += part.bottomRightCorner(layout.own, layout.own);
  cross[static_cast<std::size_t>(block)] += part.bottomLeftCorner(layout.own, layout.shared);
}

void ArrowMatrix::add(const ArrowMatrix& other, double factor) {
  shared += factor * other.shared;
  for (std::size_t b = 0; b < own.size(); ++b) {
    own[b] += factor * other.own[b];
    cross[b] += factor * other.cross[b];
  }
}

MatrixXd ArrowMatrix::of(int block) const {
  if (block < 0 || layout.own == 0) return shared;
  const auto b = static_cast<std::size_t>(block);
  MatrixXd all(layout.shared + layout.own, layout.shared + layout.own);
  all << shared, cross[b].transpose(), cross[b], own[b];
  return all;
}

VectorXd ArrowMatrix::diagonal() const {
  VectorXd all(layout.size());
  all.head(layout.shared) = shared.diagonal();
  for (int b = 0; b < layout.blocks; ++b)
    all.segment(layout.first(b), layout.own) = own[static_cast<std::size_t>(b)].diagonal();
  return all;
}

std::optional<ArrowCholesky> ArrowCholesky::factor(const ArrowMatrix& matrix,
                                                   const std::vector<bool>& free) {
  const ArrowLayout& layout = matrix.layout;
  ArrowCholesky out(layout);
  out.free_ = free;
  // Blocks first, then what they leave of the shared coordinates.
  MatrixXd shared = matrix.shared;
  hold(shared, free, 0);
  for (int b = 0; b < layout.blocks; ++b) {
    MatrixXd own = matrix.own[static_cast<std::size_t>(b)];
    hold(own, free, layout.first(b));
    MatrixXd cross = matrix.cross[static_cast<std::size_t>(b)];
    for (Index i = 0; i < cross.rows(); ++i)
      if (!free[static_cast<std::size_t>(layout.first(b) + i)]) cross.row(i).setZero();
    for (Index j = 0; j < cross.cols(); ++j)
      if (!free[static_cast<std::size_t>(j)]) cross.col(j).setZero();
    out.own_.emplace_back(own);
    if (out.own_.back().info() != Eigen::Success) return {};
    out.own_.back().matrixL().solveInPlace(cross);
    shared.noalias() -= cross.transpose() * cross;
    out.cross_.push_back(std::move(cross));
  }
  out.shared_.compute(shared);
  if (out.shared_.info() != Eigen::Success) return {};
  return out;
}

VectorXd ArrowCholesky::solve(const VectorXd& g) const {
  VectorXd x = g;
  for (Index i = 0; i < x.size(); ++i)
    if (!free_[static_cast<std::size_t>(i)]) x[i] = 0;
  // Forward through the blocks, then back from the shared coordinates.
  auto shared = x.head(layout_.shared);
  for (int b = 0; b < layout_.blocks; ++b) {
    auto own = x.segment(layout_.first(b), layout_.own);
    own_[static_cast<std::size_t>(b)].matrixL().solveInPlace(own);
    shared -= cross_[static_cast<std::size_t>(b)].transpose() * own;
  }
  shared_.solveInPlace(shared);
  for (int b = 0; b < layout_.blocks; ++b) {
    auto own = x.segment(layout_.first(b), layout_.own);
    own -= cross_[static_cast<std::size_t>(b)] * shared;
    own_[static_cast<std::size_t>(b)].matrixU().solveInPlace(own);
  }
  return x;
}

}  // namespace thenar
