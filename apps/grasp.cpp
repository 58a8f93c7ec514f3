// thenar grasp WORLD [--hand NAME] [--object NAME] [--random N --seed S] [--robustness N] ..
//
// Puts the hand of a world on its object, finds the contacts, and measures the grasp.

#include "api/grasp.h"

#include <memory>
#include <string>

#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/request_options.h"
#include "apps/terminal.h"
#include "base/file_io.h"
#include "base/progress_parts.h"
#include "questions/question_params.h"
#include "report/answers/grasp.h"
#include "report/pages/grasp.h"

namespace thenar {
namespace {

struct GraspArguments : TypedQuestion {
  std::string save;
};

void run_grasp(const GraspArguments& options) {
  if (!options.save.empty()) {
    require_ending(options.save, {".toml"});
    require_writable(options.save);
  }
  GraspRequest request = record_typed("grasp", grasp_params(), options.request);
  request.world.pictures = options.outputs.page();
  const GraspResult found = measure_grasp(request, terminal_progress());
  deliver(options.outputs, found);
  if (!options.save.empty()) save_world(grasped_world(found), options.save);
  if (found.outcome.stopped()) throw Stopped("stopped: this is what was found by then");
}

}  // namespace

void add_grasp(CLI::App& app) {
  auto options = std::make_shared<GraspArguments>();
  CLI::App* command = app.add_subcommand(
      "grasp", "Approach and grasp the object of a world; compute grasp quality");
  add_request_options(*command, grasp_params().params(), options->request);
  add_output_options(*command, options->outputs, {true, true, true});
  command->add_option("--save", options->save, "Also write the world with the hand as it ended");
  add_examples(*command, {"grasp barrett_bobbin -o out/grasp.html",
                          "grasp jaw_box --random 20 --seed 2 --robustness 100"});
  command->callback([options] { run_grasp(*options); });
}

}  // namespace thenar
