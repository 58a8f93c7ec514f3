#pragma once

/// Scenes that move: bodies, robots and human hands in contact.
/// Example: examples/12_falling_cube.cpp, 15_human_scene.cpp.

#include "api/scenes/compare_rungs.h"
#include "api/scenes/read_scene_run.h"
#include "api/scenes/scene_account.h"
#include "api/scenes/scene_builder.h"
#include "api/scenes/simulate_scene.h"
#include "api/scenes/world_scene.h"
#include "api/scenes/write_scene_run.h"
