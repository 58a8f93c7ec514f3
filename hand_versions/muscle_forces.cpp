#include "hand_versions/muscle_forces.h"

#include <optional>

#include <fmt/format.h>

#include "base/error.h"
#include "base/lists.h"
#include "hand/skin/hand_anatomy.h"

namespace thenar {
namespace {

/// Muscle of the middle finger that corresponds to one of the ring or little finger, and that
/// finger.
struct Namesake {
  std::string muscle, digit;
};

/// Returns the corresponding muscle of the middle finger, if there is one.
std::optional<Namesake> namesake_of(const std::string& name) {
  static const std::map<std::string, Namesake> table{
      {"EDC4", {"EDC3", "ring"}},   {"FDS4", {"FDS3", "ring"}},   {"FDP4", {"FDP3", "ring"}},
      {"PI3", {"DI3", "ring"}},     {"DI4", {"DI2", "ring"}},     {"EDM", {"EDC3", "little"}},
      {"FDS5", {"FDS3", "little"}}, {"FDP5", {"FDP3", "little"}}, {"PI4", {"DI3", "little"}},
      {"FDM", {"DI3", "little"}},   {"ADM", {"DI3", "little"}}};
  const auto found = table.find(name);
  return found == table.end() ? std::nullopt : std::optional<Namesake>(found->second);
}

/// Computes the cross-section of a finger over that of the middle finger [1].
double section_ratio(const HandAnatomy& hand, const std::string& digit) {
  const DigitAnatomy *one = digit_named(hand, digit), *middle = digit_named(hand, "middle");
  if (one == nullptr || middle == nullptr) return 1;
  const double ratio = one->bones[0].radius / middle->bones[0].radius;
  return ratio * ratio;
}

}  // namespace

MuscleForces muscle_forces(const Subject& subject, const std::vector<std::string>& muscles) {
  MuscleForces forces;
  std::optional<HandAnatomy> hand;
  for (const std::string& name : muscles) {
    const MuscleUnit* muscle = find_named(subject.muscles, name);
    require(muscle != nullptr, "subject '{}' has no muscle '{}'", subject.name, name);
    // Take a value stated by the subject.
    if (muscle->max_force) {
      forces.max_force[name] = *muscle->max_force;
      continue;
    }
    // Otherwise scale that of the corresponding muscle of the middle finger by the cross-section.
    const auto like = namesake_of(name);
    const MuscleUnit* other = like ? find_named(subject.muscles, like->muscle) : nullptr;
    require(
        other != nullptr && other->max_force,
        "largest tension of muscle '{}' of '{}' is unknown, and so is that of a like one on the "
        "middle finger",
        name, subject.name);
    // Derive the anatomy once, and only if it is needed.
    if (!hand) hand = find_anatomy(subject);
    const double ratio = section_ratio(*hand, like->digit);
    forces.max_force[name] = ratio * *other->max_force;
    forces.assumed.push_back(fmt::format("{}: {:.1f} N, as {} times {:.2f}", name,
                                         forces.max_force[name], like->muscle, ratio));
  }
  return forces;
}

}  // namespace thenar
