#include "grasp/contact/contact.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "base/lists.h"

namespace thenar {

std::vector<Contact> contacts_without_hand(const std::vector<HandContact>& contacts) {
  return transformed(contacts, [](const HandContact& each) { return each.contact; });
}

Contact transform_contact(const Pose<double>& X_AB, const Contact& contact_B) {
  Contact contact = contact_B;
  contact.p = X_AB * contact_B.p;
  contact.n = X_AB.R * contact_B.n;
  return contact;
}

namespace {

// Tolerance of equal contacts: positions over the grasp's extent, and normals [1]
constexpr double kContactTolerance = 1e-9;

/// Direction along which contacts are sorted; its irrational components make ties rare.
const Eigen::Vector3d kSortDirection(0.6180339887, 0.7548776662, 0.5698402910);

double extent(const std::vector<Contact>& contacts) {
  double max_distance = 0;
  for (const Contact& each : contacts)
    max_distance = std::max(max_distance, (each.p - contacts[0].p).norm());
  return max_distance;
}

/// Returns for every contact without a patch the first contact with its position and normal,
/// possibly itself.
std::vector<std::size_t> first_equal_contacts(const std::vector<Contact>& contacts) {
  const double near = kContactTolerance * extent(contacts);
  std::vector<std::size_t> first(contacts.size()), order;
  std::iota(first.begin(), first.end(), std::size_t{0});
  // Sort contacts without a patch number along one direction.
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (contacts[i].patch < 0) order.push_back(i);
  const auto level = [&](std::size_t i) { return kSortDirection.dot(contacts[i].p); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return level(i) < level(j); });
  // Sweep: only predecessors within the tolerance along that direction can be equal.
  for (std::size_t a = 0; a < order.size(); ++a)
    for (std::size_t b = a; b-- > 0;) {
      const std::size_t i = order[a], j = order[b];
      if (level(i) - level(j) > 2 * near) break;
      if ((contacts[i].p - contacts[j].p).norm() > near ||
          (contacts[i].n - contacts[j].n).norm() > kContactTolerance)
        continue;
      // The earlier contact already refers to the first one.
      first[i] = first[j];
      break;
    }
  return first;
}

}  // namespace

std::vector<int> contact_regions(const std::vector<Contact>& contacts) {
  const std::vector<std::size_t> first = first_equal_contacts(contacts);
  std::map<int, int> of_patch;
  std::map<std::size_t, int> of_place;
  std::vector<int> numbers;
  int next = 0;
  // A patch, or a group of equal contacts, gets the next number at its first point.
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const int patch = contacts[i].patch;
    const int number = patch >= 0 ? of_patch.try_emplace(patch, next).first->second
                                  : of_place.try_emplace(first[i], next).first->second;
    next = std::max(next, number + 1);
    numbers.push_back(number);
  }
  return numbers;
}

}  // namespace thenar
