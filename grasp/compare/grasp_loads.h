#pragma once

/// Loads that a grasp resists, with the reasons of zero or unknown loads.

#include <optional>
#include <string>
#include <vector>

#include "grasp/compare/comparison.h"
#include "grasp/quality/task_margin.h"

namespace thenar {

/// Magnitude below which loads are rounding errors of the cone programs [N]
inline constexpr double kNegligibleLoad = 1e-6;

/// Reasons of an unlimited load, and of one that efforts resist no part of.
inline constexpr const char* kSupportedByStructure =
    "supported by rigid structure (strength unknown)";
inline constexpr const char* kBorneByStructure =
    "efforts carry nothing of it, rigid structure (strength unknown) does";

/// Arguments of hand_forces().
struct HandForceInputs {
  HandLayout layout;
  WrenchSet set;
  Eigen::MatrixXd T;  // torque_map()
  Actuation actuation;
};

/// Explains an unknown load margin: "the effort of 'motor' is unknown" for the first actuator
/// without a limit that moves a coordinate which is not locked and carries contact forces; empty if
/// all relevant efforts are known.
[[nodiscard]] std::string explain_unknown_effort(const HandForceInputs& forces);

/// Explains a zero load margin: by friction, or by a minimal set of joints of which each would need
/// a motor of any strength to support any of the loads.
[[nodiscard]] std::string explain_zero_margin(const HandForceInputs& forces,
                                              const std::vector<ScaledWrench>& loads);

/// A load with the reason if it is zero, unknown or unlimited.
struct ExplainedLoad {
  double value = 0;     // NaN: unknown; infinite: unlimited [N]
  std::string message;  // why it is zero, unknown or infinite; otherwise empty
};

/// A hand in a posture that holds an object. The hand must outlive it.
struct HeldObject {
  const Hand& hand;
  Eigen::VectorXd q;                  // (coordinates)
  std::vector<HandContact> contacts;  // in the object's frame
  Pose<double> X_HO;                  // pose of the object in the hand's frame
};

/// Computes the arguments of hand_forces() for a held object, torques divided by the object's
/// radius.
[[nodiscard]] HandForceInputs hand_force_inputs(const HeldObject& held, const GraspBody& object);

/// Returns the unit loads of a task [N]; none for force closure.
/// @param weight  weight of the object [N]
/// @param scale   length that divides torques [m]
[[nodiscard]] std::vector<ScaledWrench> task_loads(GraspTask task, double weight, double scale);

/// Computes the load margins of tasks about the object's centre of mass, along its own axes: its
/// weight both ways along each of the three, a pull of 1 N along +-z, a torque of 1 N m about +-z,
/// within hand_forces() of actuation_with_joint_limits(). Efforts may include those that hold the
/// joints at the posture. With efforts alone (active_only()) structure pushes back no more than
/// they press; with structure, a load that needs no effort, such as one on the palm, is unlimited.
/// Loads below 1e-6 N are zero. Force closure is no load and has no margin: see
/// HandOnObject::success.
/// @param mass  mass of the object [kg], under 9.81 m/s^2
[[nodiscard]] GraspLoads grasp_loads(const HeldObject& held, const GraspBody& object, double mass,
                                     const std::vector<GraspTask>& tasks);

/// Finds a unit load along an axis [N], torques over the scale, that is proven not to be supported
/// at any magnitude; nothing if there is none. (6)
[[nodiscard]] std::optional<ScaledWrench> unsupported_load(const ForceSet& forces);

/// Computes the epsilon of a hand: the radius of inscribed_ball() of the same forces, torques
/// divided by the object's radius, within 5 % from below if the search ends, otherwise its
/// certified lower bound [N]. It is zero as soon as one load along an axis is proven not to be
/// supported.
[[nodiscard]] ExplainedLoad hand_epsilon(const HeldObject& held, const GraspBody& object);

}  // namespace thenar
