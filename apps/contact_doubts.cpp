#include "apps/contact_doubts.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/contact_file.h"
#include "grasp/contact/contact.h"

namespace thenar {
namespace {

constexpr double kNormalRounding = 1e-3;  // of a unit normal's length: rounded, not odd [1]
constexpr double kFarOverScale = 20;      // from the centre, in torque scales: in another unit [1]
constexpr double kFar = 5;                // from the centre: no object that a hand holds [m]
constexpr double kLargestFriction = 5;    // more is an angle [1]

/// Cones of the file, with their numbers.
struct Numbered {
  int number;
  const FileContact* contact;
};

std::vector<Numbered> cones_of(const ContactFile& file) {
  std::vector<Numbered> cones;
  for (std::size_t i = 0; i < file.contacts.size(); ++i)
    if (file.contacts[i].wrenches.empty())
      cones.push_back({static_cast<int>(i), &file.contacts[i]});
  return cones;
}

/// "contacts 0, 3, 4 and 9 more".
std::string listed_contacts(std::vector<int> numbers) {
  constexpr std::size_t kNamed = 6;
  const std::size_t all = numbers.size();
  numbers.resize(std::min(all, kNamed));
  return fmt::format("contact{} {}{}", all == 1 ? "" : "s", fmt::join(numbers, ", "),
                     all > kNamed ? fmt::format(" and {} more", all - kNamed) : "");
}

template <typename Odd>
std::vector<int> those(const std::vector<Numbered>& cones, Odd odd) {
  std::vector<int> numbers;
  for (const Numbered& cone : cones)
    if (odd(*cone.contact)) numbers.push_back(cone.number);
  return numbers;
}

}  // namespace

std::vector<std::string> contact_doubts(const ContactFile& file) {
  const std::vector<Numbered> cones = cones_of(file);
  std::vector<std::string> doubts;
  const auto arm = [&](const FileContact& c) -> Eigen::Vector3d {
    return c.contact.p - file.centre_of_mass;
  };
  const auto first = [&](const std::vector<int>& numbers) -> const FileContact& {
    return file.contacts[static_cast<std::size_t>(numbers.front())];
  };

  const std::vector<int> not_unit = those(
      cones, [](const FileContact& c) { return std::abs(c.normal_length - 1) >= kNormalRounding; });
  if (!not_unit.empty())
    doubts.push_back(fmt::format("a normal of length {:.6g} was made unit: {}",
                                 first(not_unit).normal_length, listed_contacts(not_unit)));

  const std::vector<int> far = those(cones, [&](const FileContact& c) {
    return arm(c).norm() > std::min(kFar, kFarOverScale * file.torque_scale);
  });
  if (!far.empty()) {
    const double r = arm(first(far)).norm();
    doubts.push_back(fmt::format(
        "{:.4g} m, or {:.4g} torque scales, from the centre of mass: {}; lengths are in metres, "
        "are these millimetres?",
        r, r / file.torque_scale, listed_contacts(far)));
  }

  const std::vector<int> outward =
      those(cones, [&](const FileContact& c) { return c.contact.n.dot(arm(c)) > 0; });
  if (!cones.empty() && outward.size() == cones.size())
    doubts.push_back(
        "all normals point away from the centre of mass; they are to point into the object, were "
        "these outward ones?");

  std::vector<Contact> places;
  for (const Numbered& cone : cones) places.push_back(cone.contact->contact);
  const std::vector<int> region = contact_regions(places);
  std::set<int> met;
  std::vector<int> repeated;
  for (std::size_t i = 0; i < cones.size(); ++i)
    if (!met.insert(region[i]).second && places[i].patch < 0) repeated.push_back(cones[i].number);
  if (!repeated.empty())
    doubts.push_back(
        fmt::format("the place and normal of another contact: {}; one limit counts, "
                    "give each a patch if there are two",
                    listed_contacts(repeated)));

  const std::vector<int> rough =
      those(cones, [](const FileContact& c) { return c.contact.friction > kLargestFriction; });
  if (!rough.empty())
    doubts.push_back(fmt::format("friction {:.4g}: {}; a coefficient is wanted, is this an angle?",
                                 first(rough).contact.friction, listed_contacts(rough)));
  return doubts;
}

}  // namespace thenar
