#pragma once

/// One grasp from start to quality.

#include <string>
#include <vector>

#include "grasp/closing/approach.h"
#include "grasp/closing/close_hand.h"
#include "grasp/closing/collision_hand.h"
#include "grasp/closing/scene.h"
#include "grasp/contact/contact_patch.h"
#include "grasp/contact/soft_pads.h"
#include "grasp/quality/epsilon.h"

namespace thenar {

struct GraspOptions {
  double way = 1;        // farthest approach [m]; 0: it begins where it is
  double side_step = 1;  // farthest it gives way to the side, by the object's reach [1]
  double stand_off = 0;  // share of max_stand_off() that the hand goes back before it closes [1]
  CloseOptions close;
  ContactPatchOptions patches;
  EpsilonOptions epsilon;
  PadOptions pads;  // hard points unless it says soft fingers
};

/// How far a grasp came.
enum class GraspOutcome {
  kGrasped,   // there are contacts: `quality` holds
  kOverlaps,  // the hand began in something: approached.overlaps or closed.overlaps say in what
  kMissed,    // the approach met nothing
  kBlocked,   // the approach met an obstacle first, and closing there touched nothing
  kTooLong,   // closing did not end
  kEmpty      // closed, and the object is not touched
};

/// "grasped", "overlaps", "missed", "blocked", "too long", "empty".
[[nodiscard]] std::string name_of(GraspOutcome outcome);

struct [[nodiscard]] Grasp {
  GraspOutcome outcome;
  ApproachResult approached;
  ClosedHand closed;
  std::vector<HandContact> contacts;  // object frame
  Epsilon quality;                    // about the object's centre of mass, torques over its reach
};

/// Where a posed hand touches the object, patch by patch, numbered in `Contact::patch`; friction
/// from the materials of both, and torsion from their soft layers, if contacts are soft fingers
/// (torsion_of()). Patches of one link that meet are one (joined()).
/// @throws InputError if the scene has no friction for a pair of materials, or lacks one of them
/// where contacts are soft.
[[nodiscard]] std::vector<HandContact> find_contacts(const PosedCollisionHand& posed,
                                                     const Scene& scene,
                                                     const ContactPatchOptions& options = {},
                                                     const PadOptions& pads = {});

/// How far a hand may go back so that its tips, where they are as far apart along the closing axis
/// as the object is wide there, are still beyond the object's centre of mass:
///   max(0, tips_ahead() - d'(com - point of approach)),  d the direction of approach [m].
/// @param q  posture of the approach (coordinates)
[[nodiscard]] double max_stand_off(const CollisionHand& hand, const Pose<double>& X_WH,
                                   const Eigen::VectorXd& q, const SceneBody& object);

/// Approaches (yielding_approach()), closes, finds the contacts, and measures. A hand that meets
/// the object goes back by its stand-off, so that fingertips may hold it off the palm; one that
/// meets an obstacle closes there, too.
/// @param q  posture of the approach, where closing begins (coordinates)
/// @throws InputError as approach(), close_hand() and find_contacts(), or if stand_off is not in
/// [0, 1].
Grasp grasp(const CollisionHand& hand, const Pose<double>& X_WH, const Eigen::VectorXd& q,
            const Scene& scene, const GraspOptions& options = {});

}  // namespace thenar
