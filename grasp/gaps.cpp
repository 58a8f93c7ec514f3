#include "grasp/gaps.h"

#include <cmath>

namespace thenar {
namespace {

constexpr double kRelative = 0.2;  // error of a gap: far ones are asked for again anyway [1]

const LinkSurface& surface_of(const PosedHand& posed, int surface) {
  return posed.touching.hand->surfaces()[surface];
}

}  // namespace

Pose<double> PosedHand::of_surface(int surface) const {
  const int link = surface_of(*this, surface).link;
  return link < 0 ? X_WH : X_WH * links[link];
}

Separation measure(Gap& gap, const PosedHand& posed, double tolerance, double cutoff) {
  SeparationOptions options;
  options.tolerance = tolerance;
  options.relative = kRelative;
  options.cutoff = cutoff;
  options.start = gap.nearest;
  const TouchBody& touch = posed.touching.touch[gap.surface];
  const Pose<double> X = posed.of_surface(gap.surface);
  const Separation found = gap.body != nullptr
                               ? separation(touch, X, gap.body->solid, gap.body->X_WB, options)
                               : separation(touch, X, *surface_of(posed, gap.other).solid,
                                            posed.of_surface(gap.other), options);
  // A bound itself has an infinite error; a distance beyond the cutoff may be less exact than that.
  gap.bound = std::isfinite(found.error) ? found.distance - found.error : found.distance;
  gap.nearest = found.triangle;
  return found;
}

double ball_bound(const Gap& gap, const PosedHand& posed) {
  const Ball& ball = posed.touching.touch[gap.surface].nodes[0].ball;
  const Eigen::Vector3d c = posed.of_surface(gap.surface) * ball.c;
  if (gap.body == nullptr) {
    const Ball& other = posed.touching.touch[gap.other].nodes[0].ball;
    return (c - posed.of_surface(gap.other) * other.c).norm() - ball.r - other.r;
  }
  const Shape& shape = *gap.body->solid.shape;
  return shape.distance(gap.body->X_WB.inverse() * c) - shape.accuracy() - ball.r;
}

std::vector<Gap> scene_gaps(const PosedHand& posed, const Scene& scene) {
  std::vector<Gap> gaps;
  const auto add = [&](int surface, const SceneBody& body) {
    gaps.push_back({surface, -1, &body});
    gaps.back().bound = ball_bound(gaps.back(), posed);
  };
  for (int s = 0; s < static_cast<int>(posed.touching.touch.size()); ++s) {
    add(s, scene.object);
    for (const SceneBody& obstacle : scene.obstacles) add(s, obstacle);
  }
  return gaps;
}

SelfGaps self_gaps(const PosedHand& posed, double accuracy) {
  SelfGaps self;
  for (const SurfacePair& pair : posed.touching.self) {
    Gap gap{pair.a, pair.b};
    gap.yield = pair.yield;
    gap.stick = pair.stick;
    gap.bound = ball_bound(gap, posed);
    double distance = gap.bound;
    if (gap.room() <= accuracy)
      distance = measure(gap, posed, accuracy / 4, 100 * accuracy).distance;
    if (gap.room() > accuracy)
      self.gaps.push_back(gap);
    else if (distance + gap.yield < 0)
      self.overlaps.push_back(
          {surface_of(posed, pair.a).name, surface_of(posed, pair.b).name, -distance});
  }
  return self;
}

std::vector<Overlap> find_overlaps(const PosedHand& posed, const Scene& scene, double accuracy) {
  std::vector<Overlap> overlaps;
  for (Gap& gap : scene_gaps(posed, scene)) {
    if (gap.bound > 0) continue;
    const double distance = measure(gap, posed, accuracy / 4, accuracy).distance;
    if (distance < 0)
      overlaps.push_back({surface_of(posed, gap.surface).name, gap.body->name, -distance});
  }
  return overlaps;
}

}  // namespace thenar
