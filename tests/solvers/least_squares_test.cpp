// Tests for solvers/least_squares.cpp and the solvers behind it.

#include "solvers/least_squares.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/numbers.h"
#include "kinematics_fit/fit_residuals.h"
#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

class EveryMethod : public testing::TestWithParam<LeastSquaresMethod> {
 protected:
  SolveOptions options() const {
    SolveOptions options;
    options.method = GetParam();
    return options;
  }
};

INSTANTIATE_TEST_SUITE_P(Solvers, EveryMethod,
                         testing::Values(LeastSquaresMethod::kCeres,
                                         LeastSquaresMethod::kNloptLocal,
                                         LeastSquaresMethod::kNloptGlobal,
                                         LeastSquaresMethod::kIpopt),
                         [](const auto& test) {
                           std::string name = name_of(test.param);
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

/// r = (z - target), plainly.
LeastSquares distance_to(const VectorXd& target, double lower, double upper) {
  LeastSquares problem;
  problem.lower = VectorXd::Constant(target.size(), lower);
  problem.upper = VectorXd::Constant(target.size(), upper);
  problem.residuals = [target](const VectorXd& z, WithJacobian) {
    return Residuals{z - target, Eigen::MatrixXd::Identity(z.size(), z.size())};
  };
  return problem;
}

/// Rosenbrock's valley, 1/2 (100 (y - x^2)^2 + (1 - x)^2), with its least value at (1, 1).
LeastSquares valley() {
  LeastSquares problem;
  problem.lower = Vector2d(-5, -5);
  problem.upper = Vector2d(5, 5);
  problem.residuals = [](const VectorXd& z, WithJacobian) {
    Residuals out{Vector2d(10 * (z[1] - z[0] * z[0]), 1 - z[0]), Eigen::MatrixXd(2, 2)};
    out.J << -20 * z[0], 10, -1, 0;
    return out;
  };
  return problem;
}

// A search without derivatives that may stop when the cost falls by 3 % does so half-way along the
// valley, and calls it success.
TEST(Solve, DoesNotBelieveASolverThatStopsShort) {
  SolveOptions options;
  options.method = LeastSquaresMethod::kNloptLocal;
  options.tolerance = 0.03;
  const Solution fit = solve(valley(), Vector2d(-1.2, 1), options);
  ASSERT_GT((fit.z - Vector2d(1, 1)).norm(), 0.5) << "it went all the way";
  EXPECT_EQ(fit.status, Status::kStalled) << fit.message;
  // The step left, by hand: J is square, so that the Gauss-Newton step takes r to zero.
  EXPECT_NEAR(fit.newton_step, std::sqrt(2 * fit.cost), 1e-9);
}

TEST(Solve, CertifiesWhatHasConverged) {
  const Solution fit = solve(valley(), Vector2d(-1.2, 1));
  EXPECT_EQ(fit.status, Status::kSolved) << fit.message;
  EXPECT_LT(fit.newton_step, 1e-3);
  EXPECT_TRUE(matrix_near(fit.z, Vector2d(1, 1), 1e-4));
}

// r = (x + 1, L x^2 + x - 1) in each coordinate, with its least value 1 at x = 0: J'J = 2 there,
// and the curvature of r takes L 2 of it away, so that plain Gauss-Newton steps shrink by L alone.
TEST(Solve, TakesFewStepsWhereResidualsStayLarge) {
  const Eigen::VectorXd L = Eigen::VectorXd::LinSpaced(6, 0.5, 0.97);
  LeastSquares problem;
  problem.lower = VectorXd::Constant(6, -kInfinity);
  problem.upper = VectorXd::Constant(6, kInfinity);
  problem.residuals = [L](const VectorXd& z, WithJacobian) {
    Residuals out{VectorXd(12), Eigen::MatrixXd::Zero(12, 6)};
    out.r << z.array() + 1, L.array() * z.array().square() + z.array() - 1;
    out.J.topRows<6>().setIdentity();
    out.J.bottomRows<6>() = VectorXd(2 * L.array() * z.array() + 1).asDiagonal();
    return out;
  };
  SolveOptions options;
  options.tolerance = 1e-14;
  const Solution fit = solve(problem, VectorXd::Constant(6, 0.3), options);
  EXPECT_EQ(fit.status, Status::kSolved) << fit.message;
  EXPECT_TRUE(matrix_near(fit.z, VectorXd::Zero(6), 1e-5)) << fit.z.transpose();
  EXPECT_NEAR(fit.cost, 6, 1e-9);
  EXPECT_LT(fit.evaluations, 60);  // by plain steps log(1e-6) / log(0.97) = 450
}

TEST_P(EveryMethod, RespectsBounds) {
  const LeastSquares problem = distance_to(Vector2d(3, 0.2), -1, 1);
  const Solution fit = solve(problem, VectorXd::Zero(2), options());
  EXPECT_EQ(fit.status, Status::kSolved) << fit.message;
  EXPECT_TRUE(matrix_near(fit.z, Vector2d(1, 0.2), 1e-4));
  EXPECT_LE(fit.z.maxCoeff(), 1 + 1e-7);  // Ipopt relaxes bounds by 1e-8 of themselves
  EXPECT_NEAR(fit.cost, 2, 1e-6);
}

/// x <= 1, asked `times` times over.
void cap_first(LeastSquares& problem, int times) {
  const Eigen::Index n = problem.lower.size();
  problem.c_lower = VectorXd::Constant(times, -10);
  problem.c_upper = VectorXd::Constant(times, 1);
  problem.constraints = [times, n](const VectorXd& z) {
    ConstraintValues out{VectorXd::Constant(times, z[0]), Eigen::MatrixXd::Zero(times, n)};
    out.C.col(0).setOnes();
    return out;
  };
}

// Bounds of a coordinate in large units lie close together; that does not hold it.
TEST(Solve, MovesWithinNarrowBounds) {
  constexpr double kUnit = 1e7;  // of the coordinate
  LeastSquares problem;
  problem.lower = VectorXd::Zero(1);
  problem.upper = VectorXd::Constant(1, 1 / kUnit);
  problem.residuals = [](const VectorXd& z, WithJacobian) {
    const double x = kUnit * z[0];
    Residuals out{Vector2d(100 * (x * x - 0.25), 10), Eigen::MatrixXd(2, 1)};
    out.J << 200 * x * kUnit, 0;
    return out;
  };
  const VectorXd start = VectorXd::Constant(1, 0.9 / kUnit);
  EXPECT_NEAR(kUnit * solve(problem, start).z[0], 0.5, 1e-6);
  SolveOptions once;
  once.max_evaluations = 1;
  const Solution early = solve(problem, start, once);
  const double x = kUnit * early.z[0];
  ASSERT_GT(x, 0.51) << "it went all the way";
  // The step left, by hand: the first residual, which alone depends on z.
  EXPECT_NEAR(early.newton_step, 100 * (x * x - 0.25), 1e-9);
}

TEST(Solve, CertifiesWhereMoreConstraintsAreActiveThanCoordinatesFree) {
  LeastSquares problem = distance_to(VectorXd::Constant(1, 3), -5, 5);
  cap_first(problem, 2);
  SolveOptions options;
  options.method = LeastSquaresMethod::kIpopt;
  const Solution fit = solve(problem, VectorXd::Zero(1), options);
  EXPECT_EQ(fit.status, Status::kSolved) << fit.message;
  EXPECT_NEAR(fit.z[0], 1, 1e-5);
  EXPECT_EQ(fit.newton_step, 0);
}

// At (1, -1) the constraint x <= 1 holds x, so that a step of 1.2 along y is left.
TEST(Solve, CountsAConstraintOnceThatIsAskedTwice) {
  for (int times = 1; times <= 3; ++times) {
    LeastSquares problem = distance_to(Vector2d(3, 0.2), -kInfinity, kInfinity);
    cap_first(problem, times);
    SolveOptions options;
    options.method = LeastSquaresMethod::kIpopt;
    options.progress.stop_requested = [] { return true; };
    const Solution start = solve(problem, Vector2d(1, -1), options);
    ASSERT_TRUE(matrix_near(start.z, Vector2d(1, -1), 1e-12)) << start.message;
    EXPECT_NEAR(start.newton_step, 1.2, 1e-12) << times;
  }
}

// The free minimum (3, 0.2) breaks x <= 1; (0.5, 0.2) does not.
TEST_P(EveryMethod, SolvesNothingWhereAConstraintIsBroken) {
  LeastSquares problem = distance_to(Vector2d(3, 0.2), -5, 5);
  cap_first(problem, 1);
  const Solution fit = solve(problem, VectorXd::Zero(2), options());
  const bool keeps = GetParam() == LeastSquaresMethod::kIpopt;
  EXPECT_EQ(fit.status, keeps ? Status::kSolved : Status::kStalled) << fit.message;
  EXPECT_NEAR(fit.z[0], keeps ? 1 : 3, 1e-4);
  EXPECT_EQ(fit.message.find("; breaks 1 of 1 constraints") == std::string::npos, keeps)
      << fit.message;
  problem = distance_to(Vector2d(0.5, 0.2), -5, 5);
  cap_first(problem, 1);
  const Solution within = solve(problem, VectorXd::Zero(2), options());
  EXPECT_EQ(within.status, Status::kSolved) << within.message;
}

// Equal bounds hold everything where x <= 1 is broken.
TEST_P(EveryMethod, SolvesNothingWhereBoundsHoldItOutsideAConstraint) {
  LeastSquares problem = distance_to(Vector2d(3, 0.2), 2, 2);
  cap_first(problem, 1);
  EXPECT_EQ(solve(problem, Vector2d(2, 2), options()).status, Status::kStalled);
}

/// The same residuals, without their Jacobian.
LeastSquares without_jacobian(LeastSquares problem) {
  problem.residuals = [exact = problem.residuals](const VectorXd& z, WithJacobian) {
    return Residuals{exact(z, WithJacobian::kNo).r, {}};
  };
  return problem;
}

TEST(Solve, CertifiesByDifferencesWithoutAJacobian) {
  SolveOptions options;
  options.method = LeastSquaresMethod::kNloptLocal;
  options.tolerance = 0.03;  // stops half-way along the valley
  const Solution half = solve(without_jacobian(valley()), Vector2d(-1.2, 1), options);
  EXPECT_EQ(half.status, Status::kStalled) << half.message;
  EXPECT_NEAR(half.newton_step, std::sqrt(2 * half.cost), 1e-6);
  options.tolerance = 1e-8;
  const LeastSquares bowl = without_jacobian(distance_to(Vector2d(0.5, 0.2), -1, 1));
  const Solution all = solve(bowl, VectorXd::Zero(2), options);
  EXPECT_EQ(all.status, Status::kSolved) << all.message;
  EXPECT_LT(all.newton_step, 0.01);
}

// Residuals are asked at no point outside the bounds, where they would be NaN.
TEST(Solve, TakesDifferencesWithinTheBounds) {
  LeastSquares problem = without_jacobian(distance_to(Vector2d(3, 0.2), -1, 1));
  problem.residuals = [within = problem.residuals](const VectorXd& z, WithJacobian want) {
    Residuals out = within(z, want);
    if (z.cwiseAbs().maxCoeff() > 1 + 1e-9) out.r.setConstant(NAN);
    return out;
  };
  SolveOptions options;
  options.method = LeastSquaresMethod::kNloptLocal;
  const Solution fit = solve(problem, VectorXd::Zero(2), options);
  EXPECT_EQ(fit.status, Status::kSolved) << fit.message;
  EXPECT_TRUE(matrix_near(fit.z, Vector2d(1, 0.2), 1e-4));
}

TEST(Solve, RefusesToSearchByDerivativesThatAreMissing) {
  SolveOptions options;
  for (const auto method : {LeastSquaresMethod::kCeres, LeastSquaresMethod::kIpopt}) {
    options.method = method;
    EXPECT_EQ(message_of<InputError>(
                  [&] { (void)solve(without_jacobian(valley()), Vector2d(-1.2, 1), options); }),
              name_of(method) + " needs the Jacobian of the residuals by 2 coordinates");
  }
}

TEST(Solve, RefusesShapesThatDisagree) {
  const auto refusal = [](const LeastSquares& problem) {
    return message_of<InputError>([&] { (void)solve(problem, VectorXd::Zero(2)); });
  };
  const LeastSquares plain = distance_to(Vector2d(0.5, 0.2), -1, 1);
  LeastSquares wrong = plain;
  wrong.residuals = {};
  EXPECT_EQ(refusal(wrong), "least squares need residuals");
  wrong = plain;
  wrong.upper = VectorXd::Ones(3);
  EXPECT_EQ(refusal(wrong), "there are 2 lower bounds, but 3 upper ones");
  wrong = plain;
  cap_first(wrong, 2);
  wrong.c_upper = VectorXd::Ones(1);
  EXPECT_EQ(refusal(wrong), "constraints have 2 lower bounds, but 1 upper ones");
  wrong.c_lower = VectorXd::Zero(1);
  EXPECT_EQ(refusal(wrong), "1 bounds of constraints, but 2 values and a Jacobian of 2 x 2");
  wrong.c_lower[0] = 2;
  EXPECT_EQ(refusal(wrong), "bounds 2 .. 1 of constraint 0 are crossed");
  wrong.c_lower[0] = 0;
  wrong.constraints = {};
  EXPECT_EQ(refusal(wrong), "1 constraints are bounded but no function computes them");
  wrong = plain;
  wrong.layout = {1, 1, 2};
  wrong.parts = {{-1, plain.residuals}};
  EXPECT_EQ(refusal(wrong), "the blocks have 3 coordinates, the bounds 2");
  wrong.layout.blocks = 1;
  wrong.parts[0].block = 1;
  EXPECT_EQ(refusal(wrong), "no block 1: there are 1");
}

TEST_P(EveryMethod, BringsTheStartWithinBounds) {
  const LeastSquares problem = distance_to(Vector2d(0.5, 0.2), -1, 1);
  const Solution fit = solve(problem, Vector2d(50, -50), options());
  EXPECT_TRUE(matrix_near(fit.z, Vector2d(0.5, 0.2), 1e-4));
}

TEST_P(EveryMethod, StartsFarAwayWhereNothingBoundsIt) {
  const LeastSquares problem = distance_to(Vector2d(0.5, 0.2), -kInfinity, kInfinity);
  const Solution fit = solve(problem, Vector2d(50, -50), options());
  EXPECT_EQ(fit.status, Status::kSolved) << fit.message;
  EXPECT_TRUE(matrix_near(fit.z, Vector2d(0.5, 0.2), 1e-4));
}

TEST_P(EveryMethod, StaysOutOfNonsense) {
  LeastSquares problem = distance_to(Vector2d(0.5, 0.2), -2, 2);
  problem.residuals = [plain = problem.residuals](const VectorXd& z, WithJacobian want) {
    Residuals out = plain(z, want);
    if (z[0] > 1) out.r.setConstant(std::numeric_limits<double>::quiet_NaN());
    return out;
  };
  const Solution fit = solve(problem, Vector2d(-1, 1), options());
  EXPECT_TRUE(std::isfinite(fit.cost));
  EXPECT_TRUE(matrix_near(fit.z, Vector2d(0.5, 0.2), 1e-4)) << fit.message;
}

TEST_P(EveryMethod, HoldsWhatBoundsPin) {
  LeastSquares problem = distance_to(Eigen::Vector3d(3, 0.2, 1), -1, 1);
  problem.lower[2] = problem.upper[2] = 0.5;
  const Solution fit = solve(problem, VectorXd::Zero(3), options());
  EXPECT_EQ(fit.status, Status::kSolved) << fit.message;
  EXPECT_TRUE(matrix_near(fit.z, Eigen::Vector3d(1, 0.2, 0.5), 1e-4));
  problem.lower = problem.upper = Eigen::Vector3d(0.1, 0.2, 0.3);
  const Solution pinned = solve(problem, VectorXd::Zero(3), options());
  EXPECT_EQ(pinned.status, Status::kSolved) << pinned.message;
  EXPECT_EQ(pinned.z, problem.lower);
}

TEST_P(EveryMethod, FitsIntoNarrowBounds) {
  LeastSquares problem = distance_to(Vector2d(0.2, 0.2), -1, 1);
  problem.lower[0] = -0.01;
  problem.upper[0] = 0.01;
  const Solution fit = solve(problem, VectorXd::Zero(2), options());
  EXPECT_EQ(fit.status, Status::kSolved) << fit.message;
  EXPECT_TRUE(matrix_near(fit.z, Vector2d(0.01, 0.2), 1e-4));
}

TEST(LeastSquares, IpoptHeedsTheTolerance) {
  const FitProblem problem =
      sample::middle_finger("[[parameter]]\nmatch='axis/*/direction/*'\nstate='free'\n").problem();
  SolveOptions options;
  options.method = LeastSquaresMethod::kIpopt;
  options.tolerance = 1e-2;
  const Solution rough = solve(least_squares(problem), VectorXd::Zero(problem.size()), options);
  options.tolerance = 1e-10;
  const Solution fine = solve(least_squares(problem), VectorXd::Zero(problem.size()), options);
  EXPECT_LT(rough.evaluations, fine.evaluations);
}

const char* const kFewFree = R"(
[[parameter]]
match = "axis/*/direction/*"
state = "free"
sd_deg = 0
between_sd_deg = 4
)";

TEST_P(EveryMethod, ReachesTheSameCostOnAFinger) {
  const FitProblem problem = sample::middle_finger(kFewFree).problem();
  const VectorXd start = VectorXd::Zero(problem.size());
  SolveOptions exact;
  exact.tolerance = 1e-14;
  const Solution reference = solve(least_squares(problem), start, exact);
  SolveOptions options = this->options();
  options.tolerance = 1e-12;
  const Solution fit = solve(least_squares(problem), start, options);
  EXPECT_NEAR(fit.cost, reference.cost, 1e-6 * reference.cost) << fit.message;
  const VectorXd r = fit_residuals(problem, fit.z, WithJacobian::kNo).r;
  EXPECT_NEAR(fit.cost, 0.5 * r.squaredNorm(), 1e-12 * fit.cost);  // says what it has found
}

TEST_P(EveryMethod, StopRequestReturnsTheBestPointYet) {
  const FitProblem problem = sample::middle_finger(kFewFree).problem();
  int asked = 0;
  SolveOptions options = this->options();
  options.progress.stop_requested = [&] { return ++asked > 2; };
  const VectorXd start = VectorXd::Zero(problem.size());
  const Solution fit = solve(least_squares(problem), start, options);
  EXPECT_EQ(fit.status, Status::kStopped) << fit.message;
  EXPECT_TRUE(fit.z.allFinite());
  EXPECT_TRUE((fit.z.array() >= problem.coordinates().lower().array()).all());
  EXPECT_TRUE((fit.z.array() <= problem.coordinates().upper().array()).all());
  const double before = 0.5 * fit_residuals(problem, start, WithJacobian::kNo).r.squaredNorm();
  EXPECT_LE(fit.cost, before);
  EXPECT_NEAR(fit.cost, 0.5 * fit_residuals(problem, fit.z, WithJacobian::kNo).r.squaredNorm(),
              1e-9);
}

TEST_P(EveryMethod, SaysWhenTheLimitCameFirst) {
  const FitProblem problem = sample::middle_finger(kFewFree).problem();
  SolveOptions options = this->options();
  options.max_evaluations = 2;
  if (GetParam() == LeastSquaresMethod::kNloptLocal ||
      GetParam() == LeastSquaresMethod::kNloptGlobal)
    options.max_evaluations = 30;  // more than its first interpolation needs
  const Solution fit = solve(least_squares(problem), VectorXd::Zero(problem.size()), options);
  EXPECT_EQ(fit.status, Status::kLimit) << fit.message;
}

/// Two valleys at x = -1 and x = 1; the second is deeper.
LeastSquares two_valleys() {
  LeastSquares problem;
  problem.lower = VectorXd::Constant(2, -3);
  problem.upper = VectorXd::Constant(2, 3);
  problem.residuals = [](const VectorXd& z, WithJacobian) {
    Residuals out{Eigen::Vector3d(4 * (z[0] * z[0] - 1), 0.3 * (z[0] - 1), z[1]),
                  Eigen::MatrixXd::Zero(3, 2)};
    out.J << 8 * z[0], 0, 0.3, 0, 0, 1;
    return out;
  };
  return problem;
}

TEST(LeastSquares, OnlyTheGlobalSearchLeavesTheWrongValley) {
  SolveOptions options;
  EXPECT_LT(solve(two_valleys(), Vector2d(-1.2, 0.5), options).z[0], 0);
  options.method = LeastSquaresMethod::kNloptGlobal;
  const Solution global = solve(two_valleys(), Vector2d(-1.2, 0.5), options);
  EXPECT_TRUE(matrix_near(global.z, Vector2d(1, 0), 1e-3));
}

TEST(LeastSquares, GlobalSearchRepeatsItselfForTheSameSeed) {
  SolveOptions options;
  options.method = LeastSquaresMethod::kNloptGlobal;
  options.seed = 7;
  const Solution a = solve(two_valleys(), Vector2d(-1.2, 0.5), options);
  const Solution b = solve(two_valleys(), Vector2d(-1.2, 0.5), options);
  EXPECT_EQ(a.z, b.z);
  EXPECT_EQ(a.evaluations, b.evaluations);
}

TEST(LeastSquares, RefusesAStartThatIsNonsense) {
  LeastSquares problem = distance_to(Vector2d(0, 0), -1, 1);
  EXPECT_THROW((void)solve(problem, VectorXd::Zero(3)), InputError);
  EXPECT_THROW((void)solve(problem, Vector2d(0, NAN)), InputError);
  problem.residuals = [](const VectorXd&, WithJacobian) {
    return Residuals{VectorXd::Constant(1, NAN), {}};
  };
  try {
    (void)solve(problem, VectorXd::Zero(2));
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "residuals at the start are not finite");
  }
}

TEST(LeastSquares, HasAWordForEachEndOfASearch) {
  Solution solution;
  EXPECT_EQ(convergence_word(solution), "not stationary");
  solution.failed = true;
  EXPECT_EQ(convergence_word(solution), "failed");
  solution.failed = false;
  for (const auto& [status, word] :
       {std::pair(Status::kSolved, "converged"), std::pair(Status::kLimit, "limit reached"),
        std::pair(Status::kStopped, "stopped")}) {
    solution.status = status;
    EXPECT_EQ(convergence_word(solution), word);
  }
}

TEST(LeastSquares, MethodsHaveNames) {
  for (const char* name : {"ceres", "nlopt", "nlopt-global", "ipopt"})
    EXPECT_EQ(name_of(least_squares_method(name)), name);
  try {
    (void)least_squares_method("newton");
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "no fit method 'newton'; there are ceres, nlopt, nlopt-global, ipopt");
  }
}

// -- Kinks ------------------------------------------------------------------------------------

/// r = (1 + |y - x^2 / 4|, x - 3, y / 10): the cost has its minimum in the bend of a kink.
LeastSquares bent_kink() {
  LeastSquares problem;
  problem.lower = Vector2d(-9, -9);
  problem.upper = Vector2d(9, 9);
  problem.residuals = [](const VectorXd& z, WithJacobian) {
    const double off = z[1] - z[0] * z[0] / 4, side = off < 0 ? -1 : 1;
    Residuals out{Eigen::Vector3d(1 + std::abs(off), z[0] - 3, z[1] / 10), Eigen::MatrixXd(3, 2)};
    out.J << -side * z[0] / 2, side, 1, 0, 0, 0.1;
    return out;
  };
  return problem;
}

// Along the kink y = x^2 / 4 the cost is 1/2 (1 + (x - 3)^2 + x^4 / 1600), least where
// x - 3 + x^3 / 800 = 0; across it, the slope of the third residual, y / 100, is less than the
// jump.
TEST(Kinks, AreWhereAFitMayEnd) {
  double x = 3;
  for (int i = 0; i < 20; ++i) x -= (x - 3 + x * x * x / 800) / (1 + 3 * x * x / 800);
  for (const Vector2d& start : {Vector2d(0, 0), Vector2d(5, 1), Vector2d(1, 6)}) {
    const Solution solution = solve(bent_kink(), start);
    EXPECT_EQ(solution.status, Status::kSolved) << solution.message;
    EXPECT_GE(solution.kink_sides, 2);
    // 3e-3 sds may be left, of 1 / sqrt(1 + ..) along the kink; sides are 1e-3 sds apart.
    EXPECT_TRUE(matrix_near(solution.z, Vector2d(x, x * x / 4), 1e-2)) << solution.message;
    EXPECT_NEAR(solution.cost, 0.5 * (1 + (x - 3) * (x - 3) + std::pow(x, 4) / 1600), 1e-3);
  }
}

// A kink across which the cost falls on is no end: r = (y + |y| / 2 - 1, x).
TEST(Kinks, AreCrossedWhereTheCostFallsOn) {
  LeastSquares problem;
  problem.lower = Vector2d(-9, -9);
  problem.upper = Vector2d(9, 9);
  problem.residuals = [](const VectorXd& z, WithJacobian) {
    const double side = z[1] < 0 ? -0.5 : 0.5;
    Residuals out{Vector2d(z[1] * (1 + side) - 1, z[0]), Eigen::MatrixXd(2, 2)};
    out.J << 0, 1 + side, 1, 0;
    return out;
  };
  const Solution solution = solve(problem, Vector2d(2, -3));
  EXPECT_EQ(solution.status, Status::kSolved) << solution.message;
  EXPECT_EQ(solution.kink_sides, 1);
  EXPECT_TRUE(matrix_near(solution.z, Vector2d(0, 2.0 / 3), 1e-4));
}

}  // namespace
}  // namespace thenar
