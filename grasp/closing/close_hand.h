#pragma once

/// Closing a hand round an object until it can close no further.

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "geometry/collision/collision_tree.h"
#include "grasp/closing/clearance.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/closing/scene.h"
#include "hand/hand.h"

namespace thenar {

/// Rates of all coordinates at a posture [rad/s] or [m/s], asked for anew while the hand closes.
/// @param q  (coordinates);  @param free  which a drive may still move (coordinates)
using ClosingRates = std::function<Eigen::VectorXd(
    const Eigen::VectorXd& q, const Eigen::Array<bool, Eigen::Dynamic, 1>& free)>;

struct CloseOptions {
  double accuracy = 1e-4;  // a link touches when its clearance is at most this [m]
  bool self = true;        // links of the hand stop each other
  int max_steps = 20000;
  ClosingRates rates;     // in place of the speeds of drives, as tendon_rates(); empty: those
  double refresh = 0.05;  // way of any coordinate after which rates are asked again [rad] or [m]
};

struct [[nodiscard]] ClosedHand {
  Eigen::VectorXd q;                   // (coordinates) [rad] or [m]
  std::vector<StoppedBy> stopped;      // of each coordinate
  std::vector<Overlap> overlaps;       // with the scene at the start; not empty: nothing was moved
  std::vector<Overlap> self_overlaps;  // links deeper in each other at the start than they yield:
                                       // they do not stop each other
  bool finished = false;  // nothing moves any more; false: overlaps or too many steps
  int steps = 0;
  int queries = 0;  // distances searched for
};

/// Moves every drive at its speed. A coordinate stops at its limit, or when a link that it moves
/// touches something and would go into it; what the others of its drive do then is Drive::coupled.
///
/// Time goes by conservative advancement: every clearance is known from below, no point moves
/// farther in a step than the clearances allow, and only clearances that are used up are measured
/// again. So no link passes through anything, however thin, and a clearance at contact is within
/// (0, accuracy].
///
/// Closing is kinematic: forces are not asked for. A breakaway coupling opens at the first contact,
/// whatever Drive::breakaway says.
///
/// Links of the hand stop each other as collision_hand() pairs them; those in each other at the
/// start are listed and do not. Soft ones stop when their layers are pressed flat (6 mm for skin on
/// skin), and only what pushes and sticks: what goes along the other slides on, and is looked at
/// every millimetre. So a thumb that runs onto a finger stops, and a finger that brushes the thumb
/// goes on.
/// @param q  where it starts (coordinates)
/// @throws InputError if q has the wrong length, is not finite or out of limits.
/// Source: [MirtichCanny1995] for conservative advancement, [Miller2004] for auto-grasp.
///   [GraspItWorld] for the thickness of skin.
ClosedHand close_hand(const CollisionHand& hand, const Pose<double>& X_WH, const Eigen::VectorXd& q,
                      const Scene& scene, const CloseOptions& options = {});

/// Throws InputError unless q is a posture of the hand within its limits (to 1e-9).
void require_start(const Hand& hand, const Eigen::VectorXd& q);

// How fast the surfaces of a hand move, at most.

/// Bounds for one surface while the hand moves with  q_dot.
struct SurfaceSpeed {
  Eigen::VectorXd speed;  // of its fastest point, by each coordinate, >= 0 [m/s] (coordinates)
  Eigen::VectorXd turn;   // angular speed by each coordinate, >= 0 [rad/s] (coordinates)
};

/// Speeds now:  |J_v q_dot| + radius |J_w q_dot|  of the ball, coordinate by coordinate.
[[nodiscard]] SurfaceSpeed surface_speed(const Hand& hand, const Eigen::VectorXd& q,
                                         const Eigen::VectorXd& q_dot, int surface,
                                         const Ball& ball);

/// Longest time in which no point with these speeds goes farther than `clearance`: as links turn on
/// each other their speeds grow by at most  speed * turn * time,  so that the way in time t is at
/// most
///   t speed (1 + t turn),  for t turn <= 1/2.
/// @param speed  >= 0 [m/s];  @param turn  >= 0 [rad/s];  @param clearance  >= 0 [m]
[[nodiscard]] double safe_time(double speed, double turn, double clearance);

/// Longest way in a time, by the same bound [m].
[[nodiscard]] double longest_way(double speed, double turn, double time);

}  // namespace thenar
