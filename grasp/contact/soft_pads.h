#pragma once

/// Soft pads: the torsion and stiffness of their contacts.

#include <optional>

#include "base/fidelity.h"
#include "data/io/world/materials.h"
#include "grasp/contact/contact_patch.h"

namespace thenar {

/// Stiffness of a pad between fingertip and object. 0: no resistance; infinite: rigid, which
/// requires compliant joints.
struct PadStiffness {
  double normal = 0;      // [N/m]
  double tangential = 0;  // along each tangent [N/m]
  double twisting = 0;    // about the normal [N m/rad]
};

/// Contact model, and the load at which pads are linearised.
struct PadOptions {
  ContactModel contact = ContactModel::kHardPoint;  // kHardPoint or kSoftFinger
  double force = 1;    // normal force on a soft contact, which determines the size of its patch [N]
  double step = 3e-3;  // distance over which curvatures are measured: about the size of a patch [m]
};

/// One of two bodies at a contact. `solid` and `material` must outlive it.
struct PadBody {
  const Solid& solid;
  const Material& material;
  Pose<double> X_OB;  // frame of the solid in the frame of the contacts
};

/// Returns the material of the softer layer, with the smaller young / thickness; null if neither
/// material has a layer.
[[nodiscard]] const Material* softer_layer(const Material& a, const Material& b);

/// Computes the torsion of each point of a patch [m]: that of winkler_patch() in the softer layer,
/// with the relative radii of both surfaces at the middle of the patch; 0 for hard points, and
/// where neither body has a layer. For a material with a pad law (Material::law) the patch and
/// torsion come from that law at that force instead.
///
/// Torsion per force depends on the force, as patches grow with it, like force^(1/4): at 5 N it is
/// 1.5 times the value at 1 N. By convention a Winkler layer is not compressed beyond its thickness
/// or half the smaller radius, and no radius exceeds 0.1 m.
///
/// Several points of one patch resist torsion by friction times their mean distance from their
/// centroid. Each point gets the remaining torsion, so that a faceted round pad with a few points
/// resists as much as a smooth one with one point. The rest is 0 for flat faces and lines (a radius
/// beyond 0.1 m), whose extent their points represent.
/// @throws InputError if the model is neither kHardPoint nor kSoftFinger, or the force or the step
/// is not positive and finite.
[[nodiscard]] double patch_torsion(const ContactPatch& patch, const PadBody& a, const PadBody& b,
                                   const PadOptions& options);

/// Computes the springs of the pad at each point of a patch under a total normal force of
/// `options.force`; nothing if neither body has a layer. With the semi-axes a, b and the layer of
/// patch_torsion(), Young's modulus E and thickness h, the whole patch has
///   normal  k_n = E / h pi a b,  tangential  k_t = k_n / 3,  twisting  k_t (a^2 + b^2) / 4:
/// springs under the patch, each with the shear modulus E / 3 of an incompressible material along
/// the tangents; k_n is d force / d depth. For a material with a pad law, patch and k_n are those
/// of the law, and the rest follows from the same formulas. Several points share k_n and k_t, and
/// resist twist by their distance alone. A patch also resists rocking about its tangents, by k_n
/// a^2 / 4; this is neglected for single points, whose contacts transmit no such torque.
/// `options.contact` is ignored: hard points on soft pads have the same springs.
/// @throws InputError if the force or the step is not positive and finite, or the patch is empty.
/// Source: [Cutkosky1989] for springs of fingertips, [Johnson1985] section 4.3 for the layer.
[[nodiscard]] std::optional<PadStiffness> pad_stiffness(const ContactPatch& patch, const PadBody& a,
                                                        const PadBody& b,
                                                        const PadOptions& options = {});

/// Groups consecutive contacts into patches: by their patch number or, without numbers, by surface
/// and by normals within 30 degrees. Only contacts and normals of the patches are set.
[[nodiscard]] std::vector<ContactPatch> group_into_patches(
    const std::vector<HandContact>& contacts);

}  // namespace thenar
