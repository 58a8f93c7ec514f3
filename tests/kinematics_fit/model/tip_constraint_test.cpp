// Tests for kinematics_fit/model/tip_constraint.h and orthogonal_solve.h: nearly straight fingers
// against the same formulas in extended precision.

#include "kinematics_fit/model/tip_constraint.h"

#include <gtest/gtest.h>

#include "tests/kinematics_fit/fit_samples.h"
#include "tests/kinematics_fit/model/tip_force_map.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;

MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, std::mt19937& rng) {
  return sample::normal(rows * columns, rng).reshaped(rows, columns);
}

TEST(OrthogonalSolve, IsExactWhereTheMatrixIsSquare) {
  std::mt19937 rng(1);
  const MatrixXd A = random_matrix(4, 4, rng), x = random_matrix(4, 6, rng);
  EXPECT_TRUE(matrix_near(solve_least_squares(A, MatrixXd(A * x)), x, 1e-12));
  EXPECT_TRUE(matrix_near(solve_least_norm(A, MatrixXd(A * x)), x, 1e-12));
}

// The residual of a least-squares solution is normal to all columns.
TEST(OrthogonalSolve, LeavesAResidualThatNoColumnCanLessen) {
  std::mt19937 rng(2);
  const MatrixXd A = random_matrix(6, 4, rng), B = random_matrix(6, 3, rng);
  const MatrixXd x = solve_least_squares(A, B);
  EXPECT_TRUE(matrix_near(A.transpose() * (A * x - B), MatrixXd::Zero(4, 3), 1e-12));
}

// The least solution lies in the span of the rows: x = A' y for some y.
TEST(OrthogonalSolve, TakesTheLeastOfAllSolutions) {
  std::mt19937 rng(3);
  const MatrixXd A = random_matrix(4, 6, rng), B = random_matrix(4, 3, rng);
  const MatrixXd x = solve_least_norm(A, B);
  EXPECT_TRUE(matrix_near(A * x, B, 1e-12));
  const MatrixXd y = (A * A.transpose()).inverse() * (A * x);
  EXPECT_TRUE(matrix_near(A.transpose() * y, x, 1e-12));
}

/// How a fingertip is held, and the length that weighs out-of-plane moments [m].
struct HeldCase {
  const char* name;
  TipConstraint hold;
  double out_of_plane;
};

void PrintTo(const HeldCase& held, std::ostream* out) { *out << held.name; }

/// Force per tension of the published middle finger, both interphalangeal joints bent by `angle`.
template <typename T>
MatrixX<T> force_map_at(double angle, const HeldCase& held) {
  static const TendonDigit finger = sample::middle_finger("").digit;
  const TendonModel<T> digit = cast_model<T>(finger.model, 0).digit;
  const VectorX<T> q =
      posture(finger.skeleton, {{"MCP3_FE", 0.3}, {"PIP3", angle}, {"DIP3", angle}}).cast<T>();
  return tip_force_map(digit, pose_tree(digit.tree, q), q, held.hold, DecidedForces::kInSpace,
                       T(held.out_of_plane));
}

class NearlyStraight : public testing::TestWithParam<HeldCase> {};

// The condition of the loads is about 1 / bend: an orthogonal method loses that many digits of
// the 16 at most, normal equations twice as many.
TEST_P(NearlyStraight, ForceKeepsTheDigitsThatItsPostureAllows) {
  for (const double bend : {1e-2, 1e-4, 1e-6, 1e-8}) {  // [rad]
    const MatrixX<long double> exact = force_map_at<long double>(bend, GetParam());
    const MatrixXd error =
        (force_map_at<double>(bend, GetParam()).cast<long double>() - exact).cast<double>();
    const double relative = error.norm() / static_cast<double>(exact.norm());
    EXPECT_LT(relative, 1e-15 / bend) << "bend " << bend;
    RecordProperty(fmt::format("bend_{:.0e}", bend), fmt::format("{:.1e}", relative));
  }
}

INSTANTIATE_TEST_SUITE_P(Holds, NearlyStraight,
                         testing::Values(HeldCase{"LeastSquares", TipConstraint::kPinned, 0},
                                         HeldCase{"Exact", TipConstraint::kRigid, 0},
                                         HeldCase{"LeastNorm", TipConstraint::kRigid, 0.039}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace thenar
