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
  std::optional<Value> value;
  std::string message;  // why there is no value, or a remark on the value
};

/// A load that a grasp supports.
struct SupportedLoad {
  std::optional<double> active;  // by efforts and friction alone; none: the programme did not end
  double with_structure = 0;     // and with what joint limits, locks and drives that cannot be
                                 // driven back bear
};

/// Torques in wrenches are about the object's centre of mass and over its reach; its own frame.
struct GraspMeasures {
  Volume volume{};                        // of the wrench set [unit forces^6]
  Measured<InscribedBall> actuated;       // epsilon within the hand's limits [N]
  Measured<double> weight;                // of the object [N]
  Measured<double> hold;                  // least sum of normal forces that holds it as it
                                          // stands, by friction alone [N]
  Measured<double> hold_actuated;         // the same within the hand's efforts [N]
  Measured<SupportedLoad> times_weight;   // along each of its axes both ways [1]
  Measured<SupportedLoad> pull;           // along its z axis, the weaker way [N]
  Measured<SupportedLoad> turn;           // about its z axis, the weaker way [N m]
  Measured<GraspStiffness> stiffness;     // of soft pads at kPadForce, joints locked [N/m]
  Measured<ObjectMotion> manipulability;  // object per drive, without slip
  int edges = 0;  // of the pyramids of `volume`; 0: cones, as all others have
};

inline constexpr double kPadForce = 1;  // on every contact, for the stiffness of pads [N]

/// Measures a closed grasp. Friction is of true cones, except in the volume, which is of the
/// result's wrenches. Pads are springs of pad_stiffness() under kPadForce.
/// @param result  whose grasp has contacts: GraspOutcome::kGrasped
/// @throws Stopped where progress says stop
[[nodiscard]] GraspMeasures grasp_measures_of(const GraspResult& result,
                                              const Progress& progress = {});

}  // namespace thenar
