#include "grasp/contact/soft_pads.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/units.h"
#include "geometry/collision/curvature.h"
#include "pad_laws/contact_law.h"
#include "pad_laws/soft_patch.h"

namespace thenar {
namespace {

constexpr double kMinGapCurvature = 10;  // curvature of a gap, that of a ball of 0.1 m [1/m]
// Shear modulus over Young's modulus of an incompressible layer [1]
constexpr double kShearRatio = 1.0 / 3;
// Minimum cosine between normals of one patch, as in contact_patches() [1]
const double kMinPatchCosine = std::cos(30 * kDegree);

bool is_soft(const Material& material) {
  return material.young > 0 && material.layer_thickness > 0;
}

Eigen::Vector3d centroid(const ContactPatch& patch) {
  Eigen::Vector3d sum(0, 0, 0);
  for (const HandContact& each : patch.contacts) sum += each.contact.p;
  return sum / static_cast<double>(patch.contacts.size());
}

/// Returns the mean distance of the points from their centroid [m].
double mean_arm(const ContactPatch& patch) {
  const Eigen::Vector3d centre = centroid(patch);
  double sum = 0;
  for (const HandContact& each : patch.contacts) sum += (each.contact.p - centre).norm();
  return sum / static_cast<double>(patch.contacts.size());
}

/// Computes curvatures where the surface is nearest to p, in the frame of the contacts.
PrincipalCurvatures curvatures_at(const PadBody& body, const Eigen::Vector3d& p_O, double step) {
  const Eigen::Vector3d p = body.X_OB.inverse() * p_O;
  const NearestSurface near = body.solid.shape->nearest(p);
  // Curvatures at the surface point nearest to p.
  PrincipalCurvatures found = curvatures(*body.solid.shape, p - near.distance * near.normal, step);
  found.d1 = body.X_OB.R * found.d1;
  return found;
}

/// Computes the relative curvatures of two bodies at p.
RelativeCurvatures gap_at(const Eigen::Vector3d& p, const PadBody& a, const PadBody& b,
                          double step) {
  const PrincipalCurvatures on_a = curvatures_at(a, p, step);
  const PrincipalCurvatures on_b = curvatures_at(b, p, step);
  const double angle = std::acos(std::min(1.0, std::abs(on_a.d1.dot(on_b.d1))));
  return relative_curvatures(on_a, on_b, angle);
}

/// Computes the patch of a Winkler layer, compressed at most to its thickness and to half the
/// smaller radius.
SoftPatch spring_patch(const Material& layer, const RelativeCurvatures& gap, double friction,
                       double force) {
  const double R1 = 1 / std::max(kMinGapCurvature, gap.k1),
               R2 = 1 / std::max(kMinGapCurvature, gap.k2);
  const auto pressed = [&](double load) {
    return winkler_patch(load, layer.young, layer.layer_thickness, R1, R2, friction);
  };
  // Beyond the maximum depth, use the force that just reaches it.
  const SoftPatch patch = pressed(force);
  const double max_depth = std::min(layer.layer_thickness, std::min(R1, R2) / 2);
  if (patch.depth <= max_depth) return patch;
  return pressed(force *
                 std::pow(max_depth / patch.depth, 2));  // depth is proportional to its root
}

/// Patch of a layer, and its stiffness d force / d depth [N/m].
struct PressedLayer {
  SoftPatch patch;
  double stiffness;
};
PressedLayer pressed_layer(const Material& layer, const RelativeCurvatures& gap, double friction,
                           double force) {
  if (layer.law != nullptr) {
    const LawContact contact = layer.law->at_force(gap, force, friction);
    return {contact.patch, contact.stiffness};
  }
  // Winkler foundation under the ellipse.
  const SoftPatch patch = spring_patch(layer, gap, friction, force);
  return {patch, layer.young / layer.layer_thickness * kPi * patch.a * patch.b};
}

void check(const PadOptions& options) {
  require(options.force > 0 && options.step > 0 && std::isfinite(options.force + options.step),
          "force and step of soft contacts must be positive and finite, got {} N and {} m",
          options.force, options.step);
}

}  // namespace

const Material* softer_layer(const Material& a, const Material& b) {
  if (!is_soft(a)) return is_soft(b) ? &b : nullptr;
  if (!is_soft(b)) return &a;
  return a.young * b.layer_thickness <= b.young * a.layer_thickness ? &a : &b;
}

double patch_torsion(const ContactPatch& patch, const PadBody& a, const PadBody& b,
                     const PadOptions& options) {
  require(
      options.contact == ContactModel::kHardPoint || options.contact == ContactModel::kSoftFinger,
      "contacts of grasps are hard points or soft fingers");
  check(options);
  const Material* layer = softer_layer(a.material, b.material);
  if (options.contact == ContactModel::kHardPoint || layer == nullptr || patch.contacts.empty())
    return 0;

  // Points represent the extent of line and face contacts, which have no elastic patch.
  const RelativeCurvatures gap = gap_at(centroid(patch), a, b, options.step);
  if (patch.contacts.size() > 1 && gap.k2 < kMinGapCurvature) return 0;
  const double friction = patch.contacts[0].contact.friction;
  // Each point gets the torsion that friction of separate points does not resist.
  const double torsion = pressed_layer(*layer, gap, friction, options.force).patch.torsion;
  return std::max(0.0, torsion - friction * mean_arm(patch));
}

std::optional<PadStiffness> pad_stiffness(const ContactPatch& patch, const PadBody& a,
                                          const PadBody& b, const PadOptions& options) {
  check(options);
  require(!patch.contacts.empty(), "a patch of no contacts has no springs");
  const Material* layer = softer_layer(a.material, b.material);
  if (layer == nullptr) return {};
  const RelativeCurvatures gap = gap_at(centroid(patch), a, b, options.step);
  const double friction = patch.contacts[0].contact.friction;
  // Springs of the whole patch, shared by its points.
  const auto [pressed, stiffness] = pressed_layer(*layer, gap, friction, options.force);
  const double normal = stiffness / static_cast<double>(patch.contacts.size());
  // The twist of a single point comes from shear springs over the ellipse.
  const double shear = kShearRatio * normal,
               arms = (pressed.a * pressed.a + pressed.b * pressed.b) / 4;
  const bool twists = patch.contacts.size() == 1 && arms > 0;  // a rigid point does not twist
  return PadStiffness{normal, shear, twists ? shear * arms : 0};
}

std::vector<ContactPatch> group_into_patches(const std::vector<HandContact>& contacts) {
  std::vector<ContactPatch> regions;
  // A contact continues the last patch if it has the same number, or the same surface and
  // direction.
  for (const HandContact& each : contacts) {
    const auto belongs = [&](const ContactPatch& region) {
      const HandContact& first = region.contacts[0];
      if (each.contact.patch >= 0 || first.contact.patch >= 0)
        return first.contact.patch == each.contact.patch;
      return first.surface == each.surface && region.normal.dot(each.contact.n) > kMinPatchCosine;
    };
    const bool continues = !regions.empty() && belongs(regions.back());
    if (!continues) regions.push_back({{}, 0, 0, each.contact.n});
    regions.back().contacts.push_back(each);
  }
  return regions;
}

}  // namespace thenar
