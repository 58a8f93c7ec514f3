#include "dynamics/stepping/touching_contacts.h"

#include <algorithm>
#include <cmath>

#include "dynamics/stepping/fixed_step.h"

namespace thenar {
namespace {

constexpr double kImpactSpeed = 1e-7;  // Slower approaches are no impacts [m/s], [rad/s]

}  // namespace

/// Notes what has a force and was not found: it may come back, as manifolds choose among their
/// points.
void TouchingContacts::note_lost(const std::vector<ActiveContact>& found) {
  lost_.clear();
  for (const ActiveContact& old : closed_)
    if (old.mode != ContactMode::kOpen && find_same(found, old) == found.end())
      lost_.push_back(old);
}

/// Keeps found contacts that are closed, with modes and impulses of those that go on.
/// @return whether all are known
bool TouchingContacts::keep_closed(std::vector<ActiveContact>& found) {
  // Contacts with a force stay closed, though their gap may be a little wide.
  const auto is_open = [&](const ActiveContact& contact) {
    return contact.gap > options_.touch &&
           std::none_of(closed_.begin(), closed_.end(), [&](const ActiveContact& c) {
             return c.mode != ContactMode::kOpen && c.same(contact);
           });
  };
  found.erase(std::remove_if(found.begin(), found.end(), is_open), found.end());
  // Contacts that go on keep their modes, and their impulses start the next solution.
  bool all_known = true;
  for (ActiveContact& contact : found) {
    const auto old = find_same(closed_, contact);
    if (old == closed_.end()) {
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

void TouchingContacts::touch_and_bounce(SceneState& state, std::vector<ActiveContact>& found) {
  note_lost(found);
  const bool all_known = keep_closed(found);
  // Impacts, where contacts approach.
  const bool approaches =
      std::any_of(closed_.begin(), closed_.end(), [](const ActiveContact& contact) {
        return contact.kind != ActiveContact::Kind::kJointFriction &&
               contact.approach < -kImpactSpeed;
      });
  if (approaches) {
    StepOutcome outcome;
    step_.impact(state, closed_, outcome);
    counts_.count(outcome);
    counts_.accept();
    ++cost_.impacts;
  }
  if (approaches || !all_known) settle_modes(state);
  // Contacts that leave are free, and touch again once their gap closes anew. A gap that still
  // counts as closed does not leave, or contacts that push each other off by turns would ask for
  // an impact each time.
  closed_.erase(std::remove_if(closed_.begin(), closed_.end(),
                               [&](const ActiveContact& c) {
                                 return c.mode == ContactMode::kOpen && c.approach > kImpactSpeed &&
                                        c.gap > options_.touch;
                               }),
                closed_.end());
  closed_.insert(closed_.end(), lost_.begin(), lost_.end());
}

/// Finds what contacts do next, by a step that is as short as can be.
void TouchingContacts::settle_modes(const SceneState& state) {
  // Shortest step from the state, with impulses scaled to its length.
  SceneState next = state;
  step_.act_as_at(next.t);
  const double factor = impulse_time_ > 0 ? options_.shortest / impulse_time_ : 0;
  scale_impulses(closed_, factor);
  scale_impulses(lost_, factor);
  // Contacts and modes of that step are where the next one starts.
  step_.substep(next, options_.shortest, closed_, options_.touch, outcome_);
  counts_.count(outcome_);
  counts_.accept();
  closed_.swap(outcome_.active);
  impulse_time_ = options_.shortest;
}

double TouchingContacts::touch_again(double length, SceneState& state,
                                     std::vector<ActiveContact>& found) {
  // Largest gap of contacts with a force; close the gaps where it is too large.
  const std::vector<ActiveContact> pressed = closed_;
  double worst = 0;
  for (const ActiveContact& contact : found)
    for (const ActiveContact& old : pressed)
      if (old.same(contact) && old.mode != ContactMode::kOpen)
        worst = std::max(worst, std::abs(contact.gap));
  if (worst > 0.1 * options_.touch) {
    step_.close_gaps(state, pressed, std::max(options_.touch, options_.recovery * length));
    step_.find(state, kNearGap, found);
  }
  // Impacts, and the deepest contact for the record.
  touch_and_bounce(state, found);
  for (const ActiveContact& contact : closed_)
    if (contact.kind == ActiveContact::Kind::kContact)
      cost_.deepest = std::max(cost_.deepest, -contact.gap);
  return worst;
}

}  // namespace thenar
