// thenar grasp WORLD [--hand NAME] [--object NAME] [--random N --seed S] [--robustness N] ..
//
// Puts the hand of a world on its object, finds the contacts, and measures the grasp.

#include "api/grasp.h"

#include <memory>
#include <string>

#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/terminal.h"
#include "base/file_io.h"
#include "base/progress_parts.h"
#include "report/answers/grasp.h"
#include "report/pages/grasp.h"

namespace thenar {
namespace {

struct GraspArguments {
  GraspRequest request;
  std::string norm = "l1", save;
  Outputs outputs;
};

void run_grasp(GraspArguments& options) {
  require_ending(options.save, {".toml"});
  if (!options.save.empty()) require_writable(options.save);
  GraspRequest& request = options.request;
  request.world.pictures = options.outputs.page();
  request.limit = options.norm == "l1" ? ForceNorm::kL1 : ForceNorm::kLinf;
  const GraspResult found = measure_grasp(request, terminal_progress());
  deliver(options.outputs, found);
  if (!options.save.empty()) save_world(grasped_world(found), options.save);
  if (found.outcome.stopped()) throw Stopped("stopped: this is what was found by then");
}

/// Adds options for the start of the hand and the number of random starts.
void add_start_options(CLI::App& command, GraspRequest& request) {
  command.add_flag("--approach,!--no-approach", request.approach,
                   "Approach along the palm's direction first (default), or close where the hand "
                   "is");
  command.add_option("--approach-distance,--way", request.approach_distance,
                     "Farthest approach [m]");
  command.add_option("--random", request.starts,
                     "Best of so many random pregrasps, drawn as in 'thenar compare'; 0: the "
                     "world's own; --hand may then be any hand by name");
  command.add_option("--seed", request.seed, "Seed of --random and --robustness");
}

/// Adds options for the measures of the grasp.
void add_measure_options(CLI::App& command, GraspArguments& options) {
  GraspRequest& request = options.request;
  command.add_option("--robustness", request.robustness.draws,
                     "Draws of uncertain friction, contacts and pose of the object; 0: none");
  command
      .add_option("--norm", options.norm,
                  "Limit of contact forces: l1 their sum, linf each of them")
      ->check(CLI::IsMember({"l1", "linf"}));
  command.add_option("--tolerance,--gap", request.tolerance,
                     "Largest difference of the certified bounds of epsilon, also in --robustness");
  command.add_option("--edges", request.edges,
                     "Friction pyramids of so many edges in epsilon, volume, robustness and "
                     "wrench sets; 0: cones, as all other measures have");
  command.add_flag("--wrenches", request.wrench_meshes,
                   "With JSON, also the wrench set as meshes: projected and cut");
}

}  // namespace

void add_grasp(CLI::App& app) {
  auto options = std::make_shared<GraspArguments>();
  CLI::App* command =
      app.add_subcommand("grasp", "Put the hand of a world on its object and measure the grasp");
  add_world_options(*command, options->request.world);
  add_start_options(*command, options->request);
  add_measure_options(*command, *options);
  add_output_options(*command, options->outputs, {true, true, true});
  command->add_option("--save", options->save, "Also write the world with the hand as it ended");
  add_examples(*command, {"grasp barrett_bobbin -o out/grasp.html",
                          "grasp jaw_box --random 20 --seed 2 --robustness 100"});
  command->callback([options] { run_grasp(*options); });
}

}  // namespace thenar
