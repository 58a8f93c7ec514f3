#include "questions/question.h"

#include "base/lists.h"
#include "base/nearest_name.h"
#include "questions/question_rows.h"

namespace thenar {

const std::vector<Question>& questions() {
  static const std::vector<Question> kAll = [] {
    std::vector<Question> all;
    // Add the groups in the order of the documentation.
    internal::add_digit_questions(all);
    internal::add_fit_questions(all);
    internal::add_contact_questions(all);
    internal::add_motion_questions(all);
    return all;
  }();
  return kAll;
}

std::vector<std::string> question_names() { return names_of(questions()); }

std::string request_record(const std::string& question, const OrderedJson& request) {
  OrderedJson record{{"question", question}};
  record.update(request);
  return json_text(record, -1);
}

const Question& question_named(const std::string& name) {
  return questions()[index_of_name(name, question_names(), "question")];
}

}  // namespace thenar
