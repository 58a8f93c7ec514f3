#include "geometry/collision/signed_distance.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/numbers.h"
#include "geometry/collision/distance_record.h"
#include "geometry/collision/segment_search.h"

namespace thenar {
namespace {

using internal::DistanceRecord;
using internal::kEverywhere;
using internal::kNoBound;
using Piece = internal::TrianglePiece;

/// An entry of the search queue: a node of the tree, or a piece.
struct Candidate {
  double bound;  // lower bound of its distance [m]
  int node;      // node of the tree; -1: a piece
  int piece;
};

bool is_farther(const Candidate& x, const Candidate& y) { return x.bound > y.bound; }

/// Finds the triangle with the lowest corner along n, given in A's frame.
int lowest_triangle(const CollisionTree& a, const Eigen::Vector3d& n) {
  double lowest = kInfinity;
  int best = 0;
  std::vector<int> nodes{0};
  while (!nodes.empty()) {
    const CollisionNode& node = a.nodes[nodes.back()];
    nodes.pop_back();
    if (n.dot(node.ball.c) - node.ball.r >= lowest) continue;
    // Add the children of an inner node.
    if (node.triangle < 0) {
      nodes.push_back(node.left);
      nodes.push_back(node.right);
      continue;
    }
    // Compare the lowest corner of a leaf's triangle.
    const SweptTriangle& t = a.triangles[node.triangle];
    const double low = (n.transpose() * t.corners).minCoeff() - t.radius;
    if (low < lowest) lowest = low, best = node.triangle;
  }
  return best;
}

/// Returns a lower bound of the distance of a piece, from the distance at its centre [m].
double bound_of(const Piece& piece) {
  const NearestSurface& seen = piece.seen;
  const double by_ball = seen.distance - piece.ball.r - piece.radius;
  if (!seen.supports) return by_ball;
  const double lowest =
      (seen.normal.transpose() * (piece.corners.colwise() - piece.ball.c)).minCoeff();
  return std::max(by_ball, seen.distance + lowest - piece.radius);
}

/// Branch and bound in B's frame, lowest bound first.
///
/// A triangle is bounded twice: by its bounding ball, and by a ball about a point lifted off B,
/// through the triangle's corners, whose surface is nearly flat there. The second bound is sharp
/// for flat faces that lie on each other, which are then not divided. The core of a capsule is
/// searched along its axis: beside a convex solid between supporting planes (ConvexBracket), beside
/// other solids between empty balls (BallPair).
class DistanceSearch {
 public:
  DistanceSearch(const CollisionTree& a, const Pose<double>& X_BA, const Shape& b,
                 SignedDistanceOptions options)
      : a_(a), X_BA_(X_BA), options_(std::move(options)), record_(b, options_) {}

  SignedDistance run() {
    // Start with the triangle of a similar pose.
    if (options_.start >= 0 && options_.start < static_cast<int>(a_.triangles.size()))
      descend(whole(options_.start));
    // Bound the root, and try a first guess if the bodies are near.
    const Ball root = posed(a_.nodes.front());
    const bool single = a_.nodes.front().triangle >= 0;
    const NearestSurface seen =
        single ? whole(a_.nodes.front().triangle).seen : record_.nearest_surface(root.c);
    const double bound = seen.distance - root.r;
    if (bound <= options_.cutoff && bound < record_.sufficient_bound() &&
        options_.within.r >= kEverywhere)
      guess(seen.normal);
    if (single)
      add_node(0, bound);
    else
      push({bound, 0, -1});
    // Expand the lowest bound, until no candidate can be better by more than the tolerance.
    while (!heap_.empty() && heap_.front().bound < record_.sufficient_bound() &&
           heap_.front().bound <= options_.cutoff && !record_.is_exhausted())
      expand(pop());
    return result();
  }

 private:
  [[nodiscard]] bool is_in_region(const Ball& ball) const {
    return (ball.c - options_.within.c).norm() <= ball.r + options_.within.r;
  }

  [[nodiscard]] Ball posed(const CollisionNode& node) const {
    return {X_BA_ * node.ball.c, node.ball.r};
  }

  void push(const Candidate& candidate) {
    if (candidate.bound >= record_.sufficient_bound()) {
      record_.skip(candidate.bound);
      return;
    }
    heap_.push_back(candidate);
    std::push_heap(heap_.begin(), heap_.end(), is_farther);
  }

  Candidate pop() {
    std::pop_heap(heap_.begin(), heap_.end(), is_farther);
    const Candidate top = heap_.back();
    heap_.pop_back();
    return top;
  }

  /// Moves to the lowest triangle along the normal of the best point, until none is better. Large
  /// empty balls there then exclude most other triangles.
  void guess(Eigen::Vector3d n) {
    for (int i = 0, last = -1; i < kGuesses; ++i) {
      const double before = record_.best().distance;
      const int lowest = lowest_triangle(a_, X_BA_.R.transpose() * n);
      if (lowest == last) break;
      descend(whole(lowest));
      if (!(record_.best().distance < before - options_.tolerance)) break;
      n = record_.best().seen.normal;
      last = lowest;
    }
    // Unless planes or segments have bounds of their own, add two empty balls.
    const internal::BestPoint& best = record_.best();
    if (best.seen.supports ||
        (a_.triangles.size() == 1 && is_segment(0) && internal::has_ball_bounds(record_)))
      return;
    for (const double lift : {3.0, 30.0})
      record_.add_empty_ball(best.core + lift * a_.nodes.front().ball.r * best.seen.normal);
  }

  [[nodiscard]] Eigen::Matrix3d corners_of(int triangle) const {
    return (X_BA_.R * a_.triangles[triangle].corners).colwise() + X_BA_.p;
  }

  /// Evaluates a whole triangle.
  Piece whole(int triangle) {
    return evaluated(corners_of(triangle), a_.triangles[triangle].radius, triangle);
  }

  /// Evaluates the distance at the centre of a piece; the last piece is stored.
  Piece evaluated(const Eigen::Matrix3d& corners, double radius, int triangle) {
    if (triangle == last_.triangle && corners == last_.corners) return last_;
    Piece piece{corners, internal::smallest_ball(corners), {}, radius, triangle};
    piece.seen = record_.nearest_surface(piece.ball.c);
    record_.update_best(piece.ball.c, piece.seen, piece);
    last_ = piece;
    return piece;
  }

  /// Adds a triangle or a part of one to the queue.
  void add_piece(const Eigen::Matrix3d& corners, double radius, int triangle, double parent) {
    // Skip it if known empty space excludes it.
    const double bound = std::max(parent, record_.empty_space().bound(corners, radius));
    if (bound >= record_.sufficient_bound()) {
      record_.skip(bound);
      return;
    }
    // Evaluate the distance at its centre.
    const Piece piece = evaluated(corners, radius, triangle);
    const double seen = std::max(bound, bound_of(piece));
    // Use the sharper bounds of segments.
    if (is_segment(triangle)) {
      const double lower = piece.seen.supports ? internal::bound_by_planes(piece, record_)
                                               : internal::bound_by_balls(piece, record_);
      if (lower > kNoBound) {
        record_.skip(std::max(seen, lower));
        return;
      }
    }
    pieces_.push_back(piece);
    push({seen, -1, static_cast<int>(pieces_.size()) - 1});
  }

  [[nodiscard]] bool is_segment(int triangle) const { return a_.triangles[triangle].n.isZero(0); }

  /// Adds a node of the tree to the queue.
  void add_node(int index, double parent) {
    // Exclude nodes outside of the searched region.
    const CollisionNode& node = a_.nodes[index];
    const Ball ball = posed(node);
    if (!is_in_region(ball)) return;
    // Evaluate the triangle of a leaf.
    if (node.triangle >= 0) {
      const double radius = a_.triangles[node.triangle].radius;
      return add_piece(corners_of(node.triangle), radius, node.triangle, parent);
    }
    // Bound the node's ball by empty space, then by its distance from B.
    double bound = std::max(parent, record_.empty_space().bound(ball));
    if (bound < record_.sufficient_bound())
      bound = std::max(
          bound, (record_.empty_space().has_planes() ? record_.nearest_surface(ball.c).distance
                                                     : record_.distance(ball.c)) -
                     ball.r);
    push({bound, index, -1});
  }

  /// Replaces a node by its children, or a piece by its halves.
  void expand(const Candidate& candidate) {
    if (candidate.node >= 0) {
      const CollisionNode& node = a_.nodes[candidate.node];
      add_node(node.left, candidate.bound);
      add_node(node.right, candidate.bound);
      return;
    }
    // Search for better points in a piece, then sharpen its bound, then halve it.
    const Piece piece = pieces_[candidate.piece];
    descend(piece);
    const double bound =
        std::max({candidate.bound, record_.empty_space().bound(piece.corners, piece.radius),
                  piece.seen.supports ? kNoBound : record_.bound_by_lifted_ball(piece)});
    if (bound >= record_.sufficient_bound())
      record_.skip(bound);
    else
      halve(piece, bound);
  }

  /// Searches for better points: the lowest corner, then the points nearest to each other,
  /// alternately.
  void descend(const Piece& piece) {
    // Find the lowest corner above B's plane.
    Eigen::Index lowest = 0;
    const double rise = (piece.seen.normal.transpose() * (piece.corners.colwise() - piece.ball.c))
                            .minCoeff(&lowest);
    if (piece.seen.distance + rise - piece.radius >= record_.sufficient_bound() &&
        record_.best().distance < kInfinity && record_.best().triangle != piece.triangle)
      return;  // flat, as far as known: there is no better point
    const Eigen::Vector3d corner = piece.corners.col(lowest);
    record_.update_best(corner, record_.nearest_surface(corner), piece);

    // Alternate between the nearest points of the two.
    Eigen::Vector3d on_b = piece.ball.c - piece.seen.distance * piece.seen.normal;
    for (int i = 0; i < kAlternations; ++i) {
      const double before = record_.best().distance;
      const Eigen::Vector3d p = internal::nearest_in_triangle(piece.corners, on_b);
      const NearestSurface there = record_.nearest_surface(p);
      record_.update_best(p, there, piece);
      if (!(record_.best().distance < before - options_.tolerance)) return;
      on_b = p - there.distance * there.normal;
    }
  }

  void halve(const Piece& piece, double bound) {
    for (const Eigen::Matrix3d& half : internal::bisect_triangle(piece.corners))
      if (is_in_region(internal::smallest_ball(half)))
        add_piece(half, piece.radius, piece.triangle, bound);
  }

  /// Returns the result in B's frame.
  SignedDistance result() {
    // Compute the error from the lowest remaining bound.
    const internal::BestPoint& best = record_.best();
    if (best.triangle < 0) whole(0);  // the cutoff was reached before any triangle was evaluated
    const double below = heap_.empty() ? kInfinity : heap_.front().bound;
    const double lower = std::min({below, record_.skipped_bound(), best.distance});
    SignedDistance s{
        best.distance,
        best.distance - lower + record_.shape().accuracy() + kRounding * best.core.norm(),
        best.core - best.radius * best.seen.normal,
        best.core - best.seen.distance * best.seen.normal,
        best.seen.normal,
        best.triangle,
        record_.evaluations()};
    if (lower > options_.cutoff) s.distance = lower, s.error = kInfinity;
    return s;
  }

  static constexpr int kGuesses = 4;          // maximum number of triangles of a first guess
  static constexpr int kAlternations = 3;     // maximum steps between nearest points of a piece
  static constexpr double kRounding = 1e-14;  // rounding error of a distance over coordinates [1]

  const CollisionTree& a_;
  const Pose<double> X_BA_;
  const SignedDistanceOptions options_;
  DistanceRecord record_;  // evaluations of B
  std::vector<Candidate> heap_;
  std::vector<Piece> pieces_;
  Piece last_{{}, {}, {}, 0, -1};  // last evaluated piece
};

/// Transforms a result from B's frame to world.
SignedDistance to_world(const Pose<double>& X_WB, SignedDistance s) {
  s.on_a = X_WB * s.on_a;
  s.on_b = X_WB * s.on_b;
  s.normal = X_WB.R * s.normal;
  return s;
}

}  // namespace

SignedDistance signed_distance(const CollisionTree& a, const Pose<double>& X_BA, const Shape& b,
                               const SignedDistanceOptions& options) {
  require(X_BA.R.allFinite() && X_BA.p.allFinite(), "poses must be finite, got an origin at {} m",
          X_BA.p.norm());
  require(options.tolerance > 0, "tolerance must be positive, got {} m", options.tolerance);
  require(!a.nodes.empty(), "a touch surface must have {} triangle or more", 1);
  return DistanceSearch(a, X_BA, b, options).run();
}

SignedDistance signed_distance(const CollisionTree& a, const Pose<double>& X_WA, const Solid& b,
                               const Pose<double>& X_WB, const SignedDistanceOptions& options) {
  require(b.shape != nullptr, "a solid without a {} has no distance", "shape");
  return to_world(X_WB, signed_distance(a, X_WB.inverse() * X_WA, *b.shape, options));
}

SignedDistance signed_distance(const Solid& a, const Pose<double>& X_WA, const Solid& b,
                               const Pose<double>& X_WB, double tolerance, double cutoff) {
  SignedDistanceOptions options;
  options.tolerance = tolerance;
  options.cutoff = cutoff;
  return signed_distance(collision_tree(a), X_WA, b, X_WB, options);
}

}  // namespace thenar
