// Tests for tendons/forces/feasible_force_set.cpp.

#include "tendons/forces/feasible_force_set.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "base/error.h"
#include "base/numbers.h"
#include "tendons/forces/max_tip_force.h"
#include "tests/matrix_near.h"
#include "tests/tendons/published_index.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

TipStatics statics_of(const MatrixXd& A, const VectorXd& F0) {
  return statics_from_matrix(A, Eigen::Matrix3Xd(3, 0), F0);
}

MatrixXd random_matrix(Index rows, Index cols, std::mt19937& rng) {
  std::uniform_real_distribution<double> entry(-1, 1);
  return MatrixXd::NullaryExpr(rows, cols, [&] { return entry(rng); });
}

// Volume of the zonotope sum [0, 1] g_i: the sum of |det| over all triples of generators
// [Shephard1974].
double zonotope_volume(const MatrixXd& g) {
  double volume = 0;
  for (Index i = 0; i < g.cols(); ++i)
    for (Index j = i + 1; j < g.cols(); ++j)
      for (Index k = j + 1; k < g.cols(); ++k)
        volume += std::abs(g.col(i).head<3>().cross(g.col(j).head<3>()).dot(g.col(k).head<3>()));
  return volume;
}

TEST(FeasibleForceSet, OrthogonalTendonsMakeABox) {
  const FeasibleForceSet set =
      feasible_force_set(statics_of(MatrixXd::Identity(3, 3), Vector3d(2, 3, 5)));
  EXPECT_EQ(set.status, Status::kSolved);
  EXPECT_EQ(set.dimension, 3);
  EXPECT_EQ(set.vertices.rows(), 8);
  EXPECT_EQ(set.normals.rows(), 6);
  EXPECT_EQ(set.triangles.rows(), 12);
  EXPECT_NEAR(set.volume, 30, 1e-12);
}

TEST(FeasibleForceSet, FourTendonsMakeTheZonotopeOfTheTriples) {
  MatrixXd A(3, 4);
  A << 1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1;
  const VectorXd F0 = Eigen::Vector4d(1, 2, 3, 4);
  const FeasibleForceSet set = feasible_force_set(statics_of(A, F0));
  EXPECT_NEAR(set.volume, zonotope_volume(A * F0.asDiagonal()), 1e-11);  // 6 + 8 + 12 + 24 = 50
  EXPECT_EQ(set.vertices.rows(), 14);  // a rhombic dodecahedron, stretched
  EXPECT_EQ(set.normals.rows(), 12);
}

// A width near the flatness limit may count as flat or not, but the question must end. Beside a
// size of order one the last row has a width of 4/3 of epsilon.
TEST(FeasibleForceSet, EndsWhereAWidthIsNearTheLimitOfFlat) {
  for (double epsilon = 0.5e-9; epsilon < 4e-9; epsilon += 0.02e-9) {
    MatrixXd A(3, 4);
    A << 1, 0, -1, 0.3, 0, 1, -0.5, -1, epsilon, 0, 0, -epsilon / 3;
    const FeasibleForceSet set = feasible_force_set(statics_of(A, VectorXd::Ones(4)));
    EXPECT_TRUE(set.status == Status::kSolved || set.status == Status::kStalled);
    EXPECT_GE(set.dimension, 2) << epsilon;
  }
}

// A zonotope of n generators in general position has n (n - 1) facets and n (n - 1) + 2 vertices.
TEST(FeasibleForceSet, CountsFacetsOfGeneralZonotopes) {
  std::mt19937 rng(1);
  for (const int m : {5, 7, 10}) {
    const MatrixXd A = random_matrix(3, m, rng);
    const FeasibleForceSet set = feasible_force_set(statics_of(A, VectorXd::Ones(m)));
    EXPECT_EQ(set.normals.rows(), m * (m - 1));
    EXPECT_EQ(set.vertices.rows(), m * (m - 1) + 2);
    EXPECT_NEAR(set.volume, zonotope_volume(A), 1e-10 * set.volume);
  }
}

TEST(FeasibleForceSet, TwinMusclesAddNoCorners) {
  MatrixXd A(3, 5);
  A << 1, 0, 0, 1, 2, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0;  // three muscles pull along x
  const FeasibleForceSet set = feasible_force_set(statics_of(A, VectorXd::Ones(5)));
  EXPECT_EQ(set.vertices.rows(), 8);
  EXPECT_NEAR(set.volume, 4, 1e-12);
}

// All forces at tensions where n - 3 torques vanish and m - (n - 3) tensions stand at a bound.
std::vector<Vector3d> enumerated_vertices(const TipStatics& s) {
  const Index m = s.R.rows(), n = s.R.cols(), extra = n - 3;
  const Eigen::FullPivLU<MatrixXd> lu(s.J);
  const MatrixXd N = lu.kernel().leftCols(extra);  // J N = 0: torques no force balances  (n, n - 3)
  const MatrixXd E = N.transpose() * s.R.transpose();
  const VectorXd e = -N.transpose() * s.tau_0;
  std::vector<Vector3d> found;
  for (int code = 0; code < static_cast<int>(std::pow(3, m)); ++code) {
    VectorXd t = VectorXd::Zero(m);
    std::vector<Index> open;
    for (Index i = 0, rest = code; i < m; ++i, rest /= 3) {
      if (rest % 3 == 2) open.push_back(i);
      if (rest % 3 == 1) t(i) = s.max_tension(i);
    }
    if (static_cast<Index>(open.size()) != extra) continue;
    MatrixXd B(extra, extra);
    for (Index k = 0; k < extra; ++k) B.col(k) = E.col(open[static_cast<std::size_t>(k)]);
    const VectorXd x = extra > 0 ? VectorXd(B.fullPivLu().solve(e - E * t)) : VectorXd(0);
    for (Index k = 0; k < extra; ++k) t(open[static_cast<std::size_t>(k)]) = x(k);
    if ((t.array() < -1e-9).any() || (t.array() > s.max_tension.array() + 1e-9).any()) continue;
    found.emplace_back(s.J.transpose().colPivHouseholderQr().solve(s.R.transpose() * t + s.tau_0));
  }
  return found;
}

TipStatics random_finger(int joints, int muscles, std::mt19937& rng) {
  TipStatics s;
  s.J = 0.05 * random_matrix(3, joints, rng);
  s.R = 0.01 * random_matrix(muscles, joints, rng);
  s.tau_0 = 0.01 * random_matrix(joints, 1, rng);
  s.max_tension = 60 * VectorXd::Ones(muscles) + 40 * random_matrix(muscles, 1, rng);
  return s;
}

class RandomFinger : public testing::TestWithParam<int> {};

TEST_P(RandomFinger, HullIsThatOfEnumeratedVertices) {
  std::mt19937 rng(static_cast<unsigned>(GetParam()));
  const TipStatics statics = random_finger(3 + GetParam() % 3, 7, rng);
  const FeasibleForceSet set = feasible_force_set(statics);
  const std::vector<Vector3d> enumerated = enumerated_vertices(statics);
  ASSERT_EQ(set.status == Status::kSolved, !enumerated.empty());
  if (enumerated.empty()) return;
  ASSERT_EQ(set.dimension, 3);
  const double size = set.vertices.cwiseAbs().maxCoeff();

  // Every enumerated point is inside, and every vertex is one of them.
  VectorXd nearest = VectorXd::Constant(set.vertices.rows(), kInfinity);
  for (const Vector3d& f : enumerated) {
    EXPECT_LE((set.normals * f - set.offsets).maxCoeff(), 1e-8 * size);
    nearest = nearest.cwiseMin((set.vertices.rowwise() - f.transpose()).rowwise().norm());
  }
  EXPECT_LE(nearest.maxCoeff(), 1e-9 * size);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomFinger, testing::Range(1, 31));

TEST(FeasibleForceSet, VerticesAreMadeByTheirTensions) {
  const TipStatics statics = published_index();
  const FeasibleForceSet set = feasible_force_set(statics);
  const MatrixXd left = set.vertices * statics.J - set.tension * statics.R;
  EXPECT_LT(left.cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_GE(set.activation.minCoeff(), 0);
  EXPECT_LE(set.activation.maxCoeff(), 1);
}

TEST(FeasibleForceSet, HoldsTheLargestForceOnItsSurface) {
  const FeasibleForceSet set = feasible_force_set(published_index());
  const Vector3d f = max_tip_force(published_index(), Vector3d(1, 0, 0)).force;
  EXPECT_NEAR((set.normals * f - set.offsets).maxCoeff(), 0, 1e-10);
}

TEST(FeasibleForceSet, EulerCountsHold) {  // a closed surface: V - E + F = 2 with E = 3 F / 2
  const FeasibleForceSet set = feasible_force_set(published_index());
  EXPECT_EQ(set.triangles.rows(), 2 * set.vertices.rows() - 4);
}

// Planar straight-free finger: links 0.04 and 0.03 m at a right angle, motion in x and y only.
TipStatics planar_finger() {
  TipStatics s;
  s.J = MatrixXd::Zero(3, 2);
  s.J.row(0) << -0.03, -0.03;
  s.J.row(1) << 0.04, 0;
  s.R = (MatrixXd(4, 2) << 0.01, 0, -0.01, 0, 0, 0.01, 0, -0.01).finished();
  s.tau_0 = VectorXd::Zero(2);
  s.max_tension = VectorXd::Constant(4, 100);
  return s;
}

// Torques fill the square [-1, 1]^2 N m; area of forces is 4 / |det J| = 4 / (0.03 * 0.04).
TEST(FeasibleForceSet, PlanarFingerMakesAPolygonAndCarriesTheRest) {
  const FeasibleForceSet set = feasible_force_set(planar_finger());
  EXPECT_EQ(set.dimension, 2);
  EXPECT_EQ(set.vertices.rows(), 4);
  EXPECT_NEAR(set.volume, 4 / (0.03 * 0.04), 1e-8);
  ASSERT_EQ(set.carried.cols(), 1);
  EXPECT_NEAR(std::abs(set.carried(2, 0)), 1, 1e-14);
}

TEST(FeasibleForceSet, StraightFingerMakesASegment) {
  TipStatics statics = planar_finger();
  statics.J.row(0).setZero();
  statics.J.row(1) << 0.07, 0.03;
  const FeasibleForceSet set = feasible_force_set(statics);
  EXPECT_EQ(set.dimension, 1);
  EXPECT_NEAR(set.volume, 2 / 0.07, 1e-12);  // +- 1 N m at the base joint
  EXPECT_EQ(set.carried.cols(), 2);
}

TEST(FeasibleForceSet, MapWithoutARowIsFlatAndCarriesNothing) {
  MatrixXd A = MatrixXd::Zero(3, 3);
  A.topRows<2>() << 1, 0, 1, 0, 1, 1;
  const FeasibleForceSet set = feasible_force_set(statics_of(A, Vector3d(1, 2, 3)));
  EXPECT_EQ(set.dimension, 2);
  EXPECT_EQ(set.vertices.rows(), 6);
  EXPECT_NEAR(set.volume, 2 + 3 + 6, 1e-12);  // the sum of |det| of pairs
  EXPECT_EQ(set.carried.cols(), 0);
}

// Three muscles on four joints, one of which only tendons load: t_3 = t_1 + t_2 and t_3 <= 1 leave
// the triangle 0, g_1 + g_3, g_2 + g_3, here (1,0,1) and (0,1,1), of area sqrt(3) / 2.
TEST(FeasibleForceSet, FewMusclesMakeATiltedTriangle) {
  MatrixXd A(4, 3);
  A << 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, -1;
  const FeasibleForceSet set =
      feasible_force_set(statics_from_matrix(A, Vector3d(1, 0, 0), Vector3d(1, 1, 1)));
  EXPECT_EQ(set.dimension, 2);
  EXPECT_EQ(set.vertices.rows(), 3);
  EXPECT_NEAR(set.volume, std::sqrt(3.0) / 2, 1e-12);
}

// The same with random arms: two muscles never make a solid.
TEST(FeasibleForceSet, TwoMusclesMakeAParallelogram) {
  std::mt19937 rng(3);
  for (int trial = 0; trial < 100; ++trial) {
    const MatrixXd A = random_matrix(3, 2, rng);
    const FeasibleForceSet set = feasible_force_set(statics_of(A, Eigen::Vector2d(1, 1)));
    EXPECT_EQ(set.dimension, 2);
    EXPECT_EQ(set.vertices.rows(), 4);
    EXPECT_NEAR(set.volume, A.col(0).head<3>().cross(A.col(1).head<3>()).norm(), 1e-9);
  }
}

TEST(FeasibleForceSet, SlackFingerIsAPoint) {
  TipStatics statics = published_index();
  statics.max_tension.setZero();
  const FeasibleForceSet set = feasible_force_set(statics);
  EXPECT_EQ(set.dimension, 0);
  EXPECT_TRUE(matrix_near(set.vertices, Eigen::RowVector3d(0, 0, 0), 1e-15));
}

TEST(FeasibleForceSet, TorqueNobodyBalancesLeavesItEmpty) {
  TipStatics statics = published_index();
  statics.tau_0(3) = 10;  // [N m], far beyond the 0.4 N m of all tendons together
  const FeasibleForceSet set = feasible_force_set(statics);
  EXPECT_EQ(set.status, Status::kInfeasible);
  EXPECT_EQ(set.dimension, -1);
  EXPECT_EQ(set.vertices.rows(), 0);
}

TEST(FeasibleForceSet, UnknownStrengthIsUnbounded) {
  TipStatics statics = statics_of(MatrixXd::Identity(3, 3), Vector3d(2, kInfinity, 5));
  EXPECT_EQ(feasible_force_set(statics).status, Status::kUnbounded);
}

// Muscle 2 is unlimited but only fights muscle 1 on a joint that no force loads.
TEST(FeasibleForceSet, UnknownStrengthThatIsBalancedIsBounded) {
  MatrixXd A(4, 4);
  A << 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, -1;
  TipStatics statics =
      statics_from_matrix(A, Vector3d(1, 0, 0), Eigen::Vector4d(2, 3, 5, kInfinity));
  EXPECT_NEAR(feasible_force_set(statics).volume, 30, 1e-12);
}

// Stability: a needle 1e6 times longer than wide keeps its volume to full relative precision.
TEST(FeasibleForceSetStability, NeedleOfAspectOneToAMillion) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const FeasibleForceSet set = feasible_force_set(statics_of(turn, Vector3d(1e3, 1e-3, 2e-3)));
  EXPECT_EQ(set.dimension, 3);
  EXPECT_NEAR(set.volume, 2e-3, 1e-8 * 2e-3);
}

// Nearly parallel axes: cond(J) = 4e6, volume is that of the torques over |det J|.
TEST(FeasibleForceSetStability, NearlyParallelAxes) {
  TipStatics s;
  const double e = 1e-6;
  s.J = 0.05 * (MatrixXd(3, 3) << 0, std::sin(e), 0, 1, std::cos(e), 0, 0, 0, 1).finished();
  s.R = 0.01 * (MatrixXd(4, 3) << 1, 0, 0, 0, 1, 0, 0, 0, 1, -1, -1, -1).finished();
  s.tau_0 = VectorXd::Zero(3);
  s.max_tension = VectorXd::Constant(4, 100);
  const FeasibleForceSet set = feasible_force_set(s);
  EXPECT_EQ(set.vertices.rows(), 14);
  const double exact = 4 / (std::pow(0.05, 3) * std::sin(e));  // four triples of |det| = 1 (N m)^3
  EXPECT_NEAR(set.volume, exact, 1e-7 * exact);
}

TEST(FeasibleForceSetStability, TwentyMusclesClose) {
  std::mt19937 rng(7);
  const MatrixXd A = random_matrix(3, 20, rng);
  const FeasibleForceSet set = feasible_force_set(statics_of(A, VectorXd::Ones(20)));
  EXPECT_EQ(set.status, Status::kSolved) << set.message;
  EXPECT_EQ(set.normals.rows(), 380);
}

}  // namespace
}  // namespace thenar
