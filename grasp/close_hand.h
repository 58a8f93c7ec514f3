#pragma once

/// Closing a hand round an object until it can close no further.

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "grasp/closing_drives.h"
#include "grasp/gaps.h"
#include "grasp/scene.h"

namespace thenar {

/// Rates of all coordinates at a posture [rad/s] or [m/s], asked for anew while the hand closes.
/// @param q  (coordinates);  @param free  which a drive may still move (coordinates)
using ClosingRates = std::function<Eigen::VectorXd(
    const Eigen::VectorXd& q, const Eigen::Array<bool, Eigen::Dynamic, 1>& free)>;

struct CloseOptions {
  double accuracy = 1e-4;  // a link touches when its gap is at most this [m]
  bool self = true;        // links of the hand stop each other
  int most_steps = 20000;
  ClosingRates rates;     // in place of the speeds of drives, as tendon_rates(); empty: those
  double refresh = 0.05;  // way of any coordinate after which rates are asked again [rad] or [m]
};

struct [[nodiscard]] ClosedHand {
  Eigen::VectorXd q;               // (coordinates) [rad] or [m]
  std::vector<StoppedBy> stopped;  // of each coordinate
  std::vector<Overlap> overlaps;   // at the start; not empty: nothing was moved
  bool finished = false;           // nothing moves any more; false: overlaps or too many steps
  int steps = 0;
  int queries = 0;  // distances searched for
};

/// Moves every drive at its speed. A coordinate stops at its limit, or when a link that it moves
/// touches something and would go into it; what the others of its drive do then is Drive::coupled.
///
/// Time goes by conservative advancement: every gap is known from below, no point moves farther in
/// a step than the gaps allow, and only gaps that are used up are measured again. So no link passes
/// through anything, however thin, and a gap at contact is within (0, accuracy].
///
/// Neighbouring links, and links in each other at the start, do not stop each other.
/// @param q  where it starts (coordinates)
/// @throws InputError if q has the wrong length, is not finite or out of limits.
/// Source: [MirtichCanny1995] for conservative advancement, [Miller2004] for auto-grasp.
ClosedHand close_hand(const TouchingHand& hand, const Pose<double>& X_WH, const Eigen::VectorXd& q,
                      const Scene& scene, const CloseOptions& options = {});

/// Throws InputError unless q is a posture of the hand within its limits (to 1e-9).
void require_start(const Hand& hand, const Eigen::VectorXd& q);

}  // namespace thenar
