#pragma once

/// The page of a comparison of hands.

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "grasp/compare/comparison.h"

namespace thenar {

/// Writes the page; false if stopped before. Hands are built again by their names, to be drawn:
/// human ones with finer skin.
/// @param objects     as compared
/// @param data        folder with robots/
/// @param provenance  name -> text
bool write_compare_report(const Comparison& comparison, const std::vector<BodySpec>& objects,
                          const std::string& data, const nlohmann::json& provenance,
                          const std::string& path, const Progress& progress = {});

}  // namespace thenar
