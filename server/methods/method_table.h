#pragma once

/// All methods that a server offers. Each group stands in a file of its name and adds its rows.

#include "server/method.h"
#include "server/session.h"

namespace thenar {

namespace internal {

/// session.*, catalogue.* and picture.*
void add_session_methods(MethodTable& table);
/// world.*, then hand.*
void add_world_methods(MethodTable& table);
/// hand.*
void add_hand_methods(MethodTable& table);
/// grasp.*
void add_grasp_methods(MethodTable& table);
/// motion.*
void add_motion_methods(MethodTable& table);
/// tendons.*
void add_tendon_methods(MethodTable& table);
/// fit.*
void add_fit_methods(MethodTable& table);
/// ask.* and job.*
void add_question_methods(MethodTable& table);

}  // namespace internal

/// The whole table, in the order in which it is documented.
[[nodiscard]] MethodTable method_table();

}  // namespace thenar
