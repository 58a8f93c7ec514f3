#pragma once

/// The page of a comparison of hands.

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "api/hands.h"
#include "grasp/compare/comparison.h"

namespace thenar {

/// Writes the page; false if stopped before.
/// @param objects     as compared
/// @param hands       that were compared
/// @param provenance  name -> text
bool write_compare_report(const Comparison& comparison, const std::vector<BodySpec>& objects,
                          const std::vector<NamedHand>& hands, const nlohmann::json& provenance,
                          const std::string& path, const Progress& progress = {});

}  // namespace thenar
