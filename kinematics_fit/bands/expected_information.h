#pragma once

/// Expected information of a future reading about which of several hypotheses is true.

#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Hypothesis and its prediction of the reading y:  y ~ N(mean, covariance).
struct PredictedReading {
  double probability = 0;  // prior probability of the hypothesis [1]
  Eigen::VectorXd mean;    // predicted reading (rows)
  Eigen::MatrixXd
      covariance;  // covariance of noise and of the uncertainty within the hypothesis (rows, rows)
};

/// Question about hypotheses: the answer given by each of them, counted from 0 (hypotheses).
using HypothesisAnswers = std::vector<int>;

/// Computes the entropy of an answer under these probabilities of the hypotheses, -sum p log2 p
/// [bit].
/// @throws InputError if shapes disagree, or an answer is negative.
[[nodiscard]] double answer_entropy(const std::vector<double>& probability,
                                    const HypothesisAnswers& answers);

/// Computes the expected information of the reading about each question a, the mutual information
///   I(a; y) = H(a) - E_y H(a | y) [bit] (questions),
/// with y drawn from the mixture of the hypotheses and H(a | y) by Bayes' rule. The mean over y
/// uses Gauss-Hermite quadrature with `nodes` points per row in every hypothesis' covariance: exact
/// to rounding if the hypotheses agree, to about 0.01 bit otherwise.
/// @param hypotheses  probabilities sum to 1; at most 3 rows
/// @throws InputError if shapes disagree, there are more than 3 rows, probabilities do not sum to
/// 1, or a covariance is not positive definite.
/// Source: [Lindley1956].
[[nodiscard]] Eigen::VectorXd expected_information(const std::vector<PredictedReading>& hypotheses,
                                                   const std::vector<HypothesisAnswers>& questions,
                                                   int nodes = 7);

}  // namespace thenar
