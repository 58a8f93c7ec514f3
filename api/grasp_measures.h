#pragma once

/// Measures of a grasp beside its epsilon: loads, grasp forces, stiffness, mobility.

#include <optional>
#include <string>

#include "base/progress.h"
#include "grasp/compare/object_motion.h"
#include "grasp/quality/grasp_stiffness.h"
#include "grasp/quality/inscribed_ball.h"
#include "grasp/quality/volume.h"

namespace thenar {

struct GraspResult;

/// A measure, or a message that says why there is none.
template <typename Value>
struct Measured {
  std::optional<Value> value;  // absent: see message
  std::string message;         // why there is no value, or a remark on the value
};

/// A load that a grasp supports.
struct SupportedLoad {
  std::optional<double> active;  // by efforts and friction alone; absent: not converged
  double with_structure = 0;     // plus joint limits, locks and non-backdrivable drives
};

/// Measures of a grasp. Wrenches are in the object's frame, their torques about its centre of mass
/// and divided by its reach.
struct GraspMeasures {
  Volume volume{};                   // volume of the wrench set [unit forces^6]
  Measured<InscribedBall> actuated;  // epsilon within the hand's limits [N]
  Measured<double> weight;           // weight of the object [N]
  Measured<double> hold;  // least sum of normal forces that holds the object as it is placed, by
                          // friction alone [N]
  Measured<double> hold_actuated;        // same sum within the hand's efforts [N]
  Measured<SupportedLoad> times_weight;  // along each axis of the object both ways [1]
  Measured<SupportedLoad> pull;          // force along the object's z axis, the weaker way [N]
  Measured<SupportedLoad> turn;          // torque about the object's z axis, the weaker way [N m]
  Measured<GraspStiffness> stiffness;    // stiffness of soft pads at kPadForce, joints locked [N/m]
  Measured<ObjectMotion> manipulability;  // motion of the object per drive, without slip
  int edges = 0;  // edges of the friction pyramids of `volume`; 0: cones, as in all other measures
};

inline constexpr double kPadForce = 1;  // normal force at which pads are linearised [N]

/// Measures a closed grasp. Friction cones are exact, except in the volume, which uses the wrenches
/// of the result. Pads are linear springs: pad_stiffness() at kPadForce.
/// @param result  with contacts: GraspOutcome::kGrasped
/// @throws Stopped if progress requests a stop
[[nodiscard]] GraspMeasures grasp_measures_of(const GraspResult& result,
                                              const Progress& progress = {});

}  // namespace thenar
