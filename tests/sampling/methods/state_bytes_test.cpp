// Tests for sampling/methods/state_bytes.cpp.

#include "sampling/methods/state_bytes.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace thenar {
namespace {

TEST(StateBytes, ComeBackExactly) {
  const Eigen::MatrixXd matrix = (Eigen::MatrixXd(2, 3) << 1, -0.1, 1e300, 3, 4e-310, 5).finished();
  StateWriter writer;
  writer.write(0.1);
  writer.write(std::int64_t{-7});
  writer.write(matrix);
  writer.write(Eigen::MatrixXd(0, 4));
  StateReader reader(writer.bytes());
  EXPECT_EQ(reader.number(), 0.1);
  EXPECT_EQ(reader.integer(), -7);
  EXPECT_EQ(reader.matrix(), matrix);
  EXPECT_EQ(reader.matrix().cols(), 4);
  EXPECT_TRUE(reader.at_end());
}

TEST(StateBytes, PartsKeepTheirLengths) {
  StateWriter writer;
  writer.write_bytes(std::string("a\0b", 3));
  writer.write_bytes("");
  writer.write(2.0);
  StateReader reader(writer.bytes());
  EXPECT_EQ(reader.bytes(), std::string("a\0b", 3));
  EXPECT_EQ(reader.bytes(), "");
  EXPECT_EQ(reader.number(), 2.0);
  EXPECT_THROW((void)StateReader(writer.bytes().substr(0, 9)).bytes(), InputError);
}

TEST(StateBytes, CutShortIsRefused) {
  StateWriter writer;
  writer.write(Eigen::MatrixXd::Ones(3, 3));
  StateReader reader(writer.bytes().substr(0, 40));
  EXPECT_THROW((void)reader.matrix(), InputError);
}

}  // namespace
}  // namespace thenar
