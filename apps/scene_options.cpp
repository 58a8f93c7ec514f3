#include "apps/scene_options.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "api/named/files.h"
#include "apps/options.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "base/progress_parts.h"
#include "report/answers/simulate_scene.h"
#include "report/pages/scene_run.h"

namespace thenar {
namespace {

/// What is said behind an answer that is not whole, or must not be used.
template <typename Result>
void tell_outcome(const Result& result, bool stopped, const Outputs& outputs) {
  const std::string refusal = refusal_of(result);
  require(refusal.empty(), "{}", refusal);
  if (stopped)
    throw Stopped(fmt::format(
        "stopped; all up to then is {}",
        outputs.files.empty() ? "above" : fmt::format("in {}", fmt::join(outputs.files, ", "))));
}

}  // namespace

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

void add_scene_options(CLI::App& command, SceneArguments& options) {
  command.add_option("--method", options.method,
                     "Of a scene: " + listed(stepping_names()) + "; as the scene says if left out");
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

void simulate_and_deliver(const SceneRequest& request, const Outputs& outputs) {
  const std::string file = outputs.one(".h5");
  if (!file.empty()) require_result_path(file);
  const Progress progress = terminal_progress();
  if (request.vary.empty()) {
    const SimulatedScene scene = run_scene(request, progress);
    print_warnings(warnings_of(scene));
    if (!file.empty()) write_scene_run(scene, file, this_run());
    deliver(outputs, scene);
    tell_outcome(scene, scene.run.status == SceneStatus::kStopped, outputs);
    return;
  }
  const SceneSweep sweep = vary_scene(request, progress);
  if (sweep.runs.empty()) tell_if_stopped(0, sweep.asked, "run");
  print_warnings(warnings_of(sweep));
  if (!file.empty()) write_scene_sweep(sweep, file, this_run());
  deliver(outputs, sweep);
  tell_outcome(sweep, progress.stop(), outputs);
}

}  // namespace thenar
