// Tests for viewer/clear_view.cpp.

#include "viewer/clear_view.h"

#include <cmath>

#include <gtest/gtest.h>

#include "grasp/robot_hand.h"
#include "tests/grasp/jaws.h"

namespace thenar {
namespace {

/// Jaws that stand open at x = -50 and 50 mm, a palm behind them at y = -25 mm.
struct OpenJaws {
  RobotHand hand{sample::jaws()};
  Eigen::VectorXd q = Eigen::VectorXd::Zero(hand.layout().lower.size());
  HandPicture picture{hand, q, {}, {}};
};

/// Whether a ray from the origin, between the jaws, meets the inner side of a jaw (40 mm along y,
/// 20 mm along z) or the front of the palm (100 mm along x, 20 mm along z).
bool hidden(const Eigen::Vector3d& eye) {
  const Eigen::Vector3d at_jaw = 0.05 / std::abs(eye.x()) * eye;
  if (std::abs(at_jaw.y()) < 0.02 && std::abs(at_jaw.z()) < 0.01) return true;
  const Eigen::Vector3d at_palm = 0.025 / std::abs(eye.y()) * eye;
  return eye.y() < 0 && std::abs(at_palm.x()) < 0.05 && std::abs(at_palm.z()) < 0.01;
}

Contact contact(const Eigen::Vector3d& p, const Eigen::Vector3d& n) {
  Contact at;
  at.p = p;
  at.n = n;
  return at;
}

TEST(ClearView, StaysWhereOneUsuallyLooksFromIfNothingIsInTheWay) {
  const OpenJaws jaws;
  const Eigen::Vector3d usual = Eigen::Vector3d(0.1, 0.1, 1).normalized();
  ASSERT_FALSE(hidden(usual));
  EXPECT_TRUE(clear_view(jaws.picture, {contact({0, 0, 0}, -usual)}, 0, usual).isApprox(usual));
}

TEST(ClearView, LooksPastWhatIsInTheWay) {
  const OpenJaws jaws;
  for (const Eigen::Vector3d& usual :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(0, -1, 0)}) {
    ASSERT_TRUE(hidden(usual));
    EXPECT_FALSE(hidden(clear_view(jaws.picture, {contact({0, 0, 0}, {0, 0, 1})}, 0, usual)));
  }
}

// Seen through the object, a contact of which the eye sees the other side, it counts less.
TEST(ClearView, PrefersTheSideOfTheContactThatNoObjectIsBefore) {
  const OpenJaws jaws;
  const Eigen::Vector3d n(0, 0, 1), usual(0, 0.2, 1);
  EXPECT_LE(clear_view(jaws.picture, {contact({0, 0, 0}, n)}, 0, usual).dot(n), 0);
}

}  // namespace
}  // namespace thenar
