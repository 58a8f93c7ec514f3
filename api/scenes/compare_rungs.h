#pragma once

/// Comparison of a scene on several rungs of its finger pads: cost, and difference from the finest.
///
///     SceneRequest request;
///     request.scene = "pencil_pinch";
///     const RungComparison rungs = compare_rungs(request, pad_rung_names());

#include <string>
#include <utility>
#include <vector>

#include "api/scenes/simulate_scene.h"

namespace thenar {

/// Difference of a run from the run on the finest rung.
struct RungError {
  // Root of the sum of squared differences of the pads' normal forces, over that of the finest's
  // forces [1].
  double force_end = 0;  // difference at the end
  double force_all = 0;  // difference over all instants
  // Largest difference among moving bodies that are not links of a hand.
  double place_end = 0;      // distance of centres of mass at the end [m]
  double place_largest = 0;  // largest distance at any instant [m]
  double turn_end = 0;       // rotation at the end [rad]
};

/// Load of a pad at one instant.
struct PadLoad {
  double force = 0;    // normal [N]
  double area = 0;     // area of the patch; 0: a hard point [m^2]
  double stick = 0;    // share of the normal force that sticks [1]
  double torsion = 0;  // torque on the first body of the pair about the normal [N m]
};

struct RungRun {
  std::string rung;   // of pad_rung_names()
  SceneResult scene;  // read scene.run.status first
  RungError error;    // 0 for the finest
};

struct [[nodiscard]] RungComparison {
  SceneRequest request;       // request without a rung
  Outcome outcome;            // done: rungs; stalled: none was solved
  std::string name;           // name of the scene
  std::vector<RungRun> runs;  // completed runs, in the order of the request
  std::size_t finest = 0;     // index of the finest run: the first of pad_rung_names() that was
                              // solved, or, if none was, that ran
  std::vector<std::pair<int, int>> pads;  // pairs of bodies, the lower first
  FileDigests files;                      // digests of all files that were read
};

/// Returns the loads of the pads of a comparison at an instant of a run (pads).
[[nodiscard]] std::vector<PadLoad> pad_loads(const RungComparison& comparison,
                                             const SceneSample& sample);

/// Simulates a scene once for each rung, one after the other, so that processor times are
/// comparable. If stopped, keeps the completed runs and discards the current one.
/// @param request  `pads` and `vary` empty
/// @param rungs    of pad_rung_names(), two or more
/// @throws InputError as simulate_scene(), or if a rung is unknown or requested twice.
[[nodiscard]] RungComparison compare_rungs(const SceneRequest& request,
                                           const std::vector<std::string>& rungs,
                                           const Progress& progress = {});

}  // namespace thenar
