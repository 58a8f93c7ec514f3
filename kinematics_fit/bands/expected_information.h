#pragma once

/// Information that a future reading is expected to give on which of several hypotheses holds.

#include <vector>

#include <Eigen/Core>

namespace thenar {

/// A hypothesis, and what it says of the reading y:  y ~ N(mean, covariance).
struct PredictedReading {
  double probability = 0;      // of the hypothesis, before the reading [1]
  Eigen::VectorXd mean;        // (rows)
  Eigen::MatrixXd covariance;  // of noise and of all that the hypothesis leaves open (rows, rows)
};

/// A question to hypotheses: the answer that each of them gives, counted from 0 (hypotheses).
using HypothesisAnswers = std::vector<int>;

/// Entropy of an answer under these probabilities of the hypotheses, -sum p log2 p [bit].
/// @throws InputError if shapes disagree, or an answer is negative.
[[nodiscard]] double answer_entropy(const std::vector<double>& probability,
                                    const HypothesisAnswers& answers);

/// Expected information of the reading about each question a, the mutual information
///   I(a; y) = H(a) - E_y H(a | y) [bit] (questions),
/// y being drawn from the mixture of the hypotheses and H(a | y) following by Bayes' rule. The mean
/// over y is taken by Gauss and Hermite's rule of `nodes` points a row in every hypothesis'
/// covariance: exact to rounding where the hypotheses agree, to about 0.01 bit elsewhere.
/// @param hypotheses  probabilities sum to 1; at most 3 rows
/// @throws InputError if shapes disagree, there are more than 3 rows, probabilities do not sum to
/// 1, or a covariance is not positive definite.
/// Source: [Lindley1956].
[[nodiscard]] Eigen::VectorXd expected_information(const std::vector<PredictedReading>& hypotheses,
                                                   const std::vector<HypothesisAnswers>& questions,
                                                   int nodes = 7);

}  // namespace thenar
