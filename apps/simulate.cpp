// thenar simulate SUBJECT --digit D --excitation FDP=0.1 ... | --excitation-file E.csv
//                 [--muscle bounds|rigid-tendon|elastic-tendon]
//                 [--hood separate|fractions|net] [--net NAME|NET.toml]
// thenar simulate SCENE [--seconds S] [--method M] [--step-ms MS] [--pads RUNG ...]
//                [--vary NAME=from:to:count ...]
//
// How one digit moves when its muscles are excited, or a scene of bodies and hands by itself.

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "api/named/files.h"
#include "api/named/things.h"
#include "api/scenes/compare_rungs.h"
#include "api/scenes/simulate_scene.h"
#include "api/simulate.h"
#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "base/progress_parts.h"
#include "base/rung_names.h"
#include "base/units.h"
#include "report/answers/simulate.h"
#include "report/answers/simulate_scene.h"
#include "report/pages/compare_rungs.h"
#include "report/pages/scene_run.h"
#include "report/pages/tendons.h"

namespace thenar {
namespace {

/// Options that only scenes have.
struct SceneArguments {
  std::string method;
  std::vector<std::string> pads;
  std::optional<double> step_ms;
  std::vector<SceneVariation> vary;
};

/// Reports an answer that is incomplete or must not be used. @throws InputError, Stopped
template <typename Result>
void tell_outcome(const Result& result, bool stopped, const Outputs& outputs) {
  const std::string refusal = refusal_of(result);
  require(refusal.empty(), "{}", refusal);
  if (stopped)
    throw Stopped(fmt::format(
        "stopped; all up to then is {}",
        outputs.files.empty() ? "above" : fmt::format("in {}", fmt::join(outputs.files, ", "))));
}

/// `NAME=from:to:count`. @throws InputError if the text is none.
SceneVariation parse_scene_variation(const std::string& text) {
  const std::string form = "NAME=from:to:count";
  const std::size_t equals = text.find('=');
  require(equals != std::string::npos && equals > 0, "wanted {}, got '{}'", form, text);
  const std::string range = text.substr(equals + 1);
  const std::size_t first = range.find(':'), second = range.find(':', first + 1);
  require(first != std::string::npos && second != std::string::npos, "wanted {}, got '{}'", form,
          text);
  const double count = parse_number(range.substr(second + 1), "a count");
  require(count >= 1 && count == std::floor(count) && count <= static_cast<double>(kMostRuns),
          "wanted a whole number of values, 1 to {}, got '{}'", kMostRuns,
          range.substr(second + 1));
  return {text.substr(0, equals), parse_number(range.substr(0, first), "a number"),
          parse_number(range.substr(first + 1, second - first - 1), "a number"),
          static_cast<int>(count)};
}

/// --method, --pads, --step-ms, --vary
void add_scene_options(CLI::App& command, SceneArguments& options) {
  command.add_option(
      "--method", options.method,
      "Of a scene: " + listed(names_in(kSteppingMethodNames)) + "; as the scene says if left out");
  command.add_option("--pads", options.pads,
                     "Of a scene: the rung of all its pads, " + listed(pad_rung_names()) +
                         "; as the scene says if left out. Several: a run on each, compared");
  command.add_option("--step-ms", options.step_ms, "Of a scene by time-stepping: every step [ms]")
      ->check(CLI::PositiveNumber);
  command.add_option_function<std::vector<std::string>>(
      "--vary",
      [&options](const std::vector<std::string>& texts) {
        options.vary.clear();
        for (const std::string& text : texts) options.vary.push_back(parse_scene_variation(text));
      },
      "Of a scene: NAME=from:to:count ..., a run for each combination, over all cores; friction, "
      "mass/BODY [kg], force/NAME [N], drive/NAME [N, Nm], step [s], longest [s], tolerance");
}

/// Simulates a scene, delivers, and refuses as the other answers of `simulate` do.
void simulate_and_deliver(const SceneRequest& request, const Outputs& outputs) {
  const std::string file = outputs.one(".h5");
  if (!file.empty()) require_result_path(file);
  const Progress progress = terminal_progress();
  if (request.vary.empty()) {
    const SceneResult scene = simulate_scene(request, progress);
    print_warnings(scene.outcome.warnings);
    if (!file.empty()) write_scene_run(scene, file, this_run());
    deliver(outputs, scene);
    tell_outcome(scene, scene.outcome.stopped(), outputs);
    return;
  }
  const std::optional<SceneSweepResult> sweep = sweep_scene(request, progress);
  if (!sweep) return;  // another process of mpirun has the answer
  if (sweep->runs.empty()) tell_if_stopped(0, sweep->outcome.asked, "run");
  print_warnings(sweep->outcome.warnings);
  if (!file.empty()) write_scene_sweep(*sweep, file, this_run());
  deliver(outputs, *sweep);
  tell_outcome(*sweep, sweep->outcome.stopped(), outputs);
}

/// Compares rungs of pads, delivers, and refuses as the other answers of `simulate` do.
void compare_and_deliver(const SceneRequest& request, const std::vector<std::string>& rungs,
                         const Outputs& outputs) {
  require(outputs.one(".h5").empty(), "wanted one rung of pads for a file of its motion (.h5)");
  const RungComparison comparison = compare_rungs(request, rungs, terminal_progress());
  if (comparison.runs.empty()) tell_if_stopped(0, comparison.outcome.asked, "rung");
  print_warnings(comparison.outcome.warnings);
  deliver(outputs, comparison);
  tell_outcome(comparison, comparison.outcome.stopped(), outputs);
}

struct SimulateArguments {
  DigitMotionRequest request;
  std::map<std::string, double> slack_mm;  // muscle -> slack length of its tendon [mm]
  double sample_ms = 5;
  SceneArguments scene;
  Outputs outputs;
};

void run_simulate(SimulateArguments options) {
  options.request.sample = 1e-3 * options.sample_ms;
  for (const auto& [muscle, slack] : options.slack_mm)
    options.request.tendon_slack[muscle] = kMm * slack;
  const std::string file = options.outputs.one(".h5");
  if (!file.empty()) require_result_path(file);

  const DigitMotionResult motion = simulate_digit(options.request, terminal_progress());
  print_warnings(motion.outcome.warnings);
  if (!file.empty()) write_motion(motion, file, this_run());
  deliver(options.outputs, motion);
  tell_outcome(motion, motion.outcome.stopped(), options.outputs);
}

/// Refuses options that only the other kind of subject has.
void refuse_options(const CLI::App& command, const std::vector<std::string>& options,
                    const std::string& whose, const std::string& what) {
  for (const std::string& option : options)
    require(command.count(option) == 0, "{} is of {}, and '{}' is {}", option, whose,
            command.get_option("subject")->as<std::string>(), what);
}

/// A scene, with what the command line says beyond its file.
void simulate_scene_of(const CLI::App& command, const SimulateArguments& options) {
  refuse_options(
      command,
      {"--digit", "--posture", "--frozen", "--passive", "--hood", "--net", "--excitation",
       "--excitation-file", "--muscle", "--tendon-slack", "--damping", "--blend", "--gravity"},
      "subjects", "a scene");
  SceneRequest request;
  request.scene = options.request.digit.subject;
  request.data = options.request.digit.data;
  request.path = options.request.digit.path;
  request.method = options.scene.method;
  request.vary = options.scene.vary;
  if (command.count("--seconds") > 0) request.seconds = options.request.seconds;
  if (command.count("--sample-ms") > 0) request.sample = 1e-3 * options.sample_ms;
  if (command.count("--tolerance") > 0) request.tolerance = options.request.tolerance;
  if (options.scene.step_ms) request.step = 1e-3 * *options.scene.step_ms;
  if (options.scene.pads.size() > 1)
    return compare_and_deliver(request, options.scene.pads, options.outputs);
  if (!options.scene.pads.empty()) request.pads = options.scene.pads.front();
  simulate_and_deliver(request, options.outputs);
}

void add_excitation_options(CLI::App& command, DigitMotionRequest& request) {
  add_named_numbers(command, "--excitation", request.excitation, "MUSCLE=0..1",
                    "MUSCLE=0..1 ..., from the start on; others are 0");
  command.add_option("--excitation-file", request.excitation_file,
                     "CSV time_s,MUSCLE,...: straight lines between its rows");
}

void add_physics_options(CLI::App& command, SimulateArguments& options) {
  DigitMotionRequest& request = options.request;
  command.add_option_function<std::string>(
      "--muscle", [&request](const std::string& name) { request.muscle = muscle_named(name); },
      "Muscles: " + listed(muscle_names()) +
          "; rigid-tendon if left out, bounds where the subject states no fibre lengths");
  add_named_numbers(command, "--tendon-slack", options.slack_mm, "MUSCLE=mm",
                    "MUSCLE=mm ...: slack lengths of tendons, for elastic ones");
  command
      .add_option("--damping", request.damping, "Of joints whose subject gives none [N m s/rad]")
      ->check(CLI::NonNegativeNumber);
  command
      .add_option("--blend", request.blend,
                  "Strain over which the bands of a net go from slack to taut")
      ->check(CLI::PositiveNumber);
  command
      .add_option_function<std::vector<double>>(
          "--gravity",
          [&request](const std::vector<double>& g) {
            request.gravity = {g[0], g[1], g[2]};
          },
          "x y z of free fall in the subject's frame [m/s^2]; none if left out")
      ->expected(3);
}

void add_time_options(CLI::App& command, SimulateArguments& options) {
  command
      .add_option("--seconds", options.request.seconds,
                  "How long [s]; of a scene as its file says if left out")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--sample-ms", options.sample_ms,
                  "Between the instants kept [ms]; of a scene as its file says if left out")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--tolerance", options.request.tolerance,
                  "Error of one step: of a subject relative, of a scene in m and rad")
      ->check(CLI::PositiveNumber);
}

}  // namespace

void add_simulate(CLI::App& app) {
  auto options = std::make_shared<SimulateArguments>();  // lives as long as the callback
  CLI::App* command =
      app.add_subcommand("simulate", "How a digit moves when muscles are excited, or a scene");
  add_tendon_options(*command, options->request.digit, "fractions");
  command->get_option("subject")->description(
      "A subject, or a scene of bodies and hands: its name, or its file (TOML)");
  add_excitation_options(*command, options->request);
  add_time_options(*command, *options);
  add_physics_options(*command, *options);
  add_scene_options(*command, options->scene);
  add_output_options(*command, options->outputs, {true, true, true, {".h5"}});
  add_examples(*command,
               {"simulate an_chao_index --excitation FDP=0.1 EDC=0.05 --seconds 0.5",
                "simulate an_chao_index --net chao_an --excitation FDP=0.1 EDC=0.1 --seconds 0.2 "
                "-o motion.html",
                "simulate swinging_pinch --seconds 2 -o run.h5 -o run.html",
                "simulate pinch --vary friction=0.1:1:10 --csv",
                "simulate pencil_pinch --pads elements soft-finger hard-point -o rungs.html"});
  command->callback([command, options] {
    const DigitRequest& digit = options->request.digit;
    (void)named_thing(digit.subject, digit.data);  // refuses what has no such name
    if (is_scene(digit.subject, digit.data)) return simulate_scene_of(*command, *options);
    refuse_options(*command, {"--method", "--pads", "--step-ms", "--vary"}, "scenes", "a subject");
    run_simulate(*options);
  });
}

}  // namespace thenar
