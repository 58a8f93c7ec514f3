#pragma once

/// Provenance of the numbers of a page.

#include <vector>

#include <nlohmann/json.hpp>

#include "base/fidelity.h"
#include "base/provenance.h"

namespace thenar {

/// Returns the hash of every file by its path, and the versions of all programs and libraries.
[[nodiscard]] nlohmann::json provenance_json(const FileDigests& files);
/// Returns the hash of every source by its path, and the versions of all programs and libraries.
[[nodiscard]] nlohmann::json provenance_json(const std::vector<SourceText>& sources);
/// Returns the provenance of sources, with the fidelity.
[[nodiscard]] nlohmann::json provenance_json(const std::vector<SourceText>& sources,
                                             const Fidelity& fidelity);

}  // namespace thenar
