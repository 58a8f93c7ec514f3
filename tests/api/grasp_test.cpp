// Tests for api/grasp.cpp.

#include "api/grasp.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file_io.h"
#include "data/io/robot/urdf.h"
#include "grasp/compare/pregrasp.h"
#include "tests/data_folder.h"
#include "tests/grasp/four_bars.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

GraspRequest bobbin() {
  GraspRequest request;
  request.world.world = "barrett_bobbin";
  request.world.data = kData;
  return request;
}

TEST(GraspInWorld, OwnsWhatItFound) {
  GraspResult found = measure_grasp(bobbin());
  const GraspResult copy = found;
  found = GraspResult{};  // its hand lives on in the copy
  EXPECT_FALSE(copy.outcome.stopped());
  EXPECT_EQ(copy.started(), 1);
  EXPECT_EQ(copy.grasp.outcome, GraspOutcome::kGrasped);
  EXPECT_EQ(copy.collision_hand.hand, copy.setting.hand.named.hand.get());
  EXPECT_FALSE(copy.collision_hand.hand->surfaces().empty());
  ASSERT_TRUE(copy.measures);
  EXPECT_FALSE(copy.robustness);  // not asked
}

TEST(GraspInWorld, SavesTheHandWhereItEnded) {
  const GraspResult found = measure_grasp(bobbin());
  const WorldSpec world = grasped_world(found);
  ASSERT_EQ(world.hands.size(), 1U);
  EXPECT_TRUE(world.hands[0].X_WH.p.isApprox(found.grasp.approached.X_WH.p));
  GraspResult none = found;
  none.grasp.outcome = GraspOutcome::kMissed;
  EXPECT_THROW((void)grasped_world(none), InputError);
}

TEST(GraspInWorld, CountsEveryStart) {
  GraspRequest request = bobbin();
  request.starts = 2;
  request.world.hand = "parallel_jaw";  // not of this world
  try {
    const GraspResult found = measure_grasp(request);
    EXPECT_EQ(found.started(), 2);
    EXPECT_GE(found.best, 0);
  } catch (const InputError&) {  // both starts may begin in something
  }
}

const std::string kShipped = std::string(kData) + "/robots/robotiq_2f85.toml";

/// A gripper whose jaws are longer than the ball is thick, over it.
class GraspOffThePalm : public TemporaryFolder {
 protected:
  [[nodiscard]] GraspResult of_ball(double radius_mm, const std::string& hand = kShipped) const {
    write_file(
        path("world.toml"),
        fmt::format("name = 'w'\nsource = 'S'\n[sources]\nS = 'made up'\n[[hand]]\nname = 'h'\n"
                    "file = '{}'\n[[body]]\nrole = 'object'\n"
                    "name = 'ball'\nmaterial = 'wood'\nposition_mm = [0, 0, 300]\n"
                    "[[body.shape]]\nkind = 'sphere'\nsize_mm = [{}]\n",
                    hand, radius_mm));
    GraspRequest request;
    request.world.world = path("world.toml");
    request.world.data = kData;
    return measure_grasp(request);
  }
};

// A ball of 50 mm that touches the palm lies under the pads: they close beyond it, on nothing.
TEST_F(GraspOffThePalm, BringsBothPadsToASmallBall) {
  const GraspResult found = of_ball(25);
  EXPECT_GT(found.start.stand_off, 0);
  std::set<std::string> digits;
  for (const HandContact& contact : found.grasp.contacts)
    digits.insert(
        found.collision_hand.hand->surfaces()[static_cast<std::size_t>(contact.surface)].digit);
  EXPECT_EQ(digits.size(), 2U);
  EXPECT_EQ(digits.count(""), 0U);
  EXPECT_EQ(std::count_if(found.outcome.warnings.begin(), found.outcome.warnings.end(),
                          [](const std::string& warning) {
                            return warning.find("the hand moved back before it closed") !=
                                   std::string::npos;
                          }),
            1);
}

// Bars of a linkage close on a ball that lies on the palm, but fingers are there to hold it.
TEST_F(GraspOffThePalm, HoldsByFingersWhatBarsWouldHold) {
  (void)write_urdf(path("bars.urdf"), sample::four_bars(0));
  for (const double radius : {8.0, 12.0, 20.0}) {
    const GraspResult found = of_ball(radius, path("bars.urdf"));
    EXPECT_EQ(touching_tips(*found.collision_hand.hand, found.grasp.contacts).size(), 2U) << radius;
  }
}

TEST_F(GraspOffThePalm, StaysOnThePalmWhereItHolds) { EXPECT_EQ(of_ball(35).start.stand_off, 0); }

TEST(GraspInWorld, RefusesNumbersOutOfRange) {
  const auto refused = [](auto change) {
    GraspRequest request = bobbin();
    change(request);
    EXPECT_THROW((void)measure_grasp(request), InputError);
  };
  refused([](GraspRequest& r) { r.tolerance = 0; });
  refused([](GraspRequest& r) { r.approach_distance = 0; });
  refused([](GraspRequest& r) { r.starts = -1; });
  refused([](GraspRequest& r) { r.edges = 2; });
  refused([](GraspRequest& r) { r.robustness.draws = -1; });
  refused([](GraspRequest& r) { r.approach = false, r.starts = 1; });
}

TEST(GraspInWorld, StopsBeforeTheFirstGraspWithNothing) {
  Progress progress;
  progress.stop_requested = [] { return true; };
  EXPECT_ANY_THROW((void)measure_grasp(bobbin(), progress));
}

}  // namespace
}  // namespace thenar
