#include "apps/contact_file.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/contact_doubts.h"
#include "apps/json_line.h"
#include "base/error.h"
#include "data/io/nearest_name.h"
#include "data/io/toml_node.h"

namespace thenar {
namespace {

using nlohmann::json;
using Names = std::vector<std::string>;

constexpr int kMisspelt = 2;               // letters that differ
constexpr double kLargest = 1e12;          // of any number: beyond it wrenches lose all digits
constexpr std::size_t kLongestShown = 60;  // of a value in a message [characters]

/// A value with the way to it, so that complaints can name its line.
class JsonValue {
 public:
  JsonValue(const std::string& path, const std::string& text, const json& value, JsonPath steps)
      : path_(path), text_(text), value_(value), steps_(std::move(steps)) {}

  [[noreturn]] void fail(const std::string& complaint) const {
    throw DataError(path_, line_of(text_, steps_), complaint);
  }
  [[noreturn]] void fail_wanted(const std::string& what) const {
    std::string came = value_.dump(-1, ' ', false, json::error_handler_t::replace);
    if (came.size() > kLongestShown) came = came.substr(0, kLongestShown) + "...";
    fail(fmt::format("wanted {}{}, got {}", what, steps_.empty() ? "" : " as " + name(), came));
  }

  [[nodiscard]] bool has(const char* member) const { return value_.contains(member); }
  /// Of members that may be left out: null leaves them out, too.
  [[nodiscard]] bool gives(const char* member) const {
    return has(member) && !value_[member].is_null();
  }
  [[nodiscard]] JsonValue operator[](const char* member) const {
    if (!has(member)) fail(fmt::format("{} has no '{}'", name(), member));
    return step(value_[member], member);
  }
  [[nodiscard]] std::vector<JsonValue> entries(const char* what) const {
    if (!value_.is_array()) fail_wanted(what);
    std::vector<JsonValue> result;
    for (std::size_t i = 0; i < value_.size(); ++i)
      result.push_back(step(value_[i], std::to_string(i)));
    return result;
  }

  /// Names of members that are none of `known`, if they look like none of these either.
  [[nodiscard]] Names others_than(const Names& known) const {
    if (!value_.is_object()) fail_wanted("an object");
    Names others;
    for (const auto& [member, value] : value_.items()) {
      if (std::find(known.begin(), known.end(), member) != known.end()) continue;
      for (const std::string& name_known : known)
        if (edit_distance(member, name_known) <= kMisspelt && name_known.size() > 2 * kMisspelt)
          step(value, member)
              .fail(
                  fmt::format("{} knows no '{}', did you mean '{}'?", name(), member, name_known));
      others.push_back(member);
    }
    return others;
  }

  [[nodiscard]] double number(const char* what) const {
    if (!value_.is_number()) fail_wanted(what);
    return bounded(value_.get<double>());
  }

  template <int n>
  [[nodiscard]] Eigen::Matrix<double, n, 1> vector() const {
    const std::string what = fmt::format("{} numbers", n);
    if (!value_.is_array() || value_.size() != n) fail_wanted(what);
    Eigen::Matrix<double, n, 1> result;
    for (int i = 0; i < n; ++i) {
      if (!value_[static_cast<std::size_t>(i)].is_number()) fail_wanted(what);
      result(i) = bounded(value_[static_cast<std::size_t>(i)].get<double>());
    }
    return result;
  }

 private:
  [[nodiscard]] double bounded(double number) const {
    if (!(std::abs(number) <= kLargest)) fail_wanted(fmt::format("no more than {:g}", kLargest));
    return number;
  }
  [[nodiscard]] JsonValue step(const json& value, const std::string& to) const {
    JsonPath steps = steps_;
    steps.push_back(to);
    return {path_, text_, value, steps};
  }
  [[nodiscard]] std::string name() const {
    return steps_.empty() ? "the file" : fmt::format("{}", fmt::join(steps_, "."));
  }

  const std::string& path_;
  const std::string& text_;
  const json& value_;
  JsonPath steps_;
};

double not_negative(const JsonValue& value) {
  const double number = value.number("a number >= 0");
  if (number < 0) value.fail_wanted("a number >= 0");
  return number;
}

double positive(const JsonValue& value) {
  const double number = value.number("a number > 0");
  if (number <= 0) value.fail_wanted("a number > 0");
  if (number < 1 / kLargest) value.fail_wanted(fmt::format("at least {:g}", 1 / kLargest));
  return number;
}

FileContact contact_with_wrenches(const JsonValue& value) {
  FileContact result;
  if (value.gives("position")) result.contact.p = value["position"].vector<3>();
  if (value.gives("normal")) (void)value["normal"].vector<3>();
  if (value.gives("friction")) result.contact.friction = not_negative(value["friction"]);
  const JsonValue wrenches = value["wrenches"];
  for (const JsonValue& wrench : wrenches.entries("a list of wrenches"))
    result.wrenches.push_back(wrench.vector<6>());
  if (result.wrenches.empty()) wrenches.fail_wanted("at least one wrench");
  return result;
}

FileContact contact_with_cone(const JsonValue& value) {
  FileContact result;
  result.contact.p = value["position"].vector<3>();
  const JsonValue normal = value["normal"];
  result.contact.n = normal.vector<3>();
  result.normal_length = result.contact.n.stableNorm();
  if (result.normal_length < 1 / kLargest) normal.fail_wanted("a direction");
  result.contact.n /= result.normal_length;
  result.contact.friction = not_negative(value["friction"]);
  return result;
}

FileContact file_contact(const JsonValue& value) {
  FileContact result =
      value.gives("wrenches") ? contact_with_wrenches(value) : contact_with_cone(value);
  if (value.gives("torsion")) result.contact.torsion = not_negative(value["torsion"]);
  return result;
}

}  // namespace

ContactFile read_contact_file(const std::string& path) {
  const std::string text = read_text_file(path);
  const json parsed = parse_json(path, text);
  const JsonValue root(path, text, parsed, {});
  const Names of_file =
      root.others_than({"centre_of_mass", "torque_scale", "contacts", "name", "source"});
  std::set<std::string> ignored(of_file.begin(), of_file.end());
  ContactFile file{root["centre_of_mass"].vector<3>(), positive(root["torque_scale"]), {}, {}};
  for (const JsonValue& contact : root["contacts"].entries("a list of contacts")) {
    const Names of_contact =
        contact.others_than({"position", "normal", "friction", "torsion", "wrenches", "name"});
    ignored.insert(of_contact.begin(), of_contact.end());
    file.contacts.push_back(file_contact(contact));
  }
  if (!ignored.empty())
    file.warnings.push_back(
        fmt::format("ignored, as it is not known: {}", fmt::join(ignored, ", ")));
  for (const std::string& doubt : contact_doubts(file)) file.warnings.push_back(doubt);
  return file;
}

}  // namespace thenar
