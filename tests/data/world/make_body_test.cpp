#include "data/io/world/make_body.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using ::testing::HasSubstr;

TEST(MakeBody, SpreadsItsMassEvenly) {
  // A box of edges a, b, c: inertia m (b^2 + c^2) / 12 about x; a ball: 2/5 m r^2.
  const BodyMass box =
      body_mass(make_body("box", box_shape({0.1, 0.2, 0.3}), 3), built_in_materials());
  EXPECT_NEAR(box.mass, 3, 1e-12);
  EXPECT_NEAR(box.inertia(0, 0), 3 * (0.04 + 0.09) / 12, 1e-12);
  const BodyMass ball = body_mass(make_body("ball", ball_shape(0.05), 2), built_in_materials());
  EXPECT_NEAR(ball.inertia(2, 2), 0.4 * 2 * 0.0025, 1e-12);
}

TEST(MakeBody, NeedsAMassWhereItsMaterialHasNoDensity) {
  const BodySpec rod = make_body("rod", cylinder_shape(0.01, 0.2), 0, "metal");
  EXPECT_THAT(message_of([&] { (void)body_mass(rod, built_in_materials()); }),
              HasSubstr("body 'rod' has neither mass nor density"));
}

TEST(MakeBody, RefusesWhatIsNoBody) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(message_of([] { (void)make_body("", ball_shape(1)); }), HasSubstr("wanted the name"));
  EXPECT_THAT(message_of([] {
                (void)make_body("b", box_shape({1, 0, 1}));
              }),
              HasSubstr("wanted a size of 'b' above 0, got 0 m"));
  EXPECT_THAT(message_of([&] { (void)make_body("b", cylinder_shape(1, nan)); }),
              HasSubstr("wanted a size of 'b' above 0"));
  EXPECT_THAT(message_of([] { (void)make_body("b", mesh_shape({})); }),
              HasSubstr("wanted the triangles of 'b'"));
  EXPECT_THAT(message_of([] { (void)make_body("b", ball_shape(1), -1); }),
              HasSubstr("wanted a mass of 'b' of 0 or more, got -1 kg"));
}

}  // namespace
}  // namespace thenar
