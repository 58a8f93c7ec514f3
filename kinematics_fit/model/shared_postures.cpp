#include "kinematics_fit/model/shared_postures.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "base/lists.h"
#include "base/units.h"

namespace thenar {
namespace {

double angle_of(const PostureRecord& posture, const std::string& joint) {
  const auto found = posture.angles.find(joint);
  return found == posture.angles.end() ? 0 : found->second;
}

/// Returns two experiments that have a posture of this name at different angles, or nulls. Equality
/// within 2 degrees is not transitive, so that all pairs are compared.
std::pair<const Experiment*, const Experiment*> find_differing(
    const std::string& name, const std::vector<Experiment>& experiments) {
  for (std::size_t e = 0; e < experiments.size(); ++e) {
    const PostureRecord* here = find_posture(experiments[e], name);
    if (here == nullptr) continue;
    for (std::size_t other = 0; other < e; ++other) {
      const PostureRecord* there = find_posture(experiments[other], name);
      if (there != nullptr && !same_posture(there, here))
        return {&experiments[other], &experiments[e]};
    }
  }
  return {nullptr, nullptr};
}

/// Returns the suffix that with_own_postures() adds to the names of an experiment's postures.
std::string own_suffix(const Experiment& experiment) { return " (" + experiment.name + ")"; }

/// Returns whether a posture differs from those of its name in the known experiments: see
/// with_own_postures().
bool differs_from_known(const PostureRecord& posture, const std::string& specimen,
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
  return find_named(experiment.postures, name);
}

bool same_posture(const PostureRecord* a, const PostureRecord* b) {
  const double kSame = radians(2);  // largest difference of angles in equal postures [rad]
  if (a == nullptr || b == nullptr) return false;
  const auto alike = [&](const auto& joint) {
    return std::abs(angle_of(*a, joint.first) - angle_of(*b, joint.first)) <= kSame;
  };
  return all_of(a->angles, alike) && all_of(b->angles, alike);
}

FitParameters share_same_postures(FitParameters parameters,
                                  const std::vector<Experiment>& experiments) {
  for (std::size_t key = 0; key < parameters.postures.size(); ++key) {
    // Where a posture differs between experiments, move its errors from the population to
    // specimens.
    if (find_differing(parameters.postures[key], experiments).first == nullptr) continue;
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
    if (!differs_from_known(posture, experiment.specimen, known)) continue;
    // Rename the posture, and its trials and activation rows.
    const std::string name = posture.name;
    posture.name += own_suffix(experiment);
    for (Trial& trial : experiment.trials)
      if (trial.posture == name) trial.posture = posture.name;
    for (ActivationRow& row : experiment.activations)
      if (row.posture == name) row.posture = posture.name;
  }
  return experiment;
}

std::vector<std::string> posture_name_warnings(const std::vector<Experiment>& experiments) {
  std::vector<std::string> warnings;
  std::set<std::string> names;
  for (const Experiment& experiment : experiments)
    for (const PostureRecord& posture : experiment.postures) {
      // Warn of renamed postures, once each.
      names.insert(posture.name);
      const std::string suffix = own_suffix(experiment);
      const std::size_t length = posture.name.size() - std::min(suffix.size(), posture.name.size());
      if (posture.name.substr(length) == suffix)
        warnings.push_back(
            fmt::format("experiment '{}': posture '{}' is more than 2 degrees from that of the "
                        "same name in other experiments: it is treated as another one",
                        experiment.name, posture.name.substr(0, length)));
    }
  // Warn of equal names for different postures of several specimens.
  for (const std::string& name : names) {
    const auto [one, other] = find_differing(name, experiments);
    if (one != nullptr)
      warnings.push_back(fmt::format(
          "posture '{}' of experiments '{}' and '{}' is not one, as angles differ by more than 2 "
          "degrees: nothing that is missed in it is shared between people",
          name, one->name, other->name));
  }
  return warnings;
}

}  // namespace thenar
