#include "server/methods/method_table.h"

namespace thenar::internal {

void add_motion_methods(MethodTable& /*table*/) {}

}  // namespace thenar::internal
