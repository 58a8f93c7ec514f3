#pragma once

/// Motion of one digit whose muscles are excited.
/// Example: examples/06_motion.cpp.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "api/named/digits.h"
#include "base/progress.h"
#include "base/run_record.h"
#include "solvers/status.h"
#include "tendons/muscle/joint_resistance.h"
#include "tendons/muscle/trajectory.h"

namespace thenar {

/// Options of a digit's motion: the digit, its excitations and its physics.
struct DigitMotionRequest {
  DigitRequest digit;                          // hood absent: fixed force fractions
  std::map<std::string, double> excitation;    // muscle -> 0..1 from the start on; others are 0;
                                               // needed unless a file or gravity moves the digit
  std::string excitation_file;                 // CSV time_s,MUSCLE,.. instead of `excitation`
  std::optional<Muscle> muscle;                // muscle model; absent: rigid tendons where
                                               // all state fibres, else by bounds
  std::map<std::string, double> tendon_slack;  // muscle -> slack length of its tendon [m]; others
                                               // as the subject says
  Eigen::Vector3d gravity{0, 0, 0};  // acceleration of free fall, subject's frame [m/s^2] (3)
  double damping = JointResistance().damping;  // where the subject states none [N m s/rad]
  double blend = kBlendStrain;  // strain over which bands of a net go from slack to taut [1]
  double seconds = 1;           // duration [s]
  double sample = 5e-3;         // time between stored instants [s]
  double tolerance = 1e-6;      // relative error of one step [1]
};

/// A digit in motion.
struct [[nodiscard]] DigitMotionResult {
  DigitMotionRequest request;  // request that was answered
  Outcome outcome;             // stalled or limit: do not use it, see trajectory.status
  std::string subject, digit;  // names
  std::shared_ptr<const DigitTendons> tendons;   // simulated digit; never null
  Trajectory trajectory;                         // angles, speeds, tensions and energies over time
  std::vector<SourceText> sources;               // subject, net, excitation file
  TendonOptions rungs{};                         // options by which `tendons` were built
  PassiveMoments passive = PassiveMoments::kOn;  // requested setting
};

/// Simulates the digit from rest at request.digit.posture; all activations are initially 0.
/// @throws InputError or DataError saying what is unknown or missing.
[[nodiscard]] DigitMotionResult simulate_digit(const DigitMotionRequest& request,
                                               const Progress& progress = {});

/// Returns the warnings of a motion, except the reason why it must not be used.
[[nodiscard]] std::vector<std::string> motion_warnings(const Trajectory& trajectory);

/// Format name in files of motions, and the entries of explain() that they keep as rungs.
inline constexpr const char* kMotionFormat = "thenar motion 1";
inline constexpr std::size_t kPathLadder = 2, kHoodLadder = 3;

/// Writes all instants as HDF5, dimensions labelled as xarray expects, with the rungs of the digit,
/// the texts and hashes of all sources and the record of the run; read_motion() reads it.
/// @throws InputError if the file cannot be written.
void write_motion(const DigitMotionResult& motion, const std::string& path,
                  const RunRecord& run = {});

/// Returns "done", "stopped", "stuck", "no progress" or "energy does not balance".
[[nodiscard]] std::string name_of(MotionStatus status);

}  // namespace thenar
