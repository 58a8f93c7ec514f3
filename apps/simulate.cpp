// thenar simulate SUBJECT --digit D --excitation FDP=0.1 ... | --excitation-file E.csv
//                 [--muscle bounds|rigid-tendon|elastic-tendon]
//                 [--hood separate|fractions|net] [--net NAME|NET.toml]
// thenar simulate SCENE [--seconds S] [--method M] [--step-ms MS] [--pads RUNG ...]
//                [--vary NAME=from:to:count ...]
//
// Simulates one digit with excited muscles, or a scene of bodies and hands.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "api/named/files.h"
#include "api/named/things.h"
#include "api/scenes/compare_rungs.h"
#include "api/scenes/scene_account.h"
#include "api/scenes/write_scene_run.h"
#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/request_options.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "base/progress_parts.h"
#include "questions/question_params.h"
#include "report/answers/simulate.h"
#include "report/answers/simulate_scene.h"
#include "report/pages/compare_rungs.h"
#include "report/pages/scene_run.h"
#include "report/pages/tendons.h"

namespace thenar {
namespace {

/// Delivers an answer. @throws InputError or Stopped after one that must not be used or is
/// incomplete
template <typename Result>
void deliver_with_outcome(const Result& result, const Outputs& outputs) {
  deliver(outputs, result);
  const std::string refusal = refusal_of(result);
  require(refusal.empty(), "{}", refusal);
  if (result.outcome.stopped())
    throw Stopped(fmt::format(
        "stopped; all up to then is {}",
        outputs.files.empty() ? "above" : fmt::format("in {}", fmt::join(outputs.files, ", "))));
}

/// Simulates a scene, delivers, and refuses as the other answers of `simulate` do.
void simulate_and_deliver(const SceneRequest& request, const Outputs& outputs) {
  // Refuse to overwrite any other file before hours of simulation.
  const std::string file = outputs.only_file(".h5");
  if (!file.empty()) require_result_path(file);
  const Progress progress = terminal_progress();
  if (request.vary.empty()) {
    const SceneResult scene = simulate_scene(request, progress);
    print_warnings(scene.outcome.warnings);
    if (!file.empty()) write_scene_run(scene, file, this_run());
    return deliver_with_outcome(scene, outputs);
  }
  // Numbers that vary make a sweep, which several processes may share.
  const std::optional<SceneSweepResult> sweep = sweep_scene(request, progress);
  if (!sweep) return;  // another process of mpirun has the answer
  if (sweep->runs.empty()) throw_if_stopped(0, sweep->outcome.asked, "run");
  print_warnings(sweep->outcome.warnings);
  if (!file.empty()) write_scene_sweep(*sweep, file, this_run());
  deliver_with_outcome(*sweep, outputs);
}

/// Compares rungs of pads, delivers, and refuses as the other answers of `simulate` do.
void compare_and_deliver(const SceneRequest& request, const std::vector<std::string>& rungs,
                         const Outputs& outputs) {
  require(outputs.only_file(".h5").empty(),
          "wanted one rung of pads for a file of its motion (.h5)");
  const RungComparison comparison = compare_rungs(request, rungs, terminal_progress());
  if (comparison.runs.empty()) throw_if_stopped(0, comparison.outcome.asked, "rung");
  print_warnings(comparison.outcome.warnings);
  deliver_with_outcome(comparison, outputs);
}

/// Arguments: of a subject, of a scene, or of both.
struct SimulateArguments : TypedQuestion {
  std::vector<std::string> pads;  // rungs
};

void simulate_digit_of(const SimulateArguments& options) {
  const DigitMotionRequest request =
      record_typed("digit_motion", digit_motion_params(), options.request);
  const std::string file = options.outputs.only_file(".h5");
  if (!file.empty()) require_result_path(file);
  const DigitMotionResult motion = simulate_digit(request, terminal_progress());
  print_warnings(motion.outcome.warnings);
  if (!file.empty()) write_motion(motion, file, this_run());
  deliver_with_outcome(motion, options.outputs);
}

/// Refuses options that only the other kind of subject has.
void refuse_options(const CLI::App& command, const std::vector<std::string>& options,
                    const std::string& whose, const std::string& what) {
  for (const std::string& option : options)
    require(command.count(option) == 0, "{} applies only to {}; '{}' is {}", option, whose,
            command.get_option("subject")->as<std::string>(), what);
}

/// A scene, with what the command line says beyond its file.
void simulate_scene_of(const SimulateArguments& options) {
  Json typed = options.request;
  typed["scene"] = typed["subject"];
  typed.erase("subject");
  if (options.pads.size() == 1) typed["pads"] = options.pads.front();
  const bool varies = typed.contains("vary");
  const RequestTable<SceneRequest> table = varies ? scene_sweep_params() : scene_params();
  const SceneRequest request = read_typed(table, typed);
  // No question compares rungs of pads: it has no record.
  if (options.pads.size() > 1) return compare_and_deliver(request, options.pads, options.outputs);
  set_request(varies ? "scene_sweep" : "scene", table.write(request));
  simulate_and_deliver(request, options.outputs);
}

}  // namespace

void add_simulate(CLI::App& app) {
  auto options = std::make_shared<SimulateArguments>();  // lives as long as the callback
  CLI::App* command =
      app.add_subcommand("simulate", "Simulate a digit with excited muscles, or a scene");
  // Options that both have are typed once, in the words of a subject.
  const std::vector<Param> digit = digit_motion_params().params();
  add_request_options(*command, without(digit, {"vary_deg", "vary_rad"}), options->request);
  std::vector<std::string> known{"scene", "pads"};
  for (const Param& param : digit) known.push_back(param.member.name);
  add_request_options(*command, without(scene_sweep_params().params(), known), options->request);
  command->get_option("--vary")->required(false);
  command->get_option("subject")->description(
      "A subject, or a scene of bodies and hands: its name, or its file (TOML)");
  // A scene has defaults of its own, in its file.
  command->get_option("--seconds")->description("Duration [s]; default for a scene: from its file");
  command->get_option("--sample-ms")
      ->description("Time between the instants kept [ms]; default for a scene: from its file");
  command->get_option("--tolerance")
      ->description(
          "Error tolerance per step: relative for a subject; in m and rad for a scene (default: "
          "from its file)");
  command->add_option("--pads", options->pads,
                      "Level of detail of all pads of a scene: " + listed(pad_rung_names()) +
                          "; default: from the scene. Several: one run for each, compared");
  add_output_options(*command, options->outputs, {true, true, true, {".h5"}});
  add_examples(*command,
               {"simulate an_chao_index --excitation FDP=0.1 EDC=0.05 --seconds 0.5",
                "simulate an_chao_index --net chao_an --excitation FDP=0.1 EDC=0.1 --seconds 0.2 "
                "-o motion.html",
                "simulate swinging_pinch --seconds 2 -o run.h5 -o run.html",
                "simulate pinch --vary friction=0.1:1:10 --csv",
                "simulate pencil_pinch --pads elements soft-finger hard-point -o rungs.html"});
  command->callback([command, options] {
    // The name decides whether a subject moves or a scene; options of the other are refused.
    const std::string subject = options->request["subject"].get<std::string>();
    const std::string data = options->request.value("data", "");
    (void)named_thing(subject, data);  // refuses what has no such name
    if (is_scene(subject, data)) {
      refuse_options(
          *command,
          {"--digit", "--posture", "--frozen", "--passive", "--hood", "--net", "--excitation",
           "--excitation-file", "--muscle", "--tendon-slack", "--damping", "--blend", "--gravity"},
          "subjects", "a scene");
      return simulate_scene_of(*options);
    }
    refuse_options(*command, {"--method", "--pads", "--step-ms", "--vary"}, "scenes", "a subject");
    simulate_digit_of(*options);
  });
}

}  // namespace thenar
