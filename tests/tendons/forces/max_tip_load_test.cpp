// Tests for tendons/forces/max_tip_load.cpp.

#include "tendons/forces/max_tip_load.h"

#include <cmath>
#include <functional>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "base/error.h"
#include "base/numbers.h"
#include "base/units.h"
#include "data/io/subject.h"
#include "tendons/linear_tendons.h"
#include "tests/matrix_near.h"
#include "tests/tendons/published_index.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// A digit of random arms and Jacobians: 4 joints, 5 tendons.
TipStatics random_digit(std::mt19937& rng) {
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(rng); };
  TipStatics statics;
  statics.J = 0.05 * Eigen::Matrix3Xd::NullaryExpr(3, 4, draw);  // [m/rad]
  statics.W = Eigen::Matrix3Xd::NullaryExpr(3, 4, draw);
  statics.R = 0.01 * MatrixXd::NullaryExpr(5, 4, draw);
  statics.tau_0 = 0.001 * VectorXd::NullaryExpr(4, draw);
  statics.max_tension = 50 * (VectorXd::NullaryExpr(5, draw).cwiseAbs() + VectorXd::Ones(5));
  return statics;
}

/// The largest x(0) of  M x = b,  lower <= x <= upper,  by visiting every basis: each choice of as
/// many columns as rows, the others at one of their bounds (or at 0 if they have none).
double by_enumeration(const MatrixXd& M, const VectorXd& b, const VectorXd& lower,
                      const VectorXd& upper) {
  const Index n = M.rows(), columns = M.cols();
  double best = -kInfinity;
  const auto visit = [&](const std::vector<Index>& basis) {
    std::vector<Index> others;
    MatrixXd square(n, n);
    for (Index i = 0, k = 0; i < columns; ++i) {
      if (k < n && basis[static_cast<std::size_t>(k)] == i)
        square.col(k++) = M.col(i);
      else
        others.push_back(i);
    }
    const Eigen::FullPivLU<MatrixXd> lu(square);
    if (!lu.isInvertible()) return;
    for (unsigned sides = 0; sides < 1U << others.size(); ++sides) {
      VectorXd x = VectorXd::Zero(columns);
      for (std::size_t k = 0; k < others.size(); ++k) {
        const double bound = (sides >> k & 1U) != 0 ? upper(others[k]) : lower(others[k]);
        x(others[k]) = std::isfinite(bound) ? bound : 0;
      }
      const VectorXd basic = lu.solve(b - M * x);
      for (Index k = 0; k < n; ++k) x(basis[static_cast<std::size_t>(k)]) = basic(k);
      const double room = 1e-9;
      if ((x.array() >= lower.array() - room).all() && (x.array() <= upper.array() + room).all())
        best = std::max(best, x(0));
    }
  };
  // All ascending choices of n columns.
  std::vector<Index> basis;
  const std::function<void(Index)> choose = [&](Index from) {
    if (static_cast<Index>(basis.size()) == n) return visit(basis);
    for (Index i = from; i < columns; ++i) {
      basis.push_back(i);
      choose(i + 1);
      basis.pop_back();
    }
  };
  choose(0);
  return best;
}

/// The same question put to by_enumeration(): amount, three other loads, tensions, stops.
double enumerated(const TipStatics& statics, const Vector3d& d, const TipLoadOptions& options) {
  const bool moment = options.load == TipLoad::kMoment;
  const Eigen::Matrix3Xd &A = moment ? statics.W : statics.J, &B = moment ? statics.J : statics.W;
  const Index m = statics.R.rows(), others = options.max_other > 0 ? 3 : 0;
  const auto stops = static_cast<Index>(options.stops.size());
  MatrixXd M(statics.J.cols(), 1 + others + m + stops);
  M << A.transpose() * d, (B.transpose() * options.axes).leftCols(others), -statics.R.transpose(),
      MatrixXd::Zero(statics.J.cols(), stops);
  VectorXd lower = VectorXd::Zero(M.cols()), upper = lower;
  upper(0) = kInfinity;
  lower.segment(1, others).setConstant(-options.max_other);
  upper.segment(1, others).setConstant(options.max_other);
  upper.segment(1 + others, m) = statics.max_tension;
  // A stop turns its joint by itself, one way.
  for (Index k = 0; k < stops; ++k) {
    const JointStop& stop = options.stops[static_cast<std::size_t>(k)];
    M(stop.coordinate, 1 + others + m + k) = stop.max_torque > 0 ? -1 : 1;
    upper(1 + others + m + k) = std::abs(stop.max_torque);
  }
  return by_enumeration(M, statics.tau_0, lower, upper);
}

class OtherLoad : public testing::TestWithParam<std::pair<TipLoad, double>> {};

TEST_P(OtherLoad, LargestAgreesWithEnumerationOfVertices) {
  std::mt19937 rng(7);
  TipLoadOptions options;
  std::tie(options.load, options.max_other) = GetParam();
  options.axes = Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).matrix();
  int solved = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const TipStatics statics = random_digit(rng);
    const Vector3d d = Vector3d(1, trial - 5, 2).normalized();
    const double wanted = enumerated(statics, d, options);
    const MaxTipLoad found = max_tip_load(statics, d, options);
    ASSERT_EQ(found.largest.status, std::isfinite(wanted) ? Status::kSolved : Status::kInfeasible);
    if (!std::isfinite(wanted)) continue;
    ++solved;
    EXPECT_NEAR(found.largest.component, wanted, 1e-9 * std::max(1.0, wanted));
    // What is found is a load that the digit bears, and the certificate says so.
    EXPECT_LE(found.largest.check.imbalance, 1e-10);
    EXPECT_LE(found.largest.check.gap, 1e-9);
    if (std::isfinite(options.max_other)) {
      EXPECT_LE((options.axes.transpose() * found.other).cwiseAbs().maxCoeff(),
                options.max_other + 1e-10);
    }
  }
  EXPECT_GE(solved, 3);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, OtherLoad,
    testing::Values(std::pair(TipLoad::kForce, 0.0), std::pair(TipLoad::kForce, 0.05),
                    std::pair(TipLoad::kForce, kInfinity), std::pair(TipLoad::kMoment, 0.0),
                    std::pair(TipLoad::kMoment, 2.0), std::pair(TipLoad::kMoment, kInfinity)));

// Torques that ligaments give one way, with and without a limit, under every other load.
TEST_P(OtherLoad, StopsAgreeWithEnumerationOfVertices) {
  std::mt19937 rng(7);
  TipLoadOptions options;
  std::tie(options.load, options.max_other) = GetParam();
  options.prices = true;
  options.stops = {{1, 0.2}, {3, -kInfinity}};
  int solved = 0, limited = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const TipStatics statics = random_digit(rng);
    const Vector3d d = Vector3d(1, trial - 5, 2).normalized();
    const double wanted = enumerated(statics, d, options);
    const MaxTipLoad found = max_tip_load(statics, d, options);
    if (found.largest.status != Status::kSolved) continue;
    ++solved;
    EXPECT_NEAR(found.largest.component, wanted, 1e-9 * std::max(1.0, wanted));
    EXPECT_LE(found.largest.check.imbalance, 1e-10);
    EXPECT_LE(found.largest.check.gap, 1e-9 * std::max(1.0, wanted));
    EXPECT_EQ(found.largest.tension.size(), 5);
    // One way, and not further than they go.
    EXPECT_GE(found.stop_torque(0), 0);
    EXPECT_LE(found.stop_torque(0), 0.2 + 1e-12);
    EXPECT_LE(found.stop_torque(1), 0);
    // The price of the limited one is the slope of the load over its limit; the other has none.
    ASSERT_EQ(found.stop_price.size(), 2);
    EXPECT_EQ(found.stop_price(1), 0);
    TipLoadOptions more = options;
    more.stops[0].max_torque += 1e-5;
    EXPECT_NEAR((enumerated(statics, d, more) - wanted) / 1e-5, found.stop_price(0),
                1e-4 * std::max(1.0, found.stop_price(0)));
    limited += found.stop_price(0) > 0 ? 1 : 0;
  }
  EXPECT_GE(solved, 3);
  EXPECT_GE(limited, 1);
}

// A wider cone, and more of the other load, are more to choose from.
TEST(MaxTipLoad, NeverFallsWithMoreToChooseFrom) {
  std::mt19937 rng(3);
  for (int trial = 0; trial < 10; ++trial) {
    const TipStatics statics = random_digit(rng);
    for (const TipLoad load : {TipLoad::kForce, TipLoad::kMoment}) {
      const double unit = load == TipLoad::kForce ? 0.01 : 1;  // of the other load [N m] or [N]
      double last = 0;
      for (const double most : {0.0, unit, 10 * unit, kInfinity}) {
        const MaxTipLoad narrow = max_tip_load(statics, Vector3d(1, 2, 2), {load, 0, most});
        const MaxTipLoad wide = max_tip_load(statics, Vector3d(1, 2, 2), {load, 0.2, most});
        EXPECT_GE(wide.largest.component, narrow.largest.component * (1 - 1e-9));
        EXPECT_GE(narrow.largest.component, last * (1 - 1e-9));
        last = narrow.largest.component;
      }
    }
  }
}

// Vertex enumeration over the published map, forces zero: 0.358 and 0.176 N m about x.
TEST(MaxTipLoad, MatchesMomentsOfThePublishedIndex) {
  const auto about_x = [](double sign) {
    return max_tip_load(published_index(), {sign, 0, 0}, {TipLoad::kMoment}).largest.component;
  };
  EXPECT_NEAR(about_x(1), 0.358, 5e-4);
  EXPECT_NEAR(about_x(-1), 0.176, 5e-4);
}

// One hinge about z at the origin, the tip at 40 mm along x, a flexor of 10 mm and 100 N: 1 N m.
TipStatics lever() {
  TipStatics statics;
  statics.J = Vector3d(0, 0.04, 0);
  statics.W = Vector3d(0, 0, 1);
  statics.R = MatrixXd::Constant(1, 1, 0.01);
  statics.tau_0 = VectorXd::Zero(1);
  statics.max_tension = VectorXd::Constant(1, 100);
  return statics;
}

TEST(MaxTipLoad, MatchesHandComputedHinge) {
  const Vector3d y(0, 1, 0), z(0, 0, 1);
  const TipStatics hinge = lever();
  // Force alone: 1 N m / 40 mm. Moment alone: all of the torque.
  EXPECT_NEAR(max_tip_load(hinge, y).largest.component, 25, 1e-9);
  EXPECT_NEAR(max_tip_load(hinge, z, {TipLoad::kMoment}).largest.component, 1, 1e-11);
  // A moment of -0.2 N m beside the force lets it be 1.2 / 0.04.
  const MaxTipLoad bounded = max_tip_load(hinge, y, {TipLoad::kForce, 0, 0.2});
  EXPECT_NEAR(bounded.largest.component, 30, 1e-9);
  EXPECT_TRUE(matrix_near(bounded.other, Vector3d(0, 0, -0.2), 1e-11));
  // Against a hold that bears any moment the bone is a lever without limit.
  EXPECT_EQ(max_tip_load(hinge, y, {TipLoad::kForce, 0, kInfinity}).largest.status,
            Status::kUnbounded);
  // No joint feels a moment across the hinge.
  EXPECT_EQ(max_tip_load(hinge, y, {TipLoad::kMoment}).largest.status, Status::kUnbounded);
}

// The lever's stop adds to its flexor, by hand (1 + 0.5) / 0.04; one that extends adds nothing.
TEST(MaxTipLoad, StopGivesTorqueOneWay) {
  TipLoadOptions options;
  options.prices = true;
  options.stops = {{0, 0.5}};
  const MaxTipLoad flexing = max_tip_load(lever(), {0, 1, 0}, options);
  EXPECT_NEAR(flexing.largest.component, 37.5, 1e-9);
  EXPECT_NEAR(flexing.stop_torque(0), 0.5, 1e-12);
  EXPECT_NEAR(flexing.stop_price(0), 1 / 0.04, 1e-7);
  EXPECT_LE(flexing.largest.check.imbalance, 1e-12);
  options.stops = {{0, -0.5}};
  const MaxTipLoad extending = max_tip_load(lever(), {0, 1, 0}, options);
  EXPECT_NEAR(extending.largest.component, 25, 1e-9);
  EXPECT_EQ(extending.stop_torque(0), 0);
  options.stops = {{1, 0.5}};
  EXPECT_THROW((void)max_tip_load(lever(), {0, 1, 0}, options), InputError);
  options.stops = {{0, 0.0}};
  EXPECT_THROW((void)max_tip_load(lever(), {0, 1, 0}, options), InputError);
}

// A newton more of F0 gives 10 mm of moment.
TEST(MaxTipLoad, PricesAreInTheUnitOfTheLoad) {
  const MaxTipLoad found = max_tip_load(
      lever(), {0, 0, 1}, {TipLoad::kMoment, 0, 0, Eigen::Matrix3d::Identity(), /*prices=*/true});
  ASSERT_EQ(found.largest.prices.increase.size(), 1);
  EXPECT_NEAR(found.largest.prices.increase(0), 0.01, 1e-12);
  EXPECT_NEAR(found.largest.torque_shadow_price(0), 1, 1e-10);  // N m of moment per N m of torque
}

// A ray leaves the set where the largest load along it ends.
TEST(FeasibleLoadSet, HoldsTheLargestLoads) {
  std::mt19937 rng(11);
  TipStatics statics = random_digit(rng);
  statics.tau_0.setZero();  // so that no load is one of them, and every ray begins inside
  for (const TipLoad load : {TipLoad::kForce, TipLoad::kMoment}) {
    const TipLoadOptions options{load, 0, load == TipLoad::kForce ? 0.05 : 2.0};
    const FeasibleForceSet set = feasible_load_set(statics, options);
    ASSERT_EQ(set.status, Status::kSolved);
    ASSERT_EQ(set.dimension, 3);
    EXPECT_EQ(set.tension.cols(), 5);
    for (const Vector3d& d : {Vector3d(1, 0, 0), Vector3d(-1, 2, 0.5), Vector3d(0, 0, -1)}) {
      const MaxTipLoad found = max_tip_load(statics, d, options);
      const VectorXd rate = set.normals * d.normalized();
      double leaves = kInfinity;
      for (Index i = 0; i < rate.size(); ++i)
        if (rate(i) > 0) leaves = std::min(leaves, set.offsets(i) / rate(i));
      EXPECT_NEAR(found.largest.component, leaves, 1e-7 * std::max(1.0, leaves));
    }
  }
}

// Free moments leave the whole set unbounded along what a hold and the bones carry alone; the rest
// keeps its vertices.
TEST(FeasibleLoadSet, SplitsOffWhatARigidHoldCarries) {
  std::mt19937 rng(11);
  const FeasibleForceSet set =
      feasible_load_set(random_digit(rng), {TipLoad::kForce, 0, kInfinity});
  EXPECT_EQ(set.status, Status::kSolved);
  EXPECT_EQ(set.dimension, 1);
  EXPECT_EQ(set.carried.cols(), 2);
}

TEST(MaxTipLoad, SlopeAgreesWithDifferences) {
  const Subject subject = with_passive(read_subject(THENAR_DATA_DIR "/subjects/an_chao_index.toml"),
                                       PassiveMoments::kOff);
  const auto tendons = build_linear_tendons(subject, "index", TendonOptions());
  const VectorXd q = VectorXd::Constant(tendons->digit().model.coordinates, radians(30));
  const Vector3d d(0.3, -1, 0.2);
  for (const TipLoad load : {TipLoad::kForce, TipLoad::kMoment})
    for (const double most : {0.0, load == TipLoad::kForce ? 0.03 : 3.0}) {
      const auto ask = [&](const VectorXd& at) {
        return max_tip_load(tip_statics(*tendons, at), d, {load, 0, most});
      };
      const MaxTipLoad here = ask(q);
      ASSERT_EQ(here.largest.status, Status::kSolved);
      ASSERT_GT(here.largest.component, 1e-4);
      const VectorXd slope =
          max_tip_load_gradient(tip_statics(*tendons, q), statics_derivatives(*tendons, q), here,
                                load, DirectionFrame::kWorld);
      for (Index k = 0; k < q.size(); ++k) {
        const VectorXd step = 1e-5 * VectorXd::Unit(q.size(), k);
        const double wanted =
            (ask(q + step).largest.component - ask(q - step).largest.component) / 2e-5;
        EXPECT_NEAR(slope(k), wanted, 1e-5 * slope.norm()) << k;
      }
    }
}

TEST(MaxTipLoad, RefusesAMomentWithoutRotations) {
  TipStatics statics = lever();
  statics.W.resize(3, 0);
  EXPECT_NO_THROW((void)max_tip_load(statics, {0, 1, 0}));
  EXPECT_THROW((void)max_tip_load(statics, {0, 0, 1}, {TipLoad::kMoment}), InputError);
  EXPECT_THROW((void)max_tip_load(statics, {0, 1, 0}, {TipLoad::kForce, 0, 1}), InputError);
  EXPECT_THROW((void)max_tip_load(lever(), {0, 1, 0}, {TipLoad::kForce, 0, -1}), InputError);
}

}  // namespace
}  // namespace thenar
