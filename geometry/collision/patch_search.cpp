#include "geometry/collision/patch_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "geometry/collision/empty_space.h"

namespace thenar {
namespace {

/// A triangle or part of one, and its rounding.
struct Part {
  Eigen::Matrix3d corners;                        // [m] (3, 3)
  double radius;                                  // [m]
  std::array<std::optional<PatchPoint>, 3> seen;  // corners that have been asked for
};

/// Segment from a point inside to a point outside, and the rounding [m] (3 + 3 + 1).
using Side = std::array<double, 7>;

/// The halves of a part. They share what has been seen at their corners: those of the part, and the
/// middle of the side that is cut, where it is the middle of the part.
std::array<Part, 2> halves_of(const Part& part, const PatchPoint& middle) {
  const std::array<Eigen::Matrix3d, 2> corners = internal::halves(part.corners);
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

class PatchSearch {
 public:
  PatchSearch(const CollisionTree& a, const Pose<double>& X_BA, const Shape& b, PatchQuery query)
      : a_(a), X_BA_(X_BA), b_(b), query_(std::move(query)) {}

  PatchPieces run() {
    // Depth-first through the tree; far nodes are left out.
    std::vector<int> nodes{0};
    while (!nodes.empty()) {
      const CollisionNode& node = a_.nodes[nodes.back()];
      nodes.pop_back();
      if (far({X_BA_ * node.ball.c, node.ball.r})) continue;
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
  /// Returns whether nothing in the ball counts.
  bool far(const Ball& ball) {
    return far_by_place(ball) || b_.distance(ball.c) - ball.r > query_.level;
  }

  /// Returns whether the ball is outside of the query, or the search has used up its evaluations.
  bool far_by_place(const Ball& ball) {
    if ((ball.c - query_.within.c).norm() > ball.r + query_.within.r) return true;
    if (++evaluations_ > query_.max_evaluations) {
      found_.complete = false;
      return true;
    }
    return false;
  }

  /// Returns a lower bound of the distance of a part, from the distance at its middle [m].
  static double bound_of(const Part& part, const Ball& ball, const NearestSurface& near) {
    const double by_ball = near.distance - ball.r - part.radius;
    if (!near.supports) return by_ball;
    const double lowest = (near.normal.transpose() * (part.corners.colwise() - ball.c)).minCoeff();
    return std::max(by_ball, near.distance + lowest - part.radius);
  }

  /// Returns whether no point of the part counts, by the distances at its corners.
  [[nodiscard]] bool far_by_corners(const Part& part) const {
    return std::any_of(part.seen.begin(), part.seen.end(), [&](const auto& seen) {
      if (!seen || seen->distance <= query_.level) return false;
      const Eigen::Matrix3d arms = part.corners.colwise() - seen->core;
      const double least = seen->supports ? (seen->normal.transpose() * arms).minCoeff()
                                          : -std::sqrt(arms.colwise().squaredNorm().maxCoeff());
      return seen->distance + least > query_.level;
    });
  }

  void search(int triangle) {
    // The triangle in B's frame; halves go back onto the stack.
    const SweptTriangle& t = a_.triangles[triangle];
    std::vector<Part> parts{{(X_BA_.R * t.corners).colwise() + X_BA_.p, t.radius, {}}};
    while (!parts.empty()) {
      Part part = parts.back();
      parts.pop_back();
      // Out of reach by place, or by what its corners have seen.
      const Ball ball = internal::smallest_ball(part.corners);
      if (far_by_corners(part) || far_by_place({ball.c, ball.r + part.radius})) continue;
      // Out of reach by what its middle sees.
      const NearestSurface near = b_.nearest(ball.c);
      if (bound_of(part, ball, near) > query_.level) continue;
      const PatchPoint middle = point_at(ball.c, near, part.radius);
      if (keep(part, ball, middle)) continue;
      for (const Part& half : halves_of(part, middle)) parts.push_back(half);
    }
  }

  PatchPoint seen(const Eigen::Vector3d& core, double radius) {
    ++evaluations_;
    return point_at(core, b_.nearest(core), radius);
  }

  static PatchPoint point_at(const Eigen::Vector3d& core, const NearestSurface& near,
                             double radius) {
    return {core,   near.distance - radius, core - near.distance * near.normal, near.normal,
            radius, near.supports};
  }

  [[nodiscard]] bool counts(const PatchPoint& point) const {
    return point.distance <= query_.level;
  }

  /// Certainly no point of the part counts.
  bool clear(const Part& part, const Ball& ball, const PatchPoint& middle) {
    ++evaluations_;
    const NearestSurface seen{middle.distance + part.radius, middle.normal};
    const double level = query_.level + part.radius;
    return bound_by(lifted_ball(b_, part.corners, ball, seen, level), part.corners) > level;
  }

  /// Returns whether the part need not be halved; its points are then among those found.
  bool keep(Part& part, const Ball& ball, const PatchPoint& middle) {
    // Corners inside and outside the level.
    std::vector<PatchPoint> inside, outside;
    const auto sort_in = [&](const PatchPoint& point) {
      (counts(point) ? inside : outside).push_back(point);
    };
    for (int k = 0; k < 3; ++k) {
      if (!part.seen[k]) part.seen[k] = seen(part.corners.col(k), part.radius);
      sort_in(*part.seen[k]);
    }
    // Certainly outside.
    if (inside.empty() && !counts(middle) && (far_by_corners(part) || clear(part, ball, middle)))
      return true;
    // Crossed by the rim, and still larger than the resolution.
    if (ball.r > query_.resolution && !(outside.empty() && counts(middle))) return false;
    // Points inside, and the rim towards those outside.
    PatchPiece piece{ball, inside};
    (counts(middle) ? piece.points : outside).push_back(middle);
    for (const PatchPoint& point : outside) add_rim(part, inside, point, piece);
    if (!piece.points.empty()) add(std::move(piece));
    return true;
  }

  /// Points of the rim towards a point outside.
  void add_rim(const Part& part, const std::vector<PatchPoint>& inside, const PatchPoint& point,
               PatchPiece& piece) {
    // The point of the part nearest to what lies below the outer one.
    PatchPoint over = seen(internal::nearest_in_triangle(part.corners, point.on_b), part.radius);
    if (!counts(over)) over = down_from(part, point, over.core);
    if (counts(over)) piece.points.push_back(over);
    // Points where sides cross the rim.
    if (query_.halvings == 0) return;
    for (const PatchPoint& in : inside) piece.points.push_back(crossing(in, point));
  }

  /// Returns the last point inside on the way from a point inside to a point outside, where it
  /// crosses the rim. Neighbours share most sides.
  const PatchPoint& crossing(const PatchPoint& inside, const PatchPoint& outside) {
    Side side;
    Eigen::Map<Eigen::Matrix<double, 7, 1>>(side.data()) << inside.core, outside.core,
        inside.radius;
    const auto [place, is_new] = crossings_.emplace(side, inside);
    if (is_new) place->second = halved(inside, outside.core);
    return place->second;
  }

  PatchPoint halved(PatchPoint in, Eigen::Vector3d out) {
    for (int i = 0; i < query_.halvings; ++i) {
      const PatchPoint halfway = seen((in.core + out) / 2, in.radius);
      if (counts(halfway))
        in = halfway;
      else
        out = halfway.core;
    }
    return in;
  }

  /// Newton's step down the slope of the distance, which the way to `over` shows, to the level
  /// aimed at: of a slope up to an edge, onto the edge.
  PatchPoint down_from(const Part& part, const PatchPoint& point, const Eigen::Vector3d& over) {
    // Slope along the way to `over`, and the step to the level aimed at.
    const Eigen::Vector3d way = over - point.core;
    const double square = way.squaredNorm(), d = point.distance + part.radius;
    if (!(square > 0)) return point;
    const double steps = d * (point.distance - query_.aim) / square;
    return seen(internal::nearest_in_triangle(part.corners, point.core + steps * way), part.radius);
  }

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
