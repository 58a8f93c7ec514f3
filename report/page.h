#pragma once

/// Conversion of a report from JSON to a single HTML file that needs no network.

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace thenar {

/// Returns the page that draws `report`; its blocks are described in viewer/README.md.
[[nodiscard]] std::string report_page(const nlohmann::json& report);

/// Writes the page to a temporary file and renames it when complete.
/// @throws InputError if the file cannot be written.
void write_report(const nlohmann::json& report, const std::string& path);

}  // namespace thenar
