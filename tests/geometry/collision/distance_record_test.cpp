// Tests for geometry/collision/distance_record.cpp.

#include "geometry/collision/distance_record.h"

#include <memory>

#include <gtest/gtest.h>

#include "geometry/primitives.h"

namespace thenar::internal {
namespace {

constexpr double kRecordBall = 0.5;  // of a ball about the origin [m]

TrianglePiece piece_of(int triangle) {
  return {Eigen::Matrix3d::Zero(), {{0, 0, 0}, 0}, {}, 0.125, triangle};
}

class BallRecord : public testing::Test {
 protected:
  std::shared_ptr<const Shape> ball_ = build_sphere(kRecordBall);
  SignedDistanceOptions options_;
  DistanceRecord record_{*ball_, options_};

  void look(const Eigen::Vector3d& p, int triangle) {
    record_.update_best(p, record_.nearest_surface(p), piece_of(triangle));
  }
};

// By hand: 1.5 m from the middle is 1 m off, less the rounding of 0.125 m.
TEST_F(BallRecord, KeepsTheNearestPoint) {
  look({1.5, 0, 0}, 3);
  look({2.5, 0, 0}, 4);
  EXPECT_EQ(record_.best().triangle, 3);
  EXPECT_DOUBLE_EQ(record_.best().distance, 0.875);
  EXPECT_EQ(record_.evaluations(), 2);
}

TEST_F(BallRecord, HasEnoughWithinTheTolerance) {
  EXPECT_EQ(record_.sufficient_bound(), kInfinity);
  look({1.5, 0, 0}, 0);
  EXPECT_DOUBLE_EQ(record_.sufficient_bound(), 0.875 - options_.tolerance);
}

TEST_F(BallRecord, NotesTheLeastOfWhatIsLeftOut) {
  record_.skip(3);
  record_.skip(2);
  record_.skip(5);
  EXPECT_EQ(record_.skipped_bound(), 2);
}

TEST_F(BallRecord, KnowsTheSpaceAboutAPointToBeEmpty) {
  record_.add_empty_ball({2.5, 0, 0});
  EXPECT_DOUBLE_EQ(record_.empty_space().bound(Ball{{2.5, 0, 0}, 0.5}), 1.5);
}

}  // namespace
}  // namespace thenar::internal
