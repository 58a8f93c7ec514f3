#pragma once

/// Measures of a grasp in the current state of a live world: contacts, quality, wrench sets.

#include <array>
#include <string>
#include <vector>

#include "base/enum_names.h"
#include "grasp/quality/wrench_set_mesh.h"
#include "live/world/live_grasp.h"

namespace thenar {

/// Contacts of a hand with an object.
struct LiveContacts {
  std::vector<HandContact> contacts;  // contacts in the object's frame, by the hand's contact model
  std::vector<std::string> links;     // name of the hand's surface (contacts)
  Pose<double> X_WO;                  // pose of the object
  std::vector<std::string> warnings;  // overlaps deeper than the soft layer of the surface
};

/// Depth above which an overlap is reported, if it also exceeds the surface's soft layer [m].
inline constexpr double kReportedOverlap = 1e-3;

/// Finds the contacts of a hand with an object in their current poses.
/// @throws InputError if there is no such hand or object, or if a touching pair of materials has no
///         coefficient of friction
[[nodiscard]] LiveContacts current_contacts(const LiveWorld& live, const LivePair& pair);

/// Options of the quality of a grasp.
struct LiveQualityRequest {
  double tolerance = 1e-3;          // largest difference of epsilon's certified bounds, > 0 [1]
  ForceNorm norm = ForceNorm::kL1;  // norm in which the contact forces are limited
};

/// Computes the contacts, wrenches and epsilon of the current grasp, in the form of measure_grasp()
/// but without the other measures. The outcome is GraspOutcome::kEmpty if nothing touches. If the
/// hand has not moved since it closed, the result also says what stopped its joints.
/// @throws InputError as current_contacts(), or for a tolerance that is not positive
[[nodiscard]] GraspResult current_grasp(const LiveWorld& live, const LivePair& pair,
                                        const LiveQualityRequest& request = {});

/// Computes current_grasp() and shows its worst disturbance in the picture until something moves.
GraspResult show_quality(LiveWorld& live, const LivePair& pair,
                         const LiveQualityRequest& request = {});

/// Limits of the forces of a wrench set.
enum class WrenchLimits {
  kGeometric,  // friction, and a sum of normal forces of 1 N
  kActuated    // friction, and the drives or muscles of the hand in its posture
};
inline constexpr std::array kWrenchLimitsNames{EnumName{WrenchLimits::kGeometric, "geometric"},
                                               EnumName{WrenchLimits::kActuated, "actuated"}};

/// Computes the boundary of a grasp's wrench set in three of its six axes. Torques are divided by
/// the object's reach (GraspBody::torque_scale).
/// @param axes    three different axes: 0..2 forces, 3..5 torques
/// @param pieces  as for wrench_set_mesh()
/// @throws InputError as current_grasp() and wrench_set_mesh(), if nothing touches, or if an effort
///         limit of the hand is unknown
[[nodiscard]] WrenchSetMesh live_wrench_set(const LiveWorld& live, const LivePair& pair,
                                            const std::array<int, 3>& axes, PictureKind kind,
                                            WrenchLimits limits, int pieces);

/// Computes current_grasp() with all measures of grasp_measures_of(), as `thenar grasp` does.
/// @throws as current_grasp(); Stopped
[[nodiscard]] GraspResult measured_grasp(const LiveWorld& live, const LivePair& pair,
                                         const LiveQualityRequest& request = {},
                                         const Progress& progress = {});

}  // namespace thenar
