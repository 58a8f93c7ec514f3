#pragma once

/// Construction of questions from a table of parameters and a function. The answer has all forms
/// for which report/ has an overload for the type of the result.

#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

#include "base/run_record.h"
#include "questions/question.h"

namespace thenar {

namespace internal {
// Defines a trait that is true if report/ has an overload of a function for a result.
#define THENAR_HAS(name, function)                                                    \
  template <typename Result, typename = void>                                         \
  struct name : std::false_type {};                                                   \
  template <typename Result>                                                          \
  struct name<Result, std::void_t<decltype(function(std::declval<const Result&>()))>> \
      : std::true_type {}
THENAR_HAS(HasFields, fields_of);
THENAR_HAS(HasTable, table_of);
THENAR_HAS(HasPage, page_of);
THENAR_HAS(HasFiles, files_of);
THENAR_HAS(HasRefusal, refusal_of);
#undef THENAR_HAS

template <typename Request, typename = void>
struct HasRun : std::false_type {};
template <typename Request>
struct HasRun<Request, std::void_t<decltype(std::declval<Request&>().run)>> : std::true_type {};
}  // namespace internal

/// Makes an answer from a result by the overloads of report/: fields_of (or json_of) and text_of,
/// and table_of, page_of, files_of and refusal_of if they exist.
/// @param kept  result; the answer shares it
template <typename Result>
[[nodiscard]] Answer answer_of(const std::shared_ptr<const Result>& kept, Outcome outcome) {
  // All forms share the result; each is computed when it is requested.
  Answer answer;
  answer.outcome = std::move(outcome);
  if constexpr (internal::HasFields<Result>::value)
    answer.json = [kept](UnitSystem system) { return json_of(fields_of(*kept), system); };
  else
    answer.json = [kept](UnitSystem) { return OrderedJson(json_of(*kept)); };
  answer.text = [kept] { return text_of(*kept); };
  // Add the optional forms that exist for this result.
  if constexpr (internal::HasTable<Result>::value)
    answer.table = [kept] { return table_of(*kept); };
  if constexpr (internal::HasPage<Result>::value) answer.page = [kept] { return page_of(*kept); };
  if constexpr (internal::HasFiles<Result>::value)
    answer.files = [kept] { return files_of(*kept); };
  if constexpr (internal::HasRefusal<Result>::value) answer.refusal = refusal_of(*kept);
  return answer;
}

/// Makes an answer that owns a result with its `outcome`.
template <typename Result>
[[nodiscard]] Answer answer_of(Result result) {
  const auto kept = std::make_shared<const Result>(std::move(result));
  return answer_of(kept, kept->outcome);
}
template <typename... Results>
[[nodiscard]] Answer answer_of(std::variant<Results...> result) {
  return std::visit([](auto& each) { return answer_of(std::move(each)); }, result);
}

/// Adds a question with a request and a result; answer_of() makes its answer.
/// @param table    parameters of the request
/// @param ask      function that computes the result
/// @param example  a request as JSON
/// @param command  command that asks the question
template <typename Request, typename Result>
void add_question(std::vector<Question>& all, const std::string& name, std::string about,
                  const RequestTable<Request>& table,
                  Result (*ask)(const Request&, const Progress&), std::string example,
                  std::string command, QuestionPace pace = QuestionPace::kAtOnce) {
  all.push_back({name, std::move(about), table.params(), std::move(example), std::move(command),
                 pace,
                 [name, table, ask](Json json, const std::string& data, const Progress& progress) {
                   if (!data.empty() && !json.contains("data")) json["data"] = data;
                   Request request = table.read(json);
                   const OrderedJson record = table.write(request);
                   // Record the request as the run in files that the question writes.
                   if constexpr (internal::HasRun<Request>::value) {
                     request.run = record_of_run({});
                     request.run.request = request_record(name, record);
                   }
                   Answer answer = answer_of(ask(request, progress));
                   answer.request = record;
                   return answer;
                 }});
}

}  // namespace thenar
