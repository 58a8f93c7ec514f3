#include "grasp/closing/grasp.h"

#include <algorithm>

#include "base/error.h"
#include "grasp/closing/fingertip_paths.h"

namespace thenar {
namespace {

/// Moves the hand back by a fraction of max_stand_off(), at most by the distance of its approach.
void retreat(ApproachResult& approached, const CollisionHand& hand, const Pose<double>& X_WH,
             const Eigen::VectorXd& q, const GraspBody& object, double fraction) {
  const Eigen::Vector3d direction = X_WH.R * hand.hand->layout().approach.direction;
  const double travelled = direction.dot(approached.X_WH.p - X_WH.p);
  const double back = fraction * max_stand_off(hand, approached.X_WH, q, object);
  approached.X_WH.p -= std::min(back, travelled) * direction;
}

/// Approaches with sidesteps and a final retreat; without an approach distance the hand stays.
ApproachResult approach_or_stay(const CollisionHand& hand, const Pose<double>& X_WH,
                                const Eigen::VectorXd& q, const GraspSetup& setup,
                                const GraspOptions& options) {
  ApproachResult approached;
  approached.X_WH = X_WH;
  if (options.approach_distance <= 0) return approached;
  // Digits that meet the object step aside.
  approached = yielding_approach(
      hand, X_WH, q, setup,
      {options.approach_distance, options.side_step * setup.object.torque_scale}, options.close);
  if (options.stand_off > 0 && approached.touches && approached.body == setup.object.name)
    retreat(approached, hand, X_WH, q, setup.object, options.stand_off);
  return approached;
}

/// Returns the outcome of the approach; kGrasped: the hand may close.
GraspOutcome outcome_of(const ApproachResult& approached, double distance) {
  if (!approached.overlaps.empty()) return GraspOutcome::kOverlaps;
  return distance <= 0 || approached.touches ? GraspOutcome::kGrasped : GraspOutcome::kMissed;
}

/// Returns the outcome of closing; kGrasped: it ended.
GraspOutcome outcome_of(const ClosedHand& closed) {
  if (!closed.overlaps.empty()) return GraspOutcome::kOverlaps;
  return closed.finished ? GraspOutcome::kGrasped : GraspOutcome::kTooLong;
}

/// Returns the outcome of a closed hand that touches nothing.
GraspOutcome outcome_without_contact(const ApproachResult& approached, const GraspSetup& setup) {
  const bool blocked = approached.touches && approached.body != setup.object.name;
  return blocked ? GraspOutcome::kBlocked : GraspOutcome::kEmpty;
}

/// Sets the torsion of every contact of a patch with the object.
void set_torsion(ContactPatch& patch, const PosedCollisionHand& posed, const GraspSetup& setup,
                 const PadOptions& pads) {
  const int surface = patch.contacts[0].surface;
  const LinkSurface& link = posed.collision_hand.hand->surfaces()[surface];
  const PadBody object{setup.object.solid, setup.materials.at(setup.object.material), {}};
  const PadBody pad{*link.solid, setup.materials.at(link.material),
                    setup.object.X_WB.inverse() * posed.surface_pose(surface)};
  const double torsion = patch_torsion(patch, pad, object, pads);
  for (HandContact& contact : patch.contacts) contact.contact.torsion = torsion;
}

/// Adds a patch, merged with adjacent patches of its link: a link of several parts must not exert
/// more force in one place than a link of one part.
// NOLINTNEXTLINE(misc-no-recursion): one patch fewer in each call
void add_patch(std::vector<ContactPatch>& patches, ContactPatch patch, const CollisionHand& hand,
               const ContactPatchOptions& options) {
  const auto link_of = [&](const ContactPatch& each) {
    return hand.hand->surfaces()[each.contacts[0].surface].link;
  };
  // Only patches of different surfaces of one link can be merged.
  for (std::size_t i = 0; i < patches.size(); ++i) {
    if (patches[i].contacts[0].surface == patch.contacts[0].surface ||
        link_of(patches[i]) != link_of(patch))
      continue;
    const std::optional<ContactPatch> one = merge_patches(patches[i], patch, options);
    if (!one) continue;
    patches.erase(patches.begin() + i);
    return add_patch(patches, *one, hand, options);
  }
  patches.push_back(std::move(patch));
}

}  // namespace

double max_stand_off(const CollisionHand& hand, const Pose<double>& X_WH, const Eigen::VectorXd& q,
                     const GraspBody& object) {
  const PalmApproach& approach = hand.hand->layout().approach;
  // Extent of the object along the closing axis.
  const FingertipPaths paths = fingertip_paths(*hand.hand, q);
  const Eigen::RowVectorXd along =
      (object.X_WB.R.transpose() * X_WH.R * paths.axis).transpose() * object.solid.visual.vertices;
  // Distance of the tips ahead of the palm when they are that near, less that of the object's
  // centre.
  const Eigen::Vector3d centre = X_WH.inverse() * (object.X_WB * object.com) - approach.point;
  const double advance = mean_tip_advance(paths, approach, along.maxCoeff() - along.minCoeff());
  return std::max(0.0, advance - approach.direction.dot(centre));
}

std::vector<HandContact> find_contacts(const PosedCollisionHand& posed, const GraspSetup& setup,
                                       const ContactPatchOptions& options, const PadOptions& pads) {
  std::vector<ContactPatch> patches;
  // Patches of every surface near the object, with the friction of the two materials.
  for (int s = 0; s < static_cast<int>(posed.collision_hand.trees.size()); ++s) {
    Clearance clearance{s, -1, &setup.object};
    if (bounding_ball_clearance(clearance, posed) > options.tolerance) continue;
    const LinkSurface& surface = posed.collision_hand.hand->surfaces()[s];
    const double mu =
        setup.materials.between(surface.material, setup.object.material).static_coefficient;
    ContactPatches found = contact_patches(posed.collision_hand.trees[s], posed.surface_pose(s),
                                           setup.object.solid, setup.object.X_WB, mu, options);
    for (ContactPatch& patch : found.patches) {
      for (HandContact& contact : patch.contacts) contact.surface = s;
      add_patch(patches, std::move(patch), posed.collision_hand, options);
    }
  }
  // Soft fingers have torsion.
  if (pads.contact != ContactModel::kHardPoint)
    for (ContactPatch& patch : patches) set_torsion(patch, posed, setup, pads);
  return number_patch_contacts(patches);
}

Grasp grasp(const CollisionHand& hand, const Pose<double>& X_WH, const Eigen::VectorXd& q,
            const GraspSetup& setup, const GraspOptions& options) {
  require(options.stand_off >= 0 && options.stand_off <= 1,
          "the stand-off of a grasp is a share of 0 .. 1, got {}", options.stand_off);
  Grasp result{};
  // Approach the object.
  result.approached = approach_or_stay(hand, X_WH, q, setup, options);
  result.closed.q = q;
  result.outcome = outcome_of(result.approached, options.approach_distance);
  if (result.outcome != GraspOutcome::kGrasped) return result;
  // Close the hand.
  result.closed = close_hand(hand, result.approached.X_WH, q, setup, options.close);
  result.outcome = outcome_of(result.closed);
  if (result.outcome != GraspOutcome::kGrasped) return result;

  // Find the contacts, and their quality about the object's centre of mass.
  const PosedCollisionHand posed{hand, result.approached.X_WH, hand.hand->pose(result.closed.q)};
  result.contacts = find_contacts(posed, setup, options.patches, options.pads);
  if (result.contacts.empty()) result.outcome = outcome_without_contact(result.approached, setup);
  result.quality = epsilon(wrench_set(contacts_without_hand(result.contacts), setup.object.com,
                                      setup.object.torque_scale),
                           options.epsilon);
  return result;
}

}  // namespace thenar
