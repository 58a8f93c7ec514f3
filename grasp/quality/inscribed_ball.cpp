#include "grasp/quality/inscribed_ball.h"

#include <algorithm>

#include "base/error.h"
#include "base/numbers.h"
#include "grasp/limits/grasp_force.h"
#include "grasp/quality/epsilon.h"

namespace thenar {
namespace {

constexpr double kMinNewDistance =
    1e-9;  // distance beyond a facet over its size from which a point is new [1]

/// Polytope of boundary points of the set; its facets and supports bound the inscribed ball.
class BallSearch {
 public:
  BallSearch(const ForceSet& forces, const BallOptions& options)
      : forces_(forces), options_(options) {
    // Limit the sum of normal forces.
    internal::append_limit(forces_, forces.normals, options.max_total_force);
  }

  InscribedBall run() {
    // Most sets contain the zero wrench, the centre of the ball.
    const GraspForce none = minimum_grasp_force(forces_, ScaledWrench{}, GraspForceObjective::kSum);
    if (none.status == Status::kSolved) {
      points_.caps.push_back({ScaledWrench{}, {}});
      result_.residual = none.residual;
    }
    ++result_.programs;
    // Support in both directions of all six axes.
    for (int i = 0; i < 6 && ok(); ++i)
      for (const double sign : {1.0, -1.0}) (void)look(sign * ScaledWrench::unit(i));
    // Refine the nearest facet until the bounds agree or the maximum number of programs is reached.
    while (ok() && result_.programs < options_.max_programs && !refine()) {
    }
    const bool met = result_.upper <= 0 || result_.upper - result_.lower <= gap();
    if (ok() && !met && !exhausted_) result_.status = Status::kLimit;
    result_.lower = std::min(result_.lower, result_.upper);
    return result_;
  }

 private:
  [[nodiscard]] bool ok() const { return result_.status == Status::kSolved; }
  [[nodiscard]] double gap() const {
    return options_.gap * std::max(result_.upper, kMinNewDistance * size_);
  }

  /// Adds the support in a direction. @returns whether its point is new: beyond all others
  bool look(const ScaledWrench& u) {
    const WrenchSupport reach = wrench_support(forces_, u);
    ++result_.programs;
    if (reach.status != Status::kSolved) {
      result_.status = reach.status;
      return false;
    }
    // The multipliers give an upper bound.
    result_.residual = max_or_nan(result_.residual, reach.residual);
    if (reach.bound < result_.upper) {
      result_.upper = reach.bound;
      result_.worst_load = -u;
    }
    const bool is_new = points_.caps.empty() ||
                        reach.value > support(points_, u, ForceNorm::kL1) + kMinNewDistance * size_;
    size_ = std::max(size_, reach.wrench.norm());
    points_.caps.push_back({reach.wrench, {}});
    return is_new;
  }

  /// Adds the support beyond the nearest facet, or across a flat hull. @returns whether it is done
  bool refine() {
    // Nearest facet of the polytope: a bound from below.
    EpsilonOptions sharp;
    sharp.gap = std::max(0.1 * gap(), 1e-12);
    const Epsilon inner = epsilon(points_, sharp);
    result_.lower = std::min(inner.lower, result_.upper);
    if (result_.upper <= 0 || result_.upper - result_.lower <= gap()) return true;
    // A flat polytope needs points on both sides.
    const ScaledWrench u = -inner.worst_wrench;
    exhausted_ = !look(u);
    if (inner.rank < 6) exhausted_ = !look(-u) && exhausted_;
    return exhausted_;
  }

  ForceSet forces_;
  BallOptions options_;
  WrenchSet points_;
  double size_ = 0;
  bool exhausted_ = false;
  InscribedBall result_{Status::kSolved, -kInfinity, kInfinity, ScaledWrench{}, 0, 0};
};

}  // namespace

bool is_unlimited(ForceSet forces, int axes) {
  // Recession cone: all limits at zero.
  forces.b.setZero();
  forces.h.setZero();
  for (int i = 0; i < axes; ++i)
    for (const double sign : {1.0, -1.0})
      if (load_margin(forces, sign * ScaledWrench::unit(i)).status != Status::kUnbounded)
        return false;
  return true;
}

InscribedBall inscribed_ball(const ForceSet& forces, const BallOptions& options) {
  require(options.gap > 0 && options.max_total_force > 0 && options.max_programs > 0,
          "gap, max_total_force and max_programs must be positive, got {}, {}, {}", options.gap,
          options.max_total_force, options.max_programs);
  if (is_unlimited(forces, 6))
    return {Status::kUnbounded, kInfinity, kInfinity, ScaledWrench{}, 12, 0};
  return BallSearch(forces, options).run();
}

}  // namespace thenar
