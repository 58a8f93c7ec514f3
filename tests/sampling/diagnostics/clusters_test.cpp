// Tests for sampling/diagnostics/clusters.cpp: valleys, directions and labels.

#include "sampling/diagnostics/clusters.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/random_stream.h"

namespace thenar {
namespace {

// Two unit normals 6 apart, equally heavy: f(3) / f(0) = 2 exp(-9/2) = 0.022 at the middle; the
// kernel's own width makes it somewhat more.
TEST(Valley, LiesBetweenTwoNormals) {
  RandomStream random(1, 0, 0);
  const Eigen::VectorXd y = Eigen::VectorXd::NullaryExpr(
      10000, [&] { return random.normal() + (random.uniform() < 0.5 ? 0 : 6); });
  const Valley valley = find_valley(y, 0.01);
  EXPECT_NEAR(valley.cut, 3, 0.5);
  EXPECT_GT(valley.depth, 0.01);
  EXPECT_LT(valley.depth, 0.15);
  EXPECT_GT(valley.contrast, 20);
}

TEST(Valley, IsNoneInOneNormalOrAConstant) {
  RandomStream random(2, 0, 0);
  const Eigen::VectorXd y = Eigen::VectorXd::NullaryExpr(10000, [&] { return random.normal(); });
  EXPECT_TRUE(find_valley(y, 0.01).depth > 0.5 || find_valley(y, 0.01).contrast < 5);
  EXPECT_EQ(find_valley(Eigen::VectorXd::Ones(10), 0.01).depth, 1);
}

// Two groups of normal draws, 12 apart along a diagonal of the plane: one label each.
TEST(Clusters, AreCutAlongADiagonal) {
  RandomStream random(3, 0, 0);
  std::vector<Eigen::MatrixXd> chains;
  Eigen::MatrixXi truth(500, 2);
  for (int chain = 0; chain < 2; ++chain) {
    chains.emplace_back(2, 500);
    for (int i = 0; i < 500; ++i) {
      truth(i, chain) = random.uniform() < 0.25 ? 1 : 0;
      const double shift = truth(i, chain) * 12 / std::sqrt(2.0);
      chains[chain].col(i) << random.normal() + shift, random.normal() - shift;
    }
  }
  EXPECT_EQ(find_clusters(chains), truth);
}

TEST(Clusters, RefuseChainsOfAnotherLength) {
  EXPECT_THROW((void)find_clusters({Eigen::MatrixXd::Zero(2, 5), Eigen::MatrixXd::Zero(2, 4)}),
               InputError);
}

// 7 stands four times, 2 and 5 twice each: the smaller label first.
TEST(Clusters, AreNumberedByFallingFrequency) {
  const Eigen::MatrixXi labels = (Eigen::MatrixXi(4, 2) << 7, 5, 7, 2, 2, 7, 7, 5).finished();
  const Eigen::MatrixXi numbers = (Eigen::MatrixXi(4, 2) << 0, 2, 0, 1, 1, 0, 0, 2).finished();
  EXPECT_EQ(relabel_by_mass(labels), numbers);
}

}  // namespace
}  // namespace thenar
