#pragma once

/// Measures of a grasp in the present state of a live world: contacts, quality, wrench sets.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/enum_names.h"
#include "grasp/quality/wrench_set_mesh.h"
#include "live/world/live_grasp.h"

namespace thenar {

/// Contacts of a hand with an object.
struct LiveContacts {
  std::vector<HandContact> contacts;  // in the object's frame, of the hand's contact model
  std::vector<std::string> links;     // names of the surfaces that touch (contacts)
  Pose<double> X_WO;                  // of the object
  std::vector<std::string> warnings;  // what is deeper in another than its soft layer
};

/// Overlaps deeper than this, and than the soft layer of the surface, are told [m].
inline constexpr double kDeepOverlap = 1e-3;

/// @throws InputError if there is no such hand or object, or no friction of a pair that touches
[[nodiscard]] LiveContacts contacts_of(const LiveWorld& live, const LivePair& pair);

/// Options of the quality of a grasp.
struct LiveQualityRequest {
  double tolerance = 1e-3;          // largest difference of epsilon's certified bounds, > 0 [1]
  ForceNorm norm = ForceNorm::kL1;  // how forces of all contacts are limited together
};

/// The grasp as it stands, as measure_grasp() gives one that it found: with contacts, wrenches and
/// epsilon, without measures. GraspOutcome::kEmpty where nothing touches. Postures that closing
/// left tell what stopped their joints.
/// @throws InputError as contacts_of(), or for a tolerance that is not positive
[[nodiscard]] GraspResult standing_grasp(const LiveWorld& live, const LivePair& pair,
                                         const LiveQualityRequest& request = {});

/// standing_grasp(), whose worst disturbance is shown from then on until something moves.
GraspResult show_quality(LiveWorld& live, const LivePair& pair,
                         const LiveQualityRequest& request = {});

/// Limits of the forces of a wrench set.
enum class WrenchLimits {
  kGeometric,  // normal forces of 1 N in all: friction alone
  kActuated    // what drives the hand, in its posture
};
inline constexpr std::array kWrenchLimitsNames{EnumName{WrenchLimits::kGeometric, "geometric"},
                                               EnumName{WrenchLimits::kActuated, "actuated"}};

/// Boundary of a grasp's wrench set in three of its six axes. Torques are over the object's reach.
/// @param axes    three different ones: 0..2 forces, 3..5 torques
/// @param pieces  as wrench_set_mesh()
/// @throws InputError as standing_grasp(), if nothing touches, as wrench_set_mesh(), or where an
///         effort is unknown that limits what is asked
[[nodiscard]] WrenchSetMesh live_wrench_set(const LiveWorld& live, const LivePair& pair,
                                            const std::array<int, 3>& axes, PictureKind kind,
                                            WrenchLimits limits, int pieces);

/// standing_grasp() with grasp_measures_of(): what `thenar grasp` says of it.
/// @throws as standing_grasp(); Stopped
[[nodiscard]] GraspResult measured_grasp(const LiveWorld& live, const LivePair& pair,
                                         const LiveQualityRequest& request = {},
                                         const Progress& progress = {});

}  // namespace thenar
