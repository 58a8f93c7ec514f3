#pragma once

/// The grasp of an object by a hand of a world: closing, contacts, quality, loads, robustness.

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
  int draws = 0;                                // 0: robustness is not asked
  ContactUncertainty contacts{0.2, 2e-3, 0.1};  // friction by a fifth, 2 mm, 0.1 rad
  double place = 5e-3;                          // of the object, standard deviation an axis [m]
  double turn = 0.05;                           // of the object, standard deviation an axis [rad]
};

/// Options of a grasp: the hand, the object, and the measures of the grasp.
struct GraspRequest {
  WorldRequest world;            // with `starts` the hand may be one that the world does not have
  bool approach = true;          // goes along the palm's direction first; false: closes where the
                                 // hand is, as a mounted hand always does
  double approach_distance = 1;  // farthest approach [m]
  int starts = 0;                // pregrasps drawn at random; 0: the world's own
  unsigned seed = 1;             // of the starts, and of robustness
  ForceNorm limit = ForceNorm::kL1;  // of contact forces in epsilon and volume
  double tolerance = 1e-3;           // largest difference of epsilon's certified bounds [1]
  int edges = 0;                     // of friction pyramids, 3 .. 100; 0: cones
  RobustnessRequest robustness;
  bool wrench_meshes = false;  // whether answers hold the wrench set as meshes, too
};

/// Robustness of a grasp under uncertain contacts, and under an uncertain pose of the object.
struct GraspRobustness {
  Robustness contacts;  // the same contacts with other friction, places and normals
  Robustness pose;      // the object moved and turned: approached, closed and touched anew
};

/// The best grasp of all starts, with its measures.
struct GraspResult {
  GraspRequest request;
  Outcome outcome;                            // done: starts; stopped also while it measures
  WorldCase setting;                          // the world, its hand and its scene
  CollisionHand collision_hand;               // collision model of the hand of `setting`
  Grasp grasp;                                // the best of all starts
  WrenchSet wrenches;                         // of its contacts, cones or pyramids
  std::array<int, 6> outcomes{};              // of all starts, by GraspOutcome
  int closures = 0;                           // starts that ended in force closure
  int best = -1;                              // start of the best grasp; -1: none was drawn
  Pregrasp start;                             // where the best grasp began
  std::optional<GraspMeasures> measures;      // none: no grasp, or stopped before
  std::optional<GraspRobustness> robustness;  // none: not asked, or stopped before
  double cpu = 0;                             // processor time, measures included [s]

  [[nodiscard]] int started() const;
};

/// Puts the hand of a world on its object and measures the grasp.
///
/// Start n of several is sample_pregrasp() n, as in compare(), and the object yields to jaws as in
/// centred_grasp(); so it does where the world's own hand approaches it. That hand stands off by a
/// quarter to all of max_stand_off() where it holds nothing from the palm: no force closure, and no
/// two digits that touch. Robustness: moves of the
/// object are normal along and about each of its axes, about its centre of mass; a move after which
/// the hand does not grasp is a miss, which is no force closure and below every epsilon. Closing
/// moves the object between jaws, but does not turn it: a box that is off by angles touches flat
/// jaws along edges or at corners, where it may turn about their line, and epsilon is near zero;
/// real jaws would turn it flush.
/// @throws InputError where a number is out of range, something is not to be found, the hand has no
///         surface or begins in something, or a mounted hand is to start at random; DataError of
///         files; Stopped where it is stopped before the first grasp.
[[nodiscard]] GraspResult measure_grasp(const GraspRequest& request, const Progress& progress = {});

/// Returns assumptions made about the hand of a result, and doubts about its grasp.
[[nodiscard]] std::vector<std::string> grasp_warnings(const GraspResult& result);

/// Returns the world with the hand as the grasp left it.
/// @throws InputError if the hand did not reach the object.
[[nodiscard]] WorldSpec grasped_world(const GraspResult& result);

}  // namespace thenar
