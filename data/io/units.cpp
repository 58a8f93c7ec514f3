#include "data/io/units.h"

#include <algorithm>
#include <iterator>

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

namespace {

struct DimensionRow {
  Dimension dimension;
  const char* name;
  double largest;  // [SI]
};
constexpr DimensionRow kDimensions[] = {
    {Dimension::kNumber, "a plain number", 1e12},  // as of contacts: beyond, no digit is left
    {Dimension::kLength, "a length", 100},         // way of a mobile base
    {Dimension::kAngle, "an angle", 1e9},          // joints without end, as other programs state it
    {Dimension::kMass, "a mass", 1e4},             // a mobile robot: 300 kg
    {Dimension::kForce, "a force", 1e9},    // drives without limit, as other programs state it
    {Dimension::kMoment, "a moment", 1e9},  // the same
    {Dimension::kArea, "an area", 1},  // physiological cross-section of a large muscle: 0.03 m2
    {Dimension::kInertia, "a moment of inertia", 1e5},
    {Dimension::kStress, "a stress", 1e13},  // Young's modulus of diamond: 1.2e12 Pa
    {Dimension::kAcceleration, "an acceleration", 1e4},
    {Dimension::kDensity, "a density", 1e5},  // osmium: 2.3e4 kg/m3
    {Dimension::kAngularStiffness, "an angular stiffness", 1e6},
    {Dimension::kAngularDamping, "an angular damping", 1e6},
    {Dimension::kLinearStiffness, "a stiffness", 1e12},
    {Dimension::kLinearDamping, "a damping", 1e12},
    {Dimension::kTime, "a time", 1e6},  // eleven days
    {Dimension::kSpeed, "a speed", 1e4},
    {Dimension::kAngularSpeed, "an angular speed", 1e6},   // of the fastest rotor
    {Dimension::kInverseSpeed, "an inverse speed", 1e6}};  // dissipation: contacts hardly close

const DimensionRow& row_of(Dimension dimension) {
  return *std::find_if(std::begin(kDimensions), std::end(kDimensions),
                       [&](const DimensionRow& row) { return row.dimension == dimension; });
}

}  // namespace

std::string dimension_name(Dimension dimension) { return row_of(dimension).name; }

double largest_of(Dimension dimension) { return row_of(dimension).largest; }

}  // namespace thenar
