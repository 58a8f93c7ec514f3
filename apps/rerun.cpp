// thenar rerun FILE [--print] [--json]
//
// Runs the command again that wrote a page, a JSON file, a fit, a posterior or a motion, in its
// folder.

#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include <fmt/format.h>

#include "api/named/recorded_run.h"
#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/lists.h"
#include "questions/request_file.h"
#include "report/answers/recorded_run.h"

namespace thenar {
namespace {

struct RerunArguments {
  std::string file;
  bool print = false;
  Outputs outputs;
};

/// Becomes this program with the arguments, in the folder; no shell reads them.
[[noreturn]] void become(const RunRecord& run) {
  // Paths in the arguments are relative to the folder of the run.
  require(chdir(run.folder.c_str()) == 0, "cannot go to '{}': {}", run.folder,
          std::strerror(errno));
  std::vector<std::string> words{"thenar"};
  append_all(words, run.arguments);
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  std::fflush(nullptr);
  execv("/proc/self/exe", pointers.data());
  throw InputError(fmt::format("cannot start thenar again: {}", std::strerror(errno)));
}

/// Returns true if the command of a run has the option --path.
bool takes_path(const CLI::App& app, const std::vector<std::string>& arguments) {
  const CLI::App* command = &app;
  for (const std::string& word : arguments) {
    const std::vector<const CLI::App*> below =
        command->get_subcommands([&](const CLI::App* each) { return each->get_name() == word; });
    if (below.empty()) break;
    command = below.front();
  }
  return command->get_option_no_throw("--path") != nullptr;
}

/// The run with its tendon paths stated, if it is of a version in which they were others by
/// default.
RecordedRun on_its_paths(RecordedRun recorded, bool takes_path) {
  std::vector<std::string>& arguments = recorded.run.arguments;
  const bool stated = any_of(arguments, [](const std::string& argument) {
    return argument == "--path" || argument.rfind("--path=", 0) == 0;
  });
  if (!takes_path || stated || !ran_on_straight_paths(recorded)) return recorded;
  arguments.insert(arguments.end(), {"--path", "via"});
  recorded.warnings.emplace_back(
      "before version 0.2 tendons ran straight where no paths were asked for: '--path via' is "
      "added");
  return recorded;
}

/// Repeats the question of a program or a client of a server.
void ask_again(const RecordedRun& recorded, const Outputs& outputs) {
  OrderedJson request = OrderedJson::parse(recorded.run.request, nullptr, false);
  require(request.is_object() && request.contains("question") && request["question"].is_string(),
          "'{}' records no request that can be read", recorded.file);
  const Question& question = question_named(request["question"].get<std::string>());
  request.erase("question");
  fmt::print(stderr, "{}", request_text(question.name, request));
  deliver(outputs, question.ask(Json(request), "", terminal_progress("what is done is kept")));
}

void run_rerun(const RerunArguments& options, const CLI::App& app) {
  const RecordedRun written = read_recorded_run(options.file);
  // A run by a program has a request instead of arguments.
  if (written.run.arguments.empty()) {
    if (options.print) return deliver(options.outputs, written);
    return ask_again(written, options.outputs);
  }
  // Only commands that exist today can be run again.
  std::vector<std::string> commands;
  for (const CLI::App* each : app.get_subcommands({})) commands.push_back(each->get_name());
  require_repeatable(written, commands);
  const RecordedRun recorded = on_its_paths(written, takes_path(app, written.run.arguments));
  if (options.print || options.outputs.json) return deliver(options.outputs, recorded);
  fmt::print(stderr, "{}", text_of(recorded));
  become(recorded.run);
}

}  // namespace

void add_rerun(CLI::App& app) {
  auto options = std::make_shared<RerunArguments>();
  CLI::App* command = app.add_subcommand(
      "rerun",
      "Run again the command that wrote a page, an answer, a fit, a posterior or a motion");
  command->add_option("file", options->file, "Page (.html), JSON, fit (.h5), posterior (.nc) ..")
      ->required();
  command->add_flag("--print", options->print,
                    "Only print the command, its folder, date and commit, and what has changed");
  add_output_options(*command, options->outputs, {});
  add_examples(*command, {"explain barrett -o out/barrett.json", "rerun out/barrett.json --print"});
  command->callback([options, &app] { run_rerun(*options, app); });
}

}  // namespace thenar
