#include "live/live_picture.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace thenar {
namespace {

LiveShape sample_shape() {
  LiveShape shape;
  shape.bodies.resize(2);
  shape.joints.resize(1);
  shape.lines = {{"FDP", "index", false, 2}, {"slip", "index", true, 1}};
  return shape;
}

LiveInstant sample_instant() {
  LiveInstant instant;
  instant.bodies.resize(2);
  instant.joints = {0.5};
  instant.line_points.assign(3, {0, 0, 0});
  instant.tensions = {std::numeric_limits<double>::quiet_NaN(), 0};
  instant.contacts.resize(1);
  return instant;
}

TEST(LivePicture, AnInstantThatFitsItsShapePasses) {
  EXPECT_NO_THROW(check_instant(sample_shape(), sample_instant()));
}

TEST(LivePicture, AnInstantThatDoesNotFitIsRefused) {
  const auto refused = [](const auto& change) {
    LiveInstant instant = sample_instant();
    change(instant);
    EXPECT_THROW(check_instant(sample_shape(), instant), InputError);
  };
  refused([](LiveInstant& instant) { instant.bodies.pop_back(); });
  refused([](LiveInstant& instant) { instant.joints.push_back(1); });
  refused([](LiveInstant& instant) { instant.line_points.pop_back(); });
  refused([](LiveInstant& instant) { instant.tensions.pop_back(); });
  refused([](LiveInstant& instant) { instant.arrows.resize(1); });
  refused([](LiveInstant& instant) { instant.contacts[0].b = 2; });
  refused([](LiveInstant& instant) {
    instant.bodies[1].p.x() = std::numeric_limits<double>::infinity();
  });
}

}  // namespace
}  // namespace thenar
