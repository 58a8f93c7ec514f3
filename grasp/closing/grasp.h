#pragma once

/// Complete grasp: approach, closing, contacts, quality.

#include <array>
#include <string>
#include <vector>

#include "base/enum_names.h"
#include "grasp/closing/approach.h"
#include "grasp/closing/close_hand.h"
#include "grasp/closing/collision_hand.h"
#include "grasp/closing/setup.h"
#include "grasp/contact/contact_patch.h"
#include "grasp/contact/soft_pads.h"
#include "grasp/quality/epsilon.h"

namespace thenar {

/// Settings of grasp().
struct GraspOptions {
  double approach_distance =
      1;                 // maximum distance of the approach [m]; 0: the hand closes without one
  double side_step = 1;  // maximum sum of sidesteps, over the object's radius [1]
  double stand_off = 0;  // retreat before closing, over max_stand_off() [1]
  CloseOptions close;
  ContactPatchOptions patches;
  EpsilonOptions epsilon;
  PadOptions pads;  // contact model: hard points or soft fingers
};

/// Outcome of a grasp.
enum class GraspOutcome {
  kGrasped,   // there are contacts, and `quality` is valid
  kOverlaps,  // the hand overlaps something at the start: see approached.overlaps or
              // closed.overlaps
  kMissed,    // the approach ended without a contact
  kBlocked,   // the approach met an obstacle first, and the closed hand does not touch the object
  kTooLong,   // closing exceeded its maximum number of steps
  kEmpty      // the closed hand does not touch the object
};
inline constexpr std::array kGraspOutcomeNames{
    EnumName{GraspOutcome::kGrasped, "grasped"},  EnumName{GraspOutcome::kOverlaps, "overlaps"},
    EnumName{GraspOutcome::kMissed, "missed"},    EnumName{GraspOutcome::kBlocked, "blocked"},
    EnumName{GraspOutcome::kTooLong, "too long"}, EnumName{GraspOutcome::kEmpty, "empty"}};
[[nodiscard]] inline std::string name_of(GraspOutcome outcome) {
  return name_in(kGraspOutcomeNames, outcome);
}

/// Result of grasp().
struct [[nodiscard]] Grasp {
  GraspOutcome outcome;
  ApproachResult approached;
  ClosedHand closed;
  std::vector<HandContact> contacts;  // in the object's frame
  Epsilon quality;  // about the centre of mass, torques divided by the object's radius
};

/// Finds the contacts of a posed hand with the object, patch by patch, numbered in
/// `Contact::patch`. They have the friction of the two materials and, for soft fingers, the torsion
/// of the soft layers (patch_torsion()). Adjacent patches of one link are merged.
/// @throws InputError if the setup has no friction for a pair of materials, or, for soft fingers,
/// lacks a material.
[[nodiscard]] std::vector<HandContact> find_contacts(const PosedCollisionHand& posed,
                                                     const GraspSetup& setup,
                                                     const ContactPatchOptions& options = {},
                                                     const PadOptions& pads = {});

/// Returns the maximum stand-off at which the tips still close beyond the object's centre of mass
/// [m]. The tips count at the time at which they are as far apart along the closing axis as the
/// object is wide:
///   max(0, mean_tip_advance() - d'(com - point of approach)),  d the direction of approach.
/// @param q  posture of the approach (coordinates)
[[nodiscard]] double max_stand_off(const CollisionHand& hand, const Pose<double>& X_WH,
                                   const Eigen::VectorXd& q, const GraspBody& object);

/// Approaches (yielding_approach()), closes, finds the contacts, and computes their quality. A hand
/// that meets the object retreats by its stand-off, so that the fingertips can hold it off the
/// palm; a hand that meets an obstacle closes where it is.
/// @param q  posture of the approach, at which closing begins (coordinates)
/// @throws InputError as approach(), close_hand() and find_contacts(), or if stand_off is not in
///         [0, 1].
Grasp grasp(const CollisionHand& hand, const Pose<double>& X_WH, const Eigen::VectorXd& q,
            const GraspSetup& setup, const GraspOptions& options = {});

}  // namespace thenar
