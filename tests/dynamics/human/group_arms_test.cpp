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

}  // namespace
}  // namespace thenar
