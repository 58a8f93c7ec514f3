#include "dynamics/stepping/mode_change.h"

#include <algorithm>
#include <cmath>

namespace thenar {
namespace {

/// Finds a contact in a list; null if the list does not have it.
const ActiveContact* same_in(const std::vector<ActiveContact>& list, const ActiveContact& contact) {
  const auto at = std::find_if(list.begin(), list.end(),
                               [&](const ActiveContact& c) { return c.same(contact); });
  return at == list.end() ? nullptr : &*at;
}

/// Returns true if a contact slides in both, but in opposite directions: it stood still in between.
bool turned_round(const ActiveContact& a, const ActiveContact& b) {
  if (a.mode != ContactMode::kSlide || b.mode != ContactMode::kSlide) return false;
  if (a.kind == ActiveContact::Kind::kJointFriction) return a.approach * b.approach < 0;
  const auto friction = [](const ActiveContact& c) -> Eigen::Vector3d {
    return c.impulse - c.impulse.dot(c.normal) * c.normal;
  };
  return friction(a).dot(friction(b)) < 0;
}

/// Computes the margin of a contact to its next mode: the normal force if it opens, else the
/// remaining friction if it sticks, and the slip if it slides. @param next  null: the contact is
/// lost
double mode_margin(const ActiveContact& contact, const ActiveContact* next) {
  // Normal force of a contact that opens, or of a limit; speed of a joint that slides.
  const double pressed = contact.kind == ActiveContact::Kind::kContact
                             ? contact.impulse.dot(contact.normal)
                             : contact.impulse.x();
  if (contact.kind == ActiveContact::Kind::kJointFriction && contact.mode == ContactMode::kSlide)
    return std::abs(contact.approach);
  if (contact.kind != ActiveContact::Kind::kContact || next == nullptr ||
      next->mode == ContactMode::kOpen)
    return pressed;
  // Slip of a contact that slides, otherwise friction that is left below the cone.
  if (contact.mode == ContactMode::kSlide) return contact.slip;
  return contact.friction.coefficient * pressed -
         (contact.impulse - pressed * contact.normal).norm();
}

}  // namespace

bool same_modes(const std::vector<ActiveContact>& a, const std::vector<ActiveContact>& b) {
  // Both lists in step, without contacts that open.
  const auto opens = [](const ActiveContact& c) { return c.mode == ContactMode::kOpen; };
  auto x = a.begin(), y = b.begin();
  while (true) {
    x = std::find_if_not(x, a.end(), opens);
    y = std::find_if_not(y, b.end(), opens);
    if (x == a.end() || y == b.end()) return x == a.end() && y == b.end();
    if (!x->same(*y) || x->mode != y->mode || turned_round(*x, *y)) return false;
    ++x, ++y;
  }
}

double slip_that_turned(const std::vector<ActiveContact>& before,
                        const std::vector<ActiveContact>& after) {
  double most = 0;
  for (const ActiveContact& contact : before) {
    const ActiveContact* const then = same_in(after, contact);
    if (then == nullptr || !turned_round(contact, *then)) continue;
    const bool is_joint = contact.kind == ActiveContact::Kind::kJointFriction;
    most = std::max(most, is_joint ? std::abs(contact.approach) : contact.slip);
  }
  return most;
}

double share_before_change(const std::vector<ActiveContact>& earlier,
                           const std::vector<ActiveContact>& now,
                           const std::vector<ActiveContact>& next) {
  double share = earlier.empty() ? 0.5 : 1;
  // Contacts that change their mode in the next substep.
  for (const ActiveContact& contact : now) {
    const ActiveContact* const before = same_in(earlier, contact);
    const ActiveContact* const after = same_in(next, contact);
    if (contact.mode == ContactMode::kOpen || before == nullptr) continue;
    if (after != nullptr && after->mode == contact.mode && !turned_round(contact, *after)) continue;
    // Instant at which the margin ends, if it falls as in the substep before.
    const double margin = mode_margin(contact, after);
    const double fall = mode_margin(*before, after) - margin;
    if (fall > 0 && margin >= 0) share = std::min(share, margin / fall);
  }
  return share;
}

}  // namespace thenar
