#include "api/contact_warnings.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/lists.h"

namespace thenar {
namespace {

constexpr double kNormalRounding = 1e-3;  // Rounding of the length of a unit normal [1]
// Largest distance of a contact from the centre of mass, in torque scales [1] and in metres [m]
constexpr double kMaxScaledDistance = 20, kMaxContactDistance = 5;
// Largest coefficient of friction; larger numbers are angles [1]
constexpr double kLargestFriction = 5;

Contact contact_of(const FileContact& given) {
  return {given.position, given.normal, given.friction, given.torsion, given.patch};
}

/// The first of some contacts.
const FileContact& at(const ContactFile& file, const std::vector<int>& numbers) {
  return file.contacts[static_cast<std::size_t>(numbers.front())];
}

/// "contacts 0, 3, 4 and 9 more".
std::string listed_contacts(std::vector<int> numbers) {
  constexpr std::size_t kMaxNamedContacts = 6;  // Most contacts that are named
  const std::size_t all = numbers.size();
  numbers.resize(std::min(all, kMaxNamedContacts));
  return fmt::format(
      "contact{} {}{}", all == 1 ? "" : "s", fmt::join(numbers, ", "),
      all > kMaxNamedContacts ? fmt::format(" and {} more", all - kMaxNamedContacts) : "");
}

/// Numbers of the contacts with cones that pass a test.
template <typename Test>
std::vector<int> cones_that(const ContactFile& file, const Test& test) {
  std::vector<int> numbers;
  for (std::size_t i = 0; i < file.contacts.size(); ++i)
    if (file.contacts[i].wrenches.empty() && test(file.contacts[i]))
      numbers.push_back(static_cast<int>(i));
  return numbers;
}

/// Numbers of all contacts with cones.
std::vector<int> all_cones(const ContactFile& file) {
  return cones_that(file, [](const FileContact&) { return true; });
}

/// Distance from the centre of mass [m] (3).
Eigen::Vector3d arm_of(const FileContact& contact, const ContactFile& file) {
  return contact.position - file.centre_of_mass;
}

void add_normals(const ContactFile& file, std::vector<std::string>& warnings) {
  const std::vector<int> not_unit = cones_that(
      file, [](const FileContact& c) { return std::abs(c.normal_length - 1) >= kNormalRounding; });
  if (!not_unit.empty())
    warnings.push_back(fmt::format("a normal of length {:.6g} was made unit: {}",
                                   at(file, not_unit).normal_length, listed_contacts(not_unit)));
}

void add_far(const ContactFile& file, std::vector<std::string>& warnings) {
  // Far is beyond an absolute distance or beyond so many torque scales, whichever is less.
  const std::vector<int> far = cones_that(file, [&](const FileContact& c) {
    return arm_of(c, file).norm() >
           std::min(kMaxContactDistance, kMaxScaledDistance * file.torque_scale);
  });
  if (far.empty()) return;
  // Report the first of them as the example.
  const double r = arm_of(at(file, far), file).norm();
  warnings.push_back(fmt::format(
      "{:.4g} m, or {:.4g} torque scales, from the centre of mass: {}; lengths are in metres, "
      "are these millimetres?",
      r, r / file.torque_scale, listed_contacts(far)));
}

void add_outward(const ContactFile& file, std::vector<std::string>& warnings) {
  const std::vector<int> outward =
      cones_that(file, [&](const FileContact& c) { return c.normal.dot(arm_of(c, file)) > 0; });
  if (!outward.empty() && outward.size() == all_cones(file).size())
    warnings.emplace_back(
        "all normals point away from the centre of mass; they are to point into the object, were "
        "these outward ones?");
}

void add_repeated(const ContactFile& file, std::vector<std::string>& warnings) {
  // Contacts in one region share one limit of normal force, whatever the number of cones.
  const std::vector<int> cones = all_cones(file);
  const std::vector<Contact> places = transformed(
      cones, [&](int cone) { return contact_of(file.contacts[static_cast<std::size_t>(cone)]); });
  const std::vector<int> region = contact_regions(places);
  std::set<int> met;
  // A stated patch means that the repetition is on purpose.
  std::vector<int> repeated;
  for (std::size_t i = 0; i < cones.size(); ++i)
    if (!met.insert(region[i]).second && places[i].patch < 0) repeated.push_back(cones[i]);
  if (!repeated.empty())
    warnings.push_back(
        fmt::format("the place and normal of another contact: {}; one limit counts, "
                    "give each a patch if there are two",
                    listed_contacts(repeated)));
}

void add_rough(const ContactFile& file, std::vector<std::string>& warnings) {
  const std::vector<int> rough =
      cones_that(file, [](const FileContact& c) { return c.friction > kLargestFriction; });
  if (!rough.empty())
    warnings.push_back(
        fmt::format("friction {:.4g}: {}; a coefficient is wanted, is this an angle?",
                    at(file, rough).friction, listed_contacts(rough)));
}

}  // namespace

std::vector<std::string> contact_warnings(const ContactFile& file) {
  std::vector<std::string> warnings;
  add_normals(file, warnings);
  add_far(file, warnings);
  add_outward(file, warnings);
  add_repeated(file, warnings);
  add_rough(file, warnings);
  return warnings;
}

std::vector<Contact> contacts_of(const ContactFile& file) {
  return transformed(file.contacts, contact_of);
}

}  // namespace thenar
