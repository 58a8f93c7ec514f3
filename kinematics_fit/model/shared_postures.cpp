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

/// Whether any two of the experiments have a posture of this name at other angles. Being the same
/// within 2 degrees is not handed on from one to the next, so that all pairs count.
bool differs(const std::string& name, const std::vector<Experiment>& experiments) {
  std::vector<const PostureRecord*> seen;
  for (const Experiment& experiment : experiments) {
    const PostureRecord* here = find_posture(experiment, name);
    if (here == nullptr) continue;
    for (const PostureRecord* there : seen)
      if (!same_posture(there, here)) return true;
    seen.push_back(here);
  }
  return false;
}

/// Whether a posture stands elsewhere in the known experiments: see with_own_postures().
bool stands_elsewhere(const PostureRecord& posture, const std::string& specimen,
                      const std::vector<Experiment>& known) {
  int own = 0, own_alike = 0, others_unlike = 0;
  for (const Experiment& other : known) {
    const PostureRecord* there = find_posture(other, posture.name);
    if (there == nullptr) continue;
    const bool alike = same_posture(there, &posture);
    if (other.specimen == specimen) {
      ++own;
      own_alike += alike ? 1 : 0;
    } else {
      others_unlike += alike ? 0 : 1;
    }
  }
  return own > 0 ? own_alike == 0 : others_unlike > 0;
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
    if (!stands_elsewhere(posture, experiment.specimen, known)) continue;
    // The new name, in the posture and in all that stands in it.
    const std::string name = posture.name;
    posture.name += " (" + experiment.name + ")";
    for (Trial& trial : experiment.trials)
      if (trial.posture == name) trial.posture = posture.name;
    for (ActivationRow& row : experiment.activations)
      if (row.posture == name) row.posture = posture.name;
  }
  return experiment;
}

}  // namespace thenar
