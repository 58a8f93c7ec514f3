#pragma once

/// What `thenar grasp` and `thenar close` are asked.

#include <string>
#include <vector>

#include "api/worlds.h"
#include "grasp/closing/grasp.h"

namespace thenar {

/// What was asked.
struct GraspQuestion {
  std::string path;               // of the world
  std::vector<std::string> data;  // folders where hands are found by name
  WorldSpec world;
  WorldHand hand;
  Scene scene;
  ForceNorm limit = ForceNorm::kL1;
  double gap = 1e-3;  // of epsilon's bounds
  int edges = 0;      // of friction pyramids; 0: cones
  int starts = 0;     // drawn at random; 0: the world's own
  unsigned seed = 1;
};

/// Which world, and which of its things.
struct WorldChoice {
  std::string world;         // a file, or the name of one of worlds/
  std::string hand, object;  // names, or "" for the only ones
  std::string data;          // --data
  bool pictures = false;     // whether it will be drawn: human hands finer than they touch
};

/// The question about a world file. @throws InputError where something is not to be found.
[[nodiscard]] GraspQuestion ask_world(const WorldChoice& choice, const Progress& progress = {});

/// The same about a hand that the world does not have: only its own start is missing.
[[nodiscard]] GraspQuestion ask_stranger(const WorldChoice& choice, const Progress& progress = {});

/// Whether the world has the hand that is named.
[[nodiscard]] bool has_hand(const WorldChoice& choice);

}  // namespace thenar
