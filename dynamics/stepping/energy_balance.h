#pragma once

/// Energy balance of a simulation.

#include <vector>

#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// Largest energy error of a valid simulation: a share of the energy turned over [1], and an
/// absolute error for scenes that hardly turn over any [J].
inline constexpr double kMaxEnergyErrorRatio = 0.01;
inline constexpr double kEnergyErrorFloor = 1e-6;

/// Energy balance between two instants, from the energy flows (SceneSample::w).
struct FlowBalance {
  double work = 0;         // work of forces, drives and muscles on the scene [J]
  double friction = 0;     // energy dissipated by friction of contacts and joints [J]
  double impacts = 0;      // energy dissipated along contact normals and at joint limits [J]
  double yielding = 0;     // energy dissipated by joint dampers, ligaments and pads [J]
  double error = 0;        // first energy + work - dissipated() - last energy; negative: energy
                           // was created [J]
  double turned_over = 0;  // largest kinetic energy + sum of |work| + losses [J]
  double t = 0;            // last instant [s]

  [[nodiscard]] double dissipated() const { return friction + impacts + yielding; }
  /// Returns |error| over (turned_over + kEnergyErrorFloor / kMaxEnergyErrorRatio) [1].
  [[nodiscard]] double relative_error() const;
  /// Returns true if the error is within the limit of a valid simulation.
  [[nodiscard]] bool holds() const { return relative_error() <= kMaxEnergyErrorRatio; }
};

/// Computes the energy balance between two instants.
///
/// Losses are the energies dissipated by friction, impacts and dampers. Energy that contacts add in
/// a fixed step or an impact is not booked and appears as an error (ImpulseBooking). `yielding` is
/// negative if passive elements return more energy than they stored: for pads pressed at the start
/// it contains their initial energy, which is unknown before the first step.
[[nodiscard]] FlowBalance flow_balance(const SceneSample& first, const SceneSample& last);

/// Returns the balance from the first sample to that of the largest error, or to the last sample if
/// all errors are rounding; `turned_over` is that of the whole simulation.
/// @param samples  samples with flows (SceneSample::w), the initial one first
[[nodiscard]] FlowBalance worst_balance(const std::vector<SceneSample>& samples);

}  // namespace thenar
