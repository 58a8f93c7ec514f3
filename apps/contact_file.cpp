#include "apps/contact_file.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/contact_doubts.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "data/io/file_guard.h"
#include "data/io/json_text.h"

namespace thenar {
namespace {

using ContactJson = nlohmann::json;
using Names = std::vector<std::string>;

constexpr int kMisspelt = 2;                 // letters that differ
constexpr double kLargest = 1e12;            // of any number: beyond it wrenches lose all digits
constexpr std::size_t kMostContacts = 1000;  // a palm full of points; hulls take minutes beyond
constexpr std::size_t kLongestShown = 60;    // of a value in a message [characters]

/// A value with the way to it, so that complaints can name its line.
class JsonValue {
 public:
  /// @param first_line  number of the text's first line
  JsonValue(const std::string& path, const std::string& text, const ContactJson& value,
            JsonPath steps, int first_line)
      : path_(path),
        text_(text),
        value_(value),
        steps_(std::move(steps)),
        first_line_(first_line) {}

  [[noreturn]] void fail(const std::string& complaint) const {
    throw DataError(path_, first_line_ - 1 + line_of(text_, steps_), complaint);
  }
  [[noreturn]] void fail_wanted(const std::string& what) const {
    std::string came = value_.dump(-1, ' ', false, ContactJson::error_handler_t::replace);
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

  [[nodiscard]] std::size_t size() const { return value_.is_array() ? value_.size() : 0; }

  /// A place or direction; of a plane two numbers, and 0.
  [[nodiscard]] Eigen::Vector3d place(bool planar) const {
    if (!planar) return vector<3>();
    const Eigen::Vector2d flat = vector<2>();
    return {flat.x(), flat.y(), 0};
  }

  /// Force and torque; of a plane f_x, f_y and the torque.
  [[nodiscard]] ScaledWrench wrench(bool planar) const {
    if (!planar) return vector<6>();
    const Eigen::Vector3d flat = vector<3>();
    return (ScaledWrench() << flat.x(), flat.y(), 0, 0, 0, flat.z()).finished();
  }

  /// An integer >= 0.
  [[nodiscard]] int count() const {
    constexpr int kMost = 1000000000;
    if (!value_.is_number_integer() || value_.get<double>() < 0 || value_.get<double>() > kMost)
      fail_wanted(fmt::format("an integer of 0 to {}", kMost));
    return value_.get<int>();
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
  [[nodiscard]] JsonValue step(const ContactJson& value, const std::string& to) const {
    JsonPath steps = steps_;
    steps.push_back(to);
    return {path_, text_, value, steps, first_line_};
  }
  [[nodiscard]] std::string name() const {
    return steps_.empty() ? "the file" : fmt::format("{}", fmt::join(steps_, "."));
  }

  const std::string& path_;
  const std::string& text_;
  const ContactJson& value_;
  JsonPath steps_;
  int first_line_;
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

FileContact contact_with_wrenches(const JsonValue& value, bool planar) {
  FileContact result;
  if (value.gives("position")) result.contact.p = value["position"].place(planar);
  if (value.gives("normal")) (void)value["normal"].place(planar);
  if (value.gives("friction")) result.contact.friction = not_negative(value["friction"]);
  const JsonValue wrenches = value["wrenches"];
  for (const JsonValue& wrench : wrenches.entries("a list of wrenches"))
    result.wrenches.push_back(wrench.wrench(planar));
  if (result.wrenches.empty()) wrenches.fail_wanted("at least one wrench");
  return result;
}

FileContact contact_with_cone(const JsonValue& value, bool planar) {
  FileContact result;
  result.contact.p = value["position"].place(planar);
  const JsonValue normal = value["normal"];
  result.contact.n = normal.place(planar);
  result.normal_length = result.contact.n.stableNorm();
  if (result.normal_length < 1 / kLargest) normal.fail_wanted("a direction");
  result.contact.n /= result.normal_length;
  result.contact.friction = not_negative(value["friction"]);
  return result;
}

FileContact file_contact(const JsonValue& value, bool planar) {
  FileContact result = value.gives("wrenches") ? contact_with_wrenches(value, planar)
                                               : contact_with_cone(value, planar);
  if (value.gives("torsion")) result.contact.torsion = not_negative(value["torsion"]);
  if (planar && result.contact.torsion > 0)
    value["torsion"].fail("torsion is about the normal, which lies in the plane: leave it out");
  if (value.gives("patch")) result.contact.patch = value["patch"].count();
  return result;
}

std::vector<ScaledWrench> wrenches_in(const JsonValue& list, bool planar, const char* what) {
  std::vector<ScaledWrench> wrenches;
  for (const JsonValue& each : list.entries(what)) wrenches.push_back(each.wrench(planar));
  if (wrenches.empty()) list.fail_wanted(what);
  return wrenches;
}

FileTask file_task(const JsonValue& value, bool planar, std::set<std::string>& ignored) {
  const Names others = value.others_than({"loads", "box", "ellipsoid"});
  ignored.insert(others.begin(), others.end());
  const int given = (value.gives("loads") ? 1 : 0) + (value.gives("box") ? 1 : 0) +
                    (value.gives("ellipsoid") ? 1 : 0);
  if (given != 1) value.fail_wanted("one of loads, box and ellipsoid");
  if (value.gives("loads"))
    return {FileTask::Kind::kLoads, wrenches_in(value["loads"], planar, "a list of loads")};
  if (value.gives("ellipsoid"))
    return {FileTask::Kind::kEllipsoid,
            wrenches_in(value["ellipsoid"], planar, "a list of semi-axes")};
  const JsonValue box = value["box"];
  FileTask task{FileTask::Kind::kBox, wrenches_in(box, planar, "two loads")};
  if (task.loads.size() != 2 || (task.loads[0].array() > task.loads[1].array()).any())
    box.fail_wanted("two loads, the lower and the upper end");
  return task;
}

}  // namespace

ContactFile read_contact_file(const std::string& path) {
  return parse_contacts(path, read_guarded(path, GuardedKind::kJson), 1);
}

ContactFile parse_contacts(const std::string& path, const std::string& text, int first_line) {
  const ContactJson parsed = parse_json(path, text, first_line);
  const JsonValue root(path, text, parsed, {}, first_line);
  const Names of_file =
      root.others_than({"centre_of_mass", "torque_scale", "contacts", "task", "name", "source"});
  std::set<std::string> ignored(of_file.begin(), of_file.end());
  const bool planar = root["centre_of_mass"].size() == 2;
  ContactFile file;
  file.planar = planar;
  file.centre_of_mass = root["centre_of_mass"].place(planar);
  file.torque_scale = positive(root["torque_scale"]);
  const JsonValue contacts = root["contacts"];
  const std::size_t count = parsed.contains("contacts") ? parsed["contacts"].size() : 0;
  if (count > kMostContacts)
    contacts.fail(fmt::format("wanted at most {} contacts, got {}", kMostContacts, count));
  for (const JsonValue& contact : contacts.entries("a list of contacts")) {
    const Names of_contact = contact.others_than(
        {"position", "normal", "friction", "torsion", "wrenches", "patch", "name"});
    ignored.insert(of_contact.begin(), of_contact.end());
    file.contacts.push_back(file_contact(contact, planar));
  }
  if (root.gives("task")) file.task = file_task(root["task"], planar, ignored);
  if (!ignored.empty())
    file.warnings.push_back(
        fmt::format("ignored, as it is not known: {}", fmt::join(ignored, ", ")));
  for (const std::string& doubt : contact_doubts(file)) file.warnings.push_back(doubt);
  return file;
}

}  // namespace thenar
