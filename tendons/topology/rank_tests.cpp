#include "tendons/topology/rank_tests.h"

#include <algorithm>
#include <cmath>

namespace thenar {
namespace {

// Largest squared difference that counts; 5 sd are as good as certain [1]
constexpr double kMostEvidence = 25;
// Least weight of a model that fits badly, so that it is not forgotten [1]
constexpr double kMinWeight = 1e-3;

struct Voice {
  Eigen::VectorXd value;  // readings of the whole pool
  double weight;
};

std::vector<Voice> voices(NetForwardModel& pool, const std::vector<FittedNet>& nets,
                          const Eigen::VectorXd& typical) {
  std::vector<Voice> out;
  // Least misfit, against which models are weighed.
  double least = std::numeric_limits<double>::infinity();
  for (const FittedNet& net : nets)
    if (net.fit.holds) least = std::min(least, net.fit.misfit);
  // Readings of every model that carries the loads.
  for (const FittedNet& net : nets) {
    if (!net.fit.holds) continue;
    const NetPrediction forecast =
        pool.predict(net.fit.s.cwiseProduct(typical), Sensitivities::kWithout);
    const double weight = std::exp(-0.5 * (net.fit.misfit - least));
    if (forecast.holds) out.push_back({forecast.value, std::max(weight, kMinWeight)});
  }
  return out;
}

double disagreement(const std::vector<Voice>& voices, Eigen::Index row, Eigen::Index rows,
                    const MeasurementNoise& noise) {
  double sum = 0, weights = 0;
  // Each pair of models, by its weight.
  for (std::size_t b = 1; b < voices.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) {
      const Eigen::VectorXd va = voices[a].value.segment(row, rows);
      const Eigen::VectorXd vb = voices[b].value.segment(row, rows);
      const Eigen::VectorXd sd = reading_sd(noise, 0.5 * (va + vb));
      const double apart = (va - vb).cwiseQuotient(sd).squaredNorm();
      sum += voices[a].weight * voices[b].weight * std::min(apart, kMostEvidence);
      weights += voices[a].weight * voices[b].weight;
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
  const std::vector<Voice> all = voices(pool, nets, typical);
  // Rows of each test within the pool.
  std::vector<RankedTest> promises;
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    const Eigen::Index rows = tests[i].map.rows();
    promises.push_back({static_cast<int>(i), disagreement(all, row, rows, noise)});
    row += rows;
  }
  std::stable_sort(promises.begin(), promises.end(), [](const RankedTest& a, const RankedTest& b) {
    return a.disagreement > b.disagreement;
  });
  return promises;
}

}  // namespace thenar
