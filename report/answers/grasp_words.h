#pragma once

/// Words about a grasp: touching surfaces, and what stopped each coordinate.

#include <string>
#include <vector>

#include "grasp/closing/describe_grasp.h"

namespace thenar {

/// Surface of a hand that touches a body or another surface.
struct Touching {
  int surface;             // index in Hand::surfaces()
  std::string other;       // body of the setup, or surface of the hand
  double gap;              // [m]
  int other_surface = -1;  // other surface of the hand; -1: a body
};

/// Finds the bodies and own surfaces that a posed hand touches; links that overlap by design are
/// ignored. @param within  largest gap that counts as touching [m]
[[nodiscard]] std::vector<Touching> find_touching(const PosedCollisionHand& posed,
                                                  const GraspSetup& setup, double within);

/// Returns the reason why each coordinate stopped: "at its upper limit", "contact: DP2 on can",
/// "coupled with one that is stopped", "no closing drive moves it", "free".
[[nodiscard]] std::vector<std::string> stop_words(const CollisionHand& hand,
                                                  const ClosedHand& closed,
                                                  const std::vector<Touching>& touching);

/// Returns a coordinate in degrees or millimetres: "31.5 deg", "12.00 mm".
[[nodiscard]] std::string value_words(double value, bool slides);

/// Returns an epsilon for display: 0 if within 1e-9, the accuracy of epsilon(), and never -0.
[[nodiscard]] double epsilon_or_zero(double epsilon);

}  // namespace thenar
