#include "kinematics_fit/model/shared_postures.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace thenar {
namespace {

double angle_of(const PostureRecord& posture, const std::string& joint) {
  const auto found = posture.angles.find(joint);
  return found == posture.angles.end() ? 0 : found->second;
}

/// Whether two of the experiments have a posture of this name at other angles.
bool differs(const std::string& name, const std::vector<Experiment>& experiments) {
  const PostureRecord* first = nullptr;
  for (const Experiment& experiment : experiments) {
    const PostureRecord* here = find_posture(experiment, name);
    if (here == nullptr) continue;
    if (first == nullptr) first = here;
    if (!same_posture(first, here)) return true;
  }
  return false;
}

}  // namespace

const PostureRecord* find_posture(const Experiment& experiment, const std::string& name) {
  const auto& all = experiment.postures;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

bool same_posture(const PostureRecord* a, const PostureRecord* b) {
  const double kSame = radians(2);
  if (a == nullptr || b == nullptr) return false;
  const auto alike = [&](const auto& joint) {
    return std::abs(angle_of(*a, joint.first) - angle_of(*b, joint.first)) <= kSame;
  };
  return std::all_of(a->angles.begin(), a->angles.end(), alike) &&
         std::all_of(b->angles.begin(), b->angles.end(), alike);
}

FitParameters share_same_postures(FitParameters parameters,
                                  const std::vector<Experiment>& experiments) {
  for (std::size_t key = 0; key < parameters.postures.size(); ++key) {
    if (!differs(parameters.postures[key], experiments)) continue;
    for (Parameter& p : parameters.all) {
      const bool of_posture =
          p.kind == ParameterKind::kPostureAngle || p.kind == ParameterKind::kPostureForce;
      if (!of_posture || p.point != static_cast<int>(key)) continue;
      p.between_sd = std::hypot(p.sd, p.between_sd);
      p.sd = 0;
    }
  }
  return parameters;
}

Experiment with_own_postures(Experiment experiment, const std::vector<Experiment>& known) {
  for (PostureRecord& posture : experiment.postures) {
    // Those of the same specimen that have the name; of nobody else then.
    const std::string name = posture.name;
    const auto own = [&](const Experiment& other) {
      return other.specimen == experiment.specimen && find_posture(other, name) != nullptr;
    };
    const bool by_own = std::any_of(known.begin(), known.end(), own);
    const bool taken = std::any_of(known.begin(), known.end(), [&](const Experiment& other) {
      const PostureRecord* there = find_posture(other, name);
      return there != nullptr && (!by_own || own(other)) && !same_posture(there, &posture);
    });
    if (!taken) continue;

    // The name, in the posture and in all that stands in it.
    posture.name += " (" + experiment.specimen + ")";
    for (Trial& trial : experiment.trials)
      if (trial.posture == name) trial.posture = posture.name;
    for (ActivationRow& row : experiment.activations)
      if (row.posture == name) row.posture = posture.name;
  }
  return experiment;
}

}  // namespace thenar
