#include "grasp/grasp.h"

namespace thenar {
namespace {

std::vector<Contact> plain(const std::vector<HandContact>& contacts) {
  std::vector<Contact> plain;
  for (const HandContact& contact : contacts) plain.push_back(contact.contact);
  return plain;
}

Approached approach_or_stay(const TouchingHand& hand, const Pose<double>& X_WH,
                            const Eigen::VectorXd& q, const Scene& scene,
                            const GraspOptions& options) {
  if (options.way > 0) return approach(hand, X_WH, q, scene, options.way, options.close);
  Approached stayed;
  stayed.X_WH = X_WH;
  return stayed;
}

/// Why there is nothing to close on; kGrasped: there is.
GraspOutcome judge(const Approached& approached, const Scene& scene, double way) {
  if (!approached.overlaps.empty()) return GraspOutcome::kOverlaps;
  if (way <= 0) return GraspOutcome::kGrasped;
  if (!approached.touches) return GraspOutcome::kMissed;
  return approached.body == scene.object.name ? GraspOutcome::kGrasped : GraspOutcome::kBlocked;
}

GraspOutcome judge(const ClosedHand& closed) {
  if (!closed.overlaps.empty()) return GraspOutcome::kOverlaps;
  return closed.finished ? GraspOutcome::kGrasped : GraspOutcome::kTooLong;
}

/// Fills in the torsion of every contact of a surface with the object.
void soften(ContactPatches& patches, int surface, const PosedHand& posed, const Scene& scene,
            const PadOptions& pads) {
  const LinkSurface& link = posed.touching.hand->surfaces()[surface];
  const PadBody object{scene.object.solid, scene.materials.at(scene.object.material), {}};
  const PadBody pad{*link.solid, scene.materials.at(link.material),
                    scene.object.X_WB.inverse() * posed.of_surface(surface)};
  for (ContactPatch& patch : patches.patches) {
    const double torsion = torsion_of(patch, pad, object, pads);
    for (HandContact& contact : patch.contacts) contact.contact.torsion = torsion;
  }
}

}  // namespace

std::string name_of(GraspOutcome outcome) {
  switch (outcome) {
    case GraspOutcome::kGrasped:
      return "grasped";
    case GraspOutcome::kOverlaps:
      return "overlaps";
    case GraspOutcome::kMissed:
      return "missed";
    case GraspOutcome::kBlocked:
      return "blocked";
    case GraspOutcome::kTooLong:
      return "too long";
    case GraspOutcome::kEmpty:
      break;
  }
  return "empty";
}

std::vector<HandContact> find_contacts(const PosedHand& posed, const Scene& scene,
                                       const ContactPatchOptions& options, const PadOptions& pads) {
  std::vector<HandContact> contacts;
  for (int s = 0; s < static_cast<int>(posed.touching.touch.size()); ++s) {
    Gap gap{s, -1, &scene.object};
    if (ball_bound(gap, posed) > options.tolerance) continue;
    const LinkSurface& surface = posed.touching.hand->surfaces()[s];
    const double mu =
        scene.materials.between(surface.material, scene.object.material).static_coefficient;
    ContactPatches patches = contact_patches(posed.touching.touch[s], posed.of_surface(s),
                                             scene.object.solid, scene.object.X_WB, mu, options);
    if (pads.contact != ContactModel::kHardPoint) soften(patches, s, posed, scene, pads);
    const std::vector<HandContact> found = contacts_of(patches, s);
    contacts.insert(contacts.end(), found.begin(), found.end());
  }
  return contacts;
}

Grasp grasp(const TouchingHand& hand, const Pose<double>& X_WH, const Eigen::VectorXd& q,
            const Scene& scene, const GraspOptions& options) {
  Grasp done{};
  done.approached = approach_or_stay(hand, X_WH, q, scene, options);
  done.closed.q = q;
  done.outcome = judge(done.approached, scene, options.way);
  if (done.outcome != GraspOutcome::kGrasped) return done;
  done.closed = close_hand(hand, done.approached.X_WH, q, scene, options.close);
  done.outcome = judge(done.closed);
  if (done.outcome != GraspOutcome::kGrasped) return done;

  const PosedHand posed{hand, done.approached.X_WH, hand.hand->pose(done.closed.q)};
  done.contacts = find_contacts(posed, scene, options.patches, options.pads);
  if (done.contacts.empty()) done.outcome = GraspOutcome::kEmpty;
  done.quality = epsilon(wrench_set(plain(done.contacts), scene.object.com, scene.object.reach),
                         options.epsilon);
  return done;
}

}  // namespace thenar
