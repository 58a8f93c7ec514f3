#pragma once

/// What `thenar grasp` and `thenar close` found, as text, JSON and a report.

#include <array>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "apps/world_hand.h"
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

/// What came of it.
struct GraspAnswer {
  Grasp grasp;                    // the best of all starts
  WrenchSet wrenches;             // of its contacts, as measured
  std::array<int, 6> outcomes{};  // of all starts, by GraspOutcome
  int closures = 0;               // starts that ended in force closure
  int best = -1;                  // its start; -1: none was drawn
  double cpu = 0;                 // [s]
};

/// Starts, measures, and keeps the best. @param way  farthest approach [m]; 0: none
[[nodiscard]] GraspAnswer answer(const GraspQuestion& question, const TouchingHand& touching,
                                 double way);

/// The contacts' wrenches, with cones or pyramids.
[[nodiscard]] WrenchSet wrenches_of(const GraspQuestion& question,
                                    const std::vector<HandContact>& contacts);

[[nodiscard]] nlohmann::ordered_json grasp_json(const GraspQuestion& question,
                                                const TouchingHand& touching,
                                                const GraspAnswer& answer);
[[nodiscard]] std::string grasp_text(const GraspQuestion& question, const TouchingHand& touching,
                                     const GraspAnswer& answer);

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
