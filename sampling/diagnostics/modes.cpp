#include "sampling/diagnostics/modes.h"

#include <limits>

#include <fmt/format.h>
#include <Eigen/Cholesky>

#include "base/error.h"
#include "base/numbers.h"
#include "sampling/diagnostics/convergence.h"

namespace thenar {
namespace {

/// Returns the index of the known mode with the largest normal density at each draw (draws,
/// chains).
Eigen::MatrixXi nearest_known(const Draws& draws, const std::vector<KnownMode>& known) {
  Eigen::MatrixXi labels = Eigen::MatrixXi::Zero(draws.draws(), draws.chains());
  Eigen::MatrixXd best = Eigen::MatrixXd::Constant(draws.draws(), draws.chains(),
                                                   -std::numeric_limits<double>::infinity());
  for (std::size_t m = 0; m < known.size(); ++m) {
    // Factorise the covariance of the mode.
    const KnownMode& mode = known[m];
    require(mode.centre.size() == draws.size() && mode.covariance.rows() == draws.size() &&
                mode.covariance.cols() == draws.size(),
            "mode {} has {} coordinates and a covariance of {} x {}, draws have {}", m,
            mode.centre.size(), mode.covariance.rows(), mode.covariance.cols(), draws.size());
    const Eigen::LLT<Eigen::MatrixXd> factor(mode.covariance);
    require(factor.info() == Eigen::Success, "covariance of mode {} is not positive definite", m);
    const double log_volume = factor.matrixLLT().diagonal().array().log().sum();
    // Assign every draw to the mode of the largest density so far.
    for (int chain = 0; chain < draws.chains(); ++chain) {
      require(draws.x[chain].allFinite(), "chain {} has draws that are not finite", chain);
      const Eigen::MatrixXd z = factor.matrixL().solve(draws.x[chain].colwise() - mode.centre);
      const Eigen::VectorXd density =
          -0.5 * z.colwise().squaredNorm().transpose().array() - log_volume;
      for (Eigen::Index i = 0; i < density.size(); ++i)
        if (density[i] > best(i, chain)) {
          best(i, chain) = density[i];
          labels(i, chain) = int(m);
        }
    }
  }
  return labels;
}

/// Describes the mode with a label.
ModeMass describe(const Draws& draws, const Eigen::MatrixXi& labels, int label) {
  // The mass is the mean of an indicator.
  const Eigen::MatrixXd inside = (labels.array() == label).cast<double>();
  ModeMass mode;
  mode.mass = inside.mean();
  mode.visits = inside.colwise().mean().transpose();
  mode.mcse = draws.draws() < 4 ? kNaN : mean_mcse(inside, draws.group);

  // Compute centre and sd of its draws.
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(draws.size()), square = sum;
  for (int chain = 0; chain < draws.chains(); ++chain) sum += draws.x[chain] * inside.col(chain);
  mode.centre = sum / inside.sum();
  for (int chain = 0; chain < draws.chains(); ++chain)
    square += (draws.x[chain].colwise() - mode.centre).cwiseAbs2() * inside.col(chain);
  mode.sd = (square / (inside.sum() - 1)).cwiseSqrt();
  if (inside.sum() < 2) mode.sd.setConstant(kNaN);

  // Count steps into or out of the mode.
  const Eigen::Index later = inside.rows() - 1;
  mode.crossings =
      long((inside.topRows(later).array() != inside.bottomRows(later).array()).count());
  return mode;
}

/// Returns warnings about the first `visited` modes, which have draws, and about modes without
/// draws.
std::vector<std::string> mode_warnings(const ModeTable& table, std::size_t visited,
                                       const std::vector<KnownMode>& known, long min_crossings) {
  std::vector<std::string> warnings;
  // Without transitions no mass is reliable.
  const bool apart = visited > 1 && table.crossings == 0;
  if (apart)
    warnings.emplace_back(
        "no chain crosses between modes: their masses only repeat where the chains began");
  for (std::size_t m = 0; m < table.modes.size(); ++m) {
    // Warn about known modes without draws, and about modes with few transitions.
    const ModeMass& mode = table.modes[m];
    const auto draws = double(table.of_draw.size());
    if (m >= visited && !(known[mode.known].mass * draws < 1))
      warnings.push_back(fmt::format("mode {}, known beforehand, holds no draw", m + 1));
    if (m < visited && visited > 1 && !apart && mode.crossings < min_crossings)
      warnings.push_back(
          fmt::format("chains cross into or out of mode {} only {} times, fewer than {}: its mass "
                      "of {:.3g} is not to be trusted",
                      m + 1, mode.crossings, min_crossings, mode.mass));
  }
  return warnings;
}

/// Appends modes without draws, in the order of the known modes.
void append_empty(const std::vector<KnownMode>& known, const std::vector<bool>& visited, int chains,
                  ModeTable& table) {
  for (std::size_t m = 0; m < known.size(); ++m) {
    if (visited[m]) continue;
    ModeMass mode;
    mode.mcse = kNaN;
    mode.centre = known[m].centre;
    mode.sd = Eigen::VectorXd::Constant(known[m].centre.size(), kNaN);
    mode.visits = Eigen::VectorXd::Zero(chains);
    mode.known = int(m);
    table.modes.push_back(mode);
  }
}

}  // namespace

ModeTable tabulate_modes(const Draws& draws, const std::vector<KnownMode>& known,
                         const ModeOptions& options) {
  ModeTable table;
  if (draws.draws() == 0) return table;
  // Label draws by known modes, otherwise by clusters.
  const Eigen::MatrixXi clusters = find_clusters(draws.x, options.clusters);
  const Eigen::MatrixXi labels = known.empty() ? clusters : nearest_known(draws, known);
  table.of_draw = relabel_by_mass(labels);

  // Describe the modes with draws, by falling mass.
  const int count = table.of_draw.maxCoeff() + 1;
  std::vector<bool> visited(known.size());
  for (int m = 0; m < count; ++m) {
    table.modes.push_back(describe(draws, table.of_draw, m));
    table.crossings += table.modes.back().crossings;
  }
  table.crossings /= 2;  // each leaves one mode and enters another
  // Identify the known modes, and append those without draws.
  for (Eigen::Index i = 0; !known.empty() && i < labels.size(); ++i) {
    visited[labels(i)] = true;
    table.modes[table.of_draw(i)].known = labels(i);
  }
  append_empty(known, visited, draws.chains(), table);
  if (table.modes.size() == 1) table.modes[0].mcse = 0;

  // Warn about unreliable masses, and about further clusters.
  table.warnings = mode_warnings(table, std::size_t(count), known, options.min_crossings);
  if (!known.empty() && clusters.maxCoeff() + 1 > count)
    table.warnings.push_back(
        fmt::format("the draws fall into {} clumps, more than the {} known modes that they visit",
                    clusters.maxCoeff() + 1, count));
  return table;
}

}  // namespace thenar
