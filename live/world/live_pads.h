#pragma once

/// Soft pads of a hand on an object in a live world: pressure over each contact patch, and its
/// sticking part.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "live/world/live_quality.h"

namespace thenar {

/// Spring of a pad that is in contact.
struct PadPoint {
  Eigen::Vector3d p{0, 0, 0};  // position of its piece of skin, world [m] (3)
  double pressure = 0;         // contact pressure [Pa]
  bool sticks = true;          // false: it slips on the object
};

/// Pad that is pressed against an object.
struct LoadedPad {
  std::string link;  // surface of the hand
  std::string material;
  double force = 0;       // normal force [N]
  double tangential = 0;  // part of the object's weight that the pad carries by friction [N]
  double depth = 0;       // depth of the press beyond the current pose [m]
  double area = 0;        // contact area [m^2]
  double stick = 1;       // normal force on sticking springs over the normal force [1]
  std::vector<PadPoint> points;
};

/// All pads of a hand on an object.
struct LivePads {
  std::vector<LoadedPad> pads;
  std::vector<std::string> reasons;  // reasons why a patch has no pad or no tangential load
};

/// Presses every contact patch with the same normal force, on a bed of springs under the skin of
/// its link (FoundationBed). The springs are those of Material::bed, or follow from Young's modulus
/// and the layer thickness, with a third of that modulus as shear modulus. The object's weight
/// loads the pads tangentially, distributed as the minimum contact forces that hold it by friction
/// (minimum_grasp_force()); share_shear() finds the springs that slip. The hand does not move, and
/// pads do not interact.
/// @param force  normal force on each patch, > 0 [N]
/// @throws InputError as current_contacts(), or for a force that is not positive
[[nodiscard]] LivePads press_pads(const LiveWorld& live, const LivePair& pair, double force);

}  // namespace thenar
