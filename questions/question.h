#pragma once

/// Every question that thenar answers, by name: what is asked, how it is answered, and what the
/// answer holds. Commands, files of requests and clients of servers ask by this table.

#include <functional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/provenance.h"
#include "questions/request_table.h"
#include "report/fields.h"
#include "solvers/status.h"

namespace thenar {

/// Answer to any question. What is not there for a question is empty.
struct Answer {
  OrderedJson request;  // that was answered, in SI
  Outcome outcome;
  std::string refusal;  // why it must not be used, though it is there; empty: it may
  std::function<OrderedJson(UnitSystem)> json;
  std::function<std::string()> text;  // for people
  std::function<Table()> table;       // as CSV
  std::function<Json()> page;
  std::function<FileDigests()> files;  // that it came from
};

/// How long a question takes at most.
enum class QuestionPace {
  kAtOnce,  // one posture, one set of contacts: some milliseconds
  kLasts    // seconds to hours
};

/// A question.
struct Question {
  std::string name;           // "tip_force"
  std::string about;          // one sentence
  std::vector<Param> params;  // of the request
  std::string example;        // a request as JSON, which tests ask
  std::string command;        // that asks it: "tip-force"
  QuestionPace pace = QuestionPace::kAtOnce;
  /// @param request  keys bear units
  /// @param data  folder of data where the request names none; empty: the usual ones
  /// @throws InputError with the field, DataError, Stopped
  std::function<Answer(const Json& request, const std::string& data, const Progress& progress)> ask;
};

/// All questions, in the order in which they are documented.
[[nodiscard]] const std::vector<Question>& questions();

/// Their names, in that order.
[[nodiscard]] std::vector<std::string> question_names();

/// What was asked, as files record it: {"question": "tip_force", ..} as text.
[[nodiscard]] std::string request_record(const std::string& question, const OrderedJson& request);

/// The question of a name. @throws InputError with the nearest name.
[[nodiscard]] const Question& question_named(const std::string& name);

}  // namespace thenar
