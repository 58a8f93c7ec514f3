// Tests for dynamics/human/muscle_schedule.cpp.

#include "dynamics/human/muscle_schedule.h"

#include <gtest/gtest.h>

#include "tests/message_of.h"

namespace thenar {
namespace {

/// From 0 to 4 between 1 s and 3 s, of muscle 1 of two.
MuscleSchedule ramp() {
  MuscleSchedule out;
  out.muscle = 1;
  out.time = Eigen::Vector2d(1, 3);
  out.value = Eigen::Vector2d(0, 4);
  return out;
}

TEST(MuscleSchedule, IsALineBetweenKnots) {
  const SchedulePiece piece = piece_at(ramp(), 1.5);
  EXPECT_EQ(piece.slope(), 2);
  EXPECT_EQ(piece.value_at(2), 2);
}

TEST(MuscleSchedule, IsConstantBeforeItsFirstKnotAndAfterItsLast) {
  EXPECT_EQ(piece_at(ramp(), 0).value_at(0.5), 0);
  EXPECT_EQ(piece_at(ramp(), 3).value_at(9), 4);
  EXPECT_EQ(piece_at(ramp(), 3).slope(), 0);
}

TEST(MuscleSchedule, RefusesTwoOfOneMuscleAtOnce) {
  EXPECT_EQ(message_of([] {
              check_schedules({ramp(), ramp()}, {"a", "b"}, 10, "me", "tension");
            }),
            "two drives give 'b' its tension at once");
}

TEST(ActiveSchedulePieces, AreZeroWhereNoScheduleActs) {
  ActiveSchedulePieces pieces(2);
  pieces.select({ramp()}, 2);
  EXPECT_EQ(pieces.piece_of(0).value_at(2), 0);
  EXPECT_EQ(pieces.piece_of(1).value_at(2), 2);
}

TEST(ActiveSchedulePieces, TakeWhatIsSetInPlaceOfSchedules) {
  ActiveSchedulePieces pieces(2);
  pieces.select({ramp()}, 2);
  pieces.set_value(1, 7);
  pieces.select({ramp()}, 2);
  EXPECT_EQ(pieces.piece_of(1).value_at(2), 7);
  EXPECT_EQ(pieces.value_set(1), 7);
  EXPECT_FALSE(pieces.value_set(0));
}

}  // namespace
}  // namespace thenar
