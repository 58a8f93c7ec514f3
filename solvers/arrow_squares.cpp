#include "solvers/arrow_squares.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Stacks the rows, and sets the columns of fixed coordinates to zero.
MatrixXd stack(const std::vector<MatrixXd>& parts, const std::vector<bool>& free, Index columns) {
  Index rows = 0;
  for (const MatrixXd& part : parts) rows += part.rows();
  MatrixXd all(rows, columns);
  Index row = 0;
  for (const MatrixXd& part : parts) {
    all.middleRows(row, part.rows()) = part;
    row += part.rows();
  }
  for (Index j = 0; j < columns; ++j)
    if (!free[j]) all.col(j).setZero();
  return all;
}

/// Returns, for each shared coordinate and then for each own coordinate of a block, whether it is
/// free (shared + own).
std::vector<bool> free_of_block(const ArrowLayout& layout, int block,
                                const std::vector<bool>& free) {
  std::vector<bool> out(free.begin(), free.begin() + layout.shared);
  const auto own = free.begin() + layout.first_index(block);
  out.insert(out.end(), own, own + layout.own);
  return out;
}

/// Computes A += factor J J' in the lower triangle.
void add_square(MatrixXd& A, const MatrixXd& J, double factor) {
  if (J.size() > 0) A.selfadjointView<Eigen::Lower>().rankUpdate(J, factor);
}

}  // namespace

ArrowSquares::ArrowSquares(const ArrowLayout& arrow)
    : layout(arrow),
      shared(MatrixXd::Zero(arrow.shared, arrow.shared)),
      diagonal(VectorXd::Zero(Index{arrow.own} * arrow.blocks)),
      rows(static_cast<std::size_t>(arrow.blocks)) {}

void ArrowSquares::add(int block, const MatrixXd& J) {
  // Rows with one entry each only change the diagonal.
  Index entries = 0;
  Eigen::VectorXi in_row = Eigen::VectorXi::Zero(J.rows());
  for (Index j = 0; j < J.cols() && entries <= 1; ++j)
    for (Index i = 0; i < J.rows(); ++i)
      if (J(i, j) != 0) entries = std::max<Index>(entries, ++in_row[i]);
  if (entries <= 1) {
    const VectorXd squares = J.colwise().squaredNorm();
    shared.diagonal() += squares.head(layout.shared);
    if (block >= 0)
      diagonal.segment(Index{layout.own} * block, layout.own) += squares.tail(layout.own);
    return;
  }
  if (block < 0)
    shared += J.transpose() * J;
  else
    rows[block].plus.push_back(J);
}

void ArrowSquares::subtract(int block, const MatrixXd& J) {
  if (block < 0)
    shared -= J.transpose() * J;
  else
    rows[block].minus.push_back(J);
}

void ArrowSquares::scale(double factor) {
  shared *= factor;
  diagonal *= factor;
  const double root = std::sqrt(factor);
  for (Rows& block : rows) {
    for (MatrixXd& J : block.plus) J *= root;
    for (MatrixXd& J : block.minus) J *= root;
  }
}

std::optional<ArrowSquaresFactor::Block> ArrowSquaresFactor::eliminate(
    const ArrowSquares& matrix, int block, const std::vector<bool>& free) {
  const ArrowLayout& layout = matrix.layout;
  const std::vector<bool> block_free = free_of_block(layout, block, free);
  // Scale own columns so that D is 1; fixed coordinates are decoupled.
  Block out;
  out.u = matrix.diagonal.segment(Index{layout.own} * block, layout.own);
  for (Index i = 0; i < out.u.size(); ++i) {
    if (!block_free[layout.shared + i]) out.u[i] = 1;
    if (!(out.u[i] > 0)) return {};
    out.u[i] = 1 / std::sqrt(out.u[i]);
  }
  const ArrowSquares::Rows& rows = matrix.rows[block];
  MatrixXd P = stack(rows.plus, block_free, layout.shared + layout.own);
  MatrixXd N = stack(rows.minus, block_free, layout.shared + layout.own);
  P.rightCols(layout.own) = P.rightCols(layout.own) * out.u.asDiagonal();
  N.rightCols(layout.own) = N.rightCols(layout.own) * out.u.asDiagonal();

  // Factorise the added part and compute L^-1 P.
  MatrixXd K = MatrixXd::Identity(P.rows(), P.rows());
  add_square(K, P.rightCols(layout.own), 1);
  const Eigen::LLT<MatrixXd> added(K);
  if (added.info() != Eigen::Success) return {};
  added.matrixL().solveInPlace(P);

  // Factorise the subtracted part.
  if (N.rows() > 0) {
    const MatrixXd overlap = N.rightCols(layout.own) * P.rightCols(layout.own).transpose();
    MatrixXd remainder = MatrixXd::Identity(N.rows(), N.rows());
    add_square(remainder, N.rightCols(layout.own), -1);
    add_square(remainder, overlap, 1);
    const Eigen::LLT<MatrixXd> subtracted(remainder);
    if (subtracted.info() != Eigen::Success) return {};
    N.noalias() -= overlap * P;
    subtracted.matrixL().solveInPlace(N);
  }

  // Stack both parts.
  out.plus = P.rows();
  out.own.resize(P.rows() + N.rows(), layout.own);
  out.own << P.rightCols(layout.own), N.rightCols(layout.own);
  out.shared.resize(out.own.rows(), layout.shared);
  out.shared << P.leftCols(layout.shared), N.leftCols(layout.shared);
  return out;
}

std::optional<ArrowSquaresFactor> ArrowSquaresFactor::factor(const ArrowSquares& matrix,
                                                             const std::vector<bool>& free) {
  const ArrowLayout& layout = matrix.layout;
  ArrowSquaresFactor out(layout);
  out.free_ = free;
  // Eliminate the blocks, then factorise the Schur complement of the shared coordinates.
  MatrixXd shared = matrix.shared;
  for (Index i = 0; i < shared.rows(); ++i) {
    if (free[i]) continue;
    shared.row(i).setZero();
    shared.col(i).setZero();
    shared(i, i) = 1;
  }
  for (int b = 0; b < layout.blocks; ++b) {
    std::optional<Block> block = eliminate(matrix, b, free);
    if (!block) return {};
    const Index minus = block->shared.rows() - block->plus;
    add_square(shared, block->shared.topRows(block->plus).transpose(), 1);
    add_square(shared, block->shared.bottomRows(minus).transpose(), -1);
    out.blocks_.push_back(std::move(*block));
  }
  out.shared_.compute(shared);
  if (out.shared_.info() != Eigen::Success) return {};
  return out;
}

VectorXd ArrowSquaresFactor::solve(const VectorXd& g) const {
  VectorXd x = g;
  for (Index i = 0; i < x.size(); ++i)
    if (!free_[i]) x[i] = 0;
  // W v: rows of the subtracted part have a negative sign.
  const auto apply_signs = [](const Block& block, VectorXd v) {
    v.tail(v.size() - block.plus) *= -1;
    return v;
  };
  // Substitute forward through the blocks, then backward from the shared coordinates.
  auto shared = x.head(layout_.shared);
  for (int b = 0; b < layout_.blocks; ++b) {
    const Block& block = blocks_[b];
    auto own = x.segment(layout_.first_index(b), layout_.own);
    own.array() *= block.u.array();
    shared -= block.shared.transpose() * apply_signs(block, block.own * own);
  }
  shared_.solveInPlace(shared);
  for (int b = 0; b < layout_.blocks; ++b) {
    const Block& block = blocks_[b];
    auto own = x.segment(layout_.first_index(b), layout_.own);
    own -= block.own.transpose() * apply_signs(block, block.own * own + block.shared * shared);
    own.array() *= block.u.array();
  }
  return x;
}

}  // namespace thenar
