#pragma once

/// Options of a command from the parameters of a request: `NAME=number`, words, flags and files as
/// people type them.

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
/// @param request  gets what is typed, by keys with printed units; lives as long as the command
void add_request_options(CLI::App& command, const std::vector<Param>& params, Json& request);

/// Returns the error of a request, by the option of the field that it names: "sampler" for
/// "method".
[[nodiscard]] InputError option_error(const std::vector<Param>& params, const InputError& error);

/// Returns the request that is typed. @throws InputError by the option that is wrong
template <typename Request>
[[nodiscard]] Request read_typed(const RequestTable<Request>& table, const Json& typed) {
  try {
    return table.read(typed);
  } catch (const InputError& error) {
    throw option_error(table.params(), error);
  }
}

/// Returns the parameters but for those of these names.
[[nodiscard]] std::vector<Param> without(std::vector<Param> params,
                                         const std::vector<std::string>& names);

/// A command that asks one question.
struct QuestionCommand {
  const char* name;      // "tip-force"
  const char* question;  // "tip_force"
  OutputKinds kinds;
  std::vector<std::string> examples;  // command lines without the program
};

/// Arguments typed for a question.
struct TypedQuestion {
  const Question* question = nullptr;
  Json request = Json::object();
  Outputs outputs;
};

/// Asks, and delivers. @throws as Question::ask, errors by the option that is wrong
void ask_and_deliver(const TypedQuestion& typed);

/// Adds a command with the options of its question.
/// @return what is typed, and the command, for options that it has besides
std::pair<CLI::App*, std::shared_ptr<TypedQuestion>> add_question_command(
    CLI::App& app, const QuestionCommand& about);

}  // namespace thenar
