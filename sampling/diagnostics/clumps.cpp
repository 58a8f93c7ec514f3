#include "sampling/diagnostics/clumps.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "sampling/diagnostics/effective_size.h"
#include "sampling/diagnostics/split_directions.h"
#include "sampling/diagnostics/valley.h"

namespace thenar {
namespace {

constexpr Eigen::Index kFewest = 50;  // draws worth cutting

/// Draws of one part, chain by chain.
struct Part {
  Eigen::MatrixXd x;       // (n, N)
  std::vector<int> chain;  // of each draw (N)

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

/// A plane  w'x = cut  through the valley between two clumps.
struct Plane {
  Eigen::VectorXd w;  // (n); empty: nothing to cut
  double cut = 0;
};

/// Independent draws worth y once it is known on which side of the cut each is: what the height of
/// a peak is known from. Moves across the valley may be as rare as they like.
double ess_beside(const Eigen::VectorXd& y, double cut, const std::vector<int>& chain) {
  const Eigen::ArrayXd above = (y.array() > cut).cast<double>();
  const double up = (y.array() * above).sum() / std::max(1.0, above.sum());
  const double down = (y.array() * (1 - above)).sum() / std::max(1.0, (1 - above).sum());
  const Eigen::VectorXd beside = y.array() - above * up - (1 - above) * down;
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

Plane find_plane(const Part& part, double least_share, const ClumpOptions& options) {
  const Eigen::MatrixXd directions = split_directions(part.x, part.chain);
  Plane best;
  double depth = options.depth;
  for (Eigen::Index k = 0; k < directions.cols(); ++k) {
    const Eigen::VectorXd y = part.x.transpose() * directions.col(k);
    const Valley valley = find_valley(y, least_share);
    if (valley.depth >= depth || valley.contrast < options.contrast) continue;
    const double worth = ess_beside(y, valley.cut, part.chain) / double(y.size());
    if (valley.contrast * std::sqrt(worth) < options.contrast) continue;
    best = {directions.col(k), valley.cut};
    depth = valley.depth;
  }
  return best;
}

/// Every draw of every chain, or an even selection.
Part gather(const std::vector<Eigen::MatrixXd>& x, long most) {
  const Eigen::Index draws = x[0].cols();
  const Eigen::Index each = std::max<Eigen::Index>(1, most / Eigen::Index(x.size()));
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

/// Cuts `part`, gives the draws of clump `label` beyond the plane a new label, and goes on.
void cut(const Part& part, double total, int label, const std::vector<Eigen::MatrixXd>& x,
         const ClumpOptions& options, Eigen::MatrixXi& labels) {
  const double share = options.least_mass * total / double(part.x.cols());
  if (part.x.cols() < kFewest || share >= 0.5) return;
  const Plane plane = find_plane(part, share, options);
  if (plane.w.size() == 0) return;

  const int beyond = labels.maxCoeff() + 1;
  for (std::size_t chain = 0; chain < x.size(); ++chain) {
    const Eigen::VectorXd y = x[chain].transpose() * plane.w;
    for (Eigen::Index i = 0; i < y.size(); ++i)
      if (labels(i, chain) == label && y[i] > plane.cut) labels(i, chain) = beyond;
  }
  const Eigen::ArrayXd y = part.x.transpose() * plane.w;
  cut(part.where(y <= plane.cut), total, label, x, options, labels);
  cut(part.where(y > plane.cut), total, beyond, x, options, labels);
}

}  // namespace

Eigen::MatrixXi by_falling_mass(const Eigen::MatrixXi& labels) {
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

Eigen::MatrixXi find_clumps(const std::vector<Eigen::MatrixXd>& x, const ClumpOptions& options) {
  if (x.empty() || x[0].size() == 0) return {};
  for (const Eigen::MatrixXd& chain : x) {
    require(chain.rows() == x[0].rows() && chain.cols() == x[0].cols(),
            "chains have {} x {} and {} x {} draws", x[0].rows(), x[0].cols(), chain.rows(),
            chain.cols());
    require(chain.allFinite(), "clumps need finite draws");
  }
  const Part part = gather(x, options.draws);
  Eigen::MatrixXi labels = Eigen::MatrixXi::Zero(x[0].cols(), Eigen::Index(x.size()));
  cut(part, double(part.x.cols()), 0, x, options, labels);
  return by_falling_mass(labels);
}

}  // namespace thenar
