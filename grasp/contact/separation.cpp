#include "grasp/contact/separation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "grasp/contact/lifted_bound.h"
#include "grasp/contact/triangle_point.h"

namespace thenar {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Part of a triangle, seen from B.
struct Piece {
  Eigen::Matrix3d corners;  // [m] (3, 3)
  Ball ball;                // around them, without the rounding
  double d;                 // B's distance of the ball's centre [m]
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
class Search {
 public:
  Search(const TouchBody& a, const Pose<double>& X_BA, const Shape& b,
         const SeparationOptions& options)
      : a_(a), X_BA_(X_BA), b_(b), options_(options) {}

  Separation run() {
    if (options_.start >= 0 && options_.start < static_cast<int>(a_.triangles.size())) {
      const Piece piece = whole(options_.start);
      descend(piece, b_.nearest(piece.ball.c));
    }
    add_node(0, -kInfinity);
    while (!heap_.empty() && heap_.front().bound < enough() &&
           heap_.front().bound <= options_.cutoff && evaluations_ < options_.most_evaluations)
      expand(pop());
    return result();
  }

 private:
  /// A bound from which on nothing need be searched.
  [[nodiscard]] double enough() const {
    return std::min(best_ - options_.tolerance, (1 - options_.relative) * best_);
  }

  [[nodiscard]] bool near(const Ball& ball) const {
    return (ball.c - options_.within.c).norm() <= ball.r + options_.within.r;
  }

  double distance(const Eigen::Vector3d& p) {
    ++evaluations_;
    return b_.distance(p);
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

  /// Remembers a point of A's core if it is the best.
  void offer(const Eigen::Vector3d& core, double d, const Piece& piece) {
    if (d - piece.radius >= best_) return;
    best_ = d - piece.radius;
    core_ = core;
    radius_ = piece.radius;
    triangle_ = piece.triangle;
  }

  Piece whole(int triangle) {
    const TouchTriangle& t = a_.triangles[static_cast<std::size_t>(triangle)];
    return evaluated((X_BA_.R * t.corners).colwise() + X_BA_.p, t.radius, triangle);
  }

  Piece evaluated(const Eigen::Matrix3d& corners, double radius, int triangle) {
    Piece piece{corners, smallest_ball(corners), 0, radius, triangle};
    piece.d = distance(piece.ball.c);
    offer(piece.ball.c, piece.d, piece);
    return piece;
  }

  void add_piece(const Piece& piece, double parent) {
    pieces_.push_back(piece);
    push({std::max(parent, piece.d - piece.ball.r - piece.radius), -1,
          static_cast<int>(pieces_.size()) - 1});
  }

  void add_node(int index, double parent) {
    const TouchNode& node = a_.nodes[static_cast<std::size_t>(index)];
    if (!near({X_BA_ * node.ball.c, node.ball.r})) return;
    if (node.triangle >= 0) return add_piece(whole(node.triangle), parent);
    const double d = distance(X_BA_ * node.ball.c);
    push({std::max(parent, d - node.ball.r), index, -1});
  }

  void expand(const Candidate& candidate) {
    if (candidate.node >= 0) {
      const TouchNode& node = a_.nodes[static_cast<std::size_t>(candidate.node)];
      add_node(node.left, candidate.bound);
      add_node(node.right, candidate.bound);
      return;
    }
    const Piece piece = pieces_[static_cast<std::size_t>(candidate.piece)];
    ++evaluations_;
    const NearestSurface seen = b_.nearest(piece.ball.c);
    descend(piece, seen);
    const double wanted = enough() + piece.radius;
    const double bound = std::max(
        candidate.bound, lifted_bound(b_, piece.corners, piece.ball, seen, wanted) - piece.radius);
    ++evaluations_;
    if (bound >= enough())
      dropped_ = std::min(dropped_, bound);
    else
      halve(piece, bound);
  }

  /// Looks for better points: the corner farthest down, and the point nearest to B's, alternately.
  void descend(const Piece& piece, const NearestSurface& seen) {
    Eigen::Index lowest = 0;
    (seen.normal.transpose() * piece.corners).minCoeff(&lowest);
    const Eigen::Vector3d corner = piece.corners.col(lowest);
    offer(corner, distance(corner), piece);

    Eigen::Vector3d on_b = piece.ball.c - seen.distance * seen.normal;
    for (int i = 0; i < 3; ++i) {
      const double before = best_;
      const Eigen::Vector3d p = nearest_in_triangle(piece.corners, on_b);
      ++evaluations_;
      const NearestSurface there = b_.nearest(p);
      offer(p, there.distance, piece);
      if (!(best_ < before - options_.tolerance)) return;
      on_b = p - there.distance * there.normal;
    }
  }

  void halve(const Piece& piece, double bound) {
    for (const Eigen::Matrix3d& half : halves(piece.corners))
      if (near(smallest_ball(half)))
        add_piece(evaluated(half, piece.radius, piece.triangle), bound);
  }

  /// In B's frame.
  Separation result() {
    if (triangle_ < 0) whole(0);  // beyond the cutoff before any triangle was seen
    const double below = heap_.empty() ? kInfinity : heap_.front().bound;
    const double lower = std::min({below, dropped_, best_});
    const NearestSurface seen = b_.nearest(core_);
    Separation s{best_,
                 best_ - lower + b_.accuracy() + kRounding * core_.norm(),
                 core_ - radius_ * seen.normal,
                 core_ - seen.distance * seen.normal,
                 seen.normal,
                 triangle_,
                 evaluations_};
    if (lower > options_.cutoff) s.distance = lower, s.error = kInfinity;
    return s;
  }

  static constexpr double kRounding = 1e-14;  // of a distance, per coordinate [1]

  const TouchBody& a_;
  const Pose<double> X_BA_;
  const Shape& b_;
  const SeparationOptions options_;

  std::vector<Candidate> heap_;
  std::vector<Piece> pieces_;
  double best_ = kInfinity;        // least distance seen [m]
  double dropped_ = kInfinity;     // least bound of what was not searched [m]
  Eigen::Vector3d core_{0, 0, 0};  // where it was seen: a point of A's core [m] (3)
  double radius_ = 0;              // of the rounding there [m]
  int triangle_ = -1;
  int evaluations_ = 0;
};

/// Turns a result in B's frame to world.
Separation turned(const Pose<double>& X_WB, Separation s) {
  s.on_a = X_WB * s.on_a;
  s.on_b = X_WB * s.on_b;
  s.normal = X_WB.R * s.normal;
  return s;
}

}  // namespace

Separation separation(const TouchBody& a, const Pose<double>& X_BA, const Shape& b,
                      const SeparationOptions& options) {
  require(X_BA.R.allFinite() && X_BA.p.allFinite(), "poses must be finite, got an origin at {} m",
          X_BA.p.norm());
  require(options.tolerance > 0, "tolerance must be positive, got {} m", options.tolerance);
  require(!a.nodes.empty(), "a touch surface must have {} triangle or more", 1);
  return Search(a, X_BA, b, options).run();
}

Separation separation(const TouchBody& a, const Pose<double>& X_WA, const Solid& b,
                      const Pose<double>& X_WB, const SeparationOptions& options) {
  require(b.shape != nullptr, "a solid without a {} has no distance", "shape");
  return turned(X_WB, separation(a, X_WB.inverse() * X_WA, *b.shape, options));
}

Separation separation(const Solid& a, const Pose<double>& X_WA, const Solid& b,
                      const Pose<double>& X_WB, double tolerance, double cutoff) {
  SeparationOptions options;
  options.tolerance = tolerance;
  options.cutoff = cutoff;
  return separation(touch_body(a), X_WA, b, X_WB, options);
}

}  // namespace thenar
