// thenar demo -o out
//
// The main job on real data: fits the middle fingers of two hands to measured forces by every
// solver, cross-validates, predicts what was not seen, samples their posteriors, asks
// what forces tell of a thumb's axes, compares two thumbs, moves two scenes, lets hands grasp,
// presses a finger pad, pinches a pencil on every rung of pads, and writes it all as one page,
// grasps, pads and scenes as pages beside it.

#include "api/demo.h"

#include <chrono>
#include <filesystem>
#include <memory>

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
#include "report/pads/press_answer.h"
#include "report/pages/compare_rungs.h"
#include "report/pages/comparison.h"
#include "report/pages/comparison_tables.h"
#include "report/pages/demo.h"
#include "report/pages/scene_run.h"

namespace thenar {
namespace {

struct DemoArguments {
  std::string data;
  std::string output = "out";
};

constexpr const char* kHandsPage = "hands.html";
constexpr const char* kPadPage = "pad.html";
constexpr const char* kPencilPage = "pencil_pinch.html";

/// Lets a human and three robot hands go at two objects, some seconds' work, and writes their
/// comparison as a page of its own. @returns the section that tells of it and leads there
Json compare_some_hands(const DemoArguments& options, const Progress& progress) {
  CompareRequest request;
  request.hands = {"human:skewed", "barrett", "shadow", "parallel_jaw"};
  request.objects = {"sphere_70", "cube_50"};
  request.approaches = 8;
  request.data = options.data;
  const HandComparison result = compare_hands(request, progress);
  if (!result.comparison.complete) return {};
  write_page(page_of(result), options.output + "/" + kHandsPage);

  Json section = glance_section(result.comparison);
  section["id"] = "hands";
  section["title"] = "Hands that grasp";
  section["blocks"].push_back({{"type", "text"},
                               {"text", "Pictures of the best grasps and all that was measured:"},
                               {"link", {{"file", kHandsPage}, {"text", "Hands compared"}}}});
  return section;
}

/// Adds the section of a page about its rungs to `blocks`, under a heading, and the page's address.
void add_rungs(const Json& page, const std::string& heading, const std::string& file,
               Json& blocks) {
  for (const Json& part : page.at("sections")) {
    if (part.at("id") != "rungs") continue;
    blocks.push_back({{"type", "text"},
                      {"text", heading + ". " + part.at("text").get<std::string>()},
                      {"link", {{"file", file}, {"text", "Pictures and curves"}}}});
    for (const Json& block : part.at("blocks")) blocks.push_back(block);
  }
}

/// Presses the default finger pad under a ball, and pinches a pencil between two, by elements and
/// by every cheaper model, half a minute's work. @returns the section that charts both
Json compare_pads(const DemoArguments& options, const Progress& progress) {
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
  const RungComparison pencil = compare_rungs(scene, pad_rung_names(), progress);
  if (progress.stop()) return {};

  const Json pad_page = page_of(pressed), pencil_page = page_of(pencil);
  write_page(pad_page, options.output + "/" + kPadPage);
  write_page(pencil_page, options.output + "/" + kPencilPage);
  Json blocks = Json::array();
  add_rungs(pad_page, title_of(pressed), kPadPage, blocks);
  add_rungs(pencil_page, "A pencil pinched between thumb and index finger", kPencilPage, blocks);
  return section("pads", "Finger pads: what each model costs, and how far it is off", "",
                 std::move(blocks));
}

void run_demo(const DemoArguments& options) {
  const auto begin = std::chrono::steady_clock::now();
  const Progress progress = terminal_progress();
  const std::string path = options.output + "/report.html";
  require_writable(path);
  const DemoResult demo = run_demo_study({options.data, options.output, this_run()}, progress);
  if (demo.stopped) throw Stopped("stopped before the report was complete");
  const Json hands = compare_some_hands(options, progress), pads = compare_pads(options, progress);
  if (progress.stop()) throw Stopped("stopped before the report was complete");
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  write_page(page_of(demo.motion.glass), options.output + "/" + kGlassPage);
  write_page(page_of(demo.motion.thumb), options.output + "/" + kThumbPage);
  write_page(demo_page(demo, Json::array({hands, pads}), seconds), path);
  print_answer(demo_text(demo, std::filesystem::absolute(path).string(), seconds));
}

}  // namespace

void add_demo(CLI::App& app) {
  auto options = std::make_shared<DemoArguments>();  // lives as long as the callback
  CLI::App* command = app.add_subcommand("demo", "Fit real data and write a report");
  add_data_option(*command, options->data);
  command->add_option("-o,--out,--output", options->output, "Folder for the report");
  add_examples(*command, {"demo -o out"});
  command->callback([options] {
    options->data = data_with("fits", options->data);
    run_demo(*options);
  });
}

}  // namespace thenar
