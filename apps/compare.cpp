// thenar compare --hands human:tier1,barrett,... --objects sphere_70,mug,... -o OUT.json
//
// Hands compared: the same approaches to the same objects, and what each hand can do by itself.

#include <cmath>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/commands.h"
#include "apps/compare_file.h"
#include "apps/compare_report.h"
#include "apps/data_folder.h"
#include "apps/hand_by_name.h"
#include "apps/output_ending.h"
#include "apps/print_table.h"
#include "apps/progress_bar.h"
#include "apps/read_source.h"
#include "base/provenance.h"
#include "base/write_file.h"
#include "grasp/compare/compare.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Options {
  std::vector<std::string> hands{"human:tier1", "human:tier2", "human:tier3",  "human:tier4",
                                 "barrett",     "dlr",         "shadow",       "allegro",
                                 "leap",        "robonaut",    "parallel_jaw", "robotiq_2f85"};
  std::vector<std::string> objects{"sphere_70", "cube_50", "can", "box",
                                   "pen",       "mug",     "egg", "jar_lid"};
  std::vector<std::string> tasks{"force-closure", "hold-weight"};
  std::string data, output, report;
  int approaches = 20, best = 3, threads = 1;
  unsigned seed = 1;
  bool normalise = false, json = false;
};

std::string object_file(const std::string& name, const std::string& data) {
  return named_file("object", name, "objects", ".toml", data_folders(data));
}

ComparedHand to_compare(const std::string& name, const std::string& data) {
  const NamedHand named = hand_by_name(name, data_folders(data));
  ComparedHand hand;
  hand.name = name;
  hand.hand = named.hand;
  hand.contact = named.contact;
  hand.warnings = named.warnings;
  if (named.targets.empty()) return hand;
  const SkinMark& thumb = pad_of(named.patches, "thumb");
  hand.thumb = {"thumb", thumb.link, thumb.p, 0};
  for (const OppositionTarget& target : named.targets)
    hand.places.push_back({target.name, target.mark.link, target.mark.p, target.score});
  return hand;
}

/// What a result depends on, by name.
Json inputs_json(const Options& options) {
  Json files = Json::object();
  for (const std::string& object : options.objects) {
    const std::string file = object_file(object, options.data);
    files[file] = sha256(read_source(file).text);
  }
  for (const std::string& hand : options.hands) {
    const std::string robot = robot_file(hand, data_folders(options.data));
    for (const std::string& file : {robot, hand})
      if (fs::is_regular_file(file)) files[file] = sha256(read_source(file).text);
  }
  return {{"hands", options.hands},
          {"objects", options.objects},
          {"tasks", options.tasks},
          {"approaches", options.approaches},
          {"best", options.best},
          {"seed", options.seed},
          {"normalise_size", options.normalise},
          {"files", files}};
}

void print_comparison(const Comparison& comparison) {
  Table cells{{"hand", "object", "closed_percent", "from", "to", "epsilon_median", "epsilon_best",
               "hold_N", "times_weight", "s"},
              {}};
  for (const HandOnObject& cell : comparison.cells) {
    std::string hold = "-", weight = "-";  // of the one grasp that is best by epsilon
    if (!cell.best.empty()) {
      const BestGrasp& best = cell.best.front();
      hold = shown(best.hold);
      const auto found = best.margin.find("hold-weight");
      if (found != best.margin.end()) weight = shown(found->second);
    }
    cells.rows.push_back({cell.hand, cell.object, shown(100 * cell.success, 0),
                          shown(100 * cell.interval.lower, 0), shown(100 * cell.interval.upper, 0),
                          shown(cell.quantile(0.5), 3), shown(cell.quantile(1), 3), hold, weight,
                          shown(cell.seconds, 1)});
  }
  print_table("Grasps: share with force closure and its 95 % interval; loads of the best", cells);
  Table hands{{"hand", "opposition", "met", "overlap_cm3", "grasp_types", "strongest_tip_N"}, {}};
  for (const HandAbilities& hand : comparison.abilities) {
    double force = 0;
    for (const DigitAbility& digit : hand.digits) force = std::max(force, digit.largest_force);
    hands.rows.push_back({hand.hand, shown(hand.opposition, 1), std::to_string(hand.reached.size()),
                          shown(hand.overlap * 1e6, 0), std::to_string(hand.types.size()),
                          shown(force)});
  }
  print_table("Hands by themselves", hands);
  for (const std::string& warning : comparison.warnings) fmt::print("warning: {}\n", warning);
}

Comparison run_comparison(const Options& options, const Json& inputs) {
  std::vector<ComparedHand> hands;
  for (const std::string& name : options.hands) hands.push_back(to_compare(name, options.data));
  std::vector<BodySpec> objects;
  for (const std::string& name : options.objects)
    objects.push_back(read_object(object_file(name, options.data)));
  CompareOptions settings;
  settings.approaches = options.approaches;
  settings.best = options.best;
  settings.threads = options.threads;
  settings.seed = options.seed;
  settings.normalise_size = options.normalise;
  settings.tasks.clear();
  for (const std::string& task : options.tasks) settings.tasks.push_back(grasp_task(task));
  const auto save = [&](const Comparison& comparison) {
    if (options.output.empty()) return;
    Json file = comparison_json(comparison);
    file["inputs"] = inputs;
    write_file(options.output, file.dump(1) + "\n");
  };
  settings.keep = save;
  std::vector<HandOnObject> done;
  if (!options.output.empty()) done = read_cells(options.output, inputs);
  const Comparison comparison = compare(hands, objects, settings, terminal_progress(), done);
  save(comparison);
  return comparison;
}

/// The page; every input is in its provenance.
void write_page(const Comparison& comparison, const Options& options, const Json& inputs) {
  std::vector<BodySpec> objects;
  for (const std::string& name : options.objects)
    objects.push_back(read_object(object_file(name, options.data)));
  nlohmann::json provenance = nlohmann::json::object();
  for (const auto& [file, hash] : inputs.at("files").items())
    provenance[file] = "sha256 " + hash.get<std::string>();
  for (const auto& [name, version] : versions()) provenance[name] = version;
  provenance["seed"] = std::to_string(options.seed);
  write_compare_report(comparison, objects, options.data, provenance, options.report);
}

void run(const Options& options) {
  require_ending(options.output, {".json"});
  require_ending(options.report, {".html"});
  if (!options.report.empty()) require_writable(options.report);
  const Json inputs = inputs_json(options);
  if (!options.output.empty()) require_writable(options.output);
  const Comparison comparison = run_comparison(options, inputs);
  if (options.json)
    fmt::print("{}\n", comparison_json(comparison).dump(1));
  else
    print_comparison(comparison);
  if (!options.report.empty()) write_page(comparison, options, inputs);
  if (!comparison.complete)
    throw Interrupted("stopped; what was finished by then is kept, the same command goes on");
}

}  // namespace

void add_compare(CLI::App& app) {
  auto options = std::make_shared<Options>();  // lives as long as the callback
  CLI::App* command = app.add_subcommand("compare", "Hands on the same objects and tasks");
  command->add_option("--hands", options->hands, "human:tier1 .. tier4, robots, files")
      ->delimiter(',');
  command->add_option("--objects", options->objects, "Of DATA/objects, or files")->delimiter(',');
  command->add_option("--tasks", options->tasks, "Of force-closure, hold-weight, pull, turn")
      ->delimiter(',');
  command->add_option("--approaches", options->approaches, "Of each hand to each object")
      ->check(CLI::PositiveNumber);
  command->add_option("--best", options->best, "Grasps whose loads are worked out, of each pair")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--seed", options->seed, "Of approaches");
  command->add_option("--threads", options->threads, "The answer is the same with any number")
      ->check(CLI::PositiveNumber);
  command->add_flag("--normalise-size", options->normalise,
                    "Scale objects by the reach of the digits over the first hand's");
  command->add_option("--data", options->data, kDataHelp);
  command->add_option("-o,--output,--out", options->output,
                      "Result (JSON); one that is there is gone on with");
  command->add_option("--report", options->report, "Also write a page with pictures (.html)");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { run(*options); });
}

}  // namespace thenar
