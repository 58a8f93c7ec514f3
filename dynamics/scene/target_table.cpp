#include "dynamics/scene/target_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/ranges.h>

#include "base/error.h"
#include "data/io/time_table.h"
#include "dynamics/stepping/simulate_scene.h"

namespace thenar {

TargetTable parse_target_table(const std::string& text, const std::string& path,
                               const SceneDriveSpec& drive) {
  const TimeTable table = parse_time_table(text, path, "target");
  const Dimension dimension = drive.turns ? Dimension::kAngle : Dimension::kLength;
  TargetTable out;
  std::vector<std::string> wanted;
  for (const Unit& unit : units_of(dimension)) {
    wanted.push_back(drive.name + "_" + unit.suffix);
    const auto found = std::find(table.columns.begin(), table.columns.end(), wanted.back());
    if (found == table.columns.end()) continue;
    if (out.target.size() > 0)
      throw DataError(path, table.header_line,
                      fmt::format("target '{}' stands in two units", drive.name));
    out.time = table.time;
    out.target = unit.to_si * table.value.col(found - table.columns.begin());
  }
  if (out.target.size() == 0)
    throw DataError(path, table.header_line,
                    fmt::format("wanted a column {}, got {}", fmt::join(wanted, " or "),
                                fmt::join(table.columns, ", ")));
  // What is nearer than steps can be is a jump, and has one time.
  for (Eigen::Index k = 1; k < out.time.size(); ++k) {
    const double span = out.time[k] - out.time[k - 1];
    if (span > 0 && span < SceneOptions().shortest)
      throw DataError(path, table.lines[static_cast<std::size_t>(k)],
                      fmt::format("wanted rows of one time, or {} s apart, got {:.3g} s",
                                  SceneOptions().shortest, span));
  }
  for (Eigen::Index k = 0; k < out.target.size(); ++k)
    if (std::abs(out.target[k]) > largest_of(dimension))
      throw DataError(
          path, table.lines[static_cast<std::size_t>(k)],
          fmt::format("wanted at most {}, got {}", with_si_unit(largest_of(dimension), dimension),
                      with_si_unit(out.target[k], dimension)));
  return out;
}

std::vector<SceneDrive> follow_table(const SceneDrive& drive, const TargetTable& table) {
  const Eigen::Index rows = table.time.size();
  require(rows > 0 && table.target.size() == rows, "{} times have {} targets", rows,
          table.target.size());
  std::vector<SceneDrive> pieces;
  const auto add = [&](double begin, double end, double first, double slope) {
    SceneDrive piece = drive;
    piece.when = {std::max(begin, drive.when.from), std::min(end, drive.when.to)};
    if (piece.when.from >= piece.when.to) return;
    piece.target = first + (slope == 0 ? 0 : slope * (piece.when.from - begin));
    piece.speed = slope;
    pieces.push_back(piece);
  };
  add(0, table.time[0], table.target[0], 0);
  for (Eigen::Index k = 0; k + 1 < rows; ++k) {
    const double span = table.time[k + 1] - table.time[k];
    if (span > 0)
      add(table.time[k], table.time[k + 1], table.target[k],
          (table.target[k + 1] - table.target[k]) / span);
  }
  add(table.time[rows - 1], std::numeric_limits<double>::infinity(), table.target[rows - 1], 0);
  return pieces;
}

}  // namespace thenar
