// Tests for solvers/arrow_matrix.cpp, against dense algebra.

#include "solvers/arrow_matrix.h"

#include <random>

#include <gtest/gtest.h>

#include "tests/kinematics_fit/fit_samples.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;

constexpr ArrowLayout kArrow{3, 2, 4};

/// J'J of random rows that read one block each, with and without blocks.
struct SampleHessian {
  ArrowMatrix arrow{kArrow};
  MatrixXd dense = MatrixXd::Zero(kArrow.size(), kArrow.size());

  explicit SampleHessian(std::mt19937& rng) {
    for (int b = -1; b < kArrow.blocks; ++b) {
      const int own = b < 0 ? 0 : kArrow.own, columns = kArrow.shared + own;
      const MatrixXd J = sample::normal(6 * columns, rng).reshaped(6, columns);
      const MatrixXd part = J.transpose() * J;
      arrow.add(b, part);
      MatrixXd place = MatrixXd::Zero(columns, kArrow.size());
      place.topLeftCorner(kArrow.shared, kArrow.shared).setIdentity();
      if (b >= 0) place.block(kArrow.shared, kArrow.first(b), own, own).setIdentity();
      dense += place.transpose() * part * place;
    }
  }
};

TEST(ArrowMatrix, HasTheEntriesOfTheDenseOne) {
  std::mt19937 rng(4);
  const SampleHessian sample(rng);
  EXPECT_EQ(sample.arrow.diagonal(), Eigen::VectorXd(sample.dense.diagonal()));
  for (int b = -1; b < kArrow.blocks; ++b) {
    std::vector<int> on{0, 1, 2};
    if (b >= 0) on.insert(on.end(), {kArrow.first(b), kArrow.first(b) + 1});
    EXPECT_EQ(sample.arrow.of(b), MatrixXd(sample.dense(on, on)));
  }
}

}  // namespace
}  // namespace thenar
