#pragma once

/// Largest tendon tensions of a hand, with substitutes for those that a subject does not state.

#include <map>
#include <string>
#include <vector>

#include "data/io/subject.h"

namespace thenar {

/// Largest tension of every muscle, with the assumptions made for it.
struct MuscleForces {
  std::map<std::string, double> max_force;  // F0 of each muscle of a digit [N]
  std::vector<std::string> assumed;         // "FDP4: 150.6 N, as FDP3, times 0.82"
};

/// Returns F0 of the muscles that cross a joint of a digit.
///
/// Where the subject does not state it, a muscle of the ring or little finger is assumed to be as
/// strong as the corresponding muscle of the middle finger, times the ratio of the two fingers'
/// cross-sections (radii of the proximal phalanges, squared). Corresponding muscles: EDC3 for EDC4
/// and EDM, FDS3, FDP3, DI2 for dorsal, DI3 for palmar interossei and for FDM and ADM.
/// @throws InputError for a muscle without F0 and without a corresponding muscle.
[[nodiscard]] MuscleForces muscle_forces(const Subject& subject,
                                         const std::vector<std::string>& muscles);

}  // namespace thenar
