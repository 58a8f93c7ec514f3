#pragma once

/// Hands for scenes: round numbers of the size of a human hand, of no one's.

#include "dynamics/stepping/moving_scene.h"

namespace thenar::sample {

/// 21 hinges: four fingers that spread and bend at three joints, a thumb on five skewed axes. Every
/// link has mass, so that engines of all kinds can take it. Nothing touches.
[[nodiscard]] MovingScene swinging_hand();

/// A palm on a slide along x, on a spring to a place that moves on; a ball that lies on it; five
/// fingers of two hinges with a round pad on each link, which constant torques press on the ball:
/// 11 contacts from the start on.
struct BallInHand {
  MovingScene scene;
  int ball = 0;
};
[[nodiscard]] BallInHand ball_in_hand();

}  // namespace thenar::sample
