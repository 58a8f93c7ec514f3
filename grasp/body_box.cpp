#include "grasp/body_box.h"

#include <algorithm>
#include <array>

#include <Eigen/Eigenvalues>

#include "geometry/mass_properties.h"

namespace thenar {
namespace {

constexpr double kSmaller = 0.99;  // volume of a box that is taken instead [1]

BodyBox box_along(const Eigen::Matrix3d& axes, const Eigen::Matrix3Xd& points) {
  const Eigen::Matrix3Xd along = axes.transpose() * points;
  return {axes, (along.rowwise().maxCoeff() - along.rowwise().minCoeff()) / 2};
}

BodyBox longest_first(const BodyBox& box) {
  std::array<int, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return box.half[a] > box.half[b]; });
  BodyBox sorted;
  for (int i = 0; i < 3; ++i) {
    sorted.axes.col(i) = box.axes.col(order[static_cast<std::size_t>(i)]);
    sorted.half[i] = box.half[order[static_cast<std::size_t>(i)]];
  }
  if (sorted.axes.determinant() < 0) sorted.axes.col(2) *= -1;
  return sorted;
}

}  // namespace

BodyBox body_box(const TriangleMesh& picture) {
  const BodyBox framed = box_along(Eigen::Matrix3d::Identity(), picture.vertices);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> inertia(mass_properties(picture, 1).inertia);
  const BodyBox turned = box_along(inertia.eigenvectors(), picture.vertices);
  const bool smaller = turned.half.prod() < kSmaller * framed.half.prod();
  return longest_first(smaller ? turned : framed);
}

}  // namespace thenar
