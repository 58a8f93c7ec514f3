// Tests for tendons/digit_tendons.cpp.

#include "tendons/digit_tendons.h"

#include <gtest/gtest.h>

#include "tests/matrix_near.h"
#include "tests/tendons/muscle/moving_samples.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

// Separate tendons lengthen as their paths do.
TEST(Excursion, IsChangeOfPathLength) {
  const Subject subject = sample::index_finger();
  TendonOptions separate;
  separate.hood = Hood::kSeparate;
  const auto tendons = build_linear_tendons(subject, "index", separate);
  const TendonModel<double>& model = tendons->digit().model;
  const VectorXd from = Eigen::Vector4d(-0.2, 0.1, 0.1, 0), to = Eigen::Vector4d(1.2, -0.1, 1, 0.8);
  VectorXd change(7);
  for (Eigen::Index m = 0; m < 7; ++m) {
    const TendonPath<double>& path =
        model.paths[static_cast<std::size_t>(model.pulls[static_cast<std::size_t>(m)])];
    change[m] = path_length(pose_tree(model.tree, to), path) -
                path_length(pose_tree(model.tree, from), path);
  }
  EXPECT_TRUE(
      matrix_near(excursion(*tendons, from, to, VectorXd::Ones(7)).e, change, 1e-12));  // [m]
}

TEST(Excursion, ConstantArmsShortenInProportion) {
  const sample::Mover mover(sample::Pendulum().subject(), Muscle::kBounds);
  const VectorXd one = VectorXd::Ones(1);
  EXPECT_NEAR(excursion(*mover.tendons, 0 * one, 0.7 * one, one).e[0], -0.01 * 0.7, 1e-16);
  EXPECT_EQ(excursion(*mover.tendons, one, one, one).e[0], 0);
}

/// One constant arm that is not to be trusted while the joint is between 0.2 and 0.4 rad.
class Untrusted : public DigitTendons {
 public:
  explicit Untrusted(TendonDigit digit) : digit_(std::move(digit)) {}
  [[nodiscard]] const TendonDigit& digit() const override { return digit_; }
  TendonTorque evaluate(const VectorXd& q, const VectorXd& t,
                        const Eigen::Matrix3Xd&) const override {
    TendonTorque pull;
    pull.R = Eigen::MatrixXd::Constant(1, 1, 0.01);
    pull.tau = pull.R.transpose() * t;
    if (q[0] > 0.2 && q[0] < 0.4) pull.warning = "adrift";
    return pull;
  }
  VectorXd lengths(const VectorXd& q, const VectorXd&, const TendonTorque&) const override {
    return -0.01 * q;
  }

 private:
  TendonDigit digit_;
};

TEST(Excursion, TellsTheTroubleThatItPassed) {
  const Untrusted tendons(build_tendon_digit(sample::Pendulum().subject(), "index"));
  const VectorXd one = VectorXd::Ones(1);
  EXPECT_EQ(excursion(tendons, 0 * one, 0.7 * one, one).warning, "adrift");
  EXPECT_EQ(excursion(tendons, 0.45 * one, 0.7 * one, one).warning, "");
}

TEST(Excursion, MotionNotesTroubleOnTheWayToItsStart) {
  const Subject subject = sample::Pendulum().subject();
  const Untrusted tendons(build_tendon_digit(subject, "index"));
  const auto contraction =
      build_contraction(musculotendons(subject, tendons.digit(), Muscle::kBounds), Muscle::kBounds);
  SimulateOptions options;
  options.seconds = 0.001;
  const VectorXd none = VectorXd::Zero(1), start = VectorXd::Constant(1, 0.7);
  const Trajectory path =
      simulate({tendons, *contraction}, constant_excitation(none), {start, {}, none}, options);
  EXPECT_EQ(path.warning, "on the way to the start: adrift (at 0 s)");
}

}  // namespace
}  // namespace thenar
