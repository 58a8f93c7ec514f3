#include "solvers/arrow_matrix.h"

namespace thenar {

using Eigen::MatrixXd;
using Eigen::VectorXd;

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

}  // namespace thenar
