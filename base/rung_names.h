#pragma once

/// Rungs of the ladders of base/fidelity.h by the names in commands.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/enum_names.h"
#include "base/fidelity.h"

namespace thenar {

inline constexpr std::array kPathNames{EnumName{Path::kViaPoint, "via"},
                                       EnumName{Path::kFitted, "fitted"},
                                       EnumName{Path::kWrapped, "wrapped"}};
inline constexpr std::array kHoodNames{EnumName{Hood::kSeparate, "separate"},
                                       EnumName{Hood::kFractions, "fractions"},
                                       EnumName{Hood::kFloatingNet, "net"}};
inline constexpr std::array kMuscleNames{EnumName{Muscle::kBounds, "bounds"},
                                         EnumName{Muscle::kRigidTendon, "rigid-tendon"},
                                         EnumName{Muscle::kElasticTendon, "elastic-tendon"}};

/// Returns the names of requestable paths: "via", "fitted", "wrapped".
[[nodiscard]] std::vector<std::string> path_names();
/// Returns the path of a name. @throws InputError with the nearest name and all others, as
/// hood_named() and muscle_named().
[[nodiscard]] Path path_named(const std::string& name);
/// Returns the name of a path: "via", "fitted", "wrapped"; also "none" and "constant", which cannot
/// be requested.
[[nodiscard]] std::string name_of(Path path);
/// Returns the record of the requested paths in a result: the name of the rung, or kSubjectsPaths
/// if subjects decide.
[[nodiscard]] std::string asked_paths(const std::optional<Path>& asked);
inline constexpr const char* kSubjectsPaths = "wrapped where surfaces are stated";

/// Returns the names of hoods: "separate", "fractions", "net".
[[nodiscard]] std::vector<std::string> hood_names();
[[nodiscard]] Hood hood_named(const std::string& name);

/// Returns the muscle rung named "bounds", "rigid-tendon" or "elastic-tendon".
[[nodiscard]] Muscle muscle_named(const std::string& name);

}  // namespace thenar
