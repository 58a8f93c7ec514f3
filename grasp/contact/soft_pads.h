#pragma once

/// Soft pads: torsion and stiffness that they give to contacts.

#include <optional>

#include "base/fidelity.h"
#include "data/io/world/materials.h"
#include "grasp/contact/contact_patch.h"

namespace thenar {

/// Springs of a pad between fingertip and object. 0: the pad gives no resistance; infinite: rigid,
/// which needs joints that yield.
struct PadStiffness {
  double normal = 0;      // [N/m]
  double tangential = 0;  // along both tangents [N/m]
  double twisting = 0;    // about the normal [N m/rad]
};

/// Contact model, and the load at which pads are linearised.
struct PadOptions {
  ContactModel contact = ContactModel::kHardPoint;  // or kSoftFinger
  double force = 1;    // normal force on a soft contact, for the size of its patch [N]
  double step = 3e-3;  // length over which curvatures are measured: about a patch [m]
};

/// One of two bodies at a contact. `solid` and `material` must outlive it.
struct PadBody {
  const Solid& solid;
  const Material& material;
  Pose<double> X_OB;  // its solid's frame in that of the contacts
};

/// The softer layer of two materials, with the smaller young / thickness; null if neither has a
/// layer.
[[nodiscard]] const Material* softer_layer(const Material& a, const Material& b);

/// Torsion of each point of a patch [m]: that of winkler_patch() in the softer layer, with the
/// relative radii of both surfaces at the middle of the patch; 0 for hard points, and where neither
/// body has a layer. A material with a law of its pad (Material::law) has the patch and torsion of
/// that law at that force in place of springs.
///
/// Torsion per force depends on the force, as patches grow with it, like force^(1/4): at 5 N it is
/// 1.5 times the value at 1 N. By convention a layer of springs is not pressed beyond its thickness
/// or half the smaller radius, and no radius exceeds 0.1 m.
///
/// Several points of one patch resist torsion already, by friction times their mean distance from
/// their middle. Each point gets the rest of the torsion, so that a faceted round pad with a few
/// points resists as much as a round one with one point. The rest is 0 for flat faces and lines (a
/// radius beyond 0.1 m), whose extent their points show.
/// @throws InputError if the model is neither kHardPoint nor kSoftFinger, or the force or the step
/// is not positive and finite.
[[nodiscard]] double torsion_of(const ContactPatch& patch, const PadBody& a, const PadBody& b,
                                const PadOptions& options);

/// Springs of the pad at each point of a patch that is pressed by `options.force` in all; nothing
/// if neither body has a layer. With the semi-axes a, b and the layer of torsion_of(), Young's
/// modulus E and thickness h, the whole patch has
///   normal  k_n = E / h pi a b,  tangential  k_t = k_n / 3,  twisting  k_t (a^2 + b^2) / 4:
/// springs under the patch, each with the shear modulus E / 3 of an incompressible material along
/// the tangents; k_n is d force / d depth. A material with a law has that law's patch and k_n, and
/// the rest by the same formulas. Several points share the first two and twist by their
/// distance alone. A patch also resists rocking about its tangents, by k_n a^2 / 4; this is left
/// out for single points, whose contacts bear no such torque. `options.contact` is ignored: hard
/// points on soft pads have the same springs.
/// @throws InputError if the force or the step is not positive and finite, or the patch is empty.
/// Source: [Cutkosky1989] for springs of fingertips, [Johnson1985] section 4.3 for the layer.
[[nodiscard]] std::optional<PadStiffness> pad_stiffness(const ContactPatch& patch, const PadBody& a,
                                                        const PadBody& b,
                                                        const PadOptions& options = {});

/// Groups consecutive contacts into patches: by their patch number, or without numbers by surface
/// and by normals within 30 degrees. Only contacts and normals of the patches are filled in.
[[nodiscard]] std::vector<ContactPatch> patches_of(const std::vector<HandContact>& contacts);

}  // namespace thenar
