#pragma once

/// Options of a command from the parameters of a request: `NAME=number`, words, flags and files.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "apps/outputs.h"
#include "base/error.h"
#include "questions/question.h"
#include "questions/request_table.h"

namespace thenar {

/// Adds an option for each parameter that has one, with its default and its unit in the help.
/// @param request  receives the typed values, by keys with printed units; must outlive the command
void add_request_options(CLI::App& command, const std::vector<Param>& params, Json& request);

/// Returns an error of a request that names the option instead of the field: "sampler" for
/// "method".
[[nodiscard]] InputError option_error(const std::vector<Param>& params, const InputError& error);

/// Returns the typed request. @throws InputError naming the wrong option
template <typename Request>
[[nodiscard]] Request read_typed(const RequestTable<Request>& table, const Json& typed) {
  try {
    return table.read(typed);
  } catch (const InputError& error) {
    throw option_error(table.params(), error);
  }
}

/// Returns the typed request, and records it as that of this run. @throws InputError naming the
/// wrong option
template <typename Request>
[[nodiscard]] Request record_typed(const std::string& question, const RequestTable<Request>& table,
                                   const Json& typed) {
  Request request = read_typed(table, typed);
  set_request(question, table.write(request));
  return request;
}

/// Returns the parameters except those with these names.
[[nodiscard]] std::vector<Param> without(std::vector<Param> params,
                                         const std::vector<std::string>& names);

/// Command that answers one question, with all kinds of output.
struct QuestionCommand {
  const char* name;                   // "tip-force"
  const char* question;               // "tip_force"
  std::vector<std::string> examples;  // command lines without the program
};

/// Arguments typed for a question.
struct TypedQuestion {
  const Question* question = nullptr;
  Json request = Json::object();
  Outputs outputs;
  bool allow_unconverged = false;  // accept an answer that must not be used
};

/// Answers a question and delivers the answer. @throws as Question::ask, naming the wrong option
void ask_and_deliver(const TypedQuestion& typed);

/// Adds a command with the options of its question.
/// @return the command and its typed arguments, for further options
std::pair<CLI::App*, std::shared_ptr<TypedQuestion>> add_question_command(
    CLI::App& app, const QuestionCommand& about);

}  // namespace thenar
