#include "dynamics/stepping/touching_contacts.h"

#include <algorithm>
#include <cmath>

#include "base/lists.h"
#include "dynamics/stepping/fixed_step.h"

namespace thenar {
namespace {

constexpr double kImpactSpeed = 1e-7;  // smallest approach speed of an impact [m/s], [rad/s]
constexpr double kCorrectionRatio =
    0.1;  // gap from which gaps are corrected over the touch gap [1]

}  // namespace

/// Remembers contacts with a force that were not found: they may reappear, because a manifold
/// selects a few of its points.
void TouchingContacts::remember_lost(const std::vector<ActiveContact>& found) {
  lost_.clear();
  for (const ActiveContact& old : closed_)
    if (old.mode != ContactMode::kOpen && find_contact(found, old) == nullptr) lost_.push_back(old);
}

/// Replaces the closed contacts by the found ones that are closed; persisting contacts keep their
/// modes and impulses. @return true if all were closed before
bool TouchingContacts::retain_closed(std::vector<ActiveContact>& found) {
  // Discard open contacts; a contact with a force stays closed at any gap.
  erase_where(found, [&](const ActiveContact& contact) {
    return contact.gap > options_.touch && !any_of(closed_, [&](const ActiveContact& c) {
             return c.mode != ContactMode::kOpen && c.is_same_contact(contact);
           });
  });
  // Copy modes and impulses of persisting contacts, for the warm start of the next solution.
  bool all_known = true;
  for (ActiveContact& contact : found) {
    const ActiveContact* const old = find_contact(closed_, contact);
    if (old == nullptr) {
      all_known = false;
      continue;
    }
    contact.impulse = old->impulse;
    contact.torsion = old->torsion;
    contact.mode = old->mode;
  }
  closed_.swap(found);
  return all_known;
}

void TouchingContacts::update_with_impacts(SceneState& state, std::vector<ActiveContact>& found) {
  remember_lost(found);
  const bool all_known = retain_closed(found);
  // Resolve impacts if a contact approaches.
  const bool approaches = any_of(closed_, [](const ActiveContact& contact) {
    return contact.kind != ActiveContact::Kind::kJointFriction && contact.approach < -kImpactSpeed;
  });
  if (approaches) {
    StepOutcome outcome;
    step_.resolve_impact(state, closed_, outcome);
    counts_.count_problem(outcome);
    counts_.accept();
    ++cost_.impacts;
  }
  // Determine new modes after an impact, and for new contacts.
  if (approaches || !all_known) settle_modes(state);
  // Remove contacts that separate. A gap that still counts as closed is kept: contacts that push
  // each other off in turn would otherwise cause an impact each time.
  erase_where(closed_, [&](const ActiveContact& c) {
    return c.mode == ContactMode::kOpen && c.approach > kImpactSpeed && c.gap > options_.touch;
  });
  append_all(closed_, lost_);
}

/// Determines the modes of the next step by a step of the shortest length from the state.
void TouchingContacts::settle_modes(const SceneState& state) {
  // Scale impulses to the shortest step.
  SceneState next = state;
  step_.select_active_forces(next.t);
  const double factor = impulse_time_ > 0 ? options_.min_step / impulse_time_ : 0;
  scale_impulses(closed_, factor);
  scale_impulses(lost_, factor);
  // Take the contacts and modes of that step, and discard its state.
  step_.take_euler_substep(next, options_.min_step, closed_, options_.touch, outcome_);
  counts_.count_problem(outcome_);
  counts_.accept();
  closed_.swap(outcome_.active);
  impulse_time_ = options_.min_step;
}

double TouchingContacts::close_gaps_and_update(double length, SceneState& state,
                                               std::vector<ActiveContact>& found) {
  // Find the largest gap of contacts with a force.
  const std::vector<ActiveContact> pressed = closed_;
  double max_gap = 0;
  for (const ActiveContact& contact : found)
    for (const ActiveContact& old : pressed)
      if (old.is_same_contact(contact) && old.mode != ContactMode::kOpen)
        max_gap = std::max(max_gap, std::abs(contact.gap));
  // Close gaps if it is too large; penetration is pushed out no faster than `recovery`.
  if (max_gap > kCorrectionRatio * options_.touch) {
    step_.close_gaps(state, pressed, std::max(options_.touch, options_.recovery * length));
    step_.find_contacts(state, kSearchMargin, found);
  }
  // Update contacts, and record the largest penetration.
  update_with_impacts(state, found);
  for (const ActiveContact& contact : closed_)
    if (contact.kind == ActiveContact::Kind::kContact)
      cost_.max_penetration = std::max(cost_.max_penetration, -contact.gap);
  return max_gap;
}

}  // namespace thenar
