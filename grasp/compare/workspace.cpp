#include <array>
#include <cmath>
#include <cstdint>
#include <set>

#include <Eigen/Eigenvalues>

#include "base/error.h"
#include "grasp/compare/abilities.h"
#include "grasp/compare/grasp_type.h"
#include "grasp/draw_uniform.h"

namespace thenar {
namespace {

using Cell = std::array<int, 3>;
using Cells = std::set<Cell>;

/// Cells of the points' first `dimension` rows.
Cells cells_of(const Eigen::Matrix3Xd& points, int dimension, double cell) {
  Cells cells;
  for (const auto& p : points.colwise()) {
    Cell at{0, 0, 0};
    for (int i = 0; i < dimension; ++i)
      at[static_cast<std::size_t>(i)] = static_cast<int>(std::floor(p[i] / cell));
    cells.insert(at);
  }
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
        inside = inside && cells.count(next) > 0;
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
  const Cells cells = cells_of(along, ability.dimension, cell);
  const double rim = rim_of(cells, ability.dimension), unit = std::pow(cell, ability.dimension);
  ability.workspace = unit * (static_cast<double>(cells.size()) - rim / 2);
  ability.workspace_error = unit * rim / 2;
  return ability;
}

}  // namespace

Workspaces workspaces(const Hand& hand, int draws, double cell, std::mt19937& random) {
  require(draws > 0 && cell > 0, "a workspace wants draws and a cell, got {} and {} m", draws,
          cell);
  const HandLayout& layout = hand.layout();
  std::vector<Eigen::Matrix3Xd> points(layout.tip_points.size(), Eigen::Matrix3Xd(3, draws));
  for (int n = 0; n < draws; ++n) {
    const std::vector<Pose<double>> links = hand.pose(draw_posture(layout, random));
    for (std::size_t t = 0; t < points.size(); ++t) {
      const HandTip& tip = layout.tip_points[t];
      points[t].col(n) = tip.link < 0 ? tip.p : links[tip.link] * tip.p;
    }
  }
  Workspaces out;
  Cells thumb, others;
  const std::string opposing = thumb_of(hand).empty() && !layout.tip_points.empty()
                                   ? layout.tip_points[0].digit
                                   : thumb_of(hand);
  for (std::size_t t = 0; t < points.size(); ++t) {
    const std::string& digit = layout.tip_points[t].digit;
    out.digits.push_back(measure_space(digit, points[t], cell));
    (digit == opposing ? thumb : others).merge(cells_of(points[t], 3, cell));
  }
  for (const Cell& each : thumb) out.overlap += others.count(each) > 0 ? std::pow(cell, 3) : 0;
  return out;
}

}  // namespace thenar
