#pragma once

/// Soft pads of a hand on an object in a live world: pressure over each patch, and the part of it
/// that sticks.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "live/world/live_quality.h"

namespace thenar {

/// A piece of skin that presses.
struct PadPoint {
  Eigen::Vector3d p{0, 0, 0};  // world [m] (3)
  double pressure = 0;         // [Pa]
  bool sticks = true;          // false: it slips on the object
};

/// A pad on an object.
struct PadOnObject {
  std::string link;  // surface of the hand
  std::string material;
  double force = 0;       // normal [N]
  double tangential = 0;  // that the pad bears of the object's weight [N]
  double depth = 0;       // by which the pad is pressed beyond where it stands [m]
  double area = 0;        // [m^2]
  double stick = 1;       // share of the normal force on what sticks [1]
  std::vector<PadPoint> points;
};

/// Springs of a patch that bear a load across it.
struct ShearShares {
  std::vector<bool> sticks;  // (springs)
  double borne = 0;          // the load, or all that friction bears [N]
};

/// Shares a load across a patch among its springs, which all go the same way d across:
///   sum of min(stiffness_i d, friction normal_i) = load.
/// Those at the limit slip, as in Cattaneo's and Mindlin's contact: a paraboloid of pressure of
/// radius a sticks within  a (1 - load / (friction N))^(1/4)  on even springs.
/// @param normal     forces, >= 0 [N] (springs);  @param stiffness  across, > 0 [N/m] (springs)
/// @param load       >= 0 [N]
[[nodiscard]] ShearShares share_shear(const Eigen::VectorXd& normal,
                                      const Eigen::VectorXd& stiffness, double friction,
                                      double load);

/// All pads of a hand on an object.
struct LivePads {
  std::vector<PadOnObject> pads;
  std::vector<std::string> reasons;  // why a patch has no pad, or no load across it
};

/// Presses every patch that touches by one force, on a bed of springs over the skin of its link
/// (FoundationBed): Material::bed, or plain springs of its young modulus and thickness, with a
/// third of that modulus across. Each pad bears its part of the object's weight across, in the
/// shares of the least forces that hold it by friction (minimum_grasp_force()): share_shear() tells
/// what slips. The hand is not moved, and pads do not feel each other.
/// @param force  normal, on each patch, > 0 [N]
/// @throws InputError as contacts_of(), or for a force that is not positive
[[nodiscard]] LivePads press_pads(const LiveWorld& live, const LivePair& pair, double force);

}  // namespace thenar
