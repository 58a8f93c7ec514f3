// thenar tendon solve|sweep|infer ...
//
// The tendons of one digit: the tension in every band of its extensor hood.

#include "apps/commands.h"
#include "apps/tendon_commands.h"

namespace thenar {

void add_tendon(CLI::App& app) {
  CLI::App* command = app.add_subcommand("tendon", "Tension in every band of the extensor hood");
  command->require_subcommand(1);
  add_tendon_infer(*command);
  add_tendon_solve(*command);
  add_tendon_sweep(*command);
}

}  // namespace thenar
