// Tests for tendons/strand_paths.cpp.

#include <gtest/gtest.h>

#include "data/io/subject.h"
#include "tendons/strand_paths.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

/// Trouble at mid-range of a digit whose wrapped paths are fitted by polynomials of this order.
std::string warning(const std::string& subject, const std::string& digit, int order) {
  const Subject hand = read_subject(THENAR_DATA_DIR "/subjects/" + subject + ".toml");
  const TendonDigit built = build_tendon_digit(hand, digit, TendonOptions());
  const VectorXd q = VectorXd::Constant(built.model.coordinates, 0.1);  // [rad]
  return build_fitted_paths(hand, built, order)->arms(pose_tree(built.model.tree, q), q).warning;
}

// The extensor of a finger bends over its knuckle: order 4 cannot follow it, order 8 can.
TEST(FittedStrands, TellHowFarTheirArmsMayBeOff) {
  EXPECT_EQ(warning("mirakhorlo2016", "middle", 8), "");
  EXPECT_NE(warning("mirakhorlo2016", "middle", 4).find("fitted arms of 'EDC3' may be off by"),
            std::string::npos);
}

// EPL leaves and meets several surfaces within its range.
TEST(FittedStrands, TellThatAThumbsExtensorIsPoorlyFitted) {
  EXPECT_NE(warning("myohand_thumb", "thumb", 8).find("'EPL'"), std::string::npos);
}

}  // namespace
}  // namespace thenar
