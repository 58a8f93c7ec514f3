#include "grasp/approach.h"

#include <algorithm>

#include "base/error.h"
#include "base/numbers.h"

namespace thenar {
Approached approach(const TouchingHand& hand, const Pose<double>& X_WH, const Eigen::VectorXd& q,
                    const Scene& scene, double way, const CloseOptions& options) {
  require_start(*hand.hand, q);
  require(way >= 0 && way < kInfinity, "the way of an approach is {} m", way);
  Approached result;
  result.X_WH = X_WH;
  PosedHand posed{hand, X_WH, hand.hand->pose(q)};
  result.overlaps = find_overlaps(posed, scene, options.accuracy);
  if (!result.overlaps.empty()) return result;
  const Eigen::Vector3d direction = X_WH.R * hand.hand->layout().approach.direction;
  std::vector<Gap> gaps = scene_gaps(posed, scene);

  // A pure translation: nothing moves faster than the hand.
  double gone = 0;
  for (int steps = 0; gone < way && steps < options.most_steps; ++steps) {
    double step = way - gone;
    for (Gap& gap : gaps) {
      if (gap.bound - options.accuracy / 2 >= step) continue;
      const Separation found =
          measure(gap, posed, options.accuracy / 4, step + 2 * options.accuracy);
      if (found.distance > options.accuracy) {
        step = std::min(step, gap.bound - options.accuracy / 2);
      } else if (found.normal.dot(direction) < 0) {
        result.touches = true;
        result.surface = hand.hand->surfaces()[gap.surface].name;
        result.body = gap.body->name;
        result.gap = gap.bound;
        return result;
      } else {
        step = std::min(step, options.accuracy / 4);  // slides along
      }
    }
    gone += step;
    for (Gap& gap : gaps) gap.bound -= step;
    posed.X_WH.p = result.X_WH.p = X_WH.p + gone * direction;
  }
  return result;
}

}  // namespace thenar
