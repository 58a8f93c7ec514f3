#include "questions/question.h"

#include "base/nearest_name.h"
#include "questions/make_question.h"
#include "questions/question_rows.h"

namespace thenar {

RunRecord internal::run_of_request(const std::string& question, const OrderedJson& request) {
  RunRecord run = record_of_run({});
  OrderedJson record{{"question", question}};
  record.update(request);
  run.request = json_text(record, -1);
  return run;
}

const std::vector<Question>& questions() {
  static const std::vector<Question> kAll = [] {
    std::vector<Question> all;
    internal::add_digit_questions(all);
    internal::add_fit_questions(all);
    internal::add_contact_questions(all);
    internal::add_motion_questions(all);
    return all;
  }();
  return kAll;
}

const Question& question_named(const std::string& name) {
  std::vector<std::string> names;
  for (const Question& each : questions()) names.push_back(each.name);
  return questions()[index_of_name(name, names, "question")];
}

}  // namespace thenar
