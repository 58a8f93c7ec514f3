#include "dynamics/stepping/mode_change.h"

#include <algorithm>
#include <cmath>

namespace thenar {
namespace {

/// Returns true if a contact slides in both, but in opposite directions: it stopped in between.
bool has_reversed_slip(const ActiveContact& a, const ActiveContact& b) {
  if (a.mode != ContactMode::kSlide || b.mode != ContactMode::kSlide) return false;
  if (a.kind == ActiveContact::Kind::kJointFriction) return a.approach * b.approach < 0;
  const auto friction = [](const ActiveContact& c) -> Eigen::Vector3d {
    return c.impulse - c.impulse.dot(c.normal) * c.normal;
  };
  return friction(a).dot(friction(b)) < 0;
}

/// Computes the margin of a contact to a change of mode: its normal impulse if it opens next,
/// otherwise its remaining friction if it sticks, or its slip if it slides.
/// @param next  the contact one substep later; null: lost
double mode_margin(const ActiveContact& contact, const ActiveContact* next) {
  // Normal impulse of a contact that opens, or impulse of a joint; speed of a sliding joint.
  const double pressed = contact.kind == ActiveContact::Kind::kContact
                             ? contact.impulse.dot(contact.normal)
                             : contact.impulse.x();
  if (contact.kind == ActiveContact::Kind::kJointFriction && contact.mode == ContactMode::kSlide)
    return std::abs(contact.approach);
  if (contact.kind != ActiveContact::Kind::kContact || next == nullptr ||
      next->mode == ContactMode::kOpen)
    return pressed;
  // Slip of a sliding contact, otherwise the friction left within the cone.
  if (contact.mode == ContactMode::kSlide) return contact.slip;
  return contact.friction.coefficient * pressed -
         (contact.impulse - pressed * contact.normal).norm();
}

}  // namespace

bool same_modes(const std::vector<ActiveContact>& a, const std::vector<ActiveContact>& b) {
  // Walk through both lists together and skip open contacts.
  const auto opens = [](const ActiveContact& c) { return c.mode == ContactMode::kOpen; };
  auto x = a.begin(), y = b.begin();
  while (true) {
    x = std::find_if_not(x, a.end(), opens);
    y = std::find_if_not(y, b.end(), opens);
    if (x == a.end() || y == b.end()) return x == a.end() && y == b.end();
    if (!x->is_same_contact(*y) || x->mode != y->mode || has_reversed_slip(*x, *y)) return false;
    ++x, ++y;
  }
}

double max_reversed_slip(const std::vector<ActiveContact>& before,
                         const std::vector<ActiveContact>& after) {
  double max_slip = 0;
  for (const ActiveContact& contact : before) {
    const ActiveContact* const then = find_contact(after, contact);
    if (then == nullptr || !has_reversed_slip(contact, *then)) continue;
    const bool is_joint = contact.kind == ActiveContact::Kind::kJointFriction;
    max_slip = std::max(max_slip, is_joint ? std::abs(contact.approach) : contact.slip);
  }
  return max_slip;
}

double fraction_before_change(const std::vector<ActiveContact>& earlier,
                              const std::vector<ActiveContact>& now,
                              const std::vector<ActiveContact>& next) {
  double fraction = earlier.empty() ? 0.5 : 1;
  // Examine contacts that change their mode in the next substep.
  for (const ActiveContact& contact : now) {
    const ActiveContact* const before = find_contact(earlier, contact);
    const ActiveContact* const after = find_contact(next, contact);
    if (contact.mode == ContactMode::kOpen || before == nullptr) continue;
    if (after != nullptr && after->mode == contact.mode && !has_reversed_slip(contact, *after))
      continue;
    // Extrapolate the margin linearly to zero.
    const double margin = mode_margin(contact, after);
    const double fall = mode_margin(*before, after) - margin;
    if (fall > 0 && margin >= 0) fraction = std::min(fraction, margin / fall);
  }
  return fraction;
}

}  // namespace thenar
