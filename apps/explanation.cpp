#include "apps/explanation.h"

#include <fmt/format.h>

namespace thenar {
namespace {

/// A cell as a number where it is one; "-" and "inf" are null. The unit "1" stays a text.
nlohmann::json json_of_cell(const std::string& header, const std::string& cell) {
  if (header == "unit") return cell;
  if (cell == "-" || cell == "inf" || cell == "-inf") return nullptr;
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  if (!cell.empty() && *end == '\0') return value;
  return cell;
}

nlohmann::ordered_json json_of(const Table& table) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const auto& cells : table.rows) {
    nlohmann::ordered_json object;
    for (std::size_t c = 0; c < cells.size(); ++c)
      object[table.header[c]] = json_of_cell(table.header[c], cells[c]);
    rows.push_back(object);
  }
  return rows;
}

}  // namespace

std::string text_of(const Explanation& explanation) {
  std::string text;
  for (const Section& section : explanation) {
    if (!text.empty() && section.lines.empty() && section.table.rows.empty()) continue;
    text += section.title + "\n";
    for (const std::string& line : section.lines) text += "  " + line + "\n";
    if (!section.table.rows.empty()) text += aligned(section.table);
    text += "\n";
  }
  return text;
}

nlohmann::ordered_json json_of(const Explanation& explanation) {
  nlohmann::ordered_json json;
  for (const Section& section : explanation) {
    if (!section.lines.empty()) json[section.key]["notes"] = section.lines;
    json[section.key]["rows"] = json_of(section.table);
  }
  return json;
}

}  // namespace thenar
