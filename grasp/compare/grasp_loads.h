#pragma once

/// What loads a grasp holds.

#include <map>
#include <string>
#include <vector>

#include "grasp/compare/comparison.h"
#include "grasp/quality/task_margin.h"

namespace thenar {

// Why a grasp holds nothing, or why nobody knows.

/// Loads below it are rounding of the cone programmes [N].
inline constexpr double kNegligibleLoad = 1e-6;

/// Of a load without limit.
inline constexpr const char* kSupportedByStructure =
    "borne by structure, whose strength is not known";

/// What hand_forces() is made of.
struct HandForceInputs {
  const HandLayout& layout;
  WrenchSet set;
  Eigen::MatrixXd T;  // torque_map()
  Actuation actuation;
};

/// "the effort of 'motor' is unknown": of the first actuator without a limit that moves a
/// coordinate which feels a contact and is not locked; empty: there is none, all that matters is
/// known.
[[nodiscard]] std::string explain_unknown_effort(const HandForceInputs& forces);

/// What stands in the way of every multiple of some loads: friction, or a least set of joints that
/// would need a motor of any strength for any of the loads to be borne.
[[nodiscard]] std::string explain_zero_margin(const HandForceInputs& forces,
                                              const std::vector<ScaledWrench>& loads);

/// A load that may be none, or not known.
struct ExplainedLoad {
  double value = 0;    // NaN: not known; infinite: nothing limits it
  std::string reason;  // why it is zero, not known or infinite; else empty
};

struct GraspLoads {
  double hold = 0;                             // as BestGrasp
  std::map<std::string, double> margin;        // as BestGrasp
  std::map<std::string, std::string> reasons;  // as BestGrasp
};

/// What holds an object: a hand in a posture, and where it touches.
struct HeldObject {
  const Hand& hand;
  const Eigen::VectorXd& q;                  // (coordinates)
  const std::vector<HandContact>& contacts;  // object frame
  Pose<double> X_HO;                         // the object seen from the hand
};

/// What hand_forces() is made of, torques divided by the object's reach.
[[nodiscard]] HandForceInputs hand_force_inputs(const HeldObject& held, const SceneBody& object);

/// The loads of a task, none of force closure. @param weight  of the object [N]
/// @param scale  of torques [m]
[[nodiscard]] std::vector<ScaledWrench> task_loads(GraspTask task, double weight, double scale);

/// Loads of tasks about the object's centre of mass, along its own axes: weight both ways along
/// each of the three, a pull of 1 N along +-z, a torque of 1 N m about +-z, within
/// hand_forces() of actuation_with_joint_limits(). Efforts may be those that hold the joints at the
/// posture; a load that needs no effort, a palm's, has no limit. Loads below 1e-6 N are zero.
/// Force closure is no load and has no margin: HandOnObject::success.
/// @param mass  of the object [kg], under 9.81 m/s^2
[[nodiscard]] GraspLoads grasp_loads(const HeldObject& held, const SceneBody& object, double mass,
                                     const std::vector<GraspTask>& tasks);

/// A load of 1 N along an axis, turns over the reach, that is proven not to be borne, however
/// small; zero: there is none.
[[nodiscard]] ScaledWrench unsupported_load(const ForceSet& forces);

/// Radius of inscribed_ball() of the same forces, torques divided by the object's reach, to 5 %
/// from below where the search ends, else its certified lower bound [N]. Zero as soon as one load
/// along an axis is proven not to be borne.
[[nodiscard]] ExplainedLoad hand_epsilon(const HeldObject& held, const SceneBody& object);

}  // namespace thenar
