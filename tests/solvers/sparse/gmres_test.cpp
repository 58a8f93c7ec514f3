#include "solvers/sparse/gmres.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace thenar {
namespace {

TEST(Gmres, SolvesAsManyStepsAsTheRankOfWhatIsNoIdentity) {
  // I + U V' with U, V of rank 3: four products reach the answer.
  std::srand(5);
  const Eigen::MatrixXd U = Eigen::MatrixXd::Random(40, 3), V = Eigen::MatrixXd::Random(40, 3);
  const Eigen::MatrixXd A = Eigen::MatrixXd::Identity(40, 40) + U * V.transpose();
  const Eigen::VectorXd b = Eigen::VectorXd::Random(40);
  int products = 0;
  const Eigen::VectorXd x = gmres(
      [&](const Eigen::VectorXd& v) {
        ++products;
        return Eigen::VectorXd(A * v);
      },
      b, 1e-10, 20);
  EXPECT_LE(products, 4);
  EXPECT_LT((x - A.partialPivLu().solve(b)).norm(), 1e-8 * x.norm());
}

TEST(Gmres, ReturnsTheBestOfItsStepsAndNothingForNothing) {
  std::srand(6);
  const Eigen::MatrixXd A =
      Eigen::MatrixXd::Identity(30, 30) + 0.3 * Eigen::MatrixXd::Random(30, 30);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(30);
  double before = b.norm();
  for (const int steps : {1, 5, 15}) {
    const Eigen::VectorXd x =
        gmres([&](const Eigen::VectorXd& v) { return Eigen::VectorXd(A * v); }, b, 1e-14, steps);
    EXPECT_LT((b - A * x).norm(), before);
    before = (b - A * x).norm();
  }
  EXPECT_EQ(gmres([](const Eigen::VectorXd& v) { return v; }, Eigen::VectorXd::Zero(3), 1e-9, 5),
            Eigen::VectorXd(Eigen::VectorXd::Zero(3)));
}

}  // namespace
}  // namespace thenar
