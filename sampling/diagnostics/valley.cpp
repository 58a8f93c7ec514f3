#include "sampling/diagnostics/valley.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "sampling/diagnostics/order_statistics.h"

namespace thenar {
namespace {

/// Density on an even grid; a draw counts in the cell it falls into.
struct Density {
  double first, step;    // of the grid [unit of y]
  double bandwidth;      // [unit of y]
  Eigen::ArrayXd at;     // [1 / unit of y] (cells)
  Eigen::ArrayXd share;  // of draws up to the end of each cell (cells)
};

constexpr int kCellsPerBandwidth = 4;
constexpr int kMostCells = 4000;

double bandwidth_of(const Eigen::VectorXd& rising) {
  const double n = double(rising.size());
  const double sd = std::sqrt((rising.array() - rising.mean()).square().mean());
  const double quartiles = (quantile(rising, 0.75) - quantile(rising, 0.25)) / 1.349;
  return 0.9 * (quartiles > 0 ? std::min(sd, quartiles) : sd) * std::pow(n, -0.2);
}

/// Between the quantiles beyond which no cut is allowed, and one bandwidth further.
Density density_of(const Eigen::VectorXd& rising, double least_share) {
  const double h = bandwidth_of(rising);
  const double low = quantile(rising, least_share / 2) - h;
  const double high = quantile(rising, 1 - least_share / 2) + h;
  const int cells =
      std::clamp(int(std::ceil((high - low) / h * kCellsPerBandwidth)), 8, kMostCells);
  Density of{low, (high - low) / cells, h, {}, Eigen::ArrayXd::Zero(cells)};

  Eigen::ArrayXd count = Eigen::ArrayXd::Zero(cells);
  const double each = 1 / double(rising.size());
  double below = 0;
  for (const double y : rising) {
    const double cell = std::floor((y - low) / of.step);
    if (cell < 0) below += each;
    if (cell >= 0 && cell < cells) count[int(cell)] += each;
  }
  for (int i = 0; i < cells; ++i) of.share[i] = below += count[i];

  const int reach = int(std::ceil(4 * h / of.step));
  of.at = Eigen::ArrayXd::Zero(cells);
  for (int shift = -reach; shift <= reach; ++shift) {
    const double z = shift * of.step / h;
    const double weight = std::exp(-z * z / 2) / (std::sqrt(2 * M_PI) * h);
    for (int i = std::max(0, shift); i < std::min(cells, cells + shift); ++i)
      of.at[i] += weight * count[i - shift];
  }
  return of;
}

}  // namespace

Valley find_valley(const Eigen::Ref<const Eigen::VectorXd>& y, double least_share) {
  require(y.size() >= 2 && y.allFinite(), "a valley needs 2 finite draws, got {}", y.size());
  const Eigen::VectorXd rising = sorted(y);
  Valley best;
  if (!(bandwidth_of(rising) > 0)) return best;
  const Density f = density_of(rising, least_share);

  // Highest peak on the right of every cell, then walk from the left.
  Eigen::ArrayXd right = f.at;
  for (Eigen::Index i = right.size() - 2; i >= 0; --i) right[i] = std::max(right[i], right[i + 1]);
  double left = 0;
  for (Eigen::Index i = 0; i < f.at.size(); ++i) {
    left = std::max(left, f.at[i]);
    if (f.share[i] < least_share || f.share[i] > 1 - least_share) continue;
    const double peak = std::min(left, right[i]), low = f.at[i];
    if (low >= best.depth * peak) continue;
    const double noise = (peak + low) / (2 * std::sqrt(M_PI)) / (double(y.size()) * f.bandwidth);
    best = {f.first + (double(i) + 0.5) * f.step, low / peak, (peak - low) / std::sqrt(noise)};
  }
  return best;
}

}  // namespace thenar
