#pragma once

/// Energy balance of a run.

#include <vector>

#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// Energy error that a run may have: a share of the energy turned over [1], and a rest [J].
inline constexpr double kSceneEnergyShare = 0.01;
inline constexpr double kSceneEnergyRest = 1e-6;

/// Energy balance between two instants, by the flows of the steps (SceneSample::w).
struct FlowBalance {
  double work = 0;         // of forces, drives and muscles on the scene [J]
  double friction = 0;     // what friction of contacts and joints took [J]
  double impacts = 0;      // what contacts took along their normals, and joint limits [J]
  double yielding = 0;     // what dampers of joints and passive elements took: ligaments, pads [J]
  double error = 0;        // energy at first + work - dissipated() - energy at last; below zero:
                           // energy was made of nothing [J]
  double turned_over = 0;  // largest kinetic energy + size of all work + losses [J]
  double t = 0;            // of the last instant [s]

  [[nodiscard]] double dissipated() const { return friction + impacts + yielding; }
  /// Error over what is turned over, of which next to nothing counts as kSceneEnergyRest [1].
  [[nodiscard]] double share() const;
  /// Returns true if the error is within the limit for a run.
  [[nodiscard]] bool holds() const { return share() <= kSceneEnergyShare; }
};

/// Computes the energy balance between two instants.
///
/// Losses are the energies that friction, impacts and dampers take. Energy that contacts add in a
/// step of fixed length or an impact is no loss, and is missing in the balance (ImpulseBooking).
/// Energy that passive elements return beyond what they stored makes `yielding` negative: for pads
/// that are pressed at the start it is their initial stored energy, which is not known before the
/// first step.
[[nodiscard]] FlowBalance flow_balance(const SceneSample& first, const SceneSample& last);

/// The balance from the first instant to that of the largest error, the last one if all are
/// rounding, with what all turned over. @param samples  with flows (SceneSample::w), start first
[[nodiscard]] FlowBalance worst_balance(const std::vector<SceneSample>& samples);

}  // namespace thenar
