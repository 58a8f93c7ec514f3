#pragma once

/// Experiments: measured fingertip forces under known tendon loads, to which fits are made.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/enum_names.h"

namespace thenar {

/// Constraint of the fingertip.
enum class TipConstraint {
  kPinned,  // a point contact: three forces, no moment
  kRigid    // clamped to the load cell: force and moment
};
inline constexpr std::array kTipConstraintNames{EnumName{TipConstraint::kPinned, "pinned"},
                                                EnumName{TipConstraint::kRigid, "rigid"}};

/// Path of tendons from the mount of a digit to the muscles.
enum class TendonExit {
  kCrossing,  // straight from the crossing of the joint next to the mount
  kAlongBone  // redirected by the mount along the bone, proximally
};
inline constexpr std::array kTendonExitNames{EnumName{TendonExit::kCrossing, "crossing"},
                                             EnumName{TendonExit::kAlongBone, "along_bone"}};

/// Place of a load cell that does not hold the tip.
struct ForceSite {
  std::string at;    // segment that it holds instead of the tip; or, on the base, the mount of the
                     // digit while its tip is held
  std::string axes;  // segment whose directions the force components use
  std::optional<double> fraction;        // fixation along the bone: 0 proximal, 1 distal; empty:
                                         // half-way, on the tip's segment at the tip          [1]
  std::optional<Eigen::Vector3d> point;  // instead: at the reference posture, subject frame [m] (3)
  TendonExit leave = TendonExit::kCrossing;  // exit of the tendon from a mount
};

[[nodiscard]] bool operator==(const ForceSite& a, const ForceSite& b);

/// Joint angles of one posture.
struct PostureRecord {
  std::string name;
  std::map<std::string, double> angles;  // joint name -> angle; joints not named are 0 [rad]
};

/// One loading, and the reading of the load cell. Components beyond Experiment::components are 0.
struct Trial {
  std::string posture;
  std::map<std::string, double> tension;  // muscle -> tendon tension, after pulley losses [N]
  Eigen::Vector3d force{0, 0, 0};         // force of the tip on the world, experiment axes [N] (3)
  std::optional<Eigen::Vector3d> moment;  // moment of the tip on the world about the tip [N m] (3)
  std::optional<Eigen::Vector3d> sd;      // of the force, if stated for this row [N] (3)
  std::optional<ForceSite> site = {};     // place of the force measurement; empty: the tip
};

/// One task, measured by electromyography and the load cell.
struct ActivationRow {
  std::string posture;
  std::map<std::string, double> activation;  // muscle -> 0..1; unnamed muscles are silent [1]
  std::map<std::string, double> sd;          // standard deviation of each activation [1]
  Eigen::Vector3d force{0, 0, 0};  // force of the tip on the world, experiment axes [N] (3)
  std::optional<Eigen::Vector3d> force_sd;  // of the force, if stated for this row [N] (3)
};

/// One specimen under one protocol.
struct Experiment {
  std::string name;      // "H01"
  std::string specimen;  // the individual; several experiments may share one
  std::string species;   // "human"
  std::string description;
  std::string source;  // citation key
  std::string digit;   // "middle"
  TipConstraint hold = TipConstraint::kPinned;
  std::string force_segment;  // segment whose axes the force components use: "DP3"
  int components = 3;         // fitted components of a force; 2: those in the plane of flexion [1]
  Eigen::Matrix3i axes_of_digit = Eigen::Matrix3i::Identity();
  // row i: component i as signed (proximal, dorsal, radial) of the digit, 0 if not fitted (3, 3)
  double sd_relative = 0;  // force noise: sd^2 = sd_floor^2 + (sd_relative |F|)^2 [1]
  double sd_floor = 0;     // [N]
  std::vector<PostureRecord> postures;
  std::vector<Trial> trials;
  std::vector<ActivationRow> activations;
  std::map<std::string, double> outside_length = {};  // segment -> its length, measured on the
                                                      // specimen's outside; empty: not stated [m]
};

/// Reads an experiment from TOML; the format is in docs/data_format.md.
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] Experiment read_experiment(const std::string& path);

/// Parses an experiment from text already in memory; `path` only names it in messages.
[[nodiscard]] Experiment parse_experiment(const std::string& text, const std::string& path);

/// Returns the standard deviation of the force components of a trial: its own, or the stated noise;
/// infinite for a component that is not fitted [N] (3)
[[nodiscard]] Eigen::Vector3d force_sd(const Experiment& experiment, const Trial& trial);
/// Returns the standard deviation of the force components of an activation row [N] (3)
[[nodiscard]] Eigen::Vector3d force_sd(const Experiment& experiment, const ActivationRow& row);

}  // namespace thenar
