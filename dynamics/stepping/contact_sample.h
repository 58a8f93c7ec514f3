#pragma once

/// Contacts at an instant, as runs keep them.

#include <array>

#include <Eigen/Core>

#include "base/enum_names.h"

namespace thenar {

/// Motion of a contact or a joint limit during a step, with or without a force.
enum class ContactMode {
  kOpen,   // it opens
  kStick,  // it neither opens nor slips
  kSlide   // it slips
};
/// In the order of the numbers in files.
inline constexpr std::array kContactModeNames{EnumName{ContactMode::kOpen, "open"},
                                              EnumName{ContactMode::kStick, "stick"},
                                              EnumName{ContactMode::kSlide, "slide"}};

/// One contact at an instant: a point, or the patch of a pad.
struct ContactSample {
  int a = 0, b = 0, id = 0;         // bodies, a < b, and the point
  Eigen::Vector3d point{0, 0, 0};   // world; of a pad the centre of pressure [m] (3)
  Eigen::Vector3d normal{0, 0, 1};  // outward of b (3)
  Eigen::Vector3d force{0, 0, 0};   // on a [N] (3)
  double torsion = 0;               // about the normal [N m]
  double gap = 0;                   // [m]
  ContactMode mode = ContactMode::kOpen;
  double area = 0;   // of the patch of a pad; 0: a point [m^2]
  double stick = 0;  // of a pad: share of the normal force on what sticks [1]
};

}  // namespace thenar
