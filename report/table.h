#pragma once

/// Tables as aligned text and as CSV.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/lists.h"

namespace thenar {

/// Rows of cells under a header with units: "angle_deg".
struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows = {};

  void add(std::vector<std::string> cells) { rows.push_back(std::move(cells)); }
  /// Adds a row that concatenates lists of cells.
  void add_parts(const std::vector<std::vector<std::string>>& parts);
};

/// Returns the table with columns two spaces apart; columns of numbers are right-aligned.
[[nodiscard]] std::string aligned(const Table& table);

/// Returns aligned() with a title above and an empty line below; "" if there are no rows.
[[nodiscard]] std::string titled(const std::string& title, const Table& table);

/// Returns the table as CSV: commas, one line a row, cells with commas, quotes or line ends in
/// quotes. Source: RFC 4180, except line ends, which are LF.
[[nodiscard]] std::string csv(const Table& table);

/// Returns a number with the given decimals: never "-0.00"; "inf" if infinite.
[[nodiscard]] std::string shown(double value, int decimals);

/// Returns a number with four significant digits, for columns that mix sizes.
[[nodiscard]] std::string shown(double value);

/// Returns the numbers of a vector as cells.
template <typename Vector>
[[nodiscard]] std::vector<std::string> cells(const Vector& values, int decimals) {
  std::vector<std::string> result;
  result.reserve(static_cast<std::size_t>(values.size()));
  for (int i = 0; i < static_cast<int>(values.size()); ++i)
    result.push_back(shown(values[i], decimals));
  return result;
}

/// Returns the entry of a list at an index of type Eigen::Index.
template <typename List, typename Index>
[[nodiscard]] auto& nth(List&& list, Index i) {
  return list[static_cast<std::size_t>(i)];
}

/// Returns each name with an ending: "PIP3_deg".
template <typename Names>
[[nodiscard]] std::vector<std::string> with_ending(const Names& names, const std::string& ending) {
  return transformed(names, [&](const std::string& name) { return name + ending; });
}

/// Returns a row that concatenates lists of cells.
[[nodiscard]] std::vector<std::string> row(const std::vector<std::vector<std::string>>& parts);

/// Returns the text, or "-" where there is none.
[[nodiscard]] inline std::string or_dash(const std::string& text) {
  return text.empty() ? "-" : text;
}

}  // namespace thenar
