#pragma once

/// What soft pads add to contacts: torsion, and springs.

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

/// What a contact is taken for.
struct PadOptions {
  ContactModel contact = ContactModel::kHardPoint;  // or kSoftFinger
  double force = 1;    // normal force of a soft contact, for the size of its patch [N]
  double step = 3e-3;  // over which curvatures are taken: about a patch [m]
};

/// One of two bodies at a contact.
struct PadBody {
  const Solid& solid;
  const Material& material;
  Pose<double> X_OB;  // its solid's frame in that of the contacts
};

/// The layer that gives way where two materials meet, of least young / thickness; null: neither has
/// one.
[[nodiscard]] const Material* softer_layer(const Material& a, const Material& b);

/// Torsion of each point of a patch [m]: of winkler_patch() in the softer layer (least young /
/// thickness), with the radii of the gap between both surfaces at the middle of the patch; 0 of
/// hard points, and where neither body has a layer.
///
/// Torque per force needs a force, as patches grow with it: torsion goes with force^(1/4), so that
/// 5 N hold 1.5 times as much per newton as 1 N. The layer is not pressed beyond its thickness or
/// half the smaller radius, and no radius is beyond 0.1 m, by convention.
///
/// Points of one patch resist torsion by themselves, by friction times their mean distance from
/// their middle: each gets what is left of the torsion after that, as facets of a round pad make a
/// few points where it makes one. Nothing is left of flat faces and of lines (a radius beyond
/// 0.1 m), whose extent is what their points show.
/// @throws InputError if the model is neither kHardPoint nor kSoftFinger, or the force or the step
/// is not positive and finite.
[[nodiscard]] double torsion_of(const ContactPatch& patch, const PadBody& a, const PadBody& b,
                                const PadOptions& options);

/// Springs of the pad at each point of a patch, pressed by `options.force` in all; nothing where
/// neither body has a layer. Of winkler_patch() with semi-axes a, b, gap and layer as torsion_of()
/// has them, Young's modulus E and thickness h, the whole patch has
///   normal  k_n = E / h pi a b,  tangential  k_t = k_n / 3,  twisting  k_t (a^2 + b^2) / 4,
/// the springs under it, each with the shear modulus E / 3 of what keeps its volume along the
/// tangents; k_n is the slope of force over depth. Several points share the first two and twist by
/// their distance alone. That a patch also resists being rocked about its tangents, by k_n a^2 / 4,
/// is left out of one point, as contacts bear no such torque.
/// `options.contact` is not asked: hard points on soft pads have the springs of these.
/// @throws InputError if the force or the step is not positive and finite, or the patch is empty.
/// Source: [Cutkosky1989] for springs of fingertips, [Johnson1985] section 4.3 for the layer.
[[nodiscard]] std::optional<PadStiffness> pad_stiffness(const ContactPatch& patch, const PadBody& a,
                                                        const PadBody& b,
                                                        const PadOptions& options = {});

/// Contacts that follow each other, patch by patch: those of one number, or without numbers those
/// of one surface that press in directions within 30 degrees. Only contacts and normals are filled
/// in.
[[nodiscard]] std::vector<ContactPatch> patches_of(const std::vector<HandContact>& contacts);

}  // namespace thenar
