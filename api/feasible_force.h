#pragma once

/// The largest force or moment of a fingertip along a direction, which muscles limit it, and all
/// forces or moments that the tip can make.
/// Example: examples/04_feasible_force.cpp.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "api/named/digit_result.h"
#include "base/enum_names.h"
#include "tendons/forces/feasible_force_set.h"
#include "tendons/forces/max_tip_force.h"
#include "tendons/forces/max_tip_load.h"

namespace thenar {

/// Effect of a digit's load on the joints that digits share: the wrist.
enum class WristLoad {
  kHeld,  // no load: the wrist is held from outside
  kFree,  // the load and the tendons that cross the wrist balance there: a digit pushes the world
  kPinch  // the load ends within the hand, as between thumb and index finger: only tendons load the
          // wrist, see without_load_on()
};

inline constexpr std::array kWristLoadNames{EnumName{WristLoad::kHeld, "held"},
                                            EnumName{WristLoad::kFree, "free"},
                                            EnumName{WristLoad::kPinch, "pinch"}};
inline constexpr std::array kTipLoadNames{EnumName{TipLoad::kForce, "force"},
                                          EnumName{TipLoad::kMoment, "moment"}};
inline constexpr std::array kDirectionFrameNames{EnumName{DirectionFrame::kWorld, "world"},
                                                 EnumName{DirectionFrame::kTip, "tip"}};

/// Options of a question for feasible forces: a digit, and a direction, the whole set, or both.
/// Forces and moments are those of the tip on the world, moments about the tip.
struct FeasibleForceRequest {
  DigitRequest digit;              // subject, digit and postures
  TipLoad load = TipLoad::kForce;  // requested load: force or moment
  double max_other = 0;            // bound on each component of the other load in `frame`; 0: none;
                                   // infinite: a rigid hold [N m] or [N]
  std::optional<Eigen::Vector3d> direction;       // any length; absent: the set
  double tolerance = 0;                           // half angle of the cone about it [rad]
  DirectionFrame frame = DirectionFrame::kWorld;  // frame of the direction and of the results
  bool whole_set = false;                         // the set in addition to a direction
  std::vector<std::string> without;               // muscles that are paralysed: they do not pull
  std::map<std::string, double> weakened;  // muscle -> its largest tension, if less than its F0 [N]
  WristLoad wrist = WristLoad::kHeld;      // load of the tip on the wrist
  std::map<std::string, double> stops;     // joint at the end of its range -> the largest torque of
                                           // its ligaments, positive flexes; may be infinite [N m]
};

/// Axes of the requested direction and of the reported forces.
struct ForceAxes {
  std::string name = "world";                              // "world", "tip" or "map"
  std::array<std::string, 3> names{"x", "y", "z"};         // name of each axis
  Eigen::Matrix3d to_world = Eigen::Matrix3d::Identity();  // columns: the axes, world frame (3, 3)
};

/// All forces, and the largest force along each axis. If moments are requested, all numbers that
/// are stated in [N] are moments [N m].
struct WholeForceSet {
  FeasibleForceSet set;            // all forces or moments that the tip can make
  std::vector<MaxTipForce> along;  // +1, -1, +2, -2, +3, -3 (6)
};

/// Loss of tip force by paralysed and weakened muscles, along the requested direction.
struct ParalysisLoss {
  MaxTipForce intact;  // largest force with all muscles intact
  double share;        // 1 - component without them / component with all, 0 .. 1; NaN: one of the
                       // two forces is not known, or the intact hand makes none
};

/// Torque of the ligaments at a joint at the end of its range.
struct StopTorque {
  std::string joint;  // name of the joint
  double torque;      // positive flexes [N m]
  double max_torque;  // largest torque, with the same sign; may be infinite [N m]
  double price;       // marginal value of `max_torque`: rise of the force [N/(N m)] or moment [1]
                      // per N m; NaN: not known
};

/// Result at one posture.
struct FeasibleForcePoint {
  Eigen::VectorXd q;               // [rad] (joints); empty for a map
  std::string message;             // why there is no answer; empty: there is one
  TipLoad load = TipLoad::kForce;  // load that `largest` and `whole` describe
  ForceAxes axes;                  // axes of the reported forces
  Eigen::Vector3d tip{0, 0, 0};    // place of the tip, world frame [m] (3); 0 for a map
  double condition = 0;            // condition number of the tip's Jacobian [1]
  std::optional<Eigen::Vector3d> plane_normal;  // unit, where all axes are parallel, world (3)
  std::optional<MaxTipForce> largest;  // largest load along the direction, if there is one, with
                                       // prices of F0; a moment has [N m] in place of [N]
  Eigen::Vector3d other{0, 0, 0};      // other load at the same time, world frame [N m] or [N] (3)
  std::vector<StopTorque> stops;  // torques at the stops at this load, where `largest` is solved
  Eigen::VectorXd change;  // derivative of largest->component by each joint angle, the direction
                           // fixed in its axes [N/rad], of a moment [N m/rad] (joints); empty:
                           // no such load, a map
  std::optional<WholeForceSet> whole;   // present if requested
  std::optional<ParalysisLoss> loss;    // loss of `largest`, where muscles are paralysed or weak
  std::vector<std::vector<int>> alike;  // muscles with equal moment arms at all joints: only the
                                        // sum of their tensions is determined
};

/// Results posture by posture, in the order of the grid; fewer if stopped.
struct FeasibleForceResult : DigitResult {
  FeasibleForceRequest request;            // request that was answered
  Eigen::VectorXd max_tension;             // F0 [N] (muscles); 0 of those that are paralysed
  std::vector<std::string> without;        // muscles of the digit that are paralysed
  std::map<std::string, double> weakened;  // weak muscles, and the largest tension of each [N]
  std::vector<FeasibleForcePoint> points;  // one result for each posture
};

/// Loads below these are reported as zero: they are rounding errors.
inline constexpr double kNoTipForce = 1e-6;   // [N]
inline constexpr double kNoTipMoment = 1e-8;  // [N m]
[[nodiscard]] double no_tip_load(TipLoad load);

/// Computes at every posture, as requested: the largest load along `direction` with prices of F0
/// (max_tip_load()), the whole set (feasible_load_set()), or both. Muscles of `without` have F0 = 0
/// in all of these, as under a nerve block; those of the subject that cross no free joint of the
/// digit are named in a warning, as their paralysis changes nothing. Where the wrist is not held,
/// muscles of other digits cross it too, but are left out, as the joints of those digits would have
/// to be in balance with them; a warning names them.
/// @throws InputError for what is unknown, a direction of no length, a tolerance outside of
/// [0, pi/2) rad, a negative `max_other`, muscles of unknown strength, axes of the tip of a map,
/// moments that a map does not know, a wrist that is not held where no joint is shared, or a stop
/// of no free joint or without torque; DataError for a wrong file.
[[nodiscard]] FeasibleForceResult compute_feasible_force(const FeasibleForceRequest& request,
                                                         const Progress& progress = {});

}  // namespace thenar
