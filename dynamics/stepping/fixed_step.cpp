#include "dynamics/stepping/fixed_step.h"

#include <algorithm>

namespace thenar {

double FixedStep::take_step(ContactStep& step, double h, SceneState& state,
                            std::vector<ActiveContact>& last, SceneCost& cost,
                            const Progress& progress) {
  const SceneState before = state;
  const std::vector<ActiveContact> start = last;
  // Double the number of parts until bodies cannot pass through each other within a part.
  for (int parts = 1;; parts *= 2) {
    const double part = h / parts;
    double motion = 0, residual = 0;
    long unsolved = 0;
    // Take the parts; a stop restores the start of the step.
    for (int i = 0; i < parts; ++i) {
      if (parts > 1 && progress.stop()) {
        state = before;
        last = start;
        return 0;
      }
      if (parts > 1) progress(static_cast<double>(i) / parts, "a step in parts");
      const SceneState from = state;
      step.take_midpoint_step(state, part, last, options_.recovery, outcome_);
      ++cost.substeps;
      if (!outcome_.solved) ++unsolved;
      residual = std::max(residual, outcome_.residual);
      std::swap(last, outcome_.active);
      motion = std::max(motion, step.tunnelling_ratio(from, state, last));
    }
    // Accept if motion is small enough, parts are the shortest, or the state is not finite.
    if (motion <= 1 || part <= options_.min_step || !is_finite(state)) {
      if (motion > 1) ++cost.tunnelling_steps;
      cost.unsolved += unsolved;
      cost.worst_residual = std::max(cost.worst_residual, residual);
      return part;
    }
    // Restart from the beginning, with impulses scaled to half the length.
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
    // Convert closed contacts, with mean forces.
    if (contact.kind != ActiveContact::Kind::kContact || contact.mode == ContactMode::kOpen)
      continue;
    out.push_back({contact.a, contact.b, contact.id, contact.point, contact.normal,
                   contact.impulse / h, contact.torsion / h, contact.gap, contact.mode});
  }
  return out;
}

SceneSample make_sample(ContactStep& step, const SceneState& state,
                        const std::vector<ActiveContact>& active, double h) {
  SceneSample out{state.t, state.q, state.v, state.z, contact_samples(active, h), {}, state.w};
  step.add_element_contacts(state, out.contacts);
  out.energy = step.energy(state);
  return out;
}

}  // namespace thenar
