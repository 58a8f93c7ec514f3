#pragma once

/// The grasp of an object by a hand of a world: closing, contacts, quality, loads, robustness.
/// Example: examples/09_grasp.cpp.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "api/grasp_measures.h"
#include "api/named/worlds.h"
#include "base/progress.h"
#include "grasp/closing/collision_hand.h"
#include "grasp/closing/grasp.h"
#include "grasp/compare/pregrasp.h"
#include "grasp/quality/robustness.h"
#include "solvers/status.h"

namespace thenar {

/// Uncertainties of a grasp, and the number of random draws.
struct RobustnessRequest {
  int draws = 0;                                // number of draws; 0: robustness is not computed
  ContactUncertainty contacts{0.2, 2e-3, 0.1};  // sds: 20 % of friction, 2 mm, 0.1 rad
  double place = 5e-3;  // standard deviation of the object's position along each axis [m]
  double turn = 0.05;   // standard deviation of the object's rotation about each axis [rad]
};

/// Options of a grasp: the hand, the object, and the measures of the grasp.
struct GraspRequest {
  WorldRequest world;    // world; with `starts` the hand need not be part of it
  bool approach = true;  // true: approach along the palm's direction first; false: close in place,
                         // as mounted hands always do
  double approach_distance = 1;      // farthest approach [m]
  int starts = 0;                    // pregrasps drawn at random; 0: the world's own
  unsigned seed = 1;                 // seed of the starts and of the robustness draws
  ForceNorm limit = ForceNorm::kL1;  // norm that limits contact forces in epsilon and volume
  double tolerance = 1e-3;           // largest difference of epsilon's certified bounds [1]
  int edges = 0;                     // edges of friction pyramids, 3 .. 100; 0: cones
  RobustnessRequest robustness;      // repeated grasps with random perturbations; default: none
  bool wrench_meshes = false;        // include the wrench set as meshes in answers
};

/// Robustness of a grasp under uncertain contacts, and under an uncertain pose of the object.
struct GraspRobustness {
  Robustness contacts;  // same contacts with perturbed friction, places and normals
  Robustness pose;      // object moved and turned; approach and closing are repeated
};

/// Best grasp of all starts, with its measures.
struct GraspResult {
  GraspRequest request;           // request that was answered
  Outcome outcome;                // done: starts; stopped also while it measures
  WorldCase setting;              // the world, its hand and its scene
  CollisionHand collision_hand;   // collision model of the hand of `setting`
  Grasp grasp;                    // the best of all starts
  WrenchSet wrenches;             // wrenches of its contacts, cones or pyramids
  std::array<int, 6> outcomes{};  // number of starts by GraspOutcome
  int closures = 0;               // starts that ended in force closure
  std::optional<int> best;        // random start of the best grasp; absent: the world's own start
  Pregrasp start;                 // pregrasp from which the best grasp started
  std::optional<GraspMeasures> measures;      // absent: no grasp, or stopped before
  std::optional<GraspRobustness> robustness;  // absent: not requested, or stopped before
  double cpu = 0;                             // processor time, measures included [s]

  [[nodiscard]] int started() const;
};

/// Puts the hand of a world on its object and measures the grasp.
///
/// Start n of several is sample_pregrasp() n, as in compare(). The object yields to jaws as in
/// centred_grasp(), also where the world's own hand approaches it. If that hand reaches neither
/// force closure nor contact of two digits from the palm, it is tried at stand-offs of a quarter to
/// all of max_stand_off(). Robustness: displacements of the object are normally distributed along
/// and about each of its axes through its centre of mass. A displacement after which the hand does
/// not grasp counts as no force closure and as an epsilon below all others. Closing moves the
/// object between jaws but does not rotate it: a misaligned box touches flat jaws along edges or at
/// corners, may rotate about their line, and has an epsilon near zero; real jaws would align it.
/// @throws InputError where a number is out of range, something is not to be found, the hand has no
///         surface or begins in something, or a mounted hand is to start at random; DataError for a
///         wrong file; Stopped before the first grasp.
[[nodiscard]] GraspResult measure_grasp(const GraspRequest& request, const Progress& progress = {});

/// Returns assumptions made about the hand of a result, and doubts about its grasp.
[[nodiscard]] std::vector<std::string> grasp_warnings(const GraspResult& result);

/// Returns the world with the hand in its final posture.
/// @throws InputError if the hand did not reach the object.
[[nodiscard]] WorldSpec grasped_world(const GraspResult& result);

}  // namespace thenar
