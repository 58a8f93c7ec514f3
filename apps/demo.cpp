// thenar demo -o out
//
// The main job on real data: fits the middle fingers of two hands to measured forces by every
// solver, cross-validates, predicts what was not seen, samples their posteriors, asks
// what forces tell of a thumb's axes, finds a thumb again from made-up forces and muscle activity
// and adds what was measured in people, compares two thumbs, moves two scenes, lets hands grasp,
// presses a finger pad, pinches a pencil on every rung of pads, and writes a page for each
// question, and a front page that sums them up.

#include "api/demo.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "api/compare.h"
#include "api/named/data_folders.h"
#include "api/pads/press_pad.h"
#include "api/scenes/compare_rungs.h"
#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/terminal.h"
#include "base/file_io.h"
#include "base/progress_parts.h"
#include "base/units.h"
#include "data/io/scene/scene_pad.h"
#include "report/demo/demo.h"
#include "report/demo/demo_findings.h"
#include "report/pads/press_answer.h"
#include "report/pages/compare_rungs.h"
#include "report/pages/comparison.h"

namespace thenar {
namespace {

struct DemoArguments {
  std::string data;
  std::optional<Path> path;
  std::string output = "out";
};

/// A page of a question that was asked here.
SetPage page_for(const char* file, const char* title, const Finding& finding, Json page,
                 const char* figure) {
  Json shown = first_block(page, figure);
  return {file, title, finding.opening, finding.line, std::move(page), std::move(shown)};
}

/// Lets a human and three robot hands go at two objects, some seconds' work.
std::vector<SetPage> compare_some_hands(const DemoArguments& options, const Progress& progress) {
  CompareRequest request;
  request.hands = {"human:skewed", "barrett", "shadow", "parallel_jaw"};
  request.objects = {"sphere_70", "cube_50"};
  request.approaches = 8;
  request.path = options.path;
  request.data = options.data;
  const HandComparison result = compare_hands(request, progress);
  if (!result.comparison.complete) return {};
  return {page_for("hands.html", "How do hands compare when they grasp?",
                   hands_finding(result.comparison), page_of(result), "row")};
}

/// Presses the default finger pad under a ball, and pinches a pencil between two, by elements and
/// by every cheaper model, half a minute's work.
std::vector<SetPage> compare_pads(const DemoArguments& options, const Progress& progress) {
  PressRequest press;
  press.object.name = "sphere";
  press.pad.data = options.data;
  press.depth = 1 * kMm;
  press.points = 6;
  press.force_error = 0.1;
  press.rungs = true;
  const PressedPad pressed = press_pad(press, progress);
  SceneRequest scene;
  scene.scene = "pencil_pinch";
  scene.data = options.data;
  scene.path = options.path;
  const RungComparison pencil = compare_rungs(scene, pad_rung_names(), progress);
  if (progress.stop()) return {};
  return {page_for("pad.html", "What does a finger pad do under a ball?", pad_finding(pressed),
                   page_of(pressed), "scene"),
          page_for("pencil_pinch.html", "What do models of pads cost in a pinch?",
                   pencil_finding(pencil), page_of(pencil), "row")};
}

void run_demo(const DemoArguments& options) {
  const auto begin = std::chrono::steady_clock::now();
  const Progress progress = terminal_progress();
  const std::string path = options.output + "/" + kFrontPage;
  require_writable(path);
  const DemoResult demo =
      run_demo_study({options.data, options.output, this_run(), options.path}, progress);
  if (demo.stopped) throw Stopped("stopped before the report was complete");
  std::vector<SetPage> more = compare_some_hands(options, progress);
  for (SetPage& page : compare_pads(options, progress)) more.push_back(std::move(page));
  if (progress.stop()) throw Stopped("stopped before the report was complete");
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  for (const SetPage& page : demo_pages(demo, std::move(more), seconds))
    write_page(page.page, options.output + "/" + page.file);
  print_answer(demo_text(demo, std::filesystem::absolute(path).string(), seconds));
}

}  // namespace

void add_demo(CLI::App& app) {
  auto options = std::make_shared<DemoArguments>();  // lives as long as the callback
  CLI::App* command = app.add_subcommand("demo", "Fit real data and write a report");
  add_hand_path_option(*command, options->path);
  add_data_option(*command, options->data);
  command->add_option("-o,--out,--output", options->output, "Folder for the report");
  add_examples(*command, {"demo -o out"});
  command->callback([options] {
    options->data = data_with("fits", options->data);
    run_demo(*options);
  });
}

}  // namespace thenar
