#pragma once

/// Closing of a hand in place in a world: what stops every joint, and what it holds.
///
///     CloseRequest request;
///     request.world.world = "jaw_box";
///     const CloseResult closed = close_in_world(request);

#include "api/grasp.h"

namespace thenar {

/// Options of close_in_world(): the hand that closes and the object that may be in it.
struct CloseRequest {
  WorldRequest world;  // world, its hand and its object
};

/// Hand at the end of closing.
struct CloseResult {
  CloseRequest request;  // request that was answered
  Outcome outcome;       // outcome of the grasp
  GraspResult grasp;  // grasp without an approach; grasp.closed says what stopped each coordinate
};

/// Closes the hand of a world without approaching the object, and measures the grasp if the object
/// is touched: measure_grasp() with GraspRequest::approach false.
/// @throws InputError, DataError, Stopped as measure_grasp()
[[nodiscard]] CloseResult close_in_world(const CloseRequest& request,
                                         const Progress& progress = {});

}  // namespace thenar
