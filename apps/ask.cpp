// thenar ask REQUEST.toml [--json] [--csv] [-o FILE]
// thenar ask QUESTION
//
// Asks what a file says, or prints a file to fill in.

#include <filesystem>

#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/nearest_name.h"
#include "base/provenance.h"
#include "questions/request_file.h"

namespace thenar {
namespace {

struct AskArguments {
  std::string request;
  Outputs outputs;
};

/// Refuses a page, which another command repeats.
void require_no_page(const std::string& file) {
  require(std::filesystem::path(file).extension() != ".html",
          "{0} is a web page, not a request (TOML); repeat it by `thenar rerun {0}`", file);
}

void run_ask(const AskArguments& options) {
  if (!is_file(options.request) && options.request.find_first_of("./") == std::string::npos)
    return print_answer(request_template(question_named(options.request)));
  require_no_page(options.request);
  const RequestFile request = read_request(options.request);
  Answer answer = request.ask(terminal_progress("what is done is kept"));
  // The request is an input as well.
  answer.files = [files = answer.files, path = options.request] {
    FileDigests all = digests_of({path});
    if (files) all.merge(files());
    return all;
  };
  set_request(request.question->name, answer.request);
  deliver(options.outputs, answer);
}

}  // namespace

void add_ask(CLI::App& app) {
  auto options = std::make_shared<AskArguments>();  // lives as long as the callback
  CLI::App* command =
      app.add_subcommand("ask", "Answer a request file, or print a template for a question");
  command
      ->add_option("request", options->request,
                   "A request (TOML), or a question: " + listed(question_names()))
      ->required();
  add_output_options(*command, options->outputs, {true, true, true});
  add_examples(*command, {"ask tip_force", "ask request.toml --json"});
  command->callback([options] { run_ask(*options); });
}

}  // namespace thenar
