#include "grasp/compare/workspace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include <Eigen/Eigenvalues>

#include "base/error.h"
#include "base/numbers.h"
#include "grasp/closing/approach_sampling.h"
#include "grasp/closing/fingertip_paths.h"
#include "grasp/compare/grasp_type.h"

namespace thenar {
namespace {

constexpr double kVoxelRatios[] = {0.25, 0.5, 1, 2, 4};  // sizes that are tried, over `voxel` [1]
// Size of voxels for the overlap of two tips, over `voxel` [1]
constexpr double kOverlapVoxelRatio = 2;
constexpr int kStopInterval = 1000;  // number of postures between two checks for a stop

using Voxel = std::array<int, 3>;
using Voxels = std::vector<Voxel>;  // ascending

/// Returns the voxels that contain points, by their first `dimension` rows.
Voxels voxels_of(const Eigen::Matrix3Xd& points, int dimension, double voxel) {
  Voxels voxels;
  voxels.reserve(static_cast<std::size_t>(points.cols()));
  for (const auto& p : points.colwise()) {
    Voxel at{0, 0, 0};
    for (int i = 0; i < dimension; ++i) at[i] = static_cast<int>(std::floor(p[i] / voxel));
    voxels.push_back(at);
  }
  // Remove duplicates.
  std::sort(voxels.begin(), voxels.end());
  voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
  return voxels;
}

/// Counts the voxels at the boundary: those with a neighbour that is not in the set.
int count_boundary_voxels(const Voxels& voxels, int dimension) {
  int rim = 0;
  for (const Voxel& voxel : voxels) {
    // Neighbours along each axis.
    bool inside = true;
    for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i)
      for (const int step : {-1, 1}) {
        Voxel next = voxel;
        next[i] += step;
        inside = inside && std::binary_search(voxels.begin(), voxels.end(), next);
      }
    if (!inside) ++rim;
  }
  return rim;
}

/// Returns the points about their mean along their principal axes, the longest extent first.
Eigen::Matrix3Xd principal_coordinates(const Eigen::Matrix3Xd& points) {
  const Eigen::Matrix3Xd centred = points.colwise() - points.rowwise().mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(
      Eigen::Matrix3d(centred * centred.transpose()));
  return axes.eigenvectors().rowwise().reverse().transpose() * centred;
}

/// Returns postures between the limits, distributed evenly but not regularly over every coordinate,
/// the middle first (coordinates, 5).
Eigen::MatrixXd spread_postures(const HandLayout& layout) {
  constexpr double kGoldenRatio = 0.6180339887498949;  // multiples of it fill 0..1 evenly
  const Eigen::VectorXd range = layout.upper - layout.lower;
  Eigen::MatrixXd postures(range.size(), 5);
  for (Eigen::Index k = 0; k < postures.cols(); ++k)
    for (Eigen::Index c = 0; c < range.size(); ++c) {
      const double turns = 0.5 + kGoldenRatio * double(k * (c + 1));
      postures(c, k) = layout.lower[c] + (turns - std::floor(turns)) * range[c];
    }
  return postures;
}

/// Counts the coordinates that move each tip in at least one posture (tips): the dimension of a
/// tip's workspace cannot exceed this number.
std::vector<int> movers_of_tips(const Hand& hand) {
  constexpr double kRangeStep = 1e-3;  // step of a coordinate over its range [1]
  constexpr double kNoMotion = 1e-9;   // motion of a tip up to which it counts as none [m]
  const HandLayout& layout = hand.layout();
  const Eigen::MatrixXd postures = spread_postures(layout);
  std::vector<int> movers(layout.tip_points.size(), 0);
  for (Eigen::Index c = 0; c < postures.rows(); ++c) {
    // Maximum motion of each tip for a small step of this coordinate.
    Eigen::VectorXd far = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(movers.size()));
    for (const Eigen::VectorXd q : postures.colwise()) {
      Eigen::VectorXd stepped = q;
      stepped[c] += kRangeStep * (layout.upper[c] - layout.lower[c]);
      const Eigen::Matrix3Xd by = fingertip_positions(hand, stepped) - fingertip_positions(hand, q);
      far = far.cwiseMax(by.colwise().norm().transpose());
    }
    for (std::size_t t = 0; t < movers.size(); ++t)
      if (far[t] > kNoMotion) ++movers[t];
  }
  return movers;
}

/// Measures the workspace of a tip. @param movers  number of coordinates that move it
DigitAbility measure_space(const std::string& digit, const Eigen::Matrix3Xd& points, int movers,
                           double voxel) {
  const Eigen::Matrix3Xd along = principal_coordinates(points);
  DigitAbility ability;
  ability.digit = digit;
  // Flat workspaces are measured in fewer dimensions.
  for (int i = 0; i < 3; ++i)
    if (along.row(i).maxCoeff() - along.row(i).minCoeff() > 2 * voxel) ++ability.dimension;
  ability.dimension = std::min(ability.dimension, movers);  // a bent curve spans a plane
  if (ability.dimension == 0) return ability;
  // Large voxels have a thick boundary, small ones holes: use the smallest relative error.
  double min_error = kInfinity;
  for (const double ratio : kVoxelRatios) {
    const Voxels voxels = voxels_of(along, ability.dimension, ratio * voxel);
    const double boundary = count_boundary_voxels(voxels, ability.dimension);
    const double unit = std::pow(ratio * voxel, ability.dimension), error = unit * boundary / 2;
    const double size = unit * (static_cast<double>(voxels.size()) - boundary / 2);
    if (error >= min_error * size) continue;
    min_error = error / size;
    ability.workspace = size;
    ability.workspace_error = error;
  }
  return ability;
}

}  // namespace

Workspaces measure_workspaces(const Hand& hand, int draws, double voxel, std::mt19937& random,
                              const Progress& progress) {
  require(draws > 0 && voxel > 0, "a workspace wants draws and a cell, got {} and {} m", draws,
          voxel);
  const HandLayout& layout = hand.layout();
  // Tip positions at random postures.
  std::vector<Eigen::Matrix3Xd> points(layout.tip_points.size(), Eigen::Matrix3Xd(3, draws));
  for (int n = 0; n < draws; ++n) {
    if (n % kStopInterval == 0 && progress.stop()) return {};
    const Eigen::Matrix3Xd tips = fingertip_positions(hand, sample_posture(layout, random));
    for (std::size_t t = 0; t < points.size(); ++t) points[t].col(n) = tips.col(t);
  }
  Workspaces out;
  std::set<Voxel> thumb, others;
  const std::vector<int> movers = movers_of_tips(hand);
  // The opposing digit is the thumb, or the first digit.
  std::string opposing = opposing_digit(hand);
  if (opposing.empty() && !layout.tip_points.empty()) opposing = layout.tip_points[0].digit;
  for (std::size_t t = 0; t < points.size() && !progress.stop(); ++t) {
    const std::string& digit = layout.tip_points[t].digit;
    // Measure each workspace, and collect voxels of the opposing digit and of all others.
    out.digits.push_back(measure_space(digit, points[t], movers[t], voxel));
    if (out.digits.back().dimension < 3) continue;  // planes and curves share no volume
    const Voxels voxels = voxels_of(points[t], 3, kOverlapVoxelRatio * voxel);
    (digit == opposing ? thumb : others).insert(voxels.begin(), voxels.end());
  }
  // Their common voxels are the overlap.
  if (thumb.empty() || others.empty()) out.overlap = kNaN;
  for (const Voxel& each : thumb)
    if (others.count(each) > 0) out.overlap += std::pow(kOverlapVoxelRatio * voxel, 3);
  return out;
}

}  // namespace thenar
