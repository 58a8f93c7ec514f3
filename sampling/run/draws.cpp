#include "sampling/run/draws.h"

#include "base/error.h"

namespace thenar {

Eigen::MatrixXd Draws::coordinate(int i) const {
  require(i >= 0 && i < size(), "draws have {} coordinates, there is no number {}", size(), i);
  Eigen::MatrixXd out(draws(), chains());
  for (int chain = 0; chain < chains(); ++chain) {
    // Chains must have equal shapes.
    require(x[chain].rows() == size() && x[chain].cols() == draws(),
            "chain {} has {} x {} draws, the first {} x {}", chain, x[chain].rows(),
            x[chain].cols(), size(), draws());
    out.col(chain) = x[chain].row(i).transpose();
  }
  return out;
}

}  // namespace thenar

namespace thenar::internal {
namespace {

constexpr Eigen::Index kStatCount = 9;  // number of fields of StepStats

}  // namespace

Eigen::Index rows_of_draw(Eigen::Index size) { return kStatCount + size; }

void put_draw(const StepStats& stats, const Eigen::Ref<const Eigen::VectorXd>& x,
              std::vector<double>& to) {
  for (const double number :
       {stats.log_prior, stats.log_likelihood, stats.acceptance, stats.step_size, stats.energy,
        double(stats.depth), double(stats.evaluations), double(stats.non_finite),
        double(stats.divergent)})
    to.push_back(number);
  to.insert(to.end(), x.data(), x.data() + x.size());
}

StepStats stats_of(const Eigen::Ref<const Eigen::VectorXd>& draw) {
  StepStats stats;
  stats.log_prior = draw[0];
  stats.log_likelihood = draw[1];
  stats.acceptance = draw[2];
  stats.step_size = draw[3];
  stats.energy = draw[4];
  stats.depth = static_cast<int>(draw[5]);
  stats.evaluations = static_cast<int>(draw[6]);
  stats.non_finite = static_cast<int>(draw[7]);
  stats.divergent = draw[8] != 0;
  return stats;
}

Eigen::VectorXd position_of(const Eigen::Ref<const Eigen::VectorXd>& draw) {
  return draw.tail(draw.size() - kStatCount);
}

}  // namespace thenar::internal
