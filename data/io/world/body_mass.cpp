#include "data/io/world/body_mass.h"

#include "base/error.h"
#include "geometry/union_mass.h"

namespace thenar {
namespace {

/// What its mass at unit density is multiplied by. @param volume  [m^3]
double density_of(const BodySpec& body, double volume, const Materials& materials) {
  if (body.spread_mass > 0) return body.spread_mass / volume;
  const double density = body.density > 0 || body.material.empty()
                             ? body.density
                             : materials.at(body.material).density;
  require(density > 0,
          "body '{}' has neither mass nor density, nor has its material '{}': state mass_g or "
          "density_kg_m3 beside its shapes, in its object file or its [[body]] of the world",
          body.name, body.material);
  return density;
}

}  // namespace

BodyMass body_mass(const BodySpec& body, const Materials& materials) {
  if (body.mass) return *body.mass;
  constexpr double kKnown = 0.01;  // of the volume: coarser is no mass to grasp with
  const UnionMass found = union_mass(body.shapes);
  const MassProperties& even = found.mass;
  require(even.mass > 0, "the shapes of body '{}' enclose nothing", body.name);
  require(found.error <= kKnown,
          "the volume of body '{}' is known to {:.0f} % only, so many of its parts overlap: state "
          "mass, com and inertia, or join the parts into one surface",
          body.name, 100 * found.error);
  BodyMass result{even.mass, even.centre, even.inertia};
  const double density = density_of(body, result.mass, materials);
  result.mass *= density;
  result.inertia *= density;
  return result;
}

}  // namespace thenar
