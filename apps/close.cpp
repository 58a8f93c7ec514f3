// thenar close WORLD.toml [--hand NAME] [--object NAME] [--json] [--report REPORT.html] [--data
// DIR]
//
// Closes the hand of a world where it stands, and says of every coordinate why it stopped.

#include <ctime>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "api/data_folders.h"
#include "apps/commands.h"
#include "apps/grasp_measures.h"
#include "apps/grasp_output.h"
#include "apps/options.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/progress_parts.h"
#include "report/answers/grasp_words.h"
#include "report/json.h"

namespace thenar {
namespace {

struct CloseArguments {
  WorldRequest choice;
  std::string out;
  bool json = false;
};

void run_close(const CloseArguments& options) {
  require_ending(options.out, {".html"});
  if (!options.out.empty()) require_writable(options.out);
  constexpr double kHand = 3, kClose = 0.3, kMeasures = 0.6;  // roughly, of a human hand [s]
  ProgressParts schedule(terminal_progress(), kHand + kClose + kMeasures);
  const GraspQuestion question = ask_world(options.choice, false, schedule.next(kHand));
  require(!question.hand.named.hand->surfaces().empty(),
          "hand '{}' has no surface that could touch", question.hand.named.name);
  const CollisionHand touching =
      collision_hand(*question.hand.named.hand, question.scene.materials);
  const std::clock_t start = std::clock();
  GraspAnswer found = answer(question, touching, 0, schedule.next(kClose));
  require(found.grasp.outcome != GraspOutcome::kOverlaps, "{}: {}", question.path,
          outcome_words(found.grasp));
  if (found.grasp.outcome == GraspOutcome::kGrasped)
    found.measures = std::make_shared<const GraspMeasures>(
        measure(question, touching, found, schedule.next(kMeasures)));
  found.cpu = cpu_since(start);
  if (!options.out.empty()) write_grasp_report(question, touching, found, options.out);
  schedule.finish();
  fmt::print("{}", options.json ? json_text(grasp_json(question, touching, found)) + "\n"
                                : grasp_text(question, touching, found));
}

}  // namespace

void add_close(CLI::App& app) {
  auto options = std::make_shared<CloseArguments>();
  CLI::App* command =
      app.add_subcommand("close", "Close the hand of a world where it stands; say what stopped it");
  command
      ->add_option("world", options->choice.world,
                   "World file (TOML), or the name of one of DATA/worlds")
      ->required();
  command->add_option("--hand", options->choice.hand, "Which hand, where there are several");
  command->add_option("--object", options->choice.object, "Which object, where there are several");
  add_data_option(*command, options->choice.data);
  command->add_flag("--json", options->json, "Print JSON");
  command->add_option("-o,--report,--out", options->out, "Also write a report (.html)");
  command->callback([options] {
    options->choice.pictures = !options->out.empty();
    run_close(*options);
  });
}

}  // namespace thenar
