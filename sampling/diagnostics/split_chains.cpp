#include "sampling/diagnostics/split_chains.h"

#include <map>

#include "base/error.h"

namespace thenar {

Eigen::MatrixXd split_chains(const Eigen::Ref<const Eigen::MatrixXd>& x) {
  require(x.cols() > 0 && x.rows() >= 4, "diagnostics need 4 draws a chain, got {} of {} chains",
          x.rows(), x.cols());
  const Eigen::Index half = x.rows() / 2;
  Eigen::MatrixXd halves(half, 2 * x.cols());
  halves << x.topRows(half), x.bottomRows(half);
  return halves;
}

Eigen::MatrixXd pool_groups(const Eigen::Ref<const Eigen::MatrixXd>& x,
                            const std::vector<int>& group) {
  require(Eigen::Index(group.size()) == x.cols(), "{} groups are named for {} chains", group.size(),
          x.cols());
  // Collect the chains of each group.
  std::map<int, std::vector<Eigen::Index>> walkers;
  for (Eigen::Index chain = 0; chain < x.cols(); ++chain) walkers[group[chain]].push_back(chain);

  if (walkers.empty()) return {};
  // Interleave the walkers, draw by draw.
  const std::size_t size = walkers.begin()->second.size();
  Eigen::MatrixXd pooled(x.rows() * Eigen::Index(size), Eigen::Index(walkers.size()));
  Eigen::Index column = 0;
  for (const auto& [name, chains] : walkers) {
    require(chains.size() == size, "group {} has {} chains, others {}", name, chains.size(), size);
    pooled.col(column++) = x(Eigen::all, chains).transpose().reshaped();
  }
  return pooled;
}

bool finite_and_varying(const Eigen::Ref<const Eigen::MatrixXd>& x) {
  return x.size() > 0 && x.allFinite() && (x.array() != x(0, 0)).any();
}

}  // namespace thenar
