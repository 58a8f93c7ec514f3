#include "dynamics/stepping/mode_change.h"

#include <algorithm>

namespace thenar {
namespace {

/// The same contact in a list, null if it is not there.
const ActiveContact* same_in(const std::vector<ActiveContact>& list, const ActiveContact& contact) {
  const auto at = std::find_if(list.begin(), list.end(),
                               [&](const ActiveContact& c) { return c.same(contact); });
  return at == list.end() ? nullptr : &*at;
}

/// How far a contact is from its next mode: the normal force if it opens, else the friction that is
/// left where it sticks, and the slip where it slides. @param next  null: it is lost
double mode_margin(const ActiveContact& contact, const ActiveContact* next) {
  const double pressed = contact.kind == ActiveContact::Kind::kContact
                             ? contact.impulse.dot(contact.normal)
                             : contact.impulse.x();
  if (contact.kind != ActiveContact::Kind::kContact || next == nullptr ||
      next->mode == ContactMode::kOpen)
    return pressed;
  if (contact.mode == ContactMode::kSlide) return contact.slip;
  return contact.friction.coefficient * pressed -
         (contact.impulse - pressed * contact.normal).norm();
}

}  // namespace

bool same_modes(const std::vector<ActiveContact>& a, const std::vector<ActiveContact>& b) {
  const auto opens = [](const ActiveContact& c) { return c.mode == ContactMode::kOpen; };
  auto x = a.begin(), y = b.begin();
  while (true) {
    x = std::find_if_not(x, a.end(), opens);
    y = std::find_if_not(y, b.end(), opens);
    if (x == a.end() || y == b.end()) return x == a.end() && y == b.end();
    if (!x->same(*y) || x->mode != y->mode) return false;
    ++x, ++y;
  }
}

double share_before_change(const std::vector<ActiveContact>& earlier,
                           const std::vector<ActiveContact>& now,
                           const std::vector<ActiveContact>& next) {
  double share = earlier.empty() ? 0.5 : 1;
  for (const ActiveContact& contact : now) {
    const ActiveContact* const before = same_in(earlier, contact);
    const ActiveContact* const after = same_in(next, contact);
    if (contact.mode == ContactMode::kOpen || before == nullptr) continue;
    if (after != nullptr && after->mode == contact.mode) continue;
    const double margin = mode_margin(contact, after);
    const double fall = mode_margin(*before, after) - margin;
    if (fall > 0 && margin >= 0) share = std::min(share, margin / fall);
  }
  return share;
}

}  // namespace thenar
