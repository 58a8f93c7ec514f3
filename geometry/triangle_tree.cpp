#include "geometry/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace thenar::internal {

using Eigen::Vector3d;

TriangleForm TriangleForm::from_corners(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  TriangleForm form;
  form.corner = {a, b, c};
  // Start from the shortest two edges: of a thin triangle nothing else keeps its digits.
  std::array<Vector3d, 3> edge{b - a, c - b, a - c};
  int longest = 0;
  for (int k = 1; k < 3; ++k)
    if (edge[k].squaredNorm() > edge[longest].squaredNorm()) longest = k;
  form.normal = edge[(longest + 1) % 3].cross(edge[(longest + 2) % 3]).normalized();
  for (int k = 0; k < 3; ++k) {
    form.across[k] = edge[k].cross(form.normal).normalized();
    form.inverse[k] = 1 / edge[k].squaredNorm();
  }
  return form;
}

namespace {

/// Height over length.
double thinness(const TriangleForm& form) {
  const double longest = 1 / std::sqrt(*std::min_element(form.inverse.begin(), form.inverse.end()));
  double height = longest;
  for (int k = 0; k < 3; ++k)
    height = std::min(height, form.across[k].dot(form.corner[k] - form.corner[(k + 2) % 3]));
  return height / longest;
}

}  // namespace

TriangleTree::TriangleTree(const TriangleMesh& mesh) {
  const Eigen::Index count = mesh.triangles.cols();
  // Compute boxes of all triangles, and build the tree over them.
  std::vector<Eigen::AlignedBox3d> boxes(count);
  for (Eigen::Index t = 0; t < count; ++t)
    for (int k = 0; k < 3; ++k) boxes[t].extend(mesh.vertices.col(mesh.triangles(k, t)));
  order_.resize(count);
  std::iota(order_.begin(), order_.end(), 0);
  nodes_.reserve(2 * count);
  build(0, static_cast<int>(count), boxes);
  // Store forms in the order of the tree.
  forms_.reserve(count);
  for (const int t : order_)
    forms_.push_back(TriangleForm::from_corners(mesh.vertices.col(mesh.triangles(0, t)),
                                                mesh.vertices.col(mesh.triangles(1, t)),
                                                mesh.vertices.col(mesh.triangles(2, t))));
  // Distances are computed to some 1e-15 of the mesh's extent, and to as much of their own size;
  // the normals of slivers are off by 1e-15 of their length over their height.
  double thinnest = 1;
  for (const TriangleForm& form : forms_) thinnest = std::min(thinnest, thinness(form));
  const double extent =
      std::max(bounds().min().cwiseAbs().maxCoeff(), bounds().max().cwiseAbs().maxCoeff());
  relative_ = std::max(1e-9, std::min(1e-14 / thinnest, 1e-2));
  absolute_ = std::pow(1e-14 * extent, 2) / relative_;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as triangles are halved
int TriangleTree::build(int first, int last, const std::vector<Eigen::AlignedBox3d>& boxes) {
  constexpr int kLeafTriangles = 3;  // maximum number of triangles of a leaf
  // Compute the boxes of the node and of its triangles' centres.
  const int here = static_cast<int>(nodes_.size());
  nodes_.push_back({{}, first, 0, 0});
  Eigen::AlignedBox3d box, centres;
  for (int i = first; i < last; ++i) {
    box.extend(boxes[order_[i]]);
    centres.extend(boxes[order_[i]].center());
  }
  nodes_[here].box = box;
  // Store few triangles as a leaf.
  if (last - first <= kLeafTriangles) {
    nodes_[here].count = last - first;
    return here;
  }
  // Halve the triangles across the longest way between their centres.
  Eigen::Index axis;
  centres.sizes().maxCoeff(&axis);
  const int middle = (first + last) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                   [&](int a, int b) {
                     const double at_a = boxes[a].center()(axis), at_b = boxes[b].center()(axis);
                     return at_a < at_b || (at_a == at_b && a < b);
                   });
  build(first, middle, boxes);
  nodes_[here].second = build(middle, last, boxes);
  return here;
}

NearestTriangle TriangleTree::nearest(const Vector3d& p, NearestTriangle guess) const {
  // Boxes still to be searched.
  struct Waiting {
    int node;
    double squared;
  };
  std::array<Waiting, 64> stack;  // as deep as the tree of 2^63 triangles
  int waiting = 0;
  stack[waiting++] = {0, nodes_[0].box.squaredExteriorDistance(p)};
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (next.squared > guess.limit) continue;
    const Node& node = nodes_[next.node];
    for (int i = node.first; i < node.first + node.count; ++i) update_nearest(i, p, guess);
    if (node.count > 0) continue;
    // Search the nearer child first.
    Waiting near{next.node + 1, nodes_[next.node + 1].box.squaredExteriorDistance(p)};
    Waiting far{node.second, nodes_[node.second].box.squaredExteriorDistance(p)};
    if (far.squared < near.squared) std::swap(near, far);
    if (far.squared <= guess.limit) stack[waiting++] = far;
    if (near.squared <= guess.limit) stack[waiting++] = near;
  }
  return guess;
}

}  // namespace thenar::internal
