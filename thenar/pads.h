#pragma once

/// Finger pads: pressed by an object, fitted to measured presses, turned into laws.
/// Example: examples/16_pressed_pad.cpp.

#include "api/named/pads.h"
#include "api/pads/calibrate_pad.h"
#include "api/pads/fit_pad.h"
#include "api/pads/press_object.h"
#include "api/pads/press_pad.h"
