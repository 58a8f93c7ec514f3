#pragma once

/// Kinds of joints of moving scenes.

#include <array>

#include "base/enum_names.h"

namespace thenar {

/// Motion of a body relative to its parent.
enum class JointKind {
  kWeld,   // no motion
  kHinge,  // turns about z of the joint's frames
  kSlide,  // slides along z of the joint's frames
  kBall,   // turns about any axis through the origins of the joint's frames
  kFree    // moves without constraint
};
inline constexpr std::array kJointKindNames{
    EnumName{JointKind::kWeld, "weld"}, EnumName{JointKind::kHinge, "hinge"},
    EnumName{JointKind::kSlide, "slide"}, EnumName{JointKind::kBall, "ball"},
    EnumName{JointKind::kFree, "free"}};

}  // namespace thenar
