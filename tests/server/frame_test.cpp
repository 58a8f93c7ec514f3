// Frames byte by byte, as docs/remote.md and server/frame.h say where each number stands.

#include "server/frame.h"

#include <cstring>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "tests/server/small_model.h"

namespace thenar {
namespace {

template <typename Number>
Number at(const std::string& frame, std::size_t offset) {
  Number number;
  EXPECT_LE(offset + sizeof(number), frame.size());
  std::memcpy(&number, frame.data() + offset, sizeof(number));
  return number;
}

TEST(Frame, HasEveryNumberInItsPlace) {
  SmallModel model;
  model.lift(0.25);
  const std::string frame = encode_frame(model.instant(), 3, 9);
  EXPECT_EQ(frame.substr(0, 4), "THF1");
  EXPECT_EQ(at<std::uint32_t>(frame, 4), 3U);
  EXPECT_EQ(at<std::uint32_t>(frame, 8), 9U);
  EXPECT_EQ(at<double>(frame, 16), 0.0);
  // Counts of bodies, joints, lines, contacts, arrows, line points, and the usual step.
  const std::uint16_t counts[] = {2, 1, 1, 1, 1, 2, 0, 0};
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(at<std::uint16_t>(frame, 24 + 2 * i), counts[i]);
  EXPECT_EQ(frame.size(), 52U + 2 * 28 + 4 + 4 + 44 + 24 + 2 * 6);
  EXPECT_FLOAT_EQ(at<float>(frame, 52 + 8), 0.25F);            // z of the first body
  EXPECT_FLOAT_EQ(at<float>(frame, 52 + 12), std::cos(0.5F));  // w
  EXPECT_FLOAT_EQ(at<float>(frame, 52 + 24), std::sin(0.5F));  // z
  EXPECT_FLOAT_EQ(at<float>(frame, 52 + 28 + 12), 1.0F);       // w of the second body
  EXPECT_FLOAT_EQ(at<float>(frame, 108), 0.25F);               // joint
  EXPECT_FLOAT_EQ(at<float>(frame, 112), 12.5F);               // tension
  EXPECT_EQ(at<std::uint16_t>(frame, 116), 0);                 // contact: a
  EXPECT_EQ(at<std::uint16_t>(frame, 118), 0xffff);            // b: none
  EXPECT_FLOAT_EQ(at<float>(frame, 116 + 4 + 20), 1.0F);       // z of its normal
  EXPECT_FLOAT_EQ(at<float>(frame, 116 + 4 + 32), 7.0F);       // z of its force
  EXPECT_FLOAT_EQ(at<float>(frame, 116 + 40), 0.4F);           // friction
  EXPECT_FLOAT_EQ(at<float>(frame, 160), 1.0F);                // arrow: from x
  EXPECT_FLOAT_EQ(at<float>(frame, 160 + 20), 6.0F);           // vector z
  // Points of the line, from their middle.
  EXPECT_NEAR(at<float>(frame, 48) + 1e-5 * at<std::int16_t>(frame, 184 + 4), 0.3, 1e-5);
  EXPECT_NEAR(at<float>(frame, 48) + 1e-5 * at<std::int16_t>(frame, 184 + 10), 0.55, 1e-5);
}

TEST(Frame, HasLongLinesInACoarserStep) {
  SmallModel model;
  LiveInstant instant = model.instant();
  instant.line_points = {{-2, 0, 0}, {1, 0, 0}};
  const std::string frame = encode_frame(instant, 0, 0);
  const double step = 1e-6 * at<std::uint16_t>(frame, 36);  // [m]
  EXPECT_GE(step * 32767, 1.5);
  EXPECT_LT(step * 32767, 1.6);
  EXPECT_NEAR(at<float>(frame, 40) + step * at<std::int16_t>(frame, 184), -2, step);
  EXPECT_NEAR(at<float>(frame, 40) + step * at<std::int16_t>(frame, 190), 1, step);
}

TEST(Frame, KeepsThatATensionIsUnknown) {
  SmallModel model;
  LiveInstant instant = model.instant();
  instant.tensions = {std::numeric_limits<double>::quiet_NaN()};
  EXPECT_TRUE(std::isnan(at<float>(encode_frame(instant, 0, 0), 112)));
  EXPECT_TRUE(frame_json(model.shape(), instant, 0)["lines"][0]["tension"].is_null());
}

TEST(Frame, RefusesMoreThanItCanCount) {
  LiveInstant instant;
  instant.bodies.resize(65536);
  EXPECT_THROW((void)encode_frame(instant, 0, 0), InputError);
  instant.bodies.resize(65535);
  EXPECT_EQ(encode_frame(instant, 0, 0).size(), 52U + 65535 * 28);
}

TEST(Frame, HasQuaternionsThatTurnAsTheRotationDoes) {
  for (const double angle : {-3.0, -0.5, 0.0, 1.0, 3.1}) {
    const Eigen::Matrix3d R = rotation_about<double>(Eigen::Vector3d(1, 2, -2) / 3, angle);
    const Eigen::Vector4d q = quaternion_of(R);
    EXPECT_GE(q(0), 0);
    EXPECT_NEAR((Eigen::Quaterniond(q(0), q(1), q(2), q(3)).toRotationMatrix() - R).norm(), 0,
                1e-14);
  }
}

TEST(Frame, SaysTheSameAsJson) {
  SmallModel model;
  model.lift(0.25);
  const OrderedJson json = frame_json(model.shape(), model.instant(), 4);
  EXPECT_EQ(json["revision"], 4);
  EXPECT_EQ(json["bodies"][0]["name"], "box");
  EXPECT_EQ(json["bodies"][0]["position"], OrderedJson({0.0, 0.0, 0.25}));
  EXPECT_EQ(json["joints"][0]["value"], 0.25);
  EXPECT_EQ(json["lines"][0]["points"].size(), 2U);
  EXPECT_TRUE(json["contacts"][0]["b"].is_null());
  EXPECT_EQ(json["arrows"][0]["vector"], OrderedJson({4.0, 5.0, 6.0}));
}

}  // namespace
}  // namespace thenar
