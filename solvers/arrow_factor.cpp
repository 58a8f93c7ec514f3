#include "solvers/arrow_factor.h"

#include <algorithm>
#include <limits>

#include <Eigen/QR>
#include <Eigen/SVD>

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Returns all rows of one block (-1: of none), as (own, shared) columns.
MatrixXd stack_rows(const ArrowLayout& layout, const std::vector<ArrowRows>& rows, int block) {
  const Index own = block < 0 ? 0 : layout.own;
  // Count the rows of the block.
  Index count = 0;
  for (const ArrowRows& part : rows)
    if (part.block == block) count += part.shared.rows();
  // Copy the rows of all its parts.
  MatrixXd all(count, own + layout.shared);
  Index row = 0;
  for (const ArrowRows& part : rows) {
    if (part.block != block) continue;
    if (own > 0) all.block(row, 0, part.shared.rows(), own) = part.own;
    all.block(row, own, part.shared.rows(), layout.shared) = part.shared;
    row += part.shared.rows();
  }
  return all;
}

/// Returns the upper triangle of a QR factorisation (min(rows, columns), columns).
MatrixXd triangle(const MatrixXd& A) {
  if (A.size() == 0) return MatrixXd(0, A.cols());
  const Eigen::HouseholderQR<MatrixXd> qr(A);
  const Index rows = std::min(A.rows(), A.cols());
  return qr.matrixQR().topRows(rows).triangularView<Eigen::Upper>();
}

/// Stacks two matrices vertically.
MatrixXd stack_vertically(const MatrixXd& top, const MatrixXd& bottom) {
  if (top.size() == 0) return bottom;
  MatrixXd all(top.rows() + bottom.rows(), top.cols());
  all << top, bottom;
  return all;
}

/// Fundamental subspaces of a matrix A, by its singular values.
struct RankSplit {
  MatrixXd row_space,
      null_space;           // orthonormal columns: directions that A determines, and the others
  MatrixXd column_space;    // orthonormal basis of the range of A
  VectorXd inverse_values;  // reciprocals of the nonzero singular values
};

/// Splits the spaces of A; singular values below the tolerance or rounding count as zero.
RankSplit split_by_rank(const MatrixXd& A, double tolerance) {
  const Index n = A.cols();
  // A matrix without entries determines nothing.
  if (A.rows() == 0 || n == 0)
    return {MatrixXd(n, 0), MatrixXd::Identity(n, n), MatrixXd(A.rows(), 0), VectorXd(0)};
  // Count the singular values above the tolerance and above rounding.
  const Eigen::JacobiSVD<MatrixXd, Eigen::FullPivHouseholderQRPreconditioner> svd(
      A, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const VectorXd& sigma = svd.singularValues();
  const double rounding = std::numeric_limits<double>::epsilon() *
                          static_cast<double>(std::max(A.rows(), n)) * sigma[0];
  const Index rank = (sigma.array() > std::max(tolerance, rounding)).count();
  return {svd.matrixV().leftCols(rank), svd.matrixV().rightCols(n - rank),
          svd.matrixU().leftCols(rank), sigma.head(rank).cwiseInverse()};
}

}  // namespace

ArrowMatrix::ArrowMatrix(const ArrowLayout& arrow)
    : layout(arrow),
      shared(MatrixXd::Zero(arrow.shared, arrow.shared)),
      own(static_cast<std::size_t>(arrow.blocks), MatrixXd::Zero(arrow.own, arrow.own)),
      cross(static_cast<std::size_t>(arrow.blocks), MatrixXd::Zero(arrow.own, arrow.shared)) {}

MatrixXd ArrowMatrix::block_entries(int block) const {
  if (block < 0 || layout.own == 0) return shared;
  MatrixXd all(layout.shared + layout.own, layout.shared + layout.own);
  all << shared, cross[block].transpose(), cross[block], own[block];
  return all;
}

VectorXd ArrowMatrix::diagonal() const {
  VectorXd all(layout.size());
  all.head(layout.shared) = shared.diagonal();
  for (int b = 0; b < layout.blocks; ++b)
    all.segment(layout.first_index(b), layout.own) = own[b].diagonal();
  return all;
}

ArrowFactor::ArrowFactor(const ArrowLayout& layout, const std::vector<ArrowRows>& rows)
    : layout_(layout) {
  // Eliminate the blocks one by one; the remaining rows depend on shared coordinates only.
  MatrixXd remaining = stack_rows(layout, rows, -1);
  for (int b = 0; b < layout.blocks; ++b) {
    const MatrixXd R = triangle(stack_rows(layout, rows, b));
    const Index own = layout.own, remaining_rows = std::max<Index>(0, R.rows() - own);
    blocks_.push_back({R.topLeftCorner(own, own), R.topRightCorner(own, layout.shared)});
    remaining = stack_vertically(remaining, R.bottomRightCorner(remaining_rows, layout.shared));
  }
  shared_ = triangle(remaining);
}

VectorXd ArrowFactor::whiten(const VectorXd& g) const {
  VectorXd y(g.size());
  // Forward substitution: blocks first, then the shared coordinates.
  VectorXd shared = g.head(layout_.shared);
  for (int b = 0; b < layout_.blocks; ++b) {
    const Block& block = blocks_[b];
    auto own = y.segment(layout_.first_index(b), layout_.own);
    own = block.R.transpose().triangularView<Eigen::Lower>().solve(
        g.segment(layout_.first_index(b), layout_.own));
    shared -= block.S.transpose() * own;
  }
  y.head(layout_.shared) = shared_.transpose().triangularView<Eigen::Lower>().solve(shared);
  return y;
}

MatrixXd ArrowFactor::whiten(const ArrowRows& rows) const {
  MatrixXd own, shared = rows.shared.transpose();
  if (rows.block >= 0) {
    const Block& block = blocks_[rows.block];
    own = block.R.transpose().triangularView<Eigen::Lower>().solve(rows.own.transpose());
    shared -= block.S.transpose() * own;
  }
  return stack_vertically(own, shared_.transpose().triangularView<Eigen::Lower>().solve(shared));
}

VectorXd ArrowFactor::unwhiten(const VectorXd& v) const {
  // Back substitution: shared coordinates first, then the blocks.
  VectorXd x(v.size());
  x.head(layout_.shared) = shared_.triangularView<Eigen::Upper>().solve(v.head(layout_.shared));
  for (int b = 0; b < layout_.blocks; ++b) {
    const Block& block = blocks_[b];
    x.segment(layout_.first_index(b), layout_.own) = block.R.triangularView<Eigen::Upper>().solve(
        v.segment(layout_.first_index(b), layout_.own) - block.S * x.head(layout_.shared));
  }
  return x;
}

ArrowMatrix ArrowFactor::inverse_blocks() const {
  const Index p = layout_.shared, d = layout_.own;
  ArrowMatrix C(layout_);
  // Covariance of the shared coordinates; that of the blocks follows from it.
  const MatrixXd root = shared_.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(p, p));
  C.shared = root * root.transpose();
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    // Variance within the block, plus that transferred from the shared coordinates.
    const auto R = blocks_[b].R.triangularView<Eigen::Upper>();
    const MatrixXd own = R.solve(MatrixXd::Identity(d, d)), response = R.solve(blocks_[b].S);
    C.cross[b] = -response * C.shared;
    C.own[b] = own * own.transpose() - C.cross[b] * response.transpose();
  }
  return C;
}

MatrixXd ArrowFactor::inverse() const {
  const ArrowMatrix blocks = inverse_blocks();
  MatrixXd C(layout_.size(), layout_.size());
  C.topLeftCorner(layout_.shared, layout_.shared) = blocks.shared;
  for (int b = 0; b < layout_.blocks; ++b) {
    const Index at = layout_.first_index(b), p = layout_.shared, d = layout_.own;
    C.block(at, 0, d, p) = blocks.cross[b];
    C.block(0, at, p, d) = blocks.cross[b].transpose();
    // Covariance with other blocks through the shared coordinates.
    const MatrixXd response = blocks_[b].R.triangularView<Eigen::Upper>().solve(blocks_[b].S);
    C.block(at, at, d, d) = blocks.own[b];
    for (int other = 0; other < b; ++other) {
      const Index to = layout_.first_index(other);
      C.block(at, to, d, d) = -response * C.block(0, to, p, d);
      C.block(to, at, d, d) = C.block(at, to, d, d).transpose();
    }
  }
  return C;
}

double ArrowFactor::log_determinant() const {
  double half = shared_.diagonal().cwiseAbs().array().log().sum();
  for (const Block& block : blocks_) half += block.R.diagonal().cwiseAbs().array().log().sum();
  return 2 * half;
}

double ArrowFactor::squared_norm(const VectorXd& v) const {
  const VectorXd shared = v.head(layout_.shared);
  double sum = (shared_ * shared).squaredNorm();
  for (int b = 0; b < layout_.blocks; ++b)
    sum += (blocks_[b].R * v.segment(layout_.first_index(b), layout_.own) + blocks_[b].S * shared)
               .squaredNorm();
  return sum;
}

MatrixXd dense_rows(const ArrowLayout& layout, const std::vector<ArrowRows>& rows) {
  Index count = 0, row = 0;
  for (const ArrowRows& part : rows) count += part.shared.rows();
  MatrixXd J = MatrixXd::Zero(count, layout.size());
  for (const ArrowRows& part : rows) {
    J.block(row, 0, part.shared.rows(), layout.shared) = part.shared;
    if (part.block >= 0)
      J.block(row, layout.first_index(part.block), part.own.rows(), layout.own) = part.own;
    row += part.shared.rows();
  }
  return J;
}

ArrowNullSpace arrow_null_space(const ArrowLayout& layout, const std::vector<ArrowRows>& rows,
                                double tolerance) {
  // Split the own columns of each block, and collect the conditions on the shared coordinates.
  std::vector<RankSplit> own;
  std::vector<MatrixXd> shared_columns;
  MatrixXd conditions = stack_rows(layout, rows, -1);
  for (int b = 0; b < layout.blocks; ++b) {
    const MatrixXd all = stack_rows(layout, rows, b);
    own.push_back(split_by_rank(all.leftCols(layout.own), tolerance));
    shared_columns.emplace_back(all.rightCols(layout.shared));
    const MatrixXd& range = own.back().column_space;
    conditions = stack_vertically(
        conditions, shared_columns.back() - range * (range.transpose() * shared_columns.back()));
  }
  const MatrixXd shared = split_by_rank(triangle(conditions), tolerance).null_space;

  // A shared direction is null if every block can compensate for it. The compensation lies in the
  // block's row space, orthogonal to the block's own null space.
  ArrowNullSpace out{MatrixXd(layout.size(), shared.cols()), {}};
  out.coupled.topRows(layout.shared) = shared;
  for (int b = 0; b < layout.blocks; ++b) {
    const RankSplit& block = own[b];
    out.coupled.middleRows(layout.first_index(b), layout.own) =
        -block.row_space * (block.inverse_values.asDiagonal() *
                            (block.column_space.transpose() * (shared_columns[b] * shared)));
    out.own.push_back(block.null_space);
  }
  // Orthonormalise the columns.
  if (shared.cols() == 0) return out;
  const Eigen::HouseholderQR<MatrixXd> qr(out.coupled);
  out.coupled = qr.householderQ() * MatrixXd::Identity(layout.size(), shared.cols());
  return out;
}

}  // namespace thenar
