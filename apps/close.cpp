// thenar close WORLD [--hand NAME] [--object NAME] [-o REPORT.html]
//
// Closes the hand of a world in place, and says why every coordinate stopped.

#include "api/close.h"

#include <memory>

#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/request_options.h"
#include "apps/terminal.h"
#include "base/progress_parts.h"
#include "questions/question_params.h"
#include "report/answers/grasp.h"
#include "report/pages/grasp.h"

namespace thenar {
void add_close(CLI::App& app) {
  auto options = std::make_shared<TypedQuestion>();
  CLI::App* command = app.add_subcommand(
      "close", "Close the hand of a world in place; report what stopped each joint");
  add_request_options(*command, world_params().params(), options->request);
  add_output_options(*command, options->outputs, {true, true, true});
  add_examples(*command, {"close arm_cube", "close arm_cube --csv"});
  command->callback([options] {
    CloseRequest request{read_typed(world_params(), options->request)};
    request.world.pictures = options->outputs.page();
    const CloseResult found = close_in_world(request, terminal_progress());
    deliver(options->outputs, found);
    if (found.outcome.stopped()) throw Stopped("stopped: this is what was found by then");
  });
}

}  // namespace thenar
