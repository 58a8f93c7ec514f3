// thenar demo -o out
//
// Shows the main applications on real data: fits the middle fingers of two hands to measured forces
// by every solver, cross-validates, predicts unseen specimens, samples posteriors, computes the
// information of forces about a thumb's axes, recovers a thumb from simulated forces and muscle
// activity and adds measurements, compares two thumbs, simulates two scenes, compares hands in
// grasping, presses a finger pad, pinches a pencil on every rung of pads, and writes a page for
// each question and a front page with a summary.

#include "studies/questions/demo.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "api/named/data_folders.h"
#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/terminal.h"
#include "base/file_io.h"
#include "base/parallel_for.h"
#include "base/progress_parts.h"
#include "studies/demo/demo.h"

namespace thenar {
namespace {

struct DemoArguments {
  std::string data;
  std::optional<Path> path;
  std::string output = "out";
};

void run_demo(const DemoArguments& options) {
  const auto begin = std::chrono::steady_clock::now();
  const Progress progress = terminal_progress();
  // Find out now that the folder cannot be written, not after minutes.
  const std::string path = options.output + "/" + kFrontPage;
  require_writable(path);
  const DemoResult demo =
      run_demo_study({options.data, options.output, this_run(), options.path}, progress);
  if (demo.outcome.stopped()) throw Stopped("stopped before the report was complete");
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const std::vector<SetPage> pages = demo_pages(demo, seconds);
  // Pages are independent of each other, and large.
  parallel_for(pages.size(), [&](std::size_t i) {
    write_page(pages[i].page, options.output + "/" + pages[i].file);
  });
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
