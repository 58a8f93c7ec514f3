#include "geometry/surface_crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace thenar::internal {
namespace {

using Eigen::Vector3d, Eigen::Vector3i;

// Triangles within this distance meet, over the mesh's extent [1]
constexpr double kMeetingDistance = 1e-10;
// Maximum number of pairs per triangle; above it all triangles count as meeting
constexpr std::size_t kMaxPairs = 100;
constexpr double kFoldAngle =
    1e-7;  // angle within which neighbours are folded onto each other [rad]

/// Returns the part of a segment, in fractions of its length, where a linear function is at most
/// `most`.
struct PartBelow {
  double from = 0, to = 1;

  /// @param at_start, at_end  the function at both ends
  void keep_below(double at_start, double at_end, double most) {
    const double slope = at_end - at_start;
    if (slope == 0) {
      if (at_start > most) to = -1;
      return;
    }
    const double share = (most - at_start) / slope;
    if (slope > 0)
      to = std::min(to, share);
    else
      from = std::max(from, share);
  }
  [[nodiscard]] bool empty() const { return from > to; }
};

/// Returns whether a segment comes within `near` of a triangle [m].
bool meets(const TriangleForm& form, const Vector3d& p, const Vector3d& q, double near) {
  // Test between the two planes beside the triangle's, then inside its three edges.
  const double at_p = form.normal.dot(p - form.corner[0]);
  const double at_q = form.normal.dot(q - form.corner[0]);
  if (std::min(at_p, at_q) > near || std::max(at_p, at_q) < -near) return false;
  PartBelow part;
  part.keep_below(at_p, at_q, near);
  part.keep_below(-at_p, -at_q, near);
  for (int k = 0; k < 3 && !part.empty(); ++k)
    part.keep_below(form.across[k].dot(p - form.corner[k]), form.across[k].dot(q - form.corner[k]),
                    near);
  return !part.empty();
}

/// Pairs of triangles, found by going down a tree with itself.
class CrossingSearch {
 public:
  CrossingSearch(const TriangleMesh& mesh, const TriangleTree& tree)
      : mesh_(mesh),
        tree_(tree),
        near_(kMeetingDistance * tree.bounds().diagonal().norm()),
        boxes_(tree.forms().size()),
        found_(tree.forms().size(), false) {
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      for (const Vector3d& corner : tree.forms()[i].corner) boxes_[i].extend(corner);
  }

  std::vector<bool> run() {
    within(0);
    if (given_up()) found_.assign(found_.size(), true);
    return std::move(found_);
  }

 private:
  using Node = TriangleTree::Node;

  [[nodiscard]] bool given_up() const { return compared_ > kMaxPairs * boxes_.size(); }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the tree
  void within(int at) {
    const Node& node = tree_.nodes()[at];
    for (int i = 0; i < node.count; ++i)
      for (int j = i + 1; j < node.count; ++j) compare(node.first + i, node.first + j);
    if (node.count > 0) return;
    within(at + 1);
    within(node.second);
    between(at + 1, node.second);
  }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the tree
  void between(int a, int b) {
    const Node& one = tree_.nodes()[a];
    const Node& other = tree_.nodes()[b];
    if (given_up() || apart(one.box, other.box)) return;
    if (one.count > 0 && other.count > 0) {
      for (int i = 0; i < one.count; ++i)
        for (int j = 0; j < other.count; ++j) compare(one.first + i, other.first + j);
    } else if (other.count > 0 || (one.count == 0 && one.box.volume() > other.box.volume())) {
      between(a + 1, b);
      between(one.second, b);
    } else {
      between(a, b + 1);
      between(a, other.second);
    }
  }

  [[nodiscard]] bool apart(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b) const {
    return (a.min().array() > b.max().array() + near_).any() ||
           (b.min().array() > a.max().array() + near_).any();
  }

  void compare(int i, int j) {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    if (apart(boxes_[a], boxes_[b])) return;
    ++compared_;
    if (!cross(i, j)) return;
    const auto number = [&](int at) { return static_cast<std::size_t>(tree_.order()[at]); };
    found_[number(i)] = found_[number(j)] = true;
  }

  [[nodiscard]] bool cross(int i, int j) const {
    const TriangleForm& a = tree_.forms()[i];
    const TriangleForm& b = tree_.forms()[j];
    const Vector3i of_a = mesh_.triangles.col(tree_.order()[i]);
    const Vector3i of_b = mesh_.triangles.col(tree_.order()[j]);
    // Find the common corners' places in both triangles.
    std::array<bool, 3> shared_a{}, shared_b{};
    int shared = 0;
    for (int k = 0; k < 3; ++k)
      for (int l = 0; l < 3; ++l)
        if (of_a(k) == of_b(l)) {
          shared_a[k] = shared_b[l] = true;
          ++shared;
        }
    if (shared == 3) return true;
    if (shared == 2) return folded(a, shared_a, b, shared_b);
    // Test edges without a common corner against the other triangle.
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      if (!shared_a[k] && !shared_a[next] && meets(b, a.corner[k], a.corner[next], near_))
        return true;
      if (!shared_b[k] && !shared_b[next] && meets(a, b.corner[k], b.corner[next], near_))
        return true;
    }
    return false;
  }

  /// Returns whether a neighbour's third corner lies over the triangle.
  static bool folded(const TriangleForm& a, const std::array<bool, 3>& shared_a,
                     const TriangleForm& b, const std::array<bool, 3>& shared_b) {
    const auto alone = [](const std::array<bool, 3>& shared) {
      return static_cast<int>(std::find(shared.begin(), shared.end(), false) - shared.begin());
    };
    const int edge = (alone(shared_a) + 1) % 3;  // across from the triangle's own third corner
    const Vector3d arm = b.corner[alone(shared_b)] - a.corner[edge];
    const double height = a.normal.dot(arm), out = a.across[edge].dot(arm);
    return out < 0 && std::abs(height) <= -kFoldAngle * out;
  }

  const TriangleMesh& mesh_;
  const TriangleTree& tree_;
  double near_;                             // [m]
  std::vector<Eigen::AlignedBox3d> boxes_;  // of each triangle, as in the tree
  std::vector<bool> found_;                 // for each triangle of the mesh
  std::size_t compared_ = 0;                // pairs whose boxes meet
};

}  // namespace

std::vector<bool> crossing_triangles(const TriangleMesh& mesh, const TriangleTree& tree) {
  return CrossingSearch(mesh, tree).run();
}

}  // namespace thenar::internal
