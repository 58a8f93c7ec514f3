#include "geometry/collision/patch_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "base/lists.h"
#include "geometry/collision/empty_space.h"

namespace thenar {
namespace {

/// A triangle or part of one, with its rounding radius.
struct Part {
  Eigen::Matrix3d corners;                        // [m] (3, 3)
  double radius;                                  // [m]
  std::array<std::optional<PatchPoint>, 3> seen;  // evaluated corners
};

/// Segment from a point inside to a point outside, and the rounding radius [m] (3 + 3 + 1).
using Side = std::array<double, 7>;

/// Halves a part. The halves share evaluated points: its corners and, if it is the middle of the
/// cut side, the centre of the part.
std::array<Part, 2> halve_part(const Part& part, const PatchPoint& middle) {
  const std::array<Eigen::Matrix3d, 2> corners = internal::bisect_triangle(part.corners);
  std::array<Part, 2> parts{Part{corners[0], part.radius, part.seen},
                            Part{corners[1], part.radius, part.seen}};
  for (Part& half : parts)
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d corner = half.corners.col(k);
      if (corner == part.corners.col(k)) continue;
      half.seen[k].reset();
      if (corner == middle.core) half.seen[k] = middle;
    }
  return parts;
}

/// Depth-first search of pieces of A that are near B.
class PatchSearch {
 public:
  PatchSearch(const CollisionTree& a, const Pose<double>& X_BA, const Shape& b, PatchQuery query)
      : a_(a), X_BA_(X_BA), b_(b), query_(std::move(query)) {}

  PatchPieces run() {
    // Traverse the tree depth-first, without far nodes.
    std::vector<int> nodes{0};
    while (!nodes.empty()) {
      const CollisionNode& node = a_.nodes[nodes.back()];
      nodes.pop_back();
      if (is_far({X_BA_ * node.ball.c, node.ball.r})) continue;
      if (node.triangle >= 0) {
        search(node.triangle);
      } else {
        nodes.push_back(node.right);
        nodes.push_back(node.left);
      }
    }
    return std::move(found_);
  }

 private:
  /// Returns whether no point in the ball is within the level.
  bool is_far(const Ball& ball) {
    return is_excluded(ball) || b_.distance(ball.c) - ball.r > query_.level;
  }

  /// Returns whether the ball is outside of the query, or the limit of evaluations is reached.
  bool is_excluded(const Ball& ball) {
    if ((ball.c - query_.within.c).norm() > ball.r + query_.within.r) return true;
    if (++evaluations_ > query_.max_evaluations) {
      found_.complete = false;
      return true;
    }
    return false;
  }

  /// Returns a lower bound of the distance of a part, from the distance at its centre [m].
  static double bound_of(const Part& part, const Ball& ball, const NearestSurface& near) {
    const double by_ball = near.distance - ball.r - part.radius;
    if (!near.supports) return by_ball;
    const double lowest = (near.normal.transpose() * (part.corners.colwise() - ball.c)).minCoeff();
    return std::max(by_ball, near.distance + lowest - part.radius);
  }

  /// Returns whether the distances at its corners prove that no point of the part is within the
  /// level.
  [[nodiscard]] bool is_far_by_corners(const Part& part) const {
    return any_of(part.seen, [&](const auto& seen) {
      if (!seen || seen->distance <= query_.level) return false;
      const Eigen::Matrix3d arms = part.corners.colwise() - seen->core;
      const double lowest = seen->supports ? (seen->normal.transpose() * arms).minCoeff()
                                           : -std::sqrt(arms.colwise().squaredNorm().maxCoeff());
      return seen->distance + lowest > query_.level;
    });
  }

  /// Searches a triangle, halving its parts until each is kept or far.
  void search(int triangle) {
    // Start with the whole triangle in B's frame; halves go onto the stack.
    const SweptTriangle& t = a_.triangles[triangle];
    std::vector<Part> parts{{(X_BA_.R * t.corners).colwise() + X_BA_.p, t.radius, {}}};
    while (!parts.empty()) {
      Part part = parts.back();
      parts.pop_back();
      // Exclude the part by its position, or by evaluated corners.
      const Ball ball = internal::smallest_ball(part.corners);
      if (is_far_by_corners(part) || is_excluded({ball.c, ball.r + part.radius})) continue;
      // Exclude it by the distance at its centre.
      const NearestSurface near = b_.nearest(ball.c);
      if (bound_of(part, ball, near) > query_.level) continue;
      const PatchPoint middle = patch_point(ball.c, near, part.radius);
      if (is_kept(part, ball, middle)) continue;
      for (const Part& half : halve_part(part, middle)) parts.push_back(half);
    }
  }

  PatchPoint evaluate(const Eigen::Vector3d& core, double radius) {
    ++evaluations_;
    return patch_point(core, b_.nearest(core), radius);
  }

  [[nodiscard]] bool is_inside(const PatchPoint& point) const {
    return point.distance <= query_.level;
  }

  /// Returns whether an empty ball proves that no point of the part is within the level.
  bool is_clear(const Part& part, const Ball& ball, const PatchPoint& middle) {
    ++evaluations_;
    const NearestSurface seen{middle.distance + part.radius, middle.normal};
    const double level = query_.level + part.radius;
    return triangle_bound(lifted_ball(b_, part.corners, ball, seen, level), part.corners) > level;
  }

  /// Returns whether the part need not be halved; its points are then added to the result.
  bool is_kept(Part& part, const Ball& ball, const PatchPoint& middle) {
    // Sort the corners into those inside and outside of the level.
    std::vector<PatchPoint> inside, outside;
    const auto sort_in = [&](const PatchPoint& point) {
      (is_inside(point) ? inside : outside).push_back(point);
    };
    for (int k = 0; k < 3; ++k) {
      if (!part.seen[k]) part.seen[k] = evaluate(part.corners.col(k), part.radius);
      sort_in(*part.seen[k]);
    }
    // Skip a part that is outside as a whole.
    if (inside.empty() && !is_inside(middle) &&
        (is_far_by_corners(part) || is_clear(part, ball, middle)))
      return true;
    // Divide a part that the boundary crosses while it is larger than the resolution.
    if (ball.r > query_.resolution && !(outside.empty() && is_inside(middle))) return false;
    // Keep the points inside, and the boundary towards those outside.
    PatchPiece piece{ball, inside};
    (is_inside(middle) ? piece.points : outside).push_back(middle);
    for (const PatchPoint& point : outside) add_boundary(part, inside, point, piece);
    if (!piece.points.empty()) add(std::move(piece));
    return true;
  }

  /// Adds points of the boundary towards a point outside.
  void add_boundary(const Part& part, const std::vector<PatchPoint>& inside,
                    const PatchPoint& point, PatchPiece& piece) {
    // Find the point of the part nearest to the surface point of the one outside.
    PatchPoint over =
        evaluate(internal::nearest_in_triangle(part.corners, point.on_b), part.radius);
    if (!is_inside(over)) over = newton_step(part, point, over.core);
    if (is_inside(over)) piece.points.push_back(over);
    // Add the points where sides cross the boundary.
    if (query_.halvings == 0) return;
    for (const PatchPoint& in : inside) piece.points.push_back(crossing(in, point));
  }

  /// Returns the last point inside on the side from a point inside to a point outside. Results are
  /// stored, as neighbours share most sides.
  const PatchPoint& crossing(const PatchPoint& inside, const PatchPoint& outside) {
    Side side;
    Eigen::Map<Eigen::Matrix<double, 7, 1>>(side.data()) << inside.core, outside.core,
        inside.radius;
    const auto [entry, is_new] = crossings_.emplace(side, inside);
    if (is_new) entry->second = bisect(inside, outside.core);
    return entry->second;
  }

  PatchPoint bisect(PatchPoint in, Eigen::Vector3d out) {
    for (int i = 0; i < query_.halvings; ++i) {
      const PatchPoint halfway = evaluate((in.core + out) / 2, in.radius);
      if (is_inside(halfway))
        in = halfway;
      else
        out = halfway.core;
    }
    return in;
  }

  /// Takes a Newton step down the slope of the distance, from a point towards `over`, to the level
  /// query_.aim; for a slope that rises to an edge it leads onto the edge.
  PatchPoint newton_step(const Part& part, const PatchPoint& point, const Eigen::Vector3d& over) {
    const Eigen::Vector3d direction = over - point.core;
    const double square = direction.squaredNorm(), d = point.distance + part.radius;
    if (!(square > 0)) return point;
    const double steps = d * (point.distance - query_.aim) / square;
    return evaluate(internal::nearest_in_triangle(part.corners, point.core + steps * direction),
                    part.radius);
  }

  /// Adds a piece to the result, with its nearest point first.
  void add(PatchPiece piece) {
    std::iter_swap(piece.points.begin(),
                   std::min_element(piece.points.begin(), piece.points.end(),
                                    [](const PatchPoint& x, const PatchPoint& y) {
                                      return x.distance < y.distance;
                                    }));
    found_.pieces.push_back(std::move(piece));
  }

  const CollisionTree& a_;
  const Pose<double> X_BA_;
  const Shape& b_;
  const PatchQuery query_;
  PatchPieces found_;
  std::map<Side, PatchPoint> crossings_;
  int evaluations_ = 0;
};

}  // namespace

PatchPieces near_pieces(const CollisionTree& a, const Pose<double>& X_BA, const Shape& b,
                        const PatchQuery& query) {
  return PatchSearch(a, X_BA, b, query).run();
}

}  // namespace thenar
