#pragma once

/// Tendons of a digit: extensor nets at rest, motion by muscles, nets inferred from forces.
/// Example: examples/05_extensor_net.cpp, 06_motion.cpp.

#include "api/read_motion.h"
#include "api/simulate.h"
#include "api/tendon_infer.h"
#include "api/tendon_solve.h"
