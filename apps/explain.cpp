#include "apps/commands.h"
namespace thenar {
void add_explain(CLI::App&) {}
}  // namespace thenar
