#pragma once

/// Pairs of bodies of a scene that may touch.

#include <utility>
#include <vector>

#include "dynamics/mechanism/tree_model.h"
#include "dynamics/stepping/moving_scene.h"

namespace thenar {

/// Pairs of bodies with surfaces, a < b in rising order, except those that move as one, that a
/// joint connects, or that MovingScene::apart names. A joint connects all that is welded to its two
/// bodies, also across bodies without a surface (the middle of a universal joint), but nothing that
/// merely stands on the world as one of them does.
/// @param model  of the scene's mechanism
[[nodiscard]] std::vector<std::pair<int, int>> pairs_that_may_meet(const MovingScene& scene,
                                                                   const TreeModel& model);

}  // namespace thenar
