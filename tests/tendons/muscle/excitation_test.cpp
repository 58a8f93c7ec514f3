// Tests for tendons/muscle/excitation.cpp.

#include "tendons/muscle/excitation.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

const std::vector<std::string> kMuscles{"EDC", "FDP"};

std::string complaint(const std::string& text) {
  try {
    (void)parse_excitation(text, "e.csv", kMuscles);
  } catch (const DataError& e) {
    return e.what();
  }
  return "";
}

TEST(Excitation, ConstantIsOnePiece) {
  const auto pieces = excitation_pieces(constant_excitation(Eigen::Vector2d(0.2, 0.7)), 3);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].begin, 0);
  EXPECT_EQ(pieces[0].end, 3);
  EXPECT_EQ(pieces[0].value_at(1.5), Eigen::Vector2d(0.2, 0.7));
}

TEST(Excitation, RampsAndJumpsBetweenKnots) {
  // 0 until 1 s, up to 1 at 3 s, a jump down to 0.5, constant from there.
  const Excitation e{Eigen::Vector3d(1, 3, 3), Eigen::Vector3d(0, 1, 0.5)};
  const auto pieces = excitation_pieces(e, 4);
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(pieces[0].value_at(0.5)[0], 0);
  EXPECT_FALSE(pieces[1].jumps);
  EXPECT_EQ(pieces[1].value_at(2)[0], 0.5);
  EXPECT_EQ(pieces[1].value_at(3)[0], 1);
  EXPECT_TRUE(pieces[2].jumps);
  EXPECT_EQ(pieces[2].value_at(3)[0], 0.5);
  EXPECT_EQ(pieces[2].end, 4);
}

TEST(Excitation, IsCutWhereTimeEnds) {
  const Excitation e{Eigen::Vector2d(0, 10), Eigen::Vector2d(0, 1)};
  const auto pieces = excitation_pieces(e, 4);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].end, 4);
  EXPECT_NEAR(pieces[0].last[0], 0.4, 1e-15);
}

TEST(Excitation, SkipsAByteOrderMark) {
  const std::string table = "time_s, FDP\n0, 0\n0.5, 1e-1\n";
  EXPECT_EQ(parse_excitation("\xEF\xBB\xBF" + table, "e.csv", kMuscles).value,
            parse_excitation(table, "e.csv", kMuscles).value);
}

TEST(Excitation, ReadsTableInOrderOfMuscles) {
  const Excitation e =
      parse_excitation("# ramp\ntime_s, FDP\n0, 0\n0.5, 1e-1\n", "e.csv", kMuscles);
  EXPECT_EQ(e.time, Eigen::Vector2d(0, 0.5));
  EXPECT_EQ(e.value.col(0), Eigen::Vector2d(0, 0));
  EXPECT_EQ(e.value.col(1), Eigen::Vector2d(0, 0.1));
}

TEST(Excitation, SaysWhichLineOfATableIsWrong) {
  EXPECT_EQ(complaint("EDC,FDP\n"), "e.csv:1: wanted a header 'time_s,MUSCLE,...'");
  EXPECT_EQ(complaint("time_s,XYZ\n"), "e.csv:1: no muscle 'XYZ'; there are EDC, FDP");
  EXPECT_EQ(complaint("time_s,EDC,EDC\n"), "e.csv:1: muscle 'EDC' has two columns");
  EXPECT_EQ(complaint("time_s,EDC\n0,0.1,0.2\n"), "e.csv:2: wanted 2 cells, got 3");
  EXPECT_EQ(complaint("time_s,EDC\n0,half\n"), "e.csv:2: wanted a number, got 'half'");
  EXPECT_EQ(complaint("time_s,EDC\n1,0\n0.5,0\n"),
            "e.csv:3: wanted times from 0 on that never fall");
  EXPECT_EQ(complaint("time_s,EDC\n0,1.5\n"), "e.csv:2: wanted an excitation in 0..1, got 1.5");
  EXPECT_EQ(complaint(""), "e.csv:1: wanted a header and at least one row");
}

TEST(Excitation, RejectsWhatNoMuscleCanBe) {
  EXPECT_EQ(
      message_of([] { (void)excitation_pieces(constant_excitation(Eigen::Vector2d(0, 1.1)), 1); }),
      "wanted excitations from 0 to 1, got 1.1 of muscle number 2");
  EXPECT_THROW((void)excitation_pieces({Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 0)}, 1),
               InputError);
}

}  // namespace
}  // namespace thenar
