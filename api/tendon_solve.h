#pragma once

/// Effects of given tendon tensions on one digit: every band of its extensor hood, joint torques,
/// and the force of its tip; at one posture, or over a grid of postures.
/// Example: examples/05_extensor_net.cpp.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "api/named/digits.h"
#include "base/progress.h"
#include "solvers/status.h"
#include "tendons/net/digit_sweep.h"

namespace thenar {

class NetTendons;

/// Options of a tendon solve: a digit in its postures, and the tensions of its tendons.
struct TendonRequest {
  DigitRequest digit;                     // hood absent: a net
  std::map<std::string, double> tension;  // muscle -> tension [N]; others are slack
};

/// A digit under tensions, with its postures.
struct LoadedDigit {
  std::string subject, digit;                   // names
  std::shared_ptr<const DigitTendons> tendons;  // never null
  Eigen::VectorXd t;                            // tension of each muscle [N] (muscles)
  PostureGrid grid;                             // requested postures
  std::vector<SourceText> sources;              // texts of the subject and of a net

  [[nodiscard]] const TendonDigit& bones() const { return tendons->digit(); }
  /// Returns the tendons as a net; null if their hood is no net.
  [[nodiscard]] const NetTendons* net() const;
};

/// Result at one posture.
struct [[nodiscard]] TendonSolveResult {
  TendonRequest request;  // request that was answered
  Outcome outcome;        // stalled: do not use it, see point.pull.status
  LoadedDigit loaded;     // digit with its tensions
  DigitPoint point;       // balance at the posture
};

/// Results at a grid of postures, each equal to that of solve_tendons().
struct [[nodiscard]] TendonSweepResult {
  TendonRequest request;           // request that was answered
  Outcome outcome;                 // stalled: at least one point must not be used
  LoadedDigit loaded;              // digit with its tensions
  std::vector<DigitPoint> points;  // points in the order of loaded.grid.postures; fewer if stopped
};

/// Solves the digit at request.digit.posture; `vary` must be empty.
/// @throws InputError or DataError saying what is unknown or missing.
[[nodiscard]] TendonSolveResult solve_tendons(const TendonRequest& request,
                                              const Progress& progress = {});

/// Solves the digit over the postures of request.digit.vary, row by row.
/// @throws InputError or DataError saying what is unknown or missing.
[[nodiscard]] TendonSweepResult sweep_tendons(const TendonRequest& request,
                                              const Progress& progress = {});

/// Returns the force of the tip in its own proximal, dorsal and radial directions [N] (3).
[[nodiscard]] Eigen::Vector3d force_in_tip_axes(const LoadedDigit& loaded, const DigitPoint& point);

}  // namespace thenar
