#pragma once

/// Pairs of bodies of a scene that may touch.

#include <utility>
#include <vector>

#include "dynamics/mechanism/tree_model.h"
#include "dynamics/stepping/moving_scene.h"

namespace thenar {

/// Lists the pairs of bodies (a < b, sorted) that may collide: both have a surface, and they do not
/// belong to one link, are not connected by a joint and are not in MovingScene::apart. A joint
/// connects all bodies welded to its two bodies, also across bodies without a surface (the middle
/// of a universal joint); welds to the world do not count.
/// @param model  tree model of the scene's mechanism
[[nodiscard]] std::vector<std::pair<int, int>> pairs_that_may_meet(const MovingScene& scene,
                                                                   const TreeModel& model);

}  // namespace thenar
