#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include <Eigen/Eigenvalues>

#include "base/error.h"
#include "grasp/compare/abilities.h"
#include "grasp/compare/grasp_type.h"
#include "grasp/draw_uniform.h"
#include "grasp/tip_ways.h"

namespace thenar {
namespace {

constexpr double kCells[] = {0.25, 0.5, 1, 2, 4};  // sizes tried, of the cell asked for [1]
constexpr double kShared = 2;                      // of cells that two tips share [1]
constexpr int kAsk = 1000;                         // draws between two looks at a stop

using Cell = std::array<int, 3>;
using Cells = std::vector<Cell>;  // ascending

/// Cells of the points' first `dimension` rows.
Cells cells_of(const Eigen::Matrix3Xd& points, int dimension, double cell) {
  Cells cells;
  cells.reserve(static_cast<std::size_t>(points.cols()));
  for (const auto& p : points.colwise()) {
    Cell at{0, 0, 0};
    for (int i = 0; i < dimension; ++i)
      at[static_cast<std::size_t>(i)] = static_cast<int>(std::floor(p[i] / cell));
    cells.push_back(at);
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

int rim_of(const Cells& cells, int dimension) {
  int rim = 0;
  for (const Cell& cell : cells) {
    bool inside = true;
    for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i)
      for (const int step : {-1, 1}) {
        Cell next = cell;
        next[i] += step;
        inside = inside && std::binary_search(cells.begin(), cells.end(), next);
      }
    if (!inside) ++rim;
  }
  return rim;
}

/// The points along their principal axes, the longest extent first, about their mean.
Eigen::Matrix3Xd principal(const Eigen::Matrix3Xd& points) {
  const Eigen::Matrix3Xd centred = points.colwise() - points.rowwise().mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(
      Eigen::Matrix3d(centred * centred.transpose()));
  return axes.eigenvectors().rowwise().reverse().transpose() * centred;
}

DigitAbility measure_space(const std::string& digit, const Eigen::Matrix3Xd& points, double cell) {
  const Eigen::Matrix3Xd along = principal(points);
  DigitAbility ability;
  ability.digit = digit;
  for (int i = 0; i < 3; ++i)
    if (along.row(i).maxCoeff() - along.row(i).minCoeff() > 2 * cell) ++ability.dimension;
  if (ability.dimension == 0) return ability;
  // Large cells have a thick rim, small ones holes between draws: the least share is between.
  double least = std::numeric_limits<double>::infinity();
  for (const double share : kCells) {
    const Cells cells = cells_of(along, ability.dimension, share * cell);
    const double rim = rim_of(cells, ability.dimension);
    const double unit = std::pow(share * cell, ability.dimension), error = unit * rim / 2;
    const double size = unit * (static_cast<double>(cells.size()) - rim / 2);
    if (error >= least * size) continue;
    least = error / size;
    ability.workspace = size;
    ability.workspace_error = error;
  }
  return ability;
}

}  // namespace

Workspaces workspaces(const Hand& hand, int draws, double cell, std::mt19937& random,
                      const Progress& progress) {
  require(draws > 0 && cell > 0, "a workspace wants draws and a cell, got {} and {} m", draws,
          cell);
  const HandLayout& layout = hand.layout();
  std::vector<Eigen::Matrix3Xd> points(layout.tip_points.size(), Eigen::Matrix3Xd(3, draws));
  for (int n = 0; n < draws; ++n) {
    if (n % kAsk == 0 && progress.stop()) return {};
    const Eigen::Matrix3Xd tips = tips_at(hand, draw_posture(layout, random));
    for (std::size_t t = 0; t < points.size(); ++t)
      points[t].col(n) = tips.col(static_cast<Eigen::Index>(t));
  }
  Workspaces out;
  std::set<Cell> thumb, others;
  const std::string opposing = thumb_of(hand).empty() && !layout.tip_points.empty()
                                   ? layout.tip_points[0].digit
                                   : thumb_of(hand);
  for (std::size_t t = 0; t < points.size() && !progress.stop(); ++t) {
    const std::string& digit = layout.tip_points[t].digit;
    out.digits.push_back(measure_space(digit, points[t], cell));
    const Cells cells = cells_of(points[t], 3, kShared * cell);
    (digit == opposing ? thumb : others).insert(cells.begin(), cells.end());
  }
  for (const Cell& each : thumb)
    if (others.count(each) > 0) out.overlap += std::pow(kShared * cell, 3);
  return out;
}

}  // namespace thenar
