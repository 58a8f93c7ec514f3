#include "tendons/topology/rank_tests.h"

#include <algorithm>
#include <cmath>

namespace thenar {
namespace {

// Cap of the squared difference; 5 sd are practically certain [1]
constexpr double kMaxEvidence = 25;
// Smallest weight of a model that fits badly, so that it still counts [1]
constexpr double kMinWeight = 1e-3;

/// Prediction of one model, with its weight.
struct WeightedPrediction {
  Eigen::VectorXd value;  // readings of the whole pool
  double weight;
};

/// Predicts the pool by every model that carries the loads.
std::vector<WeightedPrediction> predictions(NetForwardModel& pool,
                                            const std::vector<FittedNet>& nets,
                                            const Eigen::VectorXd& typical) {
  std::vector<WeightedPrediction> out;
  // Find the smallest misfit, the reference of the weights.
  double least = std::numeric_limits<double>::infinity();
  for (const FittedNet& net : nets)
    if (net.fit.holds) least = std::min(least, net.fit.misfit);
  // Predict the readings of every model that carries the loads.
  for (const FittedNet& net : nets) {
    if (!net.fit.holds) continue;
    const NetPrediction forecast =
        pool.predict(net.fit.s.cwiseProduct(typical), Sensitivities::kWithout);
    const double weight = std::exp(-0.5 * (net.fit.misfit - least));
    if (forecast.holds) out.push_back({forecast.value, std::max(weight, kMinWeight)});
  }
  return out;
}

/// Computes the weighted disagreement of all pairs of models on one test.
double disagreement(const std::vector<WeightedPrediction>& predictions, Eigen::Index row,
                    Eigen::Index rows, const MeasurementNoise& noise) {
  double sum = 0, weights = 0;
  // Sum over pairs of models by their weights.
  for (std::size_t b = 1; b < predictions.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) {
      const Eigen::VectorXd va = predictions[a].value.segment(row, rows);
      const Eigen::VectorXd vb = predictions[b].value.segment(row, rows);
      const Eigen::VectorXd sd = reading_sd(noise, 0.5 * (va + vb));
      const double apart = (va - vb).cwiseQuotient(sd).squaredNorm();
      sum += predictions[a].weight * predictions[b].weight * std::min(apart, kMaxEvidence);
      weights += predictions[a].weight * predictions[b].weight;
    }
  return weights > 0 ? sum / weights : 0;
}

}  // namespace

Eigen::VectorXd reading_sd(const MeasurementNoise& noise, const Eigen::VectorXd& value) {
  return Eigen::VectorXd::Constant(value.size(),
                                   std::hypot(noise.floor, noise.relative * value.norm()));
}

std::vector<RankedTest> rank_tests(NetForwardModel& pool, const std::vector<TendonTest>& tests,
                                   const std::vector<FittedNet>& nets,
                                   const Eigen::VectorXd& typical, const MeasurementNoise& noise) {
  const std::vector<WeightedPrediction> all = predictions(pool, nets, typical);
  // Rank each test by its rows within the pool.
  std::vector<RankedTest> ranked;
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    const Eigen::Index rows = tests[i].map.rows();
    ranked.push_back({static_cast<int>(i), disagreement(all, row, rows, noise)});
    row += rows;
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const RankedTest& a, const RankedTest& b) {
    return a.disagreement > b.disagreement;
  });
  return ranked;
}

}  // namespace thenar
