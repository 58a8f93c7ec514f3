#pragma once

/// The largest force or moment of a fingertip along a direction, which muscles limit it, and all
/// forces or moments that the tip can make.

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
  kHeld,  // nothing: something holds the wrist
  kFree,  // the wrist balances it, with the tendons across it, as of a digit that pushes the world
  kPinch  // it ends within the hand, as between thumb and index finger: the wrist balances tendons
          // alone, see without_load_on()
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
  DigitRequest digit;
  TipLoad load = TipLoad::kForce;                 // whether forces or moments are asked for
  double most_other = 0;                          // of each component of the other load about the
                                                  // axes of `frame`: 0 none, infinite: a rigid
                                                  // hold                       [N m] or [N]
  std::optional<Eigen::Vector3d> direction;       // of the load, of any length; absent: the set
  double tolerance = 0;                           // half angle of the cone about it [rad]
  DirectionFrame frame = DirectionFrame::kWorld;  // of the direction and of answers
  bool whole_set = false;                         // the set in addition to a direction
  std::vector<std::string> without;               // muscles that are paralysed: they do not pull
  std::map<std::string, double> weakened;         // muscle -> what it can pull at most, if less
                                                  // than its F0 [N]
  WristLoad wrist = WristLoad::kHeld;
  std::map<std::string, double> stops;  // joint at the end of its range -> the largest torque of
                                        // its ligaments, positive flexes; may be infinite [N m]
};

/// Axes in which forces are asked for and shown.
struct ForceAxes {
  std::string name = "world";                              // "world", "tip" or "map"
  std::array<std::string, 3> names{"x", "y", "z"};         // of each axis
  Eigen::Matrix3d to_world = Eigen::Matrix3d::Identity();  // columns: the axes, world frame (3, 3)
};

/// All forces, and the largest force along each axis; or moments, where [N] reads [N m].
struct WholeForceSet {
  FeasibleForceSet set;
  std::vector<MaxTipForce> along;  // +1, -1, +2, -2, +3, -3 (6)
};

/// Loss of tip force by paralysed and weakened muscles, along the direction asked for.
struct ParalysisLoss {
  MaxTipForce intact;  // with all muscles
  double share;        // 1 - component without them / component with all, 0 .. 1; NaN: one of the
                       // two forces is not known, or the intact hand makes none
};

/// Torque of ligaments at a joint that stands at the end of its range.
struct StopAnswer {
  std::string joint;
  double torque;  // positive flexes [N m]
  double most;    // with the same sign; may be infinite [N m]
  double price;   // of a newton metre more of `most` [N/(N m)]; NaN: not known
};

/// The answer at one posture.
struct FeasibleForcePoint {
  Eigen::VectorXd q;               // [rad] (joints); empty for a map
  std::string message;             // why there is no answer; empty: there is one
  TipLoad load = TipLoad::kForce;  // what `largest` and `whole` are of
  ForceAxes axes;                  // of the forces that are shown
  Eigen::Vector3d tip{0, 0, 0};    // place of the tip, world frame [m] (3); 0 for a map
  double condition = 0;            // of the tip's Jacobian, in the plane of parallel axes [1]
  std::optional<Eigen::Vector3d>
      plane_normal;                     // of flexion, where all axes are parallel, world (3)
  std::optional<MaxTipForce> largest;   // along the direction, if there is one; with prices of F0;
                                        // of moments [N] reads [N m]
  Eigen::Vector3d other{0, 0, 0};       // the other load meanwhile, world frame [N m] or [N] (3)
  std::vector<StopAnswer> stops;        // meanwhile, where `largest` is solved
  Eigen::VectorXd change;               // of largest->component by each joint, the direction fixed
                                        // in its axes [N/rad] (joints); empty: no such force, a map
  std::optional<WholeForceSet> whole;   // if it was asked for
  std::optional<ParalysisLoss> loss;    // of `largest`, where muscles are paralysed or weak
  std::vector<std::vector<int>> alike;  // muscles of the same moment arms at all joints, so that an
                                        // answer decides the sum of their tensions alone
};

/// Answers posture by posture, in the order of the grid; as many as were done.
struct FeasibleForceResult : DigitResult {
  FeasibleForceRequest request;
  Eigen::VectorXd max_tension;             // F0 [N] (muscles); 0 of those that are paralysed
  std::vector<std::string> without;        // muscles of the digit that are paralysed
  std::map<std::string, double> weakened;  // those that are weak, and what they can pull [N]
  std::vector<FeasibleForcePoint> points;
};

/// Loads below this are reported as none: rounding of what tendons make.
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
/// [0, pi/2) rad, a negative `most_other`, muscles of unknown strength, axes of the tip of a map,
/// moments that a map does not know, a wrist that is not held where no joint is shared, or a stop
/// of no free joint or without torque; DataError for a wrong file.
[[nodiscard]] FeasibleForceResult compute_feasible_force(const FeasibleForceRequest& request,
                                                         const Progress& progress = {});

}  // namespace thenar
