#pragma once

/// Contact as recorded in the samples of a simulation.

#include <array>

#include <Eigen/Core>

#include "base/enum_names.h"

namespace thenar {

/// Motion of a contact or joint limit during a step, whether it has a force or not.
enum class ContactMode {
  kOpen,   // opens
  kStick,  // neither opens nor slips
  kSlide   // slips
};
/// Names of contact modes, in the order of their numbers in files.
inline constexpr std::array kContactModeNames{EnumName{ContactMode::kOpen, "open"},
                                              EnumName{ContactMode::kStick, "stick"},
                                              EnumName{ContactMode::kSlide, "slide"}};

/// Contact at an instant: a point, or the patch of a pad.
struct ContactSample {
  int a = 0, b = 0, id = 0;         // bodies, a < b, and number of the point
  Eigen::Vector3d point{0, 0, 0};   // contact point or a pad's centre of pressure, world [m] (3)
  Eigen::Vector3d normal{0, 0, 1};  // unit normal out of b, world (3)
  Eigen::Vector3d force{0, 0, 0};   // force on a, world [N] (3)
  double torsion = 0;               // torque on a about the normal [N m]
  double gap = 0;                   // gap, negative if they overlap [m]
  ContactMode mode = ContactMode::kOpen;
  double area = 0;   // area of a pad's patch; 0: a point [m^2]
  double stick = 0;  // share of a pad's normal force where it sticks [1]
};

}  // namespace thenar
