#pragma once

/// Words about a grasp: touching surfaces, and what stopped each coordinate.

#include <string>
#include <vector>

#include "grasp/closing/describe_grasp.h"

namespace thenar {

/// A surface of a hand at something.
struct Touching {
  int surface;             // index in Hand::surfaces()
  std::string other;       // body of the setup, or surface of the hand
  double gap;              // [m]
  int other_surface = -1;  // other surface of the hand; -1: a body
};

/// Finds everything that a posed hand touches, itself included; links that overlap by design do not
/// count. @param within  what still touches [m]
[[nodiscard]] std::vector<Touching> find_touching(const PosedCollisionHand& posed,
                                                  const GraspSetup& setup, double within);

/// Returns the reason why each coordinate stopped: "at its upper limit", "contact: DP2 on can",
/// "coupled with one that is stopped", "nothing drives it", "free".
[[nodiscard]] std::vector<std::string> stop_words(const CollisionHand& hand,
                                                  const ClosedHand& closed,
                                                  const std::vector<Touching>& touching);

/// Returns a coordinate in degrees or millimetres: "31.5 deg", "12.00 mm".
[[nodiscard]] std::string value_words(double value, bool slides);

/// Returns an epsilon as it is shown: 0 where it is within 1e-9, to which epsilon() is exact, and
/// never -0.
[[nodiscard]] double without_rounding(double epsilon);

}  // namespace thenar
