// Tests for tendons/net/tendon_actuator.cpp and net_walk.cpp.

#include "tendons/net/tendon_actuator.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "tendons/linear_tendons.h"
#include "tendons/net/digit_sweep.h"
#include "tests/data_folder.h"
#include "tests/hand/sample_subjects.h"
#include "tests/matrix_near.h"
#include "tests/tendons/net/sweep_net.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kPip = 2;  // coordinate of the middle finger

std::unique_ptr<DigitTendons> finger(const std::string& subject, const std::string& digit,
                                     const std::string& net) {
  return build_net_tendons(read_subject(kData + "/subjects/" + subject + ".toml"), digit, {},
                           read_net(kData + "/nets/" + net + ".toml"));
}

/// What is torn in the pathology of the middle finger whose bands snap.
NetTendons torn_finger() {
  const Subject subject = read_subject(kData + "/subjects/an_chao_middle.toml");
  auto separate = build_linear_tendons(subject, "middle", {Path::kViaPoint, Hood::kSeparate});
  BuiltNet net = build_net(subject, separate->digit(), read_net(kData + "/nets/winslow.toml"));
  for (const char* band : {"central_slip", "transverse_u", "transverse_r", "triangular"})
    net = cut(net, band);
  return {std::move(separate), std::move(net)};
}

/// Postures [deg] of the PIP joint at which a sweep from 0 to 60 in such steps reports a snap since
/// the one before.
std::vector<double> snaps(const NetTendons& tendons, double step_deg) {
  const VectorXd straight = tendons.net().frame.straight;
  VectorXd end = straight, pull = VectorXd::Zero(6);
  end[kPip] += 60 * kDegree;
  pull[0] = 2.9;
  std::vector<double> at;
  const auto points =
      sweep_net(tendons, postures_between(straight, end, static_cast<int>(60 / step_deg)), pull);
  for (const SweepPoint& point : points)
    if (point.snapped) at.push_back((point.q[kPip] - straight[kPip]) / kDegree);
  return at;
}

// A snap is of the net, not of the step: a coarse step has one if and only if one of the fine steps
// within it has.
TEST(NetContinuation, FindsTheSameSnapsInSmallAndLargeSteps) {
  const NetTendons torn = torn_finger();
  const std::vector<double> fine = snaps(torn, 0.25);
  EXPECT_GT(fine.size(), 0U);
  EXPECT_LT(fine.size(), 6U);
  for (const double step : {1.0, 5.0, 10.0}) {
    std::vector<double> expected;
    for (const double at : fine) {
      const double upper = std::ceil(at / step - 1e-9) * step;
      if (expected.empty() || std::abs(expected.back() - upper) > 1e-9) expected.push_back(upper);
    }
    const std::vector<double> coarse = snaps(torn, step);
    ASSERT_EQ(coarse.size(), expected.size()) << step;
    for (std::size_t i = 0; i < coarse.size(); ++i) EXPECT_NEAR(coarse[i], expected[i], 1e-6);
  }
}

TEST(NetContinuation, FindsNoSnapsInASoundFinger) {
  const auto sound = finger("an_chao_middle", "middle", "winslow");
  for (const double step : {0.25, 10.0})
    EXPECT_TRUE(snaps(dynamic_cast<const NetTendons&>(*sound), step).empty()) << step;
}

/// Central differences of an actuator's torque and lengths, every point from the state at (q, t).
struct Differences {
  MatrixXd K, R, length;
};
Differences differences(const DigitTendons& tendons, const VectorXd& q, const VectorXd& t,
                        const Eigen::Matrix3Xd& nodes) {
  const auto at = [&](const VectorXd& there, const VectorXd& load) {
    TendonActuator actuator(tendons);
    return TendonAction(actuator.start_at(there, load, nodes));
  };
  Differences out{MatrixXd(q.size(), q.size()), MatrixXd(t.size(), q.size()),
                  MatrixXd(t.size(), q.size())};
  constexpr double h = 1e-5, f = 1e-3;  // [rad], [N]
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const VectorXd step = h * VectorXd::Unit(q.size(), j);
    const TendonAction plus = at(q + step, t), minus = at(q - step, t);
    out.K.col(j) = (plus.tau - minus.tau) / (2 * h);
    out.length.col(j) = (plus.length - minus.length) / (2 * h);
  }
  for (Eigen::Index m = 0; m < t.size(); ++m) {
    const VectorXd step = f * VectorXd::Unit(t.size(), m);
    out.R.row(m) = (at(q, t + step).tau - at(q, t - step).tau).transpose() / (2 * f);
  }
  return out;
}

// Torques, slopes and excursions of every net are each other's derivatives.
TEST(TendonActuator, HasTheSlopesOfItsTorqueAndLengths) {
  for (const char* net : {"winslow", "chao_an"}) {
    const auto tendons = finger("an_chao_middle", "middle", net);
    const VectorXd q = (VectorXd(4) << 0.5, 0.05, 0.7, 0.3).finished();
    const VectorXd t = (VectorXd(6) << 3, 5, 4, 2, 1, 2.5).finished();
    TendonActuator actuator(*tendons);
    const TendonAction action = actuator.act(q, t);
    ASSERT_TRUE(is_trusted(action.status)) << net << ": " << action.warning;
    ASSERT_TRUE(action.slopes);
    const Differences measured = differences(*tendons, q, t, actuator.nodes());
    const double size = action.K.cwiseAbs().maxCoeff();  // [N m/rad]
    EXPECT_TRUE(matrix_near(action.K, measured.K, 1e-5 * size)) << net;
    EXPECT_TRUE(matrix_near(action.R, measured.R, 1e-7)) << net;
    EXPECT_TRUE(matrix_near(MatrixXd(-action.R), measured.length, 1e-7)) << net;
    // Energy at rest has one second derivative.
    EXPECT_TRUE(matrix_near(action.K, MatrixXd(action.K.transpose()), 1e-7 * size)) << net;
  }
}

// The same on every rung of paths and fixed fractions, for every subject whose digits have tendons.
TEST(TendonActuator, HasTheSlopesOfLinearTendons) {
  sample::Draw draw(2);
  int asked = 0;
  for (const char* name : {"an_chao_index", "an_chao_middle", "mirakhorlo2016", "synek2019_middle",
                           "arms_five_axis_thumb", "myohand_thumb"}) {
    const Subject subject = read_subject(kData + "/subjects/" + name + ".toml");
    for (const Path path : {Path::kViaPoint, Path::kWrapped}) {
      TendonOptions options;
      options.path = path;
      const auto tendons = build_linear_tendons(subject, subject.digits.front().name, options);
      const auto muscles = static_cast<Eigen::Index>(tendons->digit().names.muscles.size());
      if (muscles == 0) continue;
      const VectorXd q = 0.5 * draw.posture(tendons->digit().skeleton),
                     t = draw.numbers(muscles, 1, 20);
      const TendonAction action = TendonAction(TendonActuator(*tendons).act(q, t));
      if (!action.slopes) continue;
      ++asked;
      const Differences measured = differences(*tendons, q, t, {});
      EXPECT_TRUE(matrix_near(action.K, measured.K, 1e-6)) << name;
      EXPECT_TRUE(matrix_near(action.R, measured.R, 1e-9)) << name;
      EXPECT_TRUE(TendonActuator(*tendons).act(q, 0 * t).tau.isZero(0)) << name;
    }
  }
  EXPECT_GE(asked, 8);
}

// Constant shares, smooth sheaths: the length that a muscle takes in is its arm.
TEST(TendonActuator, HasExcursionsWhoseSlopesAreTheArms) {
  const auto tendons = build_linear_tendons(read_subject(kData + "/subjects/mirakhorlo2016.toml"),
                                            "index", {Path::kWrapped, Hood::kSeparate});
  const VectorXd q = (VectorXd(4) << 0.4, 0.05, 0.6, 0.3).finished();
  const VectorXd t =
      VectorXd::Ones(static_cast<Eigen::Index>(tendons->digit().names.muscles.size()));
  TendonActuator actuator(*tendons);
  const TendonAction action = actuator.act(q, t);
  ASSERT_TRUE(action.slopes) << action.warning;
  EXPECT_TRUE(matrix_near(MatrixXd(-action.R), differences(*tendons, q, t, {}).length, 1e-8));
}

// At one posture there is one answer: that of `thenar tendon solve`.
TEST(TendonActuator, RestsWhereSolvingRests) {
  const auto tendons = finger("mirakhorlo2016", "middle", "winslow");
  sample::Draw draw(4);
  const auto muscles = static_cast<Eigen::Index>(tendons->digit().names.muscles.size());
  for (int k = 0; k < 8; ++k) {
    const VectorXd q = (VectorXd(4) << draw.number(-0.2, 1.3), draw.number(-0.2, 0.2),
                        draw.number(0, 1.5), draw.number(0, 1))
                           .finished();
    const VectorXd t = draw.numbers(muscles, 0, 20);
    const DigitPoint point = sweep_digit(*tendons, {q}, t).front();
    TendonActuator actuator(*tendons);
    const TendonAction& action = actuator.act(q, t);
    EXPECT_TRUE(matrix_near(action.tau, point.pull.tau, 1e-12)) << k;
    EXPECT_EQ(action.status, point.pull.status);
  }
}

// One long step ends where a hundred short ones do.
TEST(TendonActuator, GoesFarInOneStep) {
  const auto tendons = finger("an_chao_middle", "middle", "winslow");
  const VectorXd from = VectorXd::Zero(4), to = (VectorXd(4) << 0.8, 0.05, 1.2, 0.6).finished();
  const VectorXd t0 = (VectorXd(6) << 1, 1, 1, 1, 1, 1).finished(),
                 t1 = (VectorXd(6) << 3, 9, 4, 2, 1, 2.5).finished();
  TendonActuator far(*tendons), near(*tendons);
  (void)far.act(from, t0);
  for (int k = 0; k <= 100; ++k)
    (void)near.act(from + 0.01 * k * (to - from), t0 + 0.01 * k * (t1 - t0));
  EXPECT_TRUE(matrix_near(far.act(to, t1).tau, near.act(to, t1).tau, 1e-8));
  EXPECT_EQ(far.snaps(), near.snaps());
}

// Refused by solving, so refused here: a net without balance has a status, and its torque none.
TEST(TendonActuator, SaysWhereANetDoesNotBalance) {
  const auto tendons = finger("mirakhorlo2016", "little", "dogadov2017");
  const std::vector<std::string>& muscles = tendons->digit().names.muscles;
  VectorXd t = VectorXd::Zero(static_cast<Eigen::Index>(muscles.size()));
  t[std::find(muscles.begin(), muscles.end(), "ADM") - muscles.begin()] = 20;
  int refused = 0;
  for (const double angle : {0.0, 60.0, 65.0}) {
    const VectorXd q = angle * kDegree * VectorXd::Unit(4, 0);
    TendonActuator actuator(*tendons);
    const TendonAction& action = actuator.act(q, t);
    const DigitPoint point = sweep_digit(*tendons, {q}, t).front();
    EXPECT_EQ(action.status, point.pull.status);
    EXPECT_EQ(is_trusted(action.status), point.rest.status == NetStatus::kBalanced);
    EXPECT_EQ(action.warning.empty(), action.status == TendonStatus::kValid);
    if (!is_trusted(action.status)) ++refused;
    EXPECT_EQ(action.residual > 1, action.status == TendonStatus::kUnbalanced) << angle;  // [N]
  }
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace thenar
