#pragma once

/// Where the numbers of a page came from.

#include <vector>

#include <nlohmann/json.hpp>

#include "base/fidelity.h"
#include "base/provenance.h"

namespace thenar {

/// The hash of every file by its path, and the versions of all that computed.
[[nodiscard]] nlohmann::json provenance_json(const FileDigests& files);
/// The same of texts: the hash of every source by its path, and the versions of all that computed.
[[nodiscard]] nlohmann::json provenance_json(const std::vector<SourceText>& sources);
/// The same with the fidelity.
[[nodiscard]] nlohmann::json provenance_json(const std::vector<SourceText>& sources,
                                             const Fidelity& fidelity);

}  // namespace thenar
