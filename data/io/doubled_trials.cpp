#include "data/io/doubled_trials.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/lists.h"

namespace thenar {
namespace {

/// A trial with its place.
struct PlacedTrial {
  const Experiment* experiment;
  const Trial* trial;
  std::size_t number;  // in its experiment, from 1 [1]
};

/// Joint angles of a trial's posture [rad]; none where the experiment has no such posture.
std::map<std::string, double> angles_of(const PlacedTrial& of) {
  const PostureRecord* posture = find_named(of.experiment->postures, of.trial->posture);
  if (posture != nullptr) return posture->angles;
  return {};
}

bool are_copies(const PlacedTrial& a, const PlacedTrial& b) {
  return a.trial->force == b.trial->force && a.trial->tension == b.trial->tension &&
         a.trial->site == b.trial->site && a.experiment->digit == b.experiment->digit &&
         angles_of(a) == angles_of(b);
}

/// "trial 3 of 'H01' (Hook, FDS)"
std::string words_of(const PlacedTrial& of) {
  std::string loads;
  for (const auto& [muscle, tension] : of.trial->tension)
    if (tension > 0) loads += (loads.empty() ? "" : "+") + muscle;
  return fmt::format("trial {} of '{}' ({}, {})", of.number, of.experiment->name, of.trial->posture,
                     loads);
}

}  // namespace

std::vector<std::string> doubled_trial_warnings(const std::vector<Experiment>& experiments) {
  // Each trial beside those before it.
  std::vector<PlacedTrial> seen;
  std::string first;
  int copies = 0;
  for (const Experiment& experiment : experiments)
    for (std::size_t i = 0; i < experiment.trials.size(); ++i) {
      const PlacedTrial here{&experiment, &experiment.trials[i], i + 1};
      if (here.trial->force.isZero(0)) continue;
      const auto original = std::find_if(seen.begin(), seen.end(), [&](const PlacedTrial& other) {
        return are_copies(here, other);
      });
      if (original == seen.end()) {
        seen.push_back(here);
      } else if (++copies == 1) {
        first = words_of(here) + " is the same as " + words_of(*original);
      }
    }
  if (copies == 0) return {};
  return {fmt::format(
      "{} to the last digit{}: a copied row counts twice, and intervals come out too narrow", first,
      copies == 1   ? ""
      : copies == 2 ? ", and so is 1 more"
                    : fmt::format(", and so are {} more", copies - 1))};
}

}  // namespace thenar
