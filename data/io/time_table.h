#pragma once

/// Tables over time as CSV: what muscles are given, where drives are to go.

#include <string>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Columns of numbers over time, as the file has them.
struct TimeTable {
  std::vector<std::string> columns;  // beside the time, each once
  Eigen::VectorXd time;              // times from 0 on, never falling [s] (rows)
  Eigen::MatrixXd value;             // values in the units of the columns (rows, columns)
  std::vector<int> lines;            // line of each row
  int header_line = 1;
};

/// Reads a table:  a header  time_s,NAME,..,  then numbers. Lines that start with '#' are comments.
/// @param path   names the table in messages
/// @param what   a column is, in messages: "muscle"
/// @param known  names that columns may have; null: any
/// @throws DataError `path:line: what was wanted, what came`.
[[nodiscard]] TimeTable parse_time_table(const std::string& text, const std::string& path,
                                         const std::string& what,
                                         const std::vector<std::string>* known = nullptr);

}  // namespace thenar
