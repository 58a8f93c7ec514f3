#include "report/table.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace thenar {
namespace {

bool is_number(const std::string& cell) {
  return cell == "inf" || cell == "-inf" || cell == "-" ||
         (!cell.empty() && cell.find_first_not_of("0123456789.+-e") == std::string::npos);
}

struct TextColumn {
  std::size_t width;
  bool right;  // flush right
};

TextColumn column(const Table& table, std::size_t c) {
  TextColumn result{table.header[c].size(), true};
  for (const auto& cells : table.rows) {
    result.width = std::max(result.width, cells[c].size());
    result.right = result.right && is_number(cells[c]);
  }
  return result;
}

void add_line(const std::vector<std::string>& cells, const std::vector<TextColumn>& columns,
              std::string& text) {
  std::string line;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (c > 0) line += "  ";
    line += columns[c].right ? fmt::format("{:>{}}", cells[c], columns[c].width)
                             : fmt::format("{:<{}}", cells[c], columns[c].width);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  text += line + "\n";
}

/// A cell as it is, or between quotes, with its own quotes doubled.
std::string csv_cell(const std::string& cell) {
  if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

void Table::add_parts(const std::vector<std::vector<std::string>>& parts) { add(row(parts)); }

std::string aligned(const Table& table) {
  std::vector<TextColumn> columns;
  for (std::size_t c = 0; c < table.header.size(); ++c) columns.push_back(column(table, c));
  std::string text;
  add_line(table.header, columns, text);
  for (const auto& cells : table.rows) add_line(cells, columns, text);
  return text;
}

std::string titled(const std::string& title, const Table& table) {
  return table.rows.empty() ? "" : fmt::format("{}\n{}\n", title, aligned(table));
}

std::string csv(const Table& table) {
  std::string text;
  const auto add = [&text](const std::vector<std::string>& cells) {
    for (std::size_t c = 0; c < cells.size(); ++c) text += (c > 0 ? "," : "") + csv_cell(cells[c]);
    text += "\n";
  };
  add(table.header);
  for (const auto& cells : table.rows) add(cells);
  return text;
}

std::string shown(double value, int decimals) {
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  std::string text = fmt::format("{:.{}f}", value, decimals);
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  return zero && text[0] == '-' ? text.substr(1) : text;
}

std::string shown(double value) { return value == 0 ? "0" : fmt::format("{:.4g}", value); }

std::vector<std::string> row(const std::vector<std::vector<std::string>>& parts) {
  std::vector<std::string> result;
  for (const auto& part : parts) result.insert(result.end(), part.begin(), part.end());
  return result;
}

}  // namespace thenar
