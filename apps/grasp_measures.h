#pragma once

/// What is measured of a grasp beside its epsilon.

#include <optional>
#include <string>
#include <vector>

#include "apps/grasp_motion.h"
#include "grasp/compare/grasp_loads.h"
#include "grasp/limits/grasp_force.h"
#include "grasp/quality/grasp_stiffness.h"
#include "grasp/quality/inscribed_ball.h"
#include "grasp/quality/volume.h"
#include "report/pages/grasp.h"

namespace thenar {

/// A measure, or why there is none.
template <typename Value>
struct Measured {
  std::optional<Value> value;
  std::string reason;  // where there is no value, or what to know of it
};

/// Torques in wrenches are about the object's centre of mass and over its reach; its own frame.
struct GraspMeasures {
  Volume volume{};                        // of the wrench set [unit forces^6]
  Measured<InscribedBall> actuated;       // epsilon within what drives the hand [N]
  Measured<double> weight;                // of the object [N]
  Measured<double> hold;                  // least sum of normal forces that holds it as it
                                          // stands, by friction alone [N]
  Measured<double> hold_actuated;         // the same within what drives the hand [N]
  Measured<double> times_weight;          // held along each of its axes both ways [1]
  Measured<double> pull;                  // along its z axis, the weaker way [N]
  Measured<double> turn;                  // about its z axis, the weaker way [N m]
  Measured<GraspStiffness> stiffness;     // of soft pads at kPadForce, joints locked [N/m]
  Measured<ObjectMotion> manipulability;  // object per drive, without slip
  int edges = 0;  // of the pyramids of `volume`; 0: cones, as all others have
};

inline constexpr double kPadForce = 1;  // on every contact, for the stiffness of pads [N]

/// Measures a grasp that is one. Friction is of true cones, but for the volume, which is of the
/// answer's wrenches. Pads are springs of pad_stiffness() under kPadForce.
/// @throws Stopped where progress says stop
[[nodiscard]] GraspMeasures measure(const GraspQuestion& question, const CollisionHand& touching,
                                    const GraspAnswer& answer, const Progress& progress = {});

/// With units in the names of keys; null where there is no value, `reasons` says why.
[[nodiscard]] nlohmann::ordered_json measures_json(const GraspMeasures& measures);

/// The same in words.
[[nodiscard]] std::vector<MeasureRow> measure_rows(const GraspMeasures& measures);

}  // namespace thenar
