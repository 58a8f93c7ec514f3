// Tests for tendons/vanishing_arms.cpp.

#include "tendons/vanishing_arms.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "data/io/subject.h"
#include "tendons/linear_tendons.h"
#include "tendons/name_conventions.h"

namespace thenar {
namespace {

/// Where FDP's arm at the PIP joint of the index finger is told to have collapsed.
std::vector<VanishingArm> at_pip(double degrees) {
  const Subject subject = read_subject(THENAR_DATA_DIR "/subjects/mirakhorlo2016.toml");
  const auto tendons = build_linear_tendons(subject, "index", {Path::kViaPoint, Hood::kSeparate});
  const auto& joints = tendons->digit().names.coordinates;
  Eigen::VectorXd q = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(joints.size()));
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (joints[j] == "PIP2") q[static_cast<Eigen::Index>(j)] = radians(degrees);
  std::vector<VanishingArm> found;
  for (const VanishingArm& arm : vanishing_arms(*tendons, q))
    if (arm.muscle.rfind("FDP", 0) == 0 && arm.joint == "PIP2") found.push_back(arm);
  return found;
}

// 7.4 mm at 45 degrees, 0.6 mm at 90: the straight run cuts the corner.
TEST(CollapsedArms, AreToldWhereAStraightRunCutsThroughTheJoint) {
  const std::vector<VanishingArm> bent = at_pip(90);
  ASSERT_EQ(bent.size(), 1U);
  EXPECT_LT(std::abs(bent[0].arm), 1e-3);
  EXPECT_GT(bent[0].most, 7e-3);
  EXPECT_TRUE(at_pip(45).empty());
}

TEST(CollapsedArms, AreOfLongFlexorsOnly) {
  EXPECT_TRUE(is_long_flexor("FDP2") && is_long_flexor("FDS") && is_long_flexor("FPL"));
  EXPECT_FALSE(is_long_flexor("DI4") || is_long_flexor("FDM") || is_long_flexor("FPB"));
}

}  // namespace
}  // namespace thenar
