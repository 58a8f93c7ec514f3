// Tests for grasp/limits/force_set.cpp: how a hand feels contact forces.

#include "grasp/limits/force_set.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/grasp/quality/pinch.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

/// One link that turns about z through the origin, and a base.
class Crank : public Hand {
 public:
  Crank() : surfaces_(2) { surfaces_[1].link = 0; }
  [[nodiscard]] const HandLayout& layout() const override { return layout_; }
  [[nodiscard]] std::vector<Pose<double>> pose(const Eigen::VectorXd& q) const override {
    return {{rotation_about<double>(Eigen::Vector3d::UnitZ(), q(0)), Eigen::Vector3d::Zero()}};
  }
  [[nodiscard]] Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(
      const Eigen::VectorXd& q, int, const Eigen::Vector3d& p) const override {
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
    return (Eigen::Matrix<double, 6, 1>() << z, z.cross(pose(q)[0] * p)).finished();
  }
  [[nodiscard]] Actuation actuation(const Eigen::VectorXd&) const override { return {}; }
  [[nodiscard]] const std::vector<LinkSurface>& surfaces() const override { return surfaces_; }

 private:
  HandLayout layout_;
  std::vector<LinkSurface> surfaces_;
};

const Eigen::VectorXd kTurned = Eigen::VectorXd::Constant(1, 0.8);

/// A contact at lever `l` of the crank, whatever its angle, pushing straight along its way.
HandContact at_lever(double l, double mu, double torsion, int surface) {
  const Eigen::Vector3d arm(l * std::cos(0.8), l * std::sin(0.8), 0);
  const Eigen::Vector3d way(-std::sin(0.8), std::cos(0.8), 0);
  return {{arm, way, mu, torsion}, surface, 0};
}

// A push along the way costs its lever, friction across the way along the crank nothing.
TEST(ForceSet, TorqueIsForceTimesLever) {
  const HandContact contact = at_lever(0.06, 0.5, 0.01, 1);
  const Eigen::MatrixXd T = torque_map(Crank(), kTurned, {contact}, {});
  ASSERT_EQ(T.cols(), 4);
  EXPECT_NEAR(T(0, 0), 0.06, 1e-15);
  EXPECT_TRUE(matrix_near(T.rightCols(3), Eigen::RowVector3d::Zero(), 1e-15));
}

// Pressing along the axis, a soft finger's twist is felt whole.
TEST(ForceSet, TwistIsFeltAboutTheAxis) {
  HandContact contact = at_lever(0.06, 0, 0.01, 1);
  contact.contact.n = Eigen::Vector3d::UnitZ();
  const Eigen::MatrixXd T = torque_map(Crank(), kTurned, {contact}, {});
  EXPECT_TRUE(matrix_near(T, Eigen::RowVector2d(0, 0.01), 1e-15));
}

// What the object's frame is does not matter to the hand.
TEST(ForceSet, ObjectsFrameDoesNotMatter) {
  const Pose<double> X_HO{rotation_about<double>(Eigen::Vector3d(0.6, 0, 0.8), 1.1),
                          {0.1, 0.2, -0.3}};
  HandContact contact = at_lever(0.06, 0, 0, 1);
  contact.contact.p = X_HO.inverse() * contact.contact.p;
  contact.contact.n = X_HO.R.transpose() * contact.contact.n;
  EXPECT_NEAR(torque_map(Crank(), kTurned, {contact}, X_HO)(0, 0), 0.06, 1e-15);
}

// The torque of each variable is the moment, about the crank's axis, of what it stands for in the
// wrench set, wherever the hand looks at the object from.
TEST(ForceSet, TorquesAreOfTheForcesOfTheWrenchSet) {
  for (const double turn : {0.0, 1.1, -2.0})
    for (const Eigen::Vector3d& axis : {Eigen::Vector3d(0.6, 0, 0.8), Eigen::Vector3d(0, 1, 0)}) {
      const Pose<double> X_HO{rotation_about<double>(axis, turn), {0.1, 0.2, -0.3}};
      HandContact contact = at_lever(0.06, 0.5, 0.01, 1);
      contact.contact.p = X_HO.inverse() * contact.contact.p;
      contact.contact.n = Eigen::Vector3d(0.36, -0.48, 0.8);
      const WrenchCap cap = wrench_set({contact.contact}, {0, 0, 0}, 1).caps.at(0);
      const Eigen::MatrixXd T = torque_map(Crank(), kTurned, {contact}, X_HO);
      ASSERT_EQ(T.cols(), 1 + cap.A.cols());
      for (Eigen::Index k = 0; k < T.cols(); ++k) {
        const ScaledWrench w = k == 0 ? cap.c : ScaledWrench::from_coordinates(cap.A.col(k - 1));
        const Eigen::Vector3d force = X_HO.R * w.force;
        const Eigen::Vector3d moment = X_HO.R * w.moment_over_length + X_HO.p.cross(force);
        EXPECT_NEAR(T(0, k), moment.z(), 1e-15) << turn << ' ' << k;
      }
    }
}

TEST(ForceSet, BaseFeelsNothing) {
  EXPECT_TRUE(torque_map(Crank(), kTurned, {at_lever(0.06, 0.5, 0, 0)}, {}).isZero(0));
}

TEST(ForceSet, RefusesAContactOfNoSurface) {
  EXPECT_EQ(message_of([] { (void)torque_map(Crank(), kTurned, {at_lever(0.06, 0.5, 0, 2)}, {}); }),
            "contact 0 is at surface 2 of 2");
}

}  // namespace
}  // namespace thenar
