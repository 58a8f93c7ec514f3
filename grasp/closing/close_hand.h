#pragma once

/// Closing: moves the drives of a hand around an object until contacts and joint limits stop them.

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
  double accuracy = 1e-4;  // largest clearance that counts as contact [m]
  bool self = true;        // whether links of the hand stop each other
  int max_steps = 20000;   // maximum number of steps
  ClosingRates
      rates;  // rates that replace drive speeds, such as tendon_closing_rates(); empty: none
  /// Motion of a coordinate after which `rates` are evaluated again [rad] or [m]
  double refresh = 0.05;
};

/// Result of close_hand().
struct [[nodiscard]] ClosedHand {
  Eigen::VectorXd q;               // final posture (coordinates) [rad] or [m]
  std::vector<StoppedBy> stopped;  // reason of each coordinate (coordinates)
  /// Overlaps with the setup at the start; if there are any, nothing moves.
  std::vector<Overlap> overlaps;
  std::vector<Overlap> self_overlaps;  // links that overlap at the start beyond their soft layers;
                                       // contact between them is ignored
  bool finished = false;  // true: nothing can move any more; false: overlaps, or `max_steps`
  int steps = 0;          // number of steps
  int queries = 0;        // number of distances measured
};

/// Moves every drive at its speed. A coordinate stops at its limit, or when a link that it moves
/// touches something and would penetrate it; Drive::coupling defines how the rest of its drive
/// responds.
///
/// Conservative advancement: every clearance has a lower bound, no point moves farther in a step
/// than these bounds allow, and only clearances whose bound is used up are measured again. No link
/// can pass through anything, however thin, and a clearance at contact is within (0, accuracy].
///
/// Closing is kinematic, without forces. A breakaway coupling opens at the first contact, whatever
/// the value of Drive::breakaway.
///
/// Links of the hand stop each other in the pairs of collision_hand(); pairs that overlap at the
/// start are listed and ignored. Soft links stop when their layers are fully compressed (6 mm for
/// skin on skin), and only if they push and stick. A link that moves along the other keeps sliding,
/// and is checked every millimetre: a thumb that runs into a finger stops, a finger that brushes
/// the thumb does not.
/// @param q  initial posture (coordinates) [rad], of sliding joints [m]
/// @throws InputError if q has the wrong length, is not finite or exceeds the limits.
/// Source: [MirtichCanny1995] for conservative advancement, [Miller2004] for auto-grasp.
///   [GraspItWorld] for the thickness of skin.
ClosedHand close_hand(const CollisionHand& hand, const Pose<double>& X_WH, const Eigen::VectorXd& q,
                      const GraspSetup& setup, const CloseOptions& options = {});

/// Throws InputError unless q is a posture of the hand within its limits (to 1e-9).
void require_valid_start(const Hand& hand, const Eigen::VectorXd& q);

/// Speed bounds of one surface while the hand moves with q_dot.
struct SurfaceSpeed {
  Eigen::VectorXd speed;  // speed of its fastest point by each coordinate, >= 0 [m/s] (coordinates)
  Eigen::VectorXd angular_speed;  // by each coordinate, >= 0 [rad/s] (coordinates)
};

/// Computes  |J_v q_dot| + radius |J_w q_dot|  for a ball, coordinate by coordinate.
[[nodiscard]] SurfaceSpeed surface_speed(const Hand& hand, const Eigen::VectorXd& q,
                                         const Eigen::VectorXd& q_dot, int surface,
                                         const Ball& ball);

/// Computes the longest time in which no point with these speeds moves farther than `clearance`
/// [s]. As links rotate relative to each other, speeds grow by at most  speed * angular_speed *
/// time,  so that in time t a point moves at most
///   t speed (1 + t angular_speed),  for t angular_speed <= 1/2.
/// @param speed  >= 0 [m/s];  @param angular_speed  >= 0 [rad/s];  @param clearance  >= 0 [m]
[[nodiscard]] double safe_time(double speed, double angular_speed, double clearance);

/// Returns the largest distance that a point moves in a time, by the bound of safe_time() [m].
[[nodiscard]] double max_displacement(double speed, double angular_speed, double time);

}  // namespace thenar
