#include "dynamics/scene/target_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/ranges.h>

#include "base/error.h"
#include "base/lists.h"
#include "base/numbers.h"
#include "data/io/time_table.h"
#include "dynamics/stepping/simulate_scene.h"

namespace thenar {
namespace {

// Rounding error of a number of a table, relative [1]
constexpr double kRelativeRounding = 4 * std::numeric_limits<double>::epsilon();

}  // namespace

TargetTable parse_target_table(const std::string& text, const std::string& path,
                               const SceneDriveSpec& drive) {
  const TimeTable table = parse_time_table(text, path, "target");
  const Dimension dimension = drive.turns ? Dimension::kAngle : Dimension::kLength;
  // Find the column of the drive, in any unit of its dimension.
  TargetTable out;
  std::vector<std::string> wanted;
  for (const Unit& unit : units_of(dimension)) {
    wanted.push_back(drive.name + "_" + unit.suffix);
    const int column = place_in(table.columns, wanted.back());
    if (column < 0) continue;
    if (out.target.size() > 0)
      throw DataError(path, table.header_line,
                      fmt::format("target '{}' is given in two units", drive.name));
    out.time = table.time;
    out.target = unit.to_si * table.value.col(column);
  }
  if (out.target.size() == 0)
    throw DataError(path, table.header_line,
                    fmt::format("wanted a column {}, got {}", fmt::join(wanted, " or "),
                                fmt::join(table.columns, ", ")));
  // Rows must have equal times, which is a jump, or be at least the shortest step apart.
  for (Eigen::Index k = 1; k < out.time.size(); ++k) {
    const double span = out.time[k] - out.time[k - 1];
    if (span > 0 && span < SceneOptions().min_step)
      throw DataError(path, table.lines[k],
                      fmt::format("wanted rows of one time, or {} s apart, got {:.3g} s",
                                  SceneOptions().min_step, span));
  }
  // Check the magnitude of the targets.
  for (Eigen::Index k = 0; k < out.target.size(); ++k)
    if (std::abs(out.target[k]) > largest_of(dimension))
      throw DataError(
          path, table.lines[k],
          fmt::format("wanted at most {}, got {}", with_si_unit(largest_of(dimension), dimension),
                      with_si_unit(out.target[k], dimension)));
  return out;
}

TargetTable without_straight_knots(const TargetTable& table) {
  const Eigen::Index knots = table.time.size();
  require(knots > 0 && table.target.size() == knots, "{} times have {} targets", knots,
          table.target.size());
  std::vector<Eigen::Index> kept{0};
  // Range of slopes for which a line from the last kept knot meets all later knots so far.
  double min_slope = -kInfinity, max_slope = kInfinity;
  const auto keep = [&](Eigen::Index k) {
    const Eigen::Index last = kept.back();
    if (table.time[last] != table.time[k] || table.target[last] != table.target[k])
      kept.push_back(k);
    min_slope = -kInfinity, max_slope = kInfinity;
  };
  for (Eigen::Index k = 1; k < knots; ++k) {
    const double step = table.time[k] - table.time[k - 1];
    const double change = table.target[k] - table.target[k - 1];
    // Keep both knots of a jump.
    if (step == 0) {
      keep(k - 1);
      keep(k);
      continue;
    }
    const auto slope_to = [&](double offset) {
      return (table.target[k] + offset - table.target[kept.back()]) /
             (table.time[k] - table.time[kept.back()]);
    };
    // Keep the knot before, if the line would miss this one; then narrow the range.
    if (!(slope_to(0) >= min_slope && slope_to(0) <= max_slope)) keep(k - 1);
    const double rounding =
        kRelativeRounding * (std::abs(table.target[k]) + std::abs(change / step * table.time[k]));
    min_slope = std::max(min_slope, slope_to(-rounding));
    max_slope = std::min(max_slope, slope_to(rounding));
  }
  keep(knots - 1);
  return {table.time(kept), table.target(kept)};
}

}  // namespace thenar
