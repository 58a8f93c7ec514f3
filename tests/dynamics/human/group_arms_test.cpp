// Tests for GroupArms of dynamics/human/tendon_group.cpp: room that is used again changes no
// answer.

#include <gtest/gtest.h>

#include "dynamics/human/tendon_group.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

/// The middle finger of a specimen whose tendons wrap over cylinders.
std::shared_ptr<const DigitTendons> wrapped_finger() {
  TendonOptions options;
  options.path = Path::kWrapped;
  return build_linear_tendons(read_subject(THENAR_DATA_DIR "/subjects/mirakhorlo2016.toml"),
                              "middle", options);
}

VectorXd bent(Eigen::Index joints, double part) {
  return part * VectorXd::LinSpaced(joints, 0.3, 1);
}

// From straight to a fist and back: surfaces are touched and left on the way, and a solver that has
// been elsewhere before finds the bits of one that has not.
TEST(GroupArms, AreThoseOfOnePosture) {
  const TendonGroup group({wrapped_finger()});
  const auto joints = static_cast<Eigen::Index>(group.coordinates().size());
  const auto muscles = static_cast<Eigen::Index>(group.muscles().size());
  GroupArms arms(group);
  GroupTorque out;
  for (const double part : {0.0, 0.4, 0.9, 1.2, 0.7, -0.2, 1.2, 0.0}) {
    const VectorXd q = bent(joints, part);
    arms.solve(q, out);
    const GroupTorque once = group.evaluate(q, VectorXd::Zero(muscles), {});
    EXPECT_EQ(out.R, once.R) << part;
    EXPECT_EQ(out.status, once.status) << part;
    EXPECT_EQ(out.warning, once.warning) << part;
    GroupTorque fresh;
    GroupArms(arms).solve(q, fresh);
    EXPECT_EQ(fresh.R, out.R) << part;
  }
}

// Slopes of arms, found once, give the stiffness at any tensions: minus the symmetric part of the
// derivative of torque, which DigitTendons finds anew at each.
TEST(GroupArms, SlopesGiveStiffnessAtAllTensions) {
  const TendonGroup group({wrapped_finger()});
  const auto joints = static_cast<Eigen::Index>(group.coordinates().size());
  const auto muscles = static_cast<Eigen::Index>(group.muscles().size());
  std::vector<int> places;  // backwards, behind an empty one
  for (Eigen::Index i = 0; i < joints; ++i) places.push_back(static_cast<int>(joints - i));
  GroupArms arms(group);
  GroupSlopes slopes;
  VectorXd room;
  for (const double part : {0.0, 0.4, 0.9, -0.2}) {
    const VectorXd q = bent(joints, part);
    arms.slopes(q, slopes);
    ASSERT_TRUE(slopes.exist);
    for (const double pull : {1.0, 30.0}) {
      const VectorXd t = pull * VectorXd::LinSpaced(muscles, 0.2, 1.4);
      const Eigen::MatrixXd by_posture = group.torque_by_posture(q, t, group.evaluate(q, t, {}));
      Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(joints + 1, joints + 1);
      group.add_stiffness(slopes, t, places, room, stiffness);
      EXPECT_GT(stiffness.norm(), 1e-3 * pull);
      for (Eigen::Index j = 0; j < joints; ++j)
        for (Eigen::Index k = 0; k < joints; ++k)
          EXPECT_NEAR(stiffness(joints - j, joints - k),
                      -0.5 * (by_posture(j, k) + by_posture(k, j)), 1e-14 * pull);
      EXPECT_TRUE(stiffness.row(0).isZero(0));
    }
  }
}

}  // namespace
}  // namespace thenar
