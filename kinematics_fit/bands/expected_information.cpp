#include "kinematics_fit/bands/expected_information.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMaxRows =
    3;  // largest number of rows of a reading; quadrature points grow exponentially with it

/// Quadrature points of a standard normal vector, and their weights: product of Gauss-Hermite
/// rules.
struct NormalRule {
  MatrixXd points;  // nodes (rows, points)
  VectorXd weight;  // weights, whose sum is 1 (points)
};

/// Returns the one-dimensional rule, from the eigenvectors of the recurrence matrix
/// [GolubWelsch1969].
NormalRule rule_of_one(int nodes) {
  MatrixXd recurrence = MatrixXd::Zero(nodes, nodes);
  for (int k = 1; k < nodes; ++k)
    recurrence(k, k - 1) = recurrence(k - 1, k) = std::sqrt(static_cast<double>(k));
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(recurrence);
  return {eigen.eigenvalues().transpose(), eigen.eigenvectors().row(0).cwiseAbs2().transpose()};
}

NormalRule product_rule(Eigen::Index rows, int nodes) {
  const NormalRule one = rule_of_one(nodes);
  NormalRule out{MatrixXd(0, 1), VectorXd::Ones(1)};
  for (Eigen::Index r = 0; r < rows; ++r) {
    // Combine every point so far with every node of one more dimension.
    NormalRule more{MatrixXd(r + 1, out.weight.size() * nodes),
                    VectorXd(out.weight.size() * nodes)};
    for (Eigen::Index p = 0; p < out.weight.size(); ++p)
      for (int k = 0; k < nodes; ++k) {
        const Eigen::Index at = p * nodes + k;
        more.points.col(at).head(r) = out.points.col(p);
        more.points(r, at) = one.points(0, k);
        more.weight(at) = out.weight(p) * one.weight(k);
      }
    out = std::move(more);
  }
  return out;
}

/// Normal density, factored for evaluation.
struct Density {
  double log_weight;  // log probability less half the log determinant
  VectorXd mean;      // mean of the reading
  MatrixXd L;         // factor of the covariance L L'
};

Density density_of(const PredictedReading& hypothesis) {
  const Eigen::LLT<MatrixXd> factor(hypothesis.covariance);
  require(factor.info() == Eigen::Success && hypothesis.covariance.allFinite(),
          "the covariance of a predicted reading must be positive definite");
  MatrixXd L = factor.matrixL();
  return {std::log(hypothesis.probability) - L.diagonal().array().log().sum(), hypothesis.mean,
          std::move(L)};
}

/// Returns the probabilities of the hypotheses after the reading y.
std::vector<double> updated(const std::vector<Density>& densities, const VectorXd& y) {
  std::vector<double> p;
  double largest = -std::numeric_limits<double>::infinity();
  for (const Density& density : densities) {
    const VectorXd off = density.L.triangularView<Eigen::Lower>().solve(VectorXd(y - density.mean));
    p.push_back(density.log_weight - 0.5 * off.squaredNorm());
    largest = std::max(largest, p.back());
  }
  double sum = 0;
  for (double& each : p) sum += each = std::exp(each - largest);
  for (double& each : p) each /= sum;
  return p;
}

/// Checks the shapes, probabilities and answers. @throws InputError if one is not valid.
void check(const std::vector<PredictedReading>& hypotheses,
           const std::vector<HypothesisAnswers>& questions) {
  require(!hypotheses.empty(), "a reading tells nothing without hypotheses");
  const Eigen::Index rows = hypotheses.front().mean.size();
  require(rows >= 1 && rows <= kMaxRows, "a reading of 1 to {} rows was wanted, got {}", kMaxRows,
          rows);
  double sum = 0;
  for (const PredictedReading& each : hypotheses) {
    require(each.mean.size() == rows && each.mean.allFinite() && each.covariance.rows() == rows &&
                each.covariance.cols() == rows,
            "hypotheses predict readings of {} and of {} rows", rows, each.mean.size());
    require(each.probability >= 0, "a hypothesis has probability {}", each.probability);
    sum += each.probability;
  }
  require(std::abs(sum - 1) < 1e-9, "probabilities of hypotheses sum to {}", sum);
  for (const HypothesisAnswers& answers : questions)
    require(answers.size() == hypotheses.size(), "{} hypotheses give {} answers", hypotheses.size(),
            answers.size());
}

}  // namespace

double answer_entropy(const std::vector<double>& probability, const HypothesisAnswers& answers) {
  require(probability.size() == answers.size() && !answers.empty(), "{} hypotheses give {} answers",
          probability.size(), answers.size());
  require(*std::min_element(answers.begin(), answers.end()) >= 0, "answers are counted from 0");
  // Sum the probability of each answer.
  std::vector<double> answer_probability(
      static_cast<std::size_t>(*std::max_element(answers.begin(), answers.end()) + 1));
  for (std::size_t k = 0; k < answers.size(); ++k) answer_probability[answers[k]] += probability[k];
  double entropy = 0;
  for (const double p : answer_probability)
    if (p > 0) entropy -= p * std::log2(p);
  return entropy;
}

VectorXd expected_information(const std::vector<PredictedReading>& hypotheses,
                              const std::vector<HypothesisAnswers>& questions, int nodes) {
  check(hypotheses, questions);
  const auto count = static_cast<Eigen::Index>(questions.size());
  // Select the hypotheses that are possible, and compute the entropies before the reading.
  std::vector<double> before;
  std::vector<Density> densities;
  std::vector<HypothesisAnswers> answers(questions.size());
  for (std::size_t k = 0; k < hypotheses.size(); ++k) {
    if (hypotheses[k].probability == 0) continue;
    before.push_back(hypotheses[k].probability);
    densities.push_back(density_of(hypotheses[k]));
    for (std::size_t a = 0; a < questions.size(); ++a) answers[a].push_back(questions[a][k]);
  }
  VectorXd information(count);
  for (Eigen::Index a = 0; a < count; ++a) information(a) = answer_entropy(before, answers[a]);

  // Subtract the expected entropies after the reading, over readings of every hypothesis.
  const NormalRule rule = product_rule(hypotheses.front().mean.size(), nodes);
  for (std::size_t k = 0; k < before.size(); ++k)
    for (Eigen::Index p = 0; p < rule.weight.size(); ++p) {
      const VectorXd y = densities[k].mean + densities[k].L * rule.points.col(p);
      const std::vector<double> after = updated(densities, y);
      for (Eigen::Index a = 0; a < count; ++a)
        information(a) -= before[k] * rule.weight(p) * answer_entropy(after, answers[a]);
    }
  return information.cwiseMax(0);
}

}  // namespace thenar
