// thenar compare --hands human:tier1,barrett,... --objects sphere_70,mug,... -o OUT.json
//
// Hands compared: the same approaches to the same objects, and what each hand can do by itself.

#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "apps/commands.h"
#include "apps/compare_file.h"
#include "apps/compare_inputs.h"
#include "apps/compare_report.h"
#include "apps/data_folder.h"
#include "apps/output_ending.h"
#include "apps/print_table.h"
#include "apps/progress_bar.h"
#include "base/write_file.h"
#include "grasp/compare/compare.h"

namespace thenar {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  CompareQuestion question;
  std::string output, report;
  bool json = false;
};

/// A number, or that it is not known.
template <typename... Digits>
std::string known(double value, Digits... digits) {
  return std::isnan(value) ? "-" : shown(value, digits...);
}

void print_comparison(const Comparison& comparison) {
  Table cells{{"hand", "object", "closed_percent", "from", "to", "epsilon_median", "epsilon_best",
               "hand_epsilon_N", "hold_N", "times_weight"},
              {}};
  for (const HandOnObject& cell : comparison.cells) {
    std::string hold = "-", weight = "-";  // of the one grasp that is best by epsilon
    if (!cell.best.empty()) {
      const BestGrasp& best = cell.best.front();
      hold = shown(best.hold);
      const auto found = best.margin.find("hold-weight");
      if (found != best.margin.end()) weight = known(found->second);
    }
    cells.rows.push_back({cell.hand, cell.object, shown(100 * cell.success, 0),
                          shown(100 * cell.interval.lower, 0), shown(100 * cell.interval.upper, 0),
                          known(cell.quantile(0.5), 3), known(cell.quantile(1), 3),
                          cell.best.empty() ? "-" : known(cell.best.front().hand_epsilon, 2), hold,
                          weight});
  }
  print_table("Grasps: share with force closure and its 95 % interval; loads of the best", cells);
  Table hands{{"hand", "opposition", "met", "overlap_cm3", "grasp_types", "closing_force_N"}, {}};
  for (const HandAbilities& hand : comparison.abilities) {
    double force = NAN;
    for (const DigitAbility& digit : hand.digits) force = std::fmax(force, digit.closing_force);
    hands.rows.push_back({hand.hand, known(hand.opposition, 1), std::to_string(hand.reached.size()),
                          shown(hand.overlap * 1e6, 0), std::to_string(hand.types.size()),
                          known(force)});
  }
  print_table("Hands by themselves; closing_force: of the strongest tip", hands);
  for (const std::string& warning : comparison.warnings) fmt::print("warning: {}\n", warning);
}

Comparison run_comparison(const Options& options, const Json& inputs) {
  const auto save = [&](const Comparison& comparison) {
    if (options.output.empty()) return;
    Json file = comparison_json(comparison);
    file["inputs"] = inputs;
    write_file(options.output, file.dump(1) + "\n");
  };
  CompareOptions settings = options_of(options.question);
  settings.keep = save;
  std::vector<HandOnObject> done;
  if (!options.output.empty()) done = read_cells(options.output, inputs);
  const Progress progress = terminal_progress();
  const Comparison comparison =
      compare(hands_of(options.question), objects_of(options.question), settings, progress, done);
  save(comparison);
  return comparison;
}

void run(const Options& options) {
  require_ending(options.output, {".json"});
  require_ending(options.report, {".html"});
  if (!options.report.empty()) require_writable(options.report);
  const Json inputs = compare_inputs(options.question);
  if (!options.output.empty()) require_writable(options.output);
  const Comparison comparison = run_comparison(options, inputs);
  if (options.json)
    fmt::print("{}\n", comparison_json(comparison).dump(1));
  else
    print_comparison(comparison);
  if (!options.report.empty() && comparison.complete)
    write_compare_report(comparison, objects_of(options.question), options.question.data,
                         compare_provenance(inputs), options.report);
  if (!comparison.complete)
    throw Interrupted(fmt::format(
        "stopped; {}{}",
        options.output.empty() ? "no --out was given that could go on"
                               : "what was finished by then is kept, the same command goes on",
        options.report.empty() ? "" : "; the page is drawn when all is compared"));
}

}  // namespace

void add_compare(CLI::App& app) {
  auto options = std::make_shared<Options>();  // lives as long as the callback
  CLI::App* command = app.add_subcommand("compare", "Hands on the same objects and tasks");
  command->add_option("--hands", options->question.hands, "human:tier1 .. tier4, robots, files")
      ->delimiter(',');
  command->add_option("--objects", options->question.objects, "Of DATA/objects, or files")
      ->delimiter(',');
  command
      ->add_option("--tasks", options->question.tasks, "Of force-closure, hold-weight, pull, turn")
      ->delimiter(',');
  command->add_option("--approaches", options->question.approaches, "Of each hand to each object")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--best", options->question.best,
                   "Grasps whose loads are worked out, of each pair")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--seed", options->question.seed, "Of approaches");
  command
      ->add_option("--threads", options->question.threads, "The answer is the same with any number")
      ->check(CLI::PositiveNumber);
  command->add_flag("--normalise-size", options->question.normalise,
                    "Scale objects by the reach of the digits over the first hand's");
  command->add_option("--data", options->question.data, kDataHelp);
  command->add_option("-o,--output,--out", options->output,
                      "Result (JSON); one that is there is gone on with");
  command->add_option("--report", options->report, "Also write a page with pictures (.html)");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { run(*options); });
}

}  // namespace thenar
