// Tests for sampling/diagnostics/learnt_directions.cpp.

#include "sampling/diagnostics/learnt_directions.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "base/error.h"
#include "base/random_stream.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

/// Prior sds 1, 2 and 1e-3; 3 a - b is measured with an sd of 0.1.
const Eigen::Matrix3d kPrior = Eigen::Vector3d(1, 4, 1e-6).asDiagonal();
const Eigen::Vector3d kMeasured(3, -1, 0);
const Eigen::Matrix3d kPosterior =
    (kPrior.inverse() + kMeasured * kMeasured.transpose() / 0.01).inverse();
const std::vector<std::string> kNames = {"a", "b", "c"};

// The measured combination has the prior variance 9 + 4 = 13: ratio 1 / sqrt(1 + 13 / 0.01). In
// prior sds it is 3 : 2, so its shares are 9/13 and 4/13.
TEST(Directions, FindsWhatWasMeasured) {
  const LearntDirections of = learnt_directions(kNames, kPosterior, kPrior);
  ASSERT_EQ(of.directions.size(), 3U);
  const LearntDirection& best = of.directions[0];
  EXPECT_NEAR(best.sd_ratio, 1 / std::sqrt(1301), 1e-9);
  EXPECT_TRUE(matrix_near(best.v * 3 / best.v[0], kMeasured, 1e-9));
  EXPECT_TRUE(matrix_near(best.share, Eigen::Vector3d(9.0 / 13, 4.0 / 13, 0), 1e-9));
  EXPECT_NEAR(of.directions[1].sd_ratio, 1, 1e-9);
  EXPECT_NEAR(of.directions[2].sd_ratio, 1, 1e-9);
  EXPECT_EQ(of.decided, 1);
  EXPECT_NEAR(of.effective_parameters, 1300.0 / 1301, 1e-9);
  EXPECT_EQ(best.text, "0.69 a - 0.31 b: sd 0.028 of the prior's");
}

// x = A y: the same ratios, whatever the coordinates.
TEST(Directions, DoNotDependOnCoordinates) {
  Eigen::Matrix3d A;
  A << 2, 1, 0, -1, 3, 1e3, 0.5, 0, 1;
  const LearntDirections of =
      learnt_directions(kNames, A * kPosterior * A.transpose(), A * kPrior * A.transpose());
  EXPECT_NEAR(of.directions[0].sd_ratio, 1 / std::sqrt(1301), 1e-6);
  EXPECT_NEAR(of.directions[2].sd_ratio, 1, 1e-6);
  const Eigen::VectorXd v = of.directions[0].v;
  EXPECT_NEAR(v.dot(A * kPrior * A.transpose() * v), 1, 1e-9);  // one prior sd long
}

// From N draws the ratios scatter by about sqrt(n / N) = 0.03 of themselves.
TEST(Directions, FromDraws) {
  RandomStream random(1, 0, 0);
  const auto draw = [&](const Eigen::Matrix3d& C) -> Eigen::MatrixXd {
    const Eigen::MatrixXd z =
        Eigen::MatrixXd::NullaryExpr(3, 4000, [&] { return random.normal(); });
    return C.llt().matrixL() * z;
  };
  const LearntDirections of =
      learnt_directions(kNames, covariance_of(draw(kPosterior)), covariance_of(draw(kPrior)));
  EXPECT_NEAR(of.directions[0].sd_ratio * std::sqrt(1301), 1, 0.1);
  EXPECT_NEAR(of.directions[1].sd_ratio, 1, 0.1);
  EXPECT_EQ(of.decided, 1);
}

/// Covariances of normal draws, all and in two halves (n, count).
PosteriorCovariances covariances_of(const Eigen::MatrixXd& x) {
  const Eigen::Index half = x.cols() / 2;
  return {covariance_of(x), covariance_of(x.leftCols(half)), covariance_of(x.rightCols(half))};
}

// Draws from the prior alone have learnt nothing, however few there are for how many directions. A
// sum of max(0, 1 - r^2) over the directions of 600 draws would count some 70 parameters.
TEST(Directions, OfThePriorItselfAreNotLearnt) {
  constexpr Eigen::Index kSize = 250, kCount = 600;
  RandomStream random(2, 0, 0);
  const Eigen::MatrixXd z =
      Eigen::MatrixXd::NullaryExpr(kSize, kCount, [&] { return random.normal(); });
  const LearntDirections of =
      learnt_directions(std::vector<std::string>(kSize, "z"), covariances_of(z),
                        Eigen::MatrixXd::Identity(kSize, kSize));
  EXPECT_EQ(of.decided, 0);
  // The trace has the sd sqrt(2 n / N); 4 of them.
  EXPECT_LT(of.effective_parameters, 4 * std::sqrt(2.0 * kSize / kCount));
}

// Ten of 250 directions are measured with an sd of 0.1 prior sds: 10 (1 - 0.01) parameters.
TEST(Directions, CountWhatWasMeasuredAmongManyThatWereNot) {
  constexpr Eigen::Index kSize = 250, kCount = 2000;
  RandomStream random(3, 0, 0);
  Eigen::MatrixXd z = Eigen::MatrixXd::NullaryExpr(kSize, kCount, [&] { return random.normal(); });
  z.topRows(10) *= 0.1;
  const LearntDirections of =
      learnt_directions(std::vector<std::string>(kSize, "z"), covariances_of(z),
                        Eigen::MatrixXd::Identity(kSize, kSize));
  EXPECT_EQ(of.decided, 10);
  EXPECT_NEAR(of.effective_parameters, 9.9, 4 * std::sqrt(2.0 * kSize / kCount));
}

TEST(Directions, RefusesAPriorThatIsFlat) {
  const Eigen::Matrix3d flat = Eigen::Vector3d(1, 0, 1).asDiagonal();
  EXPECT_THROW((void)learnt_directions(kNames, kPosterior, flat), InputError);
  EXPECT_THROW((void)learnt_directions({"a"}, kPosterior, kPrior), InputError);
}

}  // namespace
}  // namespace thenar
