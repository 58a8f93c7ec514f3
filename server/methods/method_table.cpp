#include "server/methods/method_table.h"

namespace thenar {

MethodTable method_table() {
  MethodTable table;
  internal::add_session_methods(table);
  internal::add_world_methods(table);
  internal::add_grasp_methods(table);
  internal::add_motion_methods(table);
  internal::add_tendon_methods(table);
  internal::add_fit_methods(table);
  internal::add_question_methods(table);
  return table;
}

}  // namespace thenar
