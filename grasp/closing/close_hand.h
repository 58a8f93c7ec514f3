#pragma once

/// Auto-grasp: closes the drives of a hand round an object until contacts and joint limits stop
/// them.

#include <vector>

#include <Eigen/Core>

#include "geometry/collision/collision_tree.h"
#include "grasp/closing/clearance.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/closing/setup.h"
#include "hand/hand.h"

namespace thenar {

/// Settings of close_hand().
struct CloseOptions {
  double accuracy = 1e-4;  // a link touches when its clearance is at most this [m]
  bool self = true;        // links of the hand stop each other
  int max_steps = 20000;
  ClosingRates rates;     // replace the speeds of drives, as tendon_rates(); empty: drive speeds
  double refresh = 0.05;  // motion of a coordinate after which rates are updated [rad] or [m]
};

/// Result of close_hand().
struct [[nodiscard]] ClosedHand {
  Eigen::VectorXd q;                   // (coordinates) [rad] or [m]
  std::vector<StoppedBy> stopped;      // of each coordinate
  std::vector<Overlap> overlaps;       // with the setup at the start; not empty: nothing was moved
  std::vector<Overlap> self_overlaps;  // links that overlap at the start by more than they yield:
                                       // they do not stop each other
  bool finished = false;               // nothing moves any more; false: overlaps or too many steps
  int steps = 0;
  int queries = 0;  // number of distances measured
};

/// Moves every drive at its speed. A coordinate stops at its limit, or when a link that it moves
/// touches something and would go into it; Drive::coupling tells how the rest of its drive reacts.
///
/// Conservative advancement: every clearance has a lower bound, no point moves farther in a step
/// than the clearances allow, and only clearances that are used up are measured again. So no link
/// passes through anything, however thin, and a clearance at contact is within (0, accuracy].
///
/// Closing is kinematic, without forces. A breakaway coupling opens at the first contact, whatever
/// Drive::breakaway says.
///
/// Links of the hand stop each other as collision_hand() pairs them; links that overlap at the
/// start are listed and do not. Soft links stop when their layers are pressed flat (6 mm for skin
/// on skin), and only if they push and stick; a link that moves along the other slides on, and is
/// checked every millimetre. So a thumb that runs onto a finger stops, and a finger that brushes
/// the thumb goes on.
/// @param q  posture at the start (coordinates) [rad], of sliding joints [m]
/// @throws InputError if q has the wrong length, is not finite or out of limits.
/// Source: [MirtichCanny1995] for conservative advancement, [Miller2004] for auto-grasp.
///   [GraspItWorld] for the thickness of skin.
ClosedHand close_hand(const CollisionHand& hand, const Pose<double>& X_WH, const Eigen::VectorXd& q,
                      const GraspSetup& setup, const CloseOptions& options = {});

/// Throws InputError unless q is a posture of the hand within its limits (to 1e-9).
void require_start(const Hand& hand, const Eigen::VectorXd& q);

/// Speed bounds of one surface while the hand moves with q_dot.
struct SurfaceSpeed {
  Eigen::VectorXd speed;  // of its fastest point by each coordinate, >= 0 [m/s] (coordinates)
  Eigen::VectorXd turn;   // angular speed by each coordinate, >= 0 [rad/s] (coordinates)
};

/// Computes  |J_v q_dot| + radius |J_w q_dot|  of the ball, coordinate by coordinate.
[[nodiscard]] SurfaceSpeed surface_speed(const Hand& hand, const Eigen::VectorXd& q,
                                         const Eigen::VectorXd& q_dot, int surface,
                                         const Ball& ball);

/// Longest time in which no point with these speeds moves farther than `clearance` [s]. As links
/// turn on each other, their speeds grow by at most  speed * turn * time,  so that in time t a
/// point moves at most
///   t speed (1 + t turn),  for t turn <= 1/2.
/// @param speed  >= 0 [m/s];  @param turn  >= 0 [rad/s];  @param clearance  >= 0 [m]
[[nodiscard]] double safe_time(double speed, double turn, double clearance);

/// Longest distance that a point moves in a time, by the same bound [m].
[[nodiscard]] double longest_way(double speed, double turn, double time);

}  // namespace thenar
