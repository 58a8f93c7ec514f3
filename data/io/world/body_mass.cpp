#include "data/io/world/body_mass.h"

#include <algorithm>

#include "base/error.h"
#include "base/shapes/mesh_parts.h"
#include "base/shapes/shape_mass.h"
#include "base/shapes/solid.h"

namespace thenar {
namespace {

constexpr int kCells = 96;  // along the longest side

bool has_closed_form(const BodySpec& body) {
  if (body.shapes.size() != 1) return false;
  const ShapeSpec& shape = body.shapes[0];
  if (shape.kind == ShapeKind::kMesh) return connected_parts(shape.mesh).size() == 1;
  return shape.kind != ShapeKind::kTaperedCapsule && shape.kind != ShapeKind::kSuperellipsoid;
}

/// Moments of a solid, cell by cell.
class Sum {
 public:
  void add(const Eigen::Vector3d& p, double volume) {
    volume_ += volume;
    first_ += volume * p;
    second_ += volume * p * p.transpose();
  }

  /// At density 1 kg/m^3. @param cell  its edge [m]: every cell turns about its own middle, too
  [[nodiscard]] BodyMass mass(double cell) const {
    const Eigen::Vector3d com = first_ / volume_;
    const Eigen::Matrix3d second = second_ - volume_ * com * com.transpose() +
                                   volume_ * cell * cell / 12 * Eigen::Matrix3d::Identity();
    return {volume_, com, second.trace() * Eigen::Matrix3d::Identity() - second};
  }
  [[nodiscard]] bool empty() const { return !(volume_ > 0); }

 private:
  double volume_ = 0;
  Eigen::Vector3d first_{0, 0, 0};
  Eigen::Matrix3d second_ = Eigen::Matrix3d::Zero();
};

BodyMass summed(const BodySpec& body) {
  const Solid solid = build_solid(body.shapes);
  const Eigen::AlignedBox3d box = solid.shape->bounds();
  const double cell = box.sizes().maxCoeff() / kCells;
  const Eigen::Array3i count = (box.sizes().array() / cell).ceil().cast<int>() + 2;
  const Eigen::Vector3d first = box.center() - 0.5 * cell * (count.cast<double>() - 1).matrix();
  Sum sum;
  for (int i = 0; i < count.x(); ++i)
    for (int j = 0; j < count.y(); ++j)
      for (int k = 0; k < count.z(); ++k) {
        const Eigen::Vector3d p = first + cell * Eigen::Vector3d(i, j, k);
        const double filled = std::clamp(0.5 - solid.shape->distance(p) / cell, 0.0, 1.0);
        if (filled > 0) sum.add(p, filled * cell * cell * cell);
      }
  require(!sum.empty(), "the shapes of body '{}' enclose nothing", body.name);
  return sum.mass(cell);
}

BodyMass at_unit_density(const BodySpec& body) {
  if (!has_closed_form(body)) return summed(body);
  const MassProperties exact = mass_at_unit_density(body.shapes[0]);
  if (!(exact.mass > 0)) return summed(body);  // which says why there is no solid
  return {exact.mass, exact.centre, exact.inertia};
}

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
  BodyMass result = at_unit_density(body);
  const double density = density_of(body, result.mass, materials);
  result.mass *= density;
  result.inertia *= density;
  return result;
}

}  // namespace thenar
