#include "sampling/diagnostics/clusters.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Eigenvalues>

#include "base/error.h"
#include "sampling/diagnostics/effective_sample_size.h"
#include "sampling/diagnostics/order_statistics.h"

namespace thenar {
namespace {

/// Density estimate on a regular grid.
struct Density {
  double first, step;    // start and spacing of the grid [unit of y]
  double bandwidth;      // kernel bandwidth [unit of y]
  Eigen::ArrayXd at;     // density at the centre of each cell [1 / unit of y] (cells)
  Eigen::ArrayXd share;  // share of draws up to the end of each cell (cells)
};

constexpr int kCellsPerBandwidth = 4;  // number of grid cells per bandwidth
constexpr int kMaxCells = 4000;        // maximum number of grid cells

/// Returns Silverman's bandwidth of sorted draws.
double bandwidth_of(const Eigen::VectorXd& rising) {
  const auto n = double(rising.size());
  const double sd = std::sqrt((rising.array() - rising.mean()).square().mean());
  const double quartiles = (quantile(rising, 0.75) - quantile(rising, 0.25)) / 1.349;
  return 0.9 * (quartiles > 0 ? std::min(sd, quartiles) : sd) * std::pow(n, -0.2);
}

/// Estimates the density between the quantiles outside of which no cut is allowed, extended by one
/// bandwidth.
Density density_of(const Eigen::VectorXd& rising, double min_share) {
  // Choose the grid.
  const double h = bandwidth_of(rising);
  const double low = quantile(rising, min_share / 2) - h;
  const double high = quantile(rising, 1 - min_share / 2) + h;
  const int cells = std::clamp(int(std::ceil((high - low) / h * kCellsPerBandwidth)), 8, kMaxCells);
  Density density{low, (high - low) / cells, h, {}, Eigen::ArrayXd::Zero(cells)};

  // Count draws in each cell, and up to its end.
  Eigen::ArrayXd count = Eigen::ArrayXd::Zero(cells);
  const double each = 1 / double(rising.size());
  double below = 0;
  for (const double y : rising) {
    const double cell = std::floor((y - low) / density.step);
    if (cell < 0) below += each;
    if (cell >= 0 && cell < cells) count[int(cell)] += each;
  }
  for (int i = 0; i < cells; ++i) density.share[i] = below += count[i];

  // Smooth with a normal kernel of four bandwidths to each side.
  const int reach = int(std::ceil(4 * h / density.step));
  density.at = Eigen::ArrayXd::Zero(cells);
  for (int shift = -reach; shift <= reach; ++shift) {
    const double z = shift * density.step / h;
    const double weight = std::exp(-z * z / 2) / (std::sqrt(2 * M_PI) * h);
    for (int i = std::max(0, shift); i < std::min(cells, cells + shift); ++i)
      density.at[i] += weight * count[i - shift];
  }
  return density;
}

}  // namespace

Valley find_valley(const Eigen::Ref<const Eigen::VectorXd>& y, double min_share) {
  require(y.size() >= 2 && y.allFinite(), "a valley needs 2 finite draws, got {}", y.size());
  const Eigen::VectorXd rising = sorted(y);
  Valley best;
  if (!(bandwidth_of(rising) > 0)) return best;
  const Density f = density_of(rising, min_share);

  // Find the highest peak to the right of every cell, then scan from the left.
  Eigen::ArrayXd right = f.at;
  for (Eigen::Index i = right.size() - 2; i >= 0; --i) right[i] = std::max(right[i], right[i + 1]);
  double left = 0;
  for (Eigen::Index i = 0; i < f.at.size(); ++i) {
    left = std::max(left, f.at[i]);
    // Among cells with enough draws on both sides, find the lowest relative to the smaller peak.
    if (f.share[i] < min_share || f.share[i] > 1 - min_share) continue;
    const double peak = std::min(left, right[i]), low = f.at[i];
    if (low >= best.depth * peak) continue;
    const double noise = (peak + low) / (2 * std::sqrt(M_PI)) / (double(y.size()) * f.bandwidth);
    best = {f.first + (double(i) + 0.5) * f.step, low / peak, (peak - low) / std::sqrt(noise)};
  }
  return best;
}

namespace {

constexpr int kMaxStarts = 20;   // maximum number of starts of the kurtosis iteration
constexpr int kClimbSteps = 15;  // maximum number of iterations, which converge cubically
constexpr Eigen::Index kMaxClimbDraws = 4000;  // maximum number of draws used by the iteration

/// Whitened draws: y = A (x - mean) has unit covariance; directions without variance are dropped.
struct Whitened {
  Eigen::MatrixXd A;  // whitening matrix (k, n)
  Eigen::MatrixXd y;  // whitened draws (k, N)
};

/// Whitens draws (n, N).
Whitened whiten(const Eigen::MatrixXd& x) {
  // Scale coordinates by their sds.
  const Eigen::VectorXd mean = x.rowwise().mean();
  const Eigen::MatrixXd centred = x.colwise() - mean;
  const Eigen::VectorXd sd =
      centred.rowwise().norm() / std::sqrt(double(std::max<Eigen::Index>(1, x.cols())));
  const Eigen::VectorXd scale = sd.unaryExpr([](double s) { return s > 0 ? 1 / s : 0.0; });
  // Keep the eigenvectors of the correlation with nonzero variance.
  const Eigen::MatrixXd z = scale.asDiagonal() * centred;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
      Eigen::MatrixXd(z * z.transpose() / double(x.cols())));
  const Eigen::Index kept = (eigen.eigenvalues().array() > 1e-12).count();
  Whitened whitened;
  whitened.A = eigen.eigenvalues().tail(kept).cwiseSqrt().cwiseInverse().asDiagonal() *
               eigen.eigenvectors().rightCols(kept).transpose() * scale.asDiagonal();
  whitened.y = whitened.A * centred;
  return whitened;
}

/// Returns the directions in which the chain means differ most, in descending order (k, at most k).
Eigen::MatrixXd between_chains(const Eigen::MatrixXd& y, const std::vector<int>& chain) {
  // Sum the draws of each chain; the overall mean is zero.
  std::map<int, std::pair<Eigen::VectorXd, double>> sums;
  for (Eigen::Index i = 0; i < y.cols(); ++i) {
    auto& [sum, count] =
        sums.try_emplace(chain[i], Eigen::VectorXd::Zero(y.rows()), 0.0).first->second;
    sum += y.col(i);
    ++count;
  }
  // Find the principal directions of the covariance between chains.
  Eigen::MatrixXd between = Eigen::MatrixXd::Zero(y.rows(), y.rows());
  for (const auto& [name, chain_sum] : sums)
    between += chain_sum.first * chain_sum.first.transpose() / chain_sum.second;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(between);
  const auto wanted = std::min<Eigen::Index>({Eigen::Index(sums.size()) - 1, y.rows(), 5});
  return eigen.eigenvectors().rightCols(wanted).rowwise().reverse();
}

/// Iterates to a direction of extremal kurtosis, starting at w (k).
Eigen::VectorXd climb_kurtosis(const Eigen::MatrixXd& y, Eigen::VectorXd w) {
  for (int step = 0; step < kClimbSteps; ++step) {
    // Fixed point of the kurtosis along w.
    const Eigen::VectorXd along = y.transpose() * w;
    const Eigen::VectorXd next = y * along.array().cube().matrix() / double(y.cols()) - 3 * w;
    if (!(next.norm() > 0)) break;
    w = next.normalized();
  }
  return w;
}

}  // namespace

Eigen::MatrixXd projection_directions(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                      const std::vector<int>& chain) {
  const Eigen::Index n = x.rows();
  const Whitened white = whiten(x);
  const Eigen::Index k = white.y.rows();
  if (k == 0) return Eigen::MatrixXd::Identity(n, n);

  // Start the iteration with directions between chains, and with axes.
  const Eigen::MatrixXd apart = between_chains(white.y, chain);
  const Eigen::Index every = (x.cols() + kMaxClimbDraws - 1) / kMaxClimbDraws;
  const Eigen::MatrixXd few = white.y(Eigen::all, Eigen::seq(0, Eigen::last, every));
  const Eigen::Index axes = std::min<Eigen::Index>(k, kMaxStarts);
  Eigen::MatrixXd starts(k, apart.cols() + axes);
  starts << apart, Eigen::MatrixXd::Identity(k, axes);

  // Collect the directions between chains, and the results of the iteration.
  Eigen::MatrixXd w(k, apart.cols() + starts.cols());
  w.leftCols(apart.cols()) = apart;
  for (Eigen::Index i = 0; i < starts.cols(); ++i)
    w.col(apart.cols() + i) = climb_kurtosis(few, starts.col(i));

  // w'y = (A'w)'x: transform to directions of x.
  Eigen::MatrixXd all(n, n + w.cols());
  all << Eigen::MatrixXd::Identity(n, n), (white.A.transpose() * w).colwise().normalized();
  return all;
}

namespace {

constexpr Eigen::Index kMinDraws = 50;  // minimum number of draws of a part to be cut

/// Draws of one part, chain by chain.
struct Part {
  Eigen::MatrixXd x;       // draws (n, N)
  std::vector<int> chain;  // chain of each draw (N)

  /// Returns the selected draws with their chains.
  [[nodiscard]] Part where(const Eigen::Array<bool, Eigen::Dynamic, 1>& kept) const {
    std::vector<Eigen::Index> which;
    Part part;
    for (Eigen::Index i = 0; i < x.cols(); ++i)
      if (kept[i]) {
        which.push_back(i);
        part.chain.push_back(chain[i]);
      }
    part.x = x(Eigen::all, which);
    return part;
  }
};

/// Plane  w'x = cut  through the valley between two clusters.
struct Plane {
  Eigen::VectorXd w;  // normal vector (n); empty: no cut
  double cut = 0;     // position of the plane along w
};

/// Returns the effective size of y within the two sides of the cut, which determines the accuracy
/// of the peak heights. Transitions across the valley may be arbitrarily rare.
double ess_beside(const Eigen::VectorXd& y, double cut, const std::vector<int>& chain) {
  // Centre each side at its own mean.
  const Eigen::ArrayXd above = (y.array() > cut).cast<double>();
  const double up = (y.array() * above).sum() / std::max(1.0, above.sum());
  const double down = (y.array() * (1 - above)).sum() / std::max(1.0, (1 - above).sum());
  const Eigen::VectorXd beside = y.array() - above * up - (1 - above) * down;
  // Sum the effective sizes of the chains.
  double ess = 0;
  for (Eigen::Index first = 0; first < y.size();) {
    Eigen::Index end = first;
    while (end < y.size() && chain[end] == chain[first]) ++end;
    const double own = end - first < 4 ? 1 : series_ess(beside.segment(first, end - first));
    ess += std::isnan(own) ? 1 : std::min(own, double(end - first));
    first = end;
  }
  return ess;
}

/// Finds the deepest significant valley of a part along all projection directions.
Plane find_plane(const Part& part, double min_share, const ClusterOptions& options) {
  const Eigen::MatrixXd directions = projection_directions(part.x, part.chain);
  Plane best;
  double depth = options.depth;
  for (Eigen::Index k = 0; k < directions.cols(); ++k) {
    // Find a valley along this direction that is deeper than the best so far.
    const Eigen::VectorXd y = part.x.transpose() * directions.col(k);
    const Valley valley = find_valley(y, min_share);
    if (valley.depth >= depth || valley.contrast < options.contrast) continue;
    // Check its significance for autocorrelated draws.
    const double worth = ess_beside(y, valley.cut, part.chain) / double(y.size());
    if (valley.contrast * std::sqrt(worth) < options.contrast) continue;
    best = {directions.col(k), valley.cut};
    depth = valley.depth;
  }
  return best;
}

/// Gathers the draws of every chain, evenly thinned to at most `max_draws`.
Part gather(const std::vector<Eigen::MatrixXd>& x, long max_draws) {
  // Select every n-th draw of each chain.
  const Eigen::Index draws = x[0].cols();
  const Eigen::Index each = std::max<Eigen::Index>(1, max_draws / Eigen::Index(x.size()));
  const Eigen::Index every = std::max<Eigen::Index>(1, (draws + each - 1) / each);
  const Eigen::Index kept = (draws + every - 1) / every;
  Part part{Eigen::MatrixXd(x[0].rows(), kept * Eigen::Index(x.size())), {}};
  for (std::size_t chain = 0; chain < x.size(); ++chain) {
    part.x.middleCols(Eigen::Index(chain) * kept, kept) =
        x[chain](Eigen::all, Eigen::seqN(0, kept, every));
    part.chain.insert(part.chain.end(), kept, int(chain));
  }
  return part;
}

/// Cuts `part`, gives the draws of cluster `label` beyond the plane a new label, and recurses.
// NOLINTNEXTLINE(misc-no-recursion): depth is limited by min_mass
void split_part(const Part& part, double total, int label, const std::vector<Eigen::MatrixXd>& x,
                const ClusterOptions& options, Eigen::MatrixXi& labels) {
  // Stop if the part has too few draws or too little mass.
  const double share = options.min_mass * total / double(part.x.cols());
  if (part.x.cols() < kMinDraws || share >= 0.5) return;
  const Plane plane = find_plane(part, share, options);
  if (plane.w.size() == 0) return;

  // Label all draws beyond the plane, including those not used to find it.
  const int beyond = labels.maxCoeff() + 1;
  for (std::size_t chain = 0; chain < x.size(); ++chain) {
    const Eigen::VectorXd y = x[chain].transpose() * plane.w;
    for (Eigen::Index i = 0; i < y.size(); ++i)
      if (labels(i, chain) == label && y[i] > plane.cut) labels(i, chain) = beyond;
  }
  // Cut both sides.
  const Eigen::ArrayXd y = part.x.transpose() * plane.w;
  split_part(part.where(y <= plane.cut), total, label, x, options, labels);
  split_part(part.where(y > plane.cut), total, beyond, x, options, labels);
}

}  // namespace

Eigen::MatrixXi relabel_by_mass(const Eigen::MatrixXi& labels) {
  // Sort labels by falling count, ties by number.
  std::map<int, long> count;
  for (const int label : labels.reshaped()) ++count[label];
  std::vector<std::pair<long, int>> order;
  order.reserve(count.size());
  for (const auto& [label, draws] : count) order.emplace_back(-draws, label);
  std::sort(order.begin(), order.end());
  std::map<int, int> number;
  for (const auto& [draws, label] : order) number.emplace(label, int(number.size()));
  return labels.unaryExpr([&number](int label) { return number.at(label); });
}

Eigen::MatrixXi find_clusters(const std::vector<Eigen::MatrixXd>& x,
                              const ClusterOptions& options) {
  if (x.empty() || x[0].size() == 0) return {};
  for (const Eigen::MatrixXd& chain : x) {
    require(chain.rows() == x[0].rows() && chain.cols() == x[0].cols(),
            "chains have {} x {} and {} x {} draws", x[0].rows(), x[0].cols(), chain.rows(),
            chain.cols());
    require(chain.allFinite(), "clumps need finite draws");
  }
  // Find planes with some draws, and cut all draws.
  const Part part = gather(x, options.draws);
  Eigen::MatrixXi labels = Eigen::MatrixXi::Zero(x[0].cols(), Eigen::Index(x.size()));
  split_part(part, double(part.x.cols()), 0, x, options, labels);
  return relabel_by_mass(labels);
}

}  // namespace thenar
