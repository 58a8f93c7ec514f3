#pragma once

/// What `thenar grasp` and `thenar close` are asked.

#include "api/worlds.h"

namespace thenar {

/// What was asked, of which world.
struct GraspQuestion : WorldCase {
  ForceNorm limit = ForceNorm::kL1;
  double gap = 1e-3;  // of epsilon's bounds
  int edges = 0;      // of friction pyramids; 0: cones
  int starts = 0;     // drawn at random; 0: the world's own
  unsigned seed = 1;
};

/// The question about a world file. @throws InputError where something is not to be found.
[[nodiscard]] inline GraspQuestion ask_world(const WorldRequest& choice, bool hand_from_elsewhere,
                                             const Progress& progress = {}) {
  GraspQuestion question;
  static_cast<WorldCase&>(question) = open_world(choice, hand_from_elsewhere, progress);
  return question;
}

}  // namespace thenar
