#pragma once

/// Couplings of the joints that one drive moves.

#include <array>

#include "base/enum_names.h"

namespace thenar {

/// Motion of a drive's other joints when a contact blocks one of them.
enum class DriveCoupling {
  kRigid,      // gears: all stop
  kBreakaway,  // a clutch: a joint blocked beyond `breakaway` stops, more distal ones continue
  kCompliant   // springs, tendons or an adaptive linkage: all others continue
};
inline constexpr std::array kDriveCouplingNames{EnumName{DriveCoupling::kRigid, "rigid"},
                                                EnumName{DriveCoupling::kBreakaway, "breakaway"},
                                                EnumName{DriveCoupling::kCompliant, "compliant"}};

}  // namespace thenar
