#pragma once

/// What `thenar grasp` and `thenar close` found, as text, JSON and a report.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "apps/world_hand.h"
#include "base/progress.h"
#include "grasp/grasp.h"

namespace thenar {

/// What was asked.
struct GraspQuestion {
  std::string path;               // of the world
  std::vector<std::string> data;  // folders where hands are found by name
  WorldSpec world;
  WorldHand hand;
  Scene scene;
  ForceLimit limit = ForceLimit::kL1;
  double gap = 1e-3;  // of epsilon's bounds
  int edges = 0;      // of friction pyramids; 0: cones
  int starts = 0;     // drawn at random; 0: the world's own
  unsigned seed = 1;
};

struct GraspMeasures;
struct GraspRobustness;

/// What came of it.
struct GraspAnswer {
  Grasp grasp;                                        // the best of all starts
  WrenchSet wrenches;                                 // of its contacts, as measured
  std::array<int, 6> outcomes{};                      // of all starts, by GraspOutcome
  int closures = 0;                                   // starts that ended in force closure
  int best = -1;                                      // its start; -1: none was drawn
  Pose<double> X_start;                               // of the hand: where the best began
  double way = 0;                                     // it could go from there [m]; 0: it did not
  double cpu = 0;                                     // [s]
  std::shared_ptr<const GraspMeasures> measures;      // const, so shared by copies; null: no grasp
  std::shared_ptr<const GraspRobustness> robustness;  // the same; null: not asked
};

/// Starts, measures, and keeps the best. @param way  farthest approach [m]; 0: none
/// @throws Interrupted where progress says stop
[[nodiscard]] GraspAnswer answer(const GraspQuestion& question, const TouchingHand& touching,
                                 double way, const Progress& progress = {});

/// The grasp of an answer once more, in a scene that is a little different; the object yields to
/// jaws as in centred_grasp().
[[nodiscard]] Grasp regrasp(const GraspQuestion& question, const TouchingHand& touching,
                            const GraspAnswer& answer, const Scene& scene);

/// The contacts' wrenches, with cones or pyramids.
[[nodiscard]] WrenchSet wrenches_of(const GraspQuestion& question,
                                    const std::vector<HandContact>& contacts);

/// @param pictures  projections and slices of the wrench set as meshes, too
[[nodiscard]] nlohmann::ordered_json grasp_json(const GraspQuestion& question,
                                                const TouchingHand& touching,
                                                const GraspAnswer& answer, bool pictures = false);
[[nodiscard]] std::string grasp_text(const GraspQuestion& question, const TouchingHand& touching,
                                     const GraspAnswer& answer);

/// One line for all warnings of a kind, those that begin alike up to the first comma or colon: the
/// first of them, with how many more there are.
[[nodiscard]] std::vector<std::string> folded(const std::vector<std::string>& warnings);

/// A page of the grasp; human hands are drawn finer than they touch. @throws InputError
void write_grasp_report(const GraspQuestion& question, const TouchingHand& touching,
                        const GraspAnswer& answer, const std::string& path);

/// Which world, and which of its things.
struct WorldChoice {
  std::string world;         // a file, or the name of one of worlds/
  std::string hand, object;  // names, or "" for the only ones
  std::string data;          // --data
};

/// The question about a world file. @throws InputError where something is not to be found.
[[nodiscard]] GraspQuestion ask_world(const WorldChoice& choice);

/// The same about a hand that the world does not have: only its own start is missing.
[[nodiscard]] GraspQuestion ask_stranger(const WorldChoice& choice);

/// Whether the world has the hand that is named.
[[nodiscard]] bool has_hand(const WorldChoice& choice);

}  // namespace thenar
