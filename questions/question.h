#pragma once

/// Table of all questions that thenar answers: parameters, function, and forms of the answer.
/// Commands, request files and clients of servers use this table.

#include <functional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/provenance.h"
#include "questions/request_table.h"
#include "report/fields.h"
#include "solvers/status.h"

namespace thenar {

/// Answer to a question. Forms that a question does not have are empty.
struct Answer {
  OrderedJson request;  // request with default values, in SI
  Outcome outcome;
  std::string refusal;  // reason why the answer must not be used; empty: none
  std::function<OrderedJson(UnitSystem)> json;
  std::function<std::string()> text;   // text for users
  std::function<Table()> table;        // rows for CSV
  std::function<Json()> page;          // data of the HTML report
  std::function<FileDigests()> files;  // input files with their digests
};

/// Computing time of a question.
enum class QuestionPace {
  kAtOnce,  // milliseconds: one posture, one set of contacts
  kLasts    // seconds to hours
};

/// Question with its parameters and the function that answers it.
struct Question {
  std::string name;           // "tip_force"
  std::string description;    // one sentence
  std::vector<Param> params;  // parameters of the request
  std::string example;        // a valid request as JSON; tests ask it
  std::string command;        // command that asks the question: "tip-force"
  QuestionPace pace = QuestionPace::kAtOnce;
  /// @param request  parameters by keys with units
  /// @param data     data folder if the request names none; empty: the default folders
  /// @throws InputError with the field, DataError, Stopped
  std::function<Answer(const Json& request, const std::string& data, const Progress& progress)> ask;
};

/// Returns all questions, in the order of the documentation.
[[nodiscard]] const std::vector<Question>& questions();

/// Returns the names of all questions, in that order.
[[nodiscard]] std::vector<std::string> question_names();

/// Returns a request as files record it: {"question": "tip_force", ..} as text.
[[nodiscard]] std::string request_record(const std::string& question, const OrderedJson& request);

/// Finds a question by name. @throws InputError with the nearest name if there is none
[[nodiscard]] const Question& question_named(const std::string& name);

}  // namespace thenar
