#include "questions/digit_params.h"

#include "base/nearest_name.h"

namespace thenar {
namespace {

RequestTable<DigitRequest> subject_params() {
  RequestTable<DigitRequest> table;
  table.add_argument("subject", &DigitRequest::subject, "A subject: its name, or its file (TOML).");
  table.add("digit", text_schema(), &DigitRequest::digit,
            "Digit: thumb, index, middle, ring or little; default: the only one.");
  // Add the posture; frozen joints are not coordinates of the digit.
  add_posture(table, "posture", &DigitRequest::posture,
              "Angles by joint, or in the order of the joints; others stay at 0.");
  add_posture(table, "frozen", &DigitRequest::frozen, "Joints to weld, and their angles.");
  add_vary(table, &DigitRequest::vary, &DigitRequest::posture);
  // Add the fidelity of the model: paths of tendons and passive moments.
  add_path(table, &DigitRequest::path);
  table.add_word("passive", kPassiveNames, &DigitRequest::passive,
                 "Include the passive moments of human joints that the subject states.");
  add_data(table, &DigitRequest::data);
  return table;
}

}  // namespace

RequestTable<DigitRequest> linear_digit_params() {
  RequestTable<DigitRequest> table = subject_params();
  table.add("map", text_schema(), &DigitRequest::map,
            "A published tip map instead of bones and tendons.");
  return table;
}

RequestTable<DigitRequest> tendon_params(const std::string& hood) {
  RequestTable<DigitRequest> table = subject_params();
  table.add_word("hood", kHoodNames, &DigitRequest::hood, "Extensor hood; default: " + hood + ".");
  table.add("net", text_schema(), &DigitRequest::net,
            "Extensor net: " + listed(known_nets()) +
                ", or a file (TOML); default for a net hood: extensor_hood.");
  return table;
}

namespace internal {

Schema posture_schema() { return map_or_list_schema(number_schema("")); }

Schema vary_schema() {
  return list_schema(object_schema({{"joint", text_schema(), "Which.", true},
                                    {"from", number_schema(""), "First value.", true},
                                    {"to", number_schema(""), "Last value.", true},
                                    {"step", number_schema(""), "Between values.", true}}),
                     0, 100);
}

PostureRequest posture_from_json(const Json& json, PostureUnit unit) {
  PostureRequest posture;
  posture.unit = unit;
  if (json.is_array())
    posture.in_order = json.get<std::vector<double>>();
  else
    posture.named = json.get<std::map<std::string, double>>();
  return posture;
}

Json posture_to_json(const PostureRequest& posture, PostureUnit unit) {
  if (posture.empty() || posture.unit != unit) return {};
  return posture.named.empty() ? Json(posture.in_order) : Json(posture.named);
}

std::vector<Vary> vary_from_json(const Json& json) {
  std::vector<Vary> all;
  for (const Json& each : json)
    all.push_back({each["joint"].get<std::string>(), each["from"].get<double>(),
                   each["to"].get<double>(), each["step"].get<double>()});
  return all;
}

Json vary_to_json(const std::vector<Vary>& vary) {
  Json list;
  for (const Vary& each : vary)
    list.push_back(
        {{"joint", each.joint}, {"from", each.from}, {"to", each.to}, {"step", each.step}});
  return list;
}

}  // namespace internal
}  // namespace thenar
