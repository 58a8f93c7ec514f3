#pragma once

/// How fast the surfaces of a hand move, at most.

#include <Eigen/Core>

#include "geometry/collision/touch_body.h"
#include "hand/hand.h"

namespace thenar {

/// Bounds for one surface while the hand moves with  q_dot.
struct SurfaceSpeed {
  Eigen::VectorXd speed;  // of its fastest point, by each coordinate, >= 0 [m/s] (coordinates)
  Eigen::VectorXd turn;   // angular speed by each coordinate, >= 0 [rad/s] (coordinates)
};

/// Speeds now:  |J_v q_dot| + radius |J_w q_dot|  of the ball, coordinate by coordinate.
[[nodiscard]] SurfaceSpeed surface_speed(const Hand& hand, const Eigen::VectorXd& q,
                                         const Eigen::VectorXd& q_dot, int surface,
                                         const Ball& ball);

/// Longest time in which no point with these speeds goes farther than `gap`: as links turn on each
/// other their speeds grow by at most  speed * turn * time,  so that the way in time t is at most
///   t speed (1 + t turn),  for t turn <= 1/2.
/// @param speed  >= 0 [m/s];  @param turn  >= 0 [rad/s];  @param gap  >= 0 [m]
[[nodiscard]] double safe_time(double speed, double turn, double gap);

/// Longest way in a time, by the same bound [m].
[[nodiscard]] double longest_way(double speed, double turn, double time);

}  // namespace thenar
