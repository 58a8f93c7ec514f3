#pragma once

/// Blocks of a report as JSON; viewer/README.md describes the members of each.

#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "report/json.h"
#include "report/table.h"

namespace thenar {

/// A column of a table.
struct BlockColumn {
  /// @param text  name, unit and digits: "force [N]:3"; the last two may be left out
  BlockColumn(const char* text);
  BlockColumn(std::string its_name, std::string its_unit, int its_digits = -1)
      : name(std::move(its_name)), unit(std::move(its_unit)), digits(its_digits) {}

  std::string name;
  std::string unit;  // empty: none
  int digits = -1;   // decimals; -1: four significant digits
};

/// Returns the first paragraph of a page, its "opening": sentences on the question, the method and
/// the result.
[[nodiscard]] Json opening_json(const std::string& asked, const std::string& done,
                                const std::string& learnt);
[[nodiscard]] Json section(const std::string& id, const std::string& title, const std::string& text,
                           Json blocks);
[[nodiscard]] Json text_block(const std::string& text);
[[nodiscard]] Json row_block(Json blocks);
/// Returns a banner that says whether the content below is reliable, and why not.
[[nodiscard]] Json banner_block(const std::string& title, Json reasons, bool ok = false);
/// Returns a banner of a result: red with the refusal, which is the first reason; amber with
/// warnings alone. @param title  where there is no refusal
[[nodiscard]] Json refusal_banner(const std::string& refusal,
                                  const std::vector<std::string>& warnings,
                                  const std::string& failed_title, const std::string& title);
/// Returns a block with further members: {{"search", true}}.
[[nodiscard]] Json with(Json block, const Json& more);
/// Returns a list followed by `more`.
[[nodiscard]] Json joined(Json list, const Json& more);
/// Returns one series of a chart. @param style  "points", "both"; empty: lines
[[nodiscard]] Json curve_json(const std::string& name, Json x, Json y,
                              const std::string& style = "");
/// Returns one series with a point for each item. @param x, y  functions or members of an item
template <typename Items, typename X, typename Y>
[[nodiscard]] Json curve_of_each(const std::string& name, const Items& items, const X& x,
                                 const Y& y, const std::string& style = "") {
  return curve_json(name, list_of_each(items, x), list_of_each(items, y), style);
}
/// Returns a chart of curves. @param series  list of curve_json()
[[nodiscard]] Json lines_block(const std::string& caption, const std::string& x_label,
                               const std::string& y_label, Json series);
/// Returns a chart of intervals, one below the other. @param rows  {"name", "estimate", "low",
/// "high"} each
[[nodiscard]] Json interval_block(const std::string& caption, const std::string& x_label,
                                  Json rows);
[[nodiscard]] Json table_block(const std::string& caption, const std::vector<BlockColumn>& columns,
                               Json rows);

/// Returns a cell as a number where it is one; "-" and what is not finite become null.
[[nodiscard]] Json json_of_cell(const std::string& cell);
/// Returns columns with the names of a printed table.
[[nodiscard]] std::vector<BlockColumn> columns_of(const Table& table);
/// Returns a printed table as a block, its cells by json_of_cell().
[[nodiscard]] Json table_block(const std::string& caption, const Table& table);

/// Returns the entry of a list that has a name under a key; adds one with an empty list of `parts`
/// if there is none.
[[nodiscard]] Json& entry_named(Json& list, const char* key, const std::string& name,
                                const char* parts);

/// Returns a layer of a scene: items of one colour that are shown and hidden together.
[[nodiscard]] Json layer(const std::string& name, const std::string& color, Json items);

/// Returns [x, y, z] in millimetres, from metres.
[[nodiscard]] Json in_mm(const Eigen::Vector3d& p);
/// Returns [x, y, z] without conversion.
[[nodiscard]] Json numbers3(const Eigen::Vector3d& v);

/// Returns at most `most` of the indices 0 .. count - 1, evenly spread.
[[nodiscard]] std::vector<Eigen::Index> spread(Eigen::Index count, Eigen::Index most);

/// Returns a list of numbers rounded at a scale: to four significant digits of `scale`.
[[nodiscard]] Json rounded(const Eigen::Ref<const Eigen::VectorXd>& values, double scale);

}  // namespace thenar
