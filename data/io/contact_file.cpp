#include "data/io/contact_file.h"

#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "data/io/file_guard.h"
#include "data/io/json_node.h"

namespace thenar {
namespace {

using Names = std::vector<std::string>;

constexpr double kMinMagnitude = 1e-12;  // Least torque scale [m], and least length of a normal [1]
// Most contacts, a palm full of points; hulls take minutes beyond
constexpr std::size_t kMaxContacts = 1000;

/// Names of members in a contact set, and in the answer of `thenar grasp`.
struct ContactKeys {
  std::string centre, scale, position, torsion;
};
const ContactKeys kOfSet{"centre_of_mass", "torque_scale", "position", "torsion"};
const ContactKeys kOfGrasp{"centre_of_mass_m", "torque_scale_m", "position_m", "torsion_m"};

/// A place or direction; in a plane two numbers, and 0.
Eigen::Vector3d place_of(const JsonValue& value, bool planar) {
  const std::vector<double> p = value.numbers(planar ? 2 : 3);
  return {p[0], p[1], planar ? 0 : p[2]};
}

/// Force and torque; in a plane f_x, f_y and the torque.
FileWrench wrench_of(const JsonValue& value, bool planar) {
  const std::vector<double> w = value.numbers(planar ? 3 : 6);
  FileWrench wrench = FileWrench::Zero();
  if (planar)
    wrench << w[0], w[1], 0, 0, 0, w[2];
  else
    wrench << w[0], w[1], w[2], w[3], w[4], w[5];
  return wrench;
}

double not_negative(const JsonValue& value) {
  const double number = value.number("a number >= 0");
  if (number < 0) value.fail_wanted("a number >= 0");
  return number;
}

double positive(const JsonValue& value) {
  const double number = value.number("a number > 0");
  if (number <= 0) value.fail_wanted("a number > 0");
  if (number < kMinMagnitude) value.fail_wanted(fmt::format("at least {:g}", kMinMagnitude));
  return number;
}

FileContact contact_with_wrenches(const JsonValue& value, bool planar) {
  FileContact result;
  if (value.gives("position")) result.position = place_of(value["position"], planar);
  if (value.gives("normal")) (void)place_of(value["normal"], planar);
  if (value.gives("friction")) result.friction = not_negative(value["friction"]);
  const JsonValue wrenches = value["wrenches"];
  for (const JsonValue& wrench : wrenches.entries("a list of wrenches"))
    result.wrenches.push_back(wrench_of(wrench, planar));
  if (result.wrenches.empty()) wrenches.fail_wanted("at least one wrench");
  return result;
}

FileContact contact_with_cone(const JsonValue& value, bool planar, const ContactKeys& keys) {
  FileContact result;
  result.position = place_of(value[keys.position], planar);
  const JsonValue normal = value["normal"];
  result.normal = place_of(normal, planar);
  result.normal_length = result.normal.stableNorm();
  if (result.normal_length < kMinMagnitude) normal.fail_wanted("a non-zero vector");
  result.normal /= result.normal_length;
  result.friction = not_negative(value["friction"]);
  return result;
}

FileContact file_contact(const JsonValue& value, bool planar, const ContactKeys& keys) {
  FileContact result = value.gives("wrenches") ? contact_with_wrenches(value, planar)
                                               : contact_with_cone(value, planar, keys);
  if (value.gives(keys.torsion)) result.torsion = not_negative(value[keys.torsion]);
  if (planar && result.torsion > 0)
    value[keys.torsion].fail("torsion is about the normal, which lies in the plane: leave it out");
  const bool own =
      &keys == &kOfGrasp && value.gives("patch") && value["patch"].number("a number") < 0;
  if (value.gives("patch") && !own) result.patch = value["patch"].count();
  return result;
}

std::vector<FileWrench> wrenches_in(const JsonValue& list, bool planar, const char* what) {
  std::vector<FileWrench> wrenches;
  for (const JsonValue& each : list.entries(what)) wrenches.push_back(wrench_of(each, planar));
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
  const JsonNode parsed = parse_json(path, text, first_line);
  const JsonValue root(path, parsed);
  const bool grasp = root.gives(kOfGrasp.centre) && !root.gives(kOfSet.centre);
  const ContactKeys& keys = grasp ? kOfGrasp : kOfSet;
  // A grasp tells more than its contacts; of a set, what is not known is told.
  std::set<std::string> ignored;
  const auto ignore_others = [&](const JsonValue& value, const Names& known) {
    if (grasp) return;
    const Names others = value.others_than(known);
    ignored.insert(others.begin(), others.end());
  };
  ignore_others(root, {"centre_of_mass", "torque_scale", "contacts", "task", "name", "source"});
  // The plane or space, and what all torques need.
  const bool planar = root[keys.centre].size() == 2;
  ContactFile file;
  file.path = path;
  file.planar = planar;
  file.centre_of_mass = place_of(root[keys.centre], planar);
  file.torque_scale = positive(root[keys.scale]);
  // The contacts.
  const JsonValue contacts = root["contacts"];
  if (contacts.size() > kMaxContacts)
    contacts.fail(fmt::format("wanted at most {} contacts, got {}", kMaxContacts, contacts.size()));
  for (const JsonValue& contact : contacts.entries("a list of contacts")) {
    ignore_others(contact,
                  {"position", "normal", "friction", "torsion", "wrenches", "patch", "name"});
    file.contacts.push_back(file_contact(contact, planar, keys));
  }
  if (root.gives("task")) file.task = file_task(root["task"], planar, ignored);
  if (!ignored.empty())
    file.warnings.push_back(
        fmt::format("ignored, as it is not known: {}", fmt::join(ignored, ", ")));
  return file;
}

}  // namespace thenar
