#include "dynamics/stepping/fixed_step.h"

#include <algorithm>

namespace thenar {

double FixedStep::take(ContactStep& step, double h, const SceneOptions& options, SceneState& state,
                       std::vector<ActiveContact>& last, SceneCost& cost,
                       const Progress& progress) {
  const SceneState before = state;
  const std::vector<ActiveContact> start = last;
  // Twice as many parts, until surfaces move little enough within a part.
  for (int parts = 1;; parts *= 2) {
    const double part = h / parts;
    double motion = 0, residual = 0;
    long unsolved = 0;
    // Parts of equal length; a stop goes back to the beginning.
    for (int i = 0; i < parts; ++i) {
      if (parts > 1 && progress.stop()) {
        state = before;
        last = start;
        return 0;
      }
      if (parts > 1) progress(static_cast<double>(i) / parts, "a step in parts");
      const SceneState from = state;
      step.time_step(state, part, last, options.recovery, outcome_);
      ++cost.substeps;
      if (!outcome_.solved) ++unsolved;
      residual = std::max(residual, outcome_.residual);
      std::swap(last, outcome_.active);
      motion = std::max(motion, step.motion_between(from, state, last));
    }
    // Done if motion is small enough, parts are as short as can be, or the state is no number.
    if (motion <= 1 || part <= options.shortest || !is_finite(state)) {
      if (motion > 1) ++cost.leaps;
      cost.unsolved += unsolved;
      cost.worst_residual = std::max(cost.worst_residual, residual);
      return part;
    }
    // Start again with twice as many parts, and impulses for half the length.
    ++cost.rejected;
    state = before;
    last = start;
    scale_impulses(last, 0.5 / parts);
  }
}

void scale_impulses(std::vector<ActiveContact>& list, double factor) {
  for (ActiveContact& contact : list) {
    contact.impulse *= factor;
    contact.torsion *= factor;
  }
}

bool is_finite(const SceneState& state) {
  return state.q.allFinite() && state.v.allFinite() && state.z.allFinite();
}

std::vector<ContactSample> contact_samples(const std::vector<ActiveContact>& active, double h) {
  std::vector<ContactSample> out;
  if (h <= 0) return out;
  for (const ActiveContact& contact : active) {
    // Contacts with a force, as forces in the mean of the step.
    if (contact.kind != ActiveContact::Kind::kContact || contact.mode == ContactMode::kOpen)
      continue;
    out.push_back({contact.a, contact.b, contact.id, contact.point, contact.normal,
                   contact.impulse / h, contact.torsion / h, contact.gap, contact.mode});
  }
  return out;
}

}  // namespace thenar
