#include "data/io/time_table.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include <fmt/ranges.h>

#include "base/error.h"

namespace thenar {
namespace {

std::string trimmed_cell(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\""), last = text.find_last_not_of(" \t\r\"");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::vector<std::string> cells_of_row(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(trimmed_cell(cell));
  if (!line.empty() && line.back() == ',') cells.emplace_back();
  return cells;
}

/// Reads a table line by line.
class TimeTableReader {
 public:
  TimeTableReader(const std::string& path, const std::string& what,
                  const std::vector<std::string>* known)
      : path_(path), what_(what), known_(known) {}

  void read_line(int line, const std::vector<std::string>& cells) {
    table_.columns.empty() ? read_header(line, cells) : read_row(line, cells);
  }

  [[nodiscard]] TimeTable take() {
    if (rows_.empty())
      throw DataError(path_, table_.header_line, "wanted a header and at least one row");
    const auto rows = static_cast<Eigen::Index>(rows_.size());
    table_.time.resize(rows);
    table_.value.resize(rows, static_cast<Eigen::Index>(table_.columns.size()));
    for (Eigen::Index k = 0; k < rows; ++k) {
      const std::vector<double>& row = rows_[k];
      table_.time[k] = row.front();
      for (std::size_t i = 1; i < row.size(); ++i)
        table_.value(k, static_cast<Eigen::Index>(i) - 1) = row[i];
    }
    return std::move(table_);
  }

 private:
  void read_header(int line, const std::vector<std::string>& cells) {
    table_.header_line = line;
    if (cells.size() < 2 || cells.front() != "time_s") {
      std::string loud = what_;
      for (char& c : loud) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      throw DataError(path_, line, fmt::format("wanted a header 'time_s,{},...'", loud));
    }
    for (std::size_t i = 1; i < cells.size(); ++i) {
      if (known_ != nullptr && std::count(known_->begin(), known_->end(), cells[i]) == 0)
        throw DataError(
            path_, line,
            fmt::format("no {} '{}'; there are {}", what_, cells[i], fmt::join(*known_, ", ")));
      if (std::count(table_.columns.begin(), table_.columns.end(), cells[i]) > 0)
        throw DataError(path_, line, fmt::format("{} '{}' has two columns", what_, cells[i]));
      table_.columns.push_back(cells[i]);
    }
  }

  void read_row(int line, const std::vector<std::string>& cells) {
    if (cells.size() != table_.columns.size() + 1)
      throw DataError(
          path_, line,
          fmt::format("wanted {} cells, got {}", table_.columns.size() + 1, cells.size()));
    std::vector<double> row;
    row.reserve(cells.size());
    for (const std::string& cell : cells) row.push_back(number(line, cell));
    if (row.front() < (rows_.empty() ? 0 : rows_.back().front()))
      throw DataError(path_, line, "wanted times from 0 on that never fall");
    rows_.push_back(std::move(row));
    table_.lines.push_back(line);
  }

  [[nodiscard]] double number(int line, const std::string& cell) const {
    char* end = nullptr;
    const double value = std::strtod(cell.c_str(), &end);
    if (cell.empty() || *end != 0 || !std::isfinite(value))
      throw DataError(path_, line, fmt::format("wanted a number, got '{}'", cell));
    return value;
  }

  const std::string& path_;
  const std::string& what_;
  const std::vector<std::string>* known_;
  TimeTable table_;
  std::vector<std::vector<double>> rows_;
};

}  // namespace

TimeTable parse_time_table(const std::string& text, const std::string& path,
                           const std::string& what, const std::vector<std::string>* known) {
  TimeTableReader reader(path, what, known);
  // The first row that is no comment is the header; a byte order mark may lead.
  std::istringstream in(text.rfind("\xEF\xBB\xBF", 0) == 0 ? text.substr(3) : text);
  int line = 0;
  for (std::string row; std::getline(in, row);) {
    ++line;
    if (trimmed_cell(row).empty() || trimmed_cell(row).front() == '#') continue;
    reader.read_line(line, cells_of_row(row));
  }
  return reader.take();
}

}  // namespace thenar
