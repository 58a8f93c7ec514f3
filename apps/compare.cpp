// thenar compare --hands human:skewed,barrett,... --objects sphere_70,mug,... -o OUT.json
//
// Compares hands: the same approaches to the same objects, and abilities of each hand alone.

#include <memory>

#include <fmt/format.h>

#include "api/compare.h"
#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/request_options.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/lists.h"
#include "base/progress_parts.h"
#include "questions/question_params.h"
#include "report/answers/comparison.h"
#include "report/pages/comparison.h"

namespace thenar {
namespace {

/// Returns a sentence about the results that are kept when the command is stopped.
std::string kept_words(const CompareResult& result) {
  const CompareRequest& request = result.request;
  if (request.file.empty()) return "without -o FILE.json nothing is kept";
  if (result.hands.size() < request.hands.size()) return "nothing new was compared";
  return fmt::format("{} of {} pairs are kept in '{}'; the same command continues",
                     result.outcome.done, result.outcome.asked, request.file);
}

/// The files to write when all is compared: the JSON is written on the way.
Outputs without_json(Outputs outputs) {
  const std::vector<std::string> json = outputs.with_ending({".json"});
  erase_where(outputs.files, [&](const std::string& path) { return contains(json, path); });
  return outputs;
}

void run_compare(const TypedQuestion& options) {
  CompareRequest request = record_typed("compare", compare_params(), options.request);
  request.file = options.outputs.only_file(".json");
  request.run = this_run();
  const Progress progress = terminal_progress(
      request.file.empty() ? "without -o FILE.json nothing is kept"
                           : fmt::format("finished pairs are kept in '{}'", request.file));
  const CompareResult result = compare_hands(request, progress);
  // Write no page of an incomplete comparison, which would look complete.
  if (result.outcome.stopped())
    throw Stopped("stopped; " + kept_words(result) +
                  (options.outputs.page() ? "; the page is drawn when all is compared" : ""));
  deliver(without_json(options.outputs), result);
}

}  // namespace

void add_compare(CLI::App& app) {
  auto options = std::make_shared<TypedQuestion>();  // lives as long as the callback
  CLI::App* command = app.add_subcommand("compare", "Compare hands on the same objects and tasks");
  add_request_options(*command, compare_params().params(), options->request);
  for (const char* const list : {"--hands", "--objects", "--tasks"})
    command->get_option(list)->delimiter(',');
  add_output_options(*command, options->outputs, {true, true, true, {}});
  command->footer(
      "-o FILE.json is written after every pair of a hand and an object; the same command "
      "continues it\nafter Ctrl-C. The comparison with all defaults, 12 hands on 8 objects, takes "
      "several minutes.");
  add_examples(
      *command,
      {"compare --hands barrett,parallel_jaw --objects sphere_70,cube_50 --approaches 5",
       "compare --hands human:skewed,shadow --objects mug -o hands.json --report hands.html"});
  command->callback([options] { run_compare(*options); });
}

}  // namespace thenar
