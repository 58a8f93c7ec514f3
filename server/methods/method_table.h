#pragma once

/// Table of all methods of a server. Each group has its own source file, which adds its rows.

#include "server/method.h"
#include "server/session.h"

namespace thenar {

namespace internal {

/// Adds session.*, catalogue.* and picture.*.
void add_session_methods(MethodTable& table);
/// Adds world.*, then hand.*.
void add_world_methods(MethodTable& table);
/// Adds hand.*.
void add_hand_methods(MethodTable& table);
/// Adds grasp.*.
void add_grasp_methods(MethodTable& table);
/// Adds motion.*.
void add_motion_methods(MethodTable& table);
/// Adds tendons.*.
void add_tendon_methods(MethodTable& table);
/// Adds fit.*.
void add_fit_methods(MethodTable& table);
/// Adds ask.* and job.*.
void add_question_methods(MethodTable& table);

}  // namespace internal

/// Returns the table of all methods, in the order of the documentation.
[[nodiscard]] MethodTable method_table();

}  // namespace thenar
