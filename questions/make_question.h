#pragma once

/// Questions made of a table of parameters and a function that answers: what report/ has of the
/// result, its answer has.

#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

#include "base/run_record.h"
#include "questions/question.h"

namespace thenar {

namespace internal {
// Whether report/ has something of a result.
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

/// An answer with what the overloads of report/ make of a result: fields_of (or json_of) and
/// text_of, and table_of, page_of, files_of and refusal_of where they exist.
/// @param kept  lives as long as the answer
template <typename Result>
[[nodiscard]] Answer answer_of(const std::shared_ptr<const Result>& kept, Outcome outcome) {
  // The result is shared by all forms of the answer, each made when it is asked for.
  Answer answer;
  answer.outcome = std::move(outcome);
  if constexpr (internal::HasFields<Result>::value)
    answer.json = [kept](UnitSystem system) { return json_of(fields_of(*kept), system); };
  else
    answer.json = [kept](UnitSystem) { return OrderedJson(json_of(*kept)); };
  answer.text = [kept] { return text_of(*kept); };
  // Optional forms exist where the result has a function for them.
  if constexpr (internal::HasTable<Result>::value)
    answer.table = [kept] { return table_of(*kept); };
  if constexpr (internal::HasPage<Result>::value) answer.page = [kept] { return page_of(*kept); };
  if constexpr (internal::HasFiles<Result>::value)
    answer.files = [kept] { return files_of(*kept); };
  if constexpr (internal::HasRefusal<Result>::value) answer.refusal = refusal_of(*kept);
  return answer;
}

/// An answer that keeps a result, whose `outcome` says how it ended; of several kinds the one it
/// is.
template <typename Result>
[[nodiscard]] Answer answer_of(Result result) {
  const auto kept = std::make_shared<const Result>(std::move(result));
  return answer_of(kept, kept->outcome);
}
template <typename... Results>
[[nodiscard]] Answer answer_of(std::variant<Results...> result) {
  return std::visit([](auto& each) { return answer_of(std::move(each)); }, result);
}

/// Adds a question of a request and a result, which answer_of() takes.
/// @param example  a request as JSON
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
                   // Files that it writes record a run that no command line began.
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
