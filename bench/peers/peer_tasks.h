#pragma once

/// Scenes with exact answers, or with converged ones, that engines are judged by.

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "bench/peers/peer_scene.h"

namespace thenar::bench {

/// What of a run is looked at.
struct PeerMeasure {
  std::string name;  // "slip [mm]"
  std::function<double(const PeerRun&)> of;
};

/// A scene, how wrong a run of it is, and what an engine is asked for.
struct PeerTask {
  PeerScene peer;
  std::string about;                 // what happens, and the right answer
  PeerMeasure error;                 // 0: right
  std::vector<PeerMeasure> further;  // beside it
  std::function<bool(const PeerRun&)> lost;
  std::vector<double> steps;       // of engines of fixed steps [s]
  std::vector<double> tolerances;  // of those that control their error [1]
  bool touches = true;             // bodies have shapes
};

/// Farther from where it should be an object is lost [mm].
inline constexpr double kLostAt = 20;

/// Pinch, swing, slide, mass ratios, capsule, ramp, stack, a ball in a hand, a hand that swings.
[[nodiscard]] std::vector<PeerTask> contact_tasks();

}  // namespace thenar::bench
