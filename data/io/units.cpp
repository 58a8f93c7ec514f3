#include "data/io/units.h"

#include "base/units.h"

namespace thenar {
const std::vector<Unit>& all_units() {
  static const std::vector<Unit> units{
      {"", Dimension::kNumber, 1},
      {"mm", Dimension::kLength, 1e-3},
      {"cm", Dimension::kLength, 1e-2},
      {"m", Dimension::kLength, 1},
      {"deg", Dimension::kAngle, kDegree},
      {"rad", Dimension::kAngle, 1},
      {"g", Dimension::kMass, 1e-3},
      {"kg", Dimension::kMass, 1},
      {"N", Dimension::kForce, 1},
      {"Nmm", Dimension::kMoment, 1e-3},
      {"Nm", Dimension::kMoment, 1},
      {"mm2", Dimension::kArea, 1e-6},
      {"cm2", Dimension::kArea, 1e-4},
      {"m2", Dimension::kArea, 1},
      {"g_mm2", Dimension::kInertia, 1e-9},
      {"kg_m2", Dimension::kInertia, 1},
      {"N_cm2", Dimension::kStress, 1e4},
      {"MPa", Dimension::kStress, 1e6},
      {"kPa", Dimension::kStress, 1e3},
      {"Pa", Dimension::kStress, 1},
      {"m_s2", Dimension::kAcceleration, 1},
      {"g_cm3", Dimension::kDensity, 1e3},
      {"kg_m3", Dimension::kDensity, 1},
      {"Nm_per_rad", Dimension::kAngularStiffness, 1},
      {"Nmm_per_rad", Dimension::kAngularStiffness, 1e-3},
      {"Nm_per_deg", Dimension::kAngularStiffness, 1 / kDegree},
      {"Nmm_per_deg", Dimension::kAngularStiffness, 1e-3 / kDegree},
      {"Nms_per_rad", Dimension::kAngularDamping, 1},
      {"Nmms_per_rad", Dimension::kAngularDamping, 1e-3},
      {"N_per_m", Dimension::kLinearStiffness, 1},
      {"N_per_mm", Dimension::kLinearStiffness, 1e3},
      {"Ns_per_m", Dimension::kLinearDamping, 1},
      {"ms", Dimension::kTime, 1e-3},
      {"s", Dimension::kTime, 1},
      {"mm_s", Dimension::kSpeed, 1e-3},
      {"m_s", Dimension::kSpeed, 1},
      {"deg_s", Dimension::kAngularSpeed, kDegree},
      {"rad_s", Dimension::kAngularSpeed, 1},
      {"s_per_m", Dimension::kInverseSpeed, 1},
  };
  return units;
}

std::vector<Unit> units_of(Dimension dimension) {
  std::vector<Unit> found;
  for (const Unit& unit : all_units())
    if (unit.dimension == dimension) found.push_back(unit);
  return found;
}

std::string dimension_name(Dimension dimension) {
  switch (dimension) {
    case Dimension::kNumber:
      return "a plain number";
    case Dimension::kLength:
      return "a length";
    case Dimension::kAngle:
      return "an angle";
    case Dimension::kMass:
      return "a mass";
    case Dimension::kForce:
      return "a force";
    case Dimension::kMoment:
      return "a moment";
    case Dimension::kArea:
      return "an area";
    case Dimension::kInertia:
      return "a moment of inertia";
    case Dimension::kStress:
      return "a stress";
    case Dimension::kAcceleration:
      return "an acceleration";
    case Dimension::kDensity:
      return "a density";
    case Dimension::kAngularStiffness:
      return "an angular stiffness";
    case Dimension::kAngularDamping:
      return "an angular damping";
    case Dimension::kLinearStiffness:
      return "a stiffness";
    case Dimension::kLinearDamping:
      return "a damping";
    case Dimension::kTime:
      return "a time";
    case Dimension::kSpeed:
      return "a speed";
    case Dimension::kAngularSpeed:
      return "an angular speed";
    case Dimension::kInverseSpeed:
      break;
  }
  return "an inverse speed";
}

}  // namespace thenar
