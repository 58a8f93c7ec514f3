#include "geometry/collision/signed_distance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/numbers.h"
#include "geometry/collision/empty_space.h"
#include "geometry/collision/segment_bounds.h"

namespace thenar {
namespace {

/// Part of a triangle, seen from B.
struct Piece {
  Eigen::Matrix3d corners;  // [m] (3, 3)
  Ball ball;                // around them, without the rounding
  NearestSurface seen;      // of B from the ball's centre
  double radius;            // of the rounding [m]
  int triangle;
};

/// Something still to be searched: a node of the tree, or a piece.
struct Candidate {
  double bound;  // nothing in it is nearer [m]
  int node;      // -1: it is a piece
  int piece;
};

bool farther(const Candidate& x, const Candidate& y) { return x.bound > y.bound; }

/// Branch and bound in B's frame, lowest bound first.
///
/// A triangle is bounded twice: by the ball around it, and by the ball about a point lifted off B,
/// through the triangle's corners, whose surface is nearly flat there. Flat faces that lie on each
/// other are settled by the second without being divided. The core of a capsule is searched along
/// itself: beside a convex solid between supporting planes (ConvexBracket), beside other solids
/// between balls without a point of the solid (BallPair).
class DistanceSearch {
 public:
  DistanceSearch(const CollisionTree& a, const Pose<double>& X_BA, const Shape& b,
                 SignedDistanceOptions options)
      : a_(a), X_BA_(X_BA), b_(b), options_(std::move(options)) {}

  SignedDistance run() {
    // A triangle of a near pose is a good start.
    if (options_.start >= 0 && options_.start < static_cast<int>(a_.triangles.size()))
      descend(whole(options_.start));
    // Bound of the root; only near pairs are worth a guess.
    const Ball root = posed(a_.nodes.front());
    const bool single = a_.nodes.front().triangle >= 0;
    const NearestSurface seen = single ? whole(a_.nodes.front().triangle).seen : see(root.c);
    const double bound = seen.distance - root.r;
    if (bound <= options_.cutoff && bound < enough() && options_.within.r >= kEverywhere)
      guess(seen.normal);
    if (single)
      add_node(0, bound);
    else
      push({bound, 0, -1});
    // Lowest bound first, until no candidate can be better by more than the tolerance.
    while (!heap_.empty() && heap_.front().bound < enough() &&
           heap_.front().bound <= options_.cutoff && evaluations_ < options_.max_evaluations)
      expand(pop());
    return result();
  }

 private:
  /// A bound from which on nothing need be searched.
  [[nodiscard]] double enough() const {
    if (best_ == kInfinity) return kInfinity;
    return best_ - std::max(options_.tolerance, options_.relative * best_);
  }

  [[nodiscard]] bool near(const Ball& ball) const {
    return (ball.c - options_.within.c).norm() <= ball.r + options_.within.r;
  }

  [[nodiscard]] Ball posed(const CollisionNode& node) const {
    return {X_BA_ * node.ball.c, node.ball.r};
  }

  double distance(const Eigen::Vector3d& p) {
    ++evaluations_;
    return b_.distance(p);
  }
  NearestSurface see(const Eigen::Vector3d& p) {
    ++evaluations_;
    NearestSurface seen = b_.nearest(p);
    if (seen.supports) empty_.add_plane(seen.normal, seen.normal.dot(p) - seen.distance);
    return seen;
  }

  void push(const Candidate& candidate) {
    if (candidate.bound >= enough()) {
      dropped_ = std::min(dropped_, candidate.bound);
      return;
    }
    heap_.push_back(candidate);
    std::push_heap(heap_.begin(), heap_.end(), farther);
  }

  Candidate pop() {
    std::pop_heap(heap_.begin(), heap_.end(), farther);
    const Candidate top = heap_.back();
    heap_.pop_back();
    return top;
  }

  /// Moves to the triangle farthest down, as B is seen from the best point, until none is better.
  /// Large empty balls there then exclude most other triangles at once.
  void guess(Eigen::Vector3d n) {
    for (int i = 0, last = -1; i < kGuesses; ++i) {
      const double before = best_;
      const int lowest = lowest_triangle(X_BA_.R.transpose() * n);
      if (lowest == last) break;
      descend(whole(lowest));
      if (!(best_ < before - options_.tolerance)) break;
      n = seen_.normal;
      last = lowest;
    }
    // Planes and segments have bounds of their own.
    if (seen_.supports || (a_.triangles.size() == 1 && fills_in(0))) return;
    for (const double h : {3.0, 30.0}) {
      const Eigen::Vector3d above = core_ + h * a_.nodes.front().ball.r * seen_.normal;
      empty_.add_ball({above, distance(above)});
    }
  }

  /// The triangle with the corner least far along n, which is in A's frame.
  [[nodiscard]] int lowest_triangle(const Eigen::Vector3d& n) const {
    double least = kInfinity;
    int best = 0;
    std::vector<int> nodes{0};
    while (!nodes.empty()) {
      const CollisionNode& node = a_.nodes[nodes.back()];
      nodes.pop_back();
      if (n.dot(node.ball.c) - node.ball.r >= least) continue;
      // Inner nodes: both children.
      if (node.triangle < 0) {
        nodes.push_back(node.left);
        nodes.push_back(node.right);
        continue;
      }
      // The triangle's lowest corner.
      const SweptTriangle& t = a_.triangles[node.triangle];
      const double low = (n.transpose() * t.corners).minCoeff() - t.radius;
      if (low < least) least = low, best = node.triangle;
    }
    return best;
  }

  /// Keeps a point of A's core if it is the best.
  void offer(const Eigen::Vector3d& core, const NearestSurface& seen, const Piece& piece) {
    if (seen.distance - piece.radius >= best_) return;
    best_ = seen.distance - piece.radius;
    core_ = core;
    seen_ = seen;
    radius_ = piece.radius;
    triangle_ = piece.triangle;
  }

  [[nodiscard]] Eigen::Matrix3d corners_of(int triangle) const {
    return (X_BA_.R * a_.triangles[triangle].corners).colwise() + X_BA_.p;
  }

  Piece whole(int triangle) {
    return evaluated(corners_of(triangle), a_.triangles[triangle].radius, triangle);
  }

  Piece evaluated(const Eigen::Matrix3d& corners, double radius, int triangle) {
    if (triangle == last_.triangle && corners == last_.corners) return last_;
    Piece piece{corners, internal::smallest_ball(corners), {}, radius, triangle};
    piece.seen = see(piece.ball.c);
    offer(piece.ball.c, piece.seen, piece);
    last_ = piece;
    return piece;
  }

  /// Queues a triangle or a part of one.
  void add_piece(const Eigen::Matrix3d& corners, double radius, int triangle, double parent) {
    // What is known to be empty may rule it out.
    const double bound = std::max(parent, empty_.bound(corners, radius));
    if (bound >= enough()) {
      dropped_ = std::min(dropped_, bound);
      return;
    }
    // Look at its middle.
    const Piece piece = evaluated(corners, radius, triangle);
    const double seen = std::max(bound, bound_of(piece));
    // Segments have sharper bounds of their own.
    if (is_segment(triangle)) {
      const double lower = piece.seen.supports ? close_in(piece) : fill_in(piece);
      if (lower > kNothing) {
        dropped_ = std::min(dropped_, std::max(seen, lower));
        return;
      }
    }
    pieces_.push_back(piece);
    push({seen, -1, static_cast<int>(pieces_.size()) - 1});
  }

  /// Returns a lower bound of the distance of a piece, from the distance at its middle [m].
  static double bound_of(const Piece& piece) {
    const NearestSurface& seen = piece.seen;
    const double by_ball = seen.distance - piece.ball.r - piece.radius;
    if (!seen.supports) return by_ball;
    const double lowest =
        (seen.normal.transpose() * (piece.corners.colwise() - piece.ball.c)).minCoeff();
    return std::max(by_ball, seen.distance + lowest - piece.radius);
  }

  [[nodiscard]] bool is_segment(int triangle) const { return a_.triangles[triangle].n.isZero(0); }

  /// Bounds a segment by planes of B from both sides. Returns the bound, kNothing if a plane does
  /// not support B.
  double close_in(const Piece& piece) {
    // Distance and slope at a point of the segment.
    const Eigen::Matrix3d& c = piece.corners;
    const Eigen::Vector3d u = longest_side(c).stableNormalized();
    const auto tangent = [&](double t, const NearestSurface& seen) {
      return Tangent{t, seen.distance - piece.radius, seen.normal.dot(u)};
    };
    NearestSurface seen = piece.seen;
    ConvexBracket bracket(-piece.ball.r, piece.ball.r, tangent(0, seen));
    // Planes from both sides, until the bound is high enough.
    for (int i = 0; i < kMaxAlong && bracket.lower() < enough() &&
                    bracket.lower() <= options_.cutoff && evaluations_ < options_.max_evaluations;
         ++i) {
      const double step = std::abs(seen.distance * seen.normal.dot(u));
      const double t = bracket.next(std::max(step, 1e-2 * piece.ball.r));
      const Eigen::Vector3d p = piece.ball.c + t * u;
      seen = see(p);
      if (!seen.supports) return kNothing;
      offer(p, seen, piece);
      bracket.add(tangent(t, seen));
    }
    return bracket.lower();
  }

  [[nodiscard]] bool fills_in(int triangle) const {
    return is_segment(triangle) && options_.within.r >= kEverywhere && b_.accuracy() == 0;
  }

  /// Bounds a segment outside B by empty balls about its points, placed where the bound is least
  /// until it is enough: nothing between the balls is nearer. Returns the bound of the segment,
  /// kNothing if it goes into B, not all of it counts, or distances are not exact.
  double fill_in(const Piece& piece) {
    const double r = piece.ball.r;
    // Only where all of the segment counts and distances are exact.
    if (!fills_in(piece.triangle) || !(r > 0)) return kNothing;
    const Eigen::Vector3d u = longest_side(piece.corners).stableNormalized();
    const auto distance_at = [&](double t) {
      const Eigen::Vector3d p = piece.ball.c + t * u;
      const NearestSurface seen = see(p);
      offer(p, seen, piece);
      return seen.distance;
    };
    // Balls at both ends; then between the pair with the lowest bound.
    std::vector<BallPair> pairs{{-r, r, distance_at(-r), distance_at(r)}};
    while (pairs.back().d_from > 0 && pairs.back().d_to > 0) {
      const auto lowest = std::min_element(
          pairs.begin(), pairs.end(),
          [](const BallPair& x, const BallPair& y) { return x.least() < y.least(); });
      const BallPair pair = *lowest;
      const double bound = pair.least() - piece.radius, t = pair.narrowest();
      if (bound >= enough() || bound > options_.cutoff || pairs.size() >= kMaxPairs ||
          evaluations_ >= options_.max_evaluations || !(t > pair.from && t < pair.to))
        return bound;
      const double d = distance_at(t);
      *lowest = {pair.from, t, pair.d_from, d};
      pairs.push_back({t, pair.to, d, pair.d_to});
    }
    return kNothing;
  }

  static Eigen::Vector3d longest_side(const Eigen::Matrix3d& corners) {
    Eigen::Vector3d longest = corners.col(1) - corners.col(0);
    for (const int k : {0, 1}) {
      const Eigen::Vector3d side = corners.col(2) - corners.col(k);
      if (side.squaredNorm() > longest.squaredNorm()) longest = side;
    }
    return longest;
  }

  void add_node(int index, double parent) {
    // Outside of the region that counts.
    const CollisionNode& node = a_.nodes[index];
    const Ball ball = posed(node);
    if (!near(ball)) return;
    // A leaf is a triangle.
    if (node.triangle >= 0) {
      const double radius = a_.triangles[node.triangle].radius;
      return add_piece(corners_of(node.triangle), radius, node.triangle, parent);
    }
    // A node's ball, against empty space and against B.
    double bound = std::max(parent, empty_.bound(ball));
    if (bound < enough())
      bound =
          std::max(bound, (empty_.has_planes() ? see(ball.c).distance : distance(ball.c)) - ball.r);
    push({bound, index, -1});
  }

  void expand(const Candidate& candidate) {
    // A node: both children.
    if (candidate.node >= 0) {
      const CollisionNode& node = a_.nodes[candidate.node];
      add_node(node.left, candidate.bound);
      add_node(node.right, candidate.bound);
      return;
    }
    // A piece: look for better points, then sharpen its bound, then halve it.
    const Piece piece = pieces_[candidate.piece];
    descend(piece);
    const double bound = std::max({candidate.bound, empty_.bound(piece.corners, piece.radius),
                                   piece.seen.supports ? kNothing : lifted(piece)});
    if (bound >= enough())
      dropped_ = std::min(dropped_, bound);
    else
      halve(piece, bound);
  }

  double lifted(const Piece& piece) {
    ++evaluations_;
    const Ball empty =
        lifted_ball(b_, piece.corners, piece.ball, piece.seen, enough() + piece.radius);
    if (!std::isfinite(empty.r)) return -kInfinity;
    empty_.add_ball(empty);
    return bound_by(empty, piece.corners) - piece.radius;
  }

  /// Looks for better points: the corner farthest down, and the point nearest to B's, alternately.
  void descend(const Piece& piece) {
    // The corner that B's plane sees lowest.
    Eigen::Index lowest = 0;
    const double rise = (piece.seen.normal.transpose() * (piece.corners.colwise() - piece.ball.c))
                            .minCoeff(&lowest);
    if (piece.seen.distance + rise - piece.radius >= enough() && best_ < kInfinity &&
        triangle_ != piece.triangle)
      return;  // seen as flat, it has no better point
    const Eigen::Vector3d corner = piece.corners.col(lowest);
    offer(corner, see(corner), piece);

    // Alternate between the nearest points of the two.
    Eigen::Vector3d on_b = piece.ball.c - piece.seen.distance * piece.seen.normal;
    for (int i = 0; i < 3; ++i) {
      const double before = best_;
      const Eigen::Vector3d p = internal::nearest_in_triangle(piece.corners, on_b);
      const NearestSurface there = see(p);
      offer(p, there, piece);
      if (!(best_ < before - options_.tolerance)) return;
      on_b = p - there.distance * there.normal;
    }
  }

  void halve(const Piece& piece, double bound) {
    for (const Eigen::Matrix3d& half : internal::halves(piece.corners))
      if (near(internal::smallest_ball(half))) add_piece(half, piece.radius, piece.triangle, bound);
  }

  /// Returns the result in B's frame.
  SignedDistance result() {
    // The lowest bound that is left tells the error.
    if (triangle_ < 0) whole(0);  // beyond the cutoff before any triangle was seen
    const double below = heap_.empty() ? kInfinity : heap_.front().bound;
    const double lower = std::min({below, dropped_, best_});
    SignedDistance s{best_,
                     best_ - lower + b_.accuracy() + kRounding * core_.norm(),
                     core_ - radius_ * seen_.normal,
                     core_ - seen_.distance * seen_.normal,
                     seen_.normal,
                     triangle_,
                     evaluations_};
    if (lower > options_.cutoff) s.distance = lower, s.error = kInfinity;
    return s;
  }

  static constexpr double kNothing = -kInfinity;  // Bound that excludes nothing [m]
  static constexpr double kEverywhere = 1e29;     // Radius of a ball that restricts nothing [m]
  static constexpr int kMaxAlong = 40;            // Most planes along one segment
  static constexpr std::size_t kMaxPairs = 200;   // Most pairs of balls along one segment
  static constexpr int kGuesses = 4;              // Most triangles tried as a first guess
  static constexpr double kRounding = 1e-14;  // Rounding of a distance, over the coordinates [1]

  const CollisionTree& a_;
  const Pose<double> X_BA_;
  const Shape& b_;
  const SignedDistanceOptions options_;

  std::vector<Candidate> heap_;
  std::vector<Piece> pieces_;
  Piece last_{{}, {}, {}, 0, -1};  // that was evaluated
  double best_ = kInfinity;        // least distance seen [m]
  double dropped_ = kInfinity;     // least bound of what was not searched [m]
  Eigen::Vector3d core_{0, 0, 0};  // where it was seen: a point of A's core [m] (3)
  NearestSurface seen_{};          // of B from there
  EmptySpace empty_;               // of B
  double radius_ = 0;              // of the rounding there [m]
  int triangle_ = -1;
  int evaluations_ = 0;
};

/// Turns a result in B's frame to world.
SignedDistance turned(const Pose<double>& X_WB, SignedDistance s) {
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
  return turned(X_WB, signed_distance(a, X_WB.inverse() * X_WA, *b.shape, options));
}

SignedDistance signed_distance(const Solid& a, const Pose<double>& X_WA, const Solid& b,
                               const Pose<double>& X_WB, double tolerance, double cutoff) {
  SignedDistanceOptions options;
  options.tolerance = tolerance;
  options.cutoff = cutoff;
  return signed_distance(collision_tree(a), X_WA, b, X_WB, options);
}

}  // namespace thenar
