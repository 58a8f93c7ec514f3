#pragma once

/// What a grasp says in words: what touches what, what stopped a coordinate, where a wrench points.

#include <string>
#include <vector>

#include "grasp/closing/grasp.h"

namespace thenar {

/// A surface of a hand at something.
struct Touching {
  int surface;             // of Hand::surfaces()
  std::string other;       // body of the scene, or surface of the hand
  double gap;              // [m]
  int other_surface = -1;  // of the hand; -1: a body
};

/// Everything a posed hand touches, itself included; links of it that overlap by design are not
/// meant. @param within  what still touches [m]
[[nodiscard]] std::vector<Touching> find_touching(const PosedCollisionHand& posed,
                                                  const Scene& scene, double within);

/// What stopped every coordinate: "at its upper limit", "contact: DP2 on can",
/// "coupled with one that is stopped", "nothing drives it", "free".
[[nodiscard]] std::vector<std::string> stop_words(const CollisionHand& hand,
                                                  const ClosedHand& closed,
                                                  const std::vector<Touching>& touching);

/// Whether a coordinate slides rather than turns. @param q  where it is looked at (coordinates)
[[nodiscard]] bool slides(const Hand& hand, const Eigen::VectorXd& q, int coordinate);

/// A coordinate in degrees or millimetres: "31.5 deg", "12.00 mm".
[[nodiscard]] std::string value_words(double value, bool slides);

/// The large parts of a direction: "force along -z, torque about +x". Parts below a third of the
/// largest are left out.
[[nodiscard]] std::string direction_words(const ScaledWrench& wrench);

/// The same of a motion: "along -z, turning about +x".
[[nodiscard]] std::string motion_words(const ScaledWrench& motion);

/// An epsilon as it is shown: 0 where it is within 1e-9, to which epsilon() is exact, and never -0.
[[nodiscard]] double without_rounding(double epsilon);

/// "grasped: 12 contacts, force closure", "overlaps: DP2 is 3.2 mm in table"...
[[nodiscard]] std::string outcome_words(const Grasp& grasp);

/// "DP2 is 3.2 mm in table, ..."
[[nodiscard]] std::string overlap_words(const std::vector<Overlap>& overlaps);

/// A warning about links of the hand that begin in each other, so that they do not stop each other;
/// empty where none do.
[[nodiscard]] std::string own_overlap_words(const ClosedHand& closed);

}  // namespace thenar
