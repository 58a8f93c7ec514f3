// thenar compare --hands human:skewed,barrett,... --objects sphere_70,mug,... -o OUT.json
//
// Hands compared: the same approaches to the same objects, and what each hand can do by itself.

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "api/data_folders.h"
#include "apps/commands.h"
#include "apps/compare_file.h"
#include "apps/compare_inputs.h"
#include "apps/compare_print.h"
#include "apps/compare_report.h"
#include "apps/options.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/progress_parts.h"
#include "grasp/compare/compare_hands.h"
#include "report/json.h"

namespace thenar {
namespace {

struct CompareArguments {
  CompareQuestion question;
  std::string output, report;
  bool json = false;
};

bool holds(const Comparison& comparison, const HandOnObject& wanted) {
  return std::any_of(comparison.cells.begin(), comparison.cells.end(), [&](const auto& cell) {
    return cell.hand == wanted.hand && cell.object == wanted.object;
  });
}

void require_fits(const BestGrasp& best, const NamedHand& hand, const std::string& path) {
  const Eigen::Index angles = hand.hand->layout().lower.size();
  if (best.q.size() != angles)
    throw DataError(path, 1,
                    fmt::format("a posture of '{}' has {} angles, wanted {}", hand.name,
                                best.q.size(), angles));
  const auto surfaces = static_cast<int>(hand.hand->surfaces().size());
  for (const HandContact& contact : best.contacts)
    if (contact.surface >= surfaces)
      throw DataError(path, 1,
                      fmt::format("a contact of '{}' is on surface {}, and it has {}", hand.name,
                                  contact.surface, surfaces));
}

/// Postures of a file are of as many joints as the hands have, contacts on surfaces of theirs.
void require_postures(const std::vector<HandOnObject>& cells, const std::vector<NamedHand>& named,
                      const std::string& path) {
  for (const HandOnObject& cell : cells)
    for (const NamedHand& hand : named)
      for (const BestGrasp& best : cell.best)
        if (hand.name == cell.hand) require_fits(best, hand, path);
}

/// With what an earlier run left and this one did not come to.
Comparison joined(Comparison comparison, const std::vector<HandOnObject>& done) {
  for (const HandOnObject& cell : done)
    if (!holds(comparison, cell)) comparison.cells.push_back(cell);
  return comparison;
}

Comparison run_comparison(const CompareArguments& options, const OrderedJson& inputs,
                          const std::vector<NamedHand>& named, const Progress& progress) {
  std::vector<HandOnObject> done;
  std::optional<FileLock> lock;  // another comparison would drop our cells, and we its
  if (!options.output.empty()) {
    lock.emplace(options.output);
    done = read_cells(options.output, inputs);
    require_postures(done, named, options.output);
  }
  const auto save = [&](const Comparison& comparison) {
    if (options.output.empty()) return;
    OrderedJson file = comparison_json(joined(comparison, done));
    file["inputs"] = inputs;
    file["sha256"] = comparison_checksum(file);
    write_file(options.output, json_text(file, 1) + "\n");
  };
  CompareOptions settings = options_of(options.question);
  settings.keep = save;
  const Comparison comparison = compare(hands_of(options.question, named),
                                        objects_of(options.question), settings, progress, done);
  save(comparison);
  return joined(comparison, done);
}

/// What a stop leaves.
std::string kept_words(const CompareArguments& options, const Comparison& comparison) {
  if (options.output.empty()) return "without --out nothing is kept";
  return fmt::format(
      "{} of {} pairs are kept in '{}', the same command goes on", comparison.cells.size(),
      options.question.hands.size() * options.question.objects.size(), options.output);
}

void run_compare(const CompareArguments& options) {
  require_ending(options.output, {".json"});
  require_ending(options.report, {".html"});
  if (!options.report.empty()) require_writable(options.report);
  const OrderedJson inputs = compare_inputs(options.question);
  if (!options.output.empty()) require_writable(options.output);
  const std::vector<NamedHand> named = named_hands(options.question);  // a signal ends it at once
  const Progress progress = terminal_progress(
      options.output.empty() ? "without --out nothing is kept"
                             : fmt::format("finished pairs are kept in '{}'", options.output));
  const Comparison comparison = run_comparison(options, inputs, named, progress);
  if (!comparison.complete)
    throw Stopped("stopped; " + kept_words(options, comparison) +
                  (options.report.empty() ? "" : "; the page is drawn when all is compared"));
  if (options.json)
    fmt::print("{}\n", json_text(comparison_json(comparison), 1));
  else
    print_comparison(comparison);
  if (options.report.empty()) return;
  std::fflush(stdout);
  const bool drawn = write_compare_report(comparison, objects_of(options.question), named,
                                          compare_provenance(inputs), options.report, progress);
  if (!drawn)
    throw Stopped("stopped before the page was drawn; " + kept_words(options, comparison));
}

}  // namespace

void add_compare(CLI::App& app) {
  auto options = std::make_shared<CompareArguments>();  // lives as long as the callback
  CLI::App* command = app.add_subcommand("compare", "Hands on the same objects and tasks");
  command
      ->add_option("--hands", options->question.hands,
                   "human:orthogonal, human:skewed, human:soft, human:tendons; robots; files")
      ->delimiter(',');
  command->add_option("--objects", options->question.objects, "Of DATA/objects, or files")
      ->delimiter(',');
  command
      ->add_option("--tasks", options->question.tasks, "Of force-closure, hold-weight, pull, turn")
      ->delimiter(',');
  command->add_option("--approaches", options->question.approaches, "Of each hand to each object")
      ->check(at_least(1));
  command
      ->add_option("--best", options->question.best,
                   "Grasps whose loads are worked out, of each pair")
      ->check(at_least(0));
  command->add_option("--seed", options->question.seed, "Of approaches");
  command
      ->add_option("--threads", options->question.threads, "The answer is the same with any number")
      ->check(at_least(1));
  command->add_flag("--normalise-size", options->question.normalise,
                    "Scale objects by the reach of the digits over the first hand's");
  add_data_option(*command, options->question.data);
  command->add_option("-o,--output,--out", options->output,
                      "Result (JSON); one that is there is gone on with");
  command->add_option("--report", options->report, "Also write a page with pictures (.html)");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { run_compare(*options); });
}

}  // namespace thenar
