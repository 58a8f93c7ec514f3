// Tests for dynamics/stepping/mode_change.cpp, against straight lines by hand.

#include "dynamics/stepping/mode_change.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

using Contacts = std::vector<ActiveContact>;

/// A contact on a floor with friction 1/2. @param tangential  impulse [N s]
ActiveContact on_floor(int id, ContactMode mode, double normal, double tangential,
                       double slip = 0) {
  ActiveContact contact;
  contact.b = 1;
  contact.id = id;
  contact.feature = static_cast<std::uint64_t>(id);
  contact.friction.coefficient = 0.5;
  contact.mode = mode;
  contact.impulse = {tangential, 0, normal};
  contact.slip = slip;
  return contact;
}

constexpr ContactMode kOpens = ContactMode::kOpen, kSticks = ContactMode::kStick,
                      kSlides = ContactMode::kSlide;

TEST(SameModes, LeavesOutWhatHasNoForce) {
  const ActiveContact open = on_floor(1, kOpens, 0, 0), stuck = on_floor(2, kSticks, 1, 0);
  EXPECT_TRUE(same_modes({open, stuck}, {stuck}));
  EXPECT_TRUE(same_modes({stuck}, {stuck, open}));
  EXPECT_TRUE(same_modes({open}, {}));
  EXPECT_FALSE(same_modes({stuck}, {}));
  EXPECT_FALSE(same_modes({stuck}, {on_floor(2, kSlides, 1, 0.5)}));
  EXPECT_FALSE(same_modes({stuck}, {on_floor(3, kSticks, 1, 0)}));
}

TEST(SameModes, TellsWhatSlidesTheOtherWay) {
  const ActiveContact forth = on_floor(1, kSlides, 1, 0.5, 0.2),
                      back = on_floor(1, kSlides, 1, -0.5, 0.1);
  EXPECT_TRUE(same_modes({forth}, {forth}));
  EXPECT_FALSE(same_modes({forth}, {back}));
  // From 0.6 to 0.2 m/s in a substep: it stands after half of the next.
  EXPECT_NEAR(fraction_before_change({on_floor(1, kSlides, 1, 0.5, 0.6)}, {forth}, {back}), 0.5,
              1e-15);
}

// From 4 to 1 N s in a substep: 0 after a third of the next.
TEST(ShareBeforeChange, NormalForceFallsToZero) {
  EXPECT_NEAR(
      fraction_before_change({on_floor(1, kSticks, 4, 0)}, {on_floor(1, kSticks, 1, 0)}, {}),
      1.0 / 3, 1e-15);
  EXPECT_NEAR(fraction_before_change({on_floor(1, kSticks, 4, 0)}, {on_floor(1, kSticks, 1, 0)},
                                     {on_floor(1, kOpens, 0, 0)}),
              1.0 / 3, 1e-15);
}

// Of 1 N s that friction bears at most, 0.9 are left, then 0.3: none after half of the next.
TEST(ShareBeforeChange, FrictionIsUsedUp) {
  EXPECT_NEAR(fraction_before_change({on_floor(1, kSticks, 2, 0.1)}, {on_floor(1, kSticks, 2, 0.7)},
                                     {on_floor(1, kSlides, 2, 1)}),
              0.5, 1e-15);
}

TEST(ShareBeforeChange, SlipEnds) {
  EXPECT_NEAR(
      fraction_before_change({on_floor(1, kSlides, 2, 1, 0.5)}, {on_floor(1, kSlides, 2, 1, 0.1)},
                             {on_floor(1, kSticks, 2, 0.5)}),
      0.25, 1e-15);
}

TEST(ShareBeforeChange, FirstOfSeveralCounts) {
  const Contacts earlier{on_floor(1, kSticks, 4, 0), on_floor(2, kSlides, 2, 1, 0.5)};
  const Contacts now{on_floor(1, kSticks, 1, 0), on_floor(2, kSlides, 2, 1, 0.1)};
  EXPECT_NEAR(fraction_before_change(earlier, now, {}), 1.0 / 3, 1e-15);
  EXPECT_NEAR(fraction_before_change(earlier, now, {on_floor(2, kSticks, 2, 0.5)}), 0.25, 1e-15);
}

TEST(ShareBeforeChange, OfALimitItsOneForceFalls) {
  ActiveContact earlier, now;
  earlier.kind = now.kind = ActiveContact::Kind::kLowerLimit;
  earlier.mode = now.mode = kSticks;
  earlier.impulse.x() = 3;
  now.impulse.x() = 1;
  EXPECT_NEAR(fraction_before_change({earlier}, {now}, {}), 0.5, 1e-15);
}

TEST(ShareBeforeChange, IsTheWholeWhereNothingFalls) {
  const Contacts falling{on_floor(1, kSticks, 1, 0)}, rising{on_floor(1, kSticks, 4, 0)};
  EXPECT_EQ(fraction_before_change(falling, rising, {}), 1);
  // Nor where all stay as they are.
  EXPECT_EQ(fraction_before_change(rising, falling, falling), 1);
  EXPECT_EQ(fraction_before_change({}, falling, {}), 0.5);
}

}  // namespace
}  // namespace thenar
