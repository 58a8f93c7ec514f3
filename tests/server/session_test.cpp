// Tests for server/session.cpp: models by mode, and revisions that only go up.

#include "server/session.h"

#include <gtest/gtest.h>

#include "tests/message_of.h"
#include "tests/server/small_model.h"

namespace thenar {
namespace {

TEST(Session, BeginsWithNothingToShow) {
  const Session session({});
  EXPECT_EQ(session.shown_model(), nullptr);
  EXPECT_EQ(session.mode_name(), "world");
  EXPECT_FALSE(session.has_model(LiveMode::kWorld));
  EXPECT_EQ(session.revision(), 0U);
}

// A client that holds the revision of a scene holds it for that scene alone.
TEST(Session, RevisionsGoUpWithEveryChange) {
  Session session({});
  const auto motion = std::make_shared<SmallModel>(), fit = std::make_shared<SmallModel>();
  unsigned long last = session.revision();
  const auto expect_up = [&](const char* what) {
    EXPECT_GT(session.revision(), last) << what;
    last = session.revision();
  };
  session.open(LiveMode::kMotion, motion);
  expect_up("a model");
  motion->rename("ball");
  expect_up("its shape");
  motion->rename("box");
  motion->rename("cup");
  expect_up("its shape, twice");
  session.open(LiveMode::kFit, fit);  // whose shape never changed
  expect_up("another mode");
  session.show(LiveMode::kMotion);
  expect_up("the first one again");
  session.open(LiveMode::kMotion, std::make_shared<SmallModel>());
  expect_up("a new model in its place");
  // What moves without another shape is no revision.
  session.model<SmallModel>(LiveMode::kMotion).lift(0.2);
  EXPECT_EQ(session.revision(), last);
  session.show(LiveMode::kMotion);
  EXPECT_EQ(session.revision(), last);
}

TEST(Session, AMotionThatIsNotShownPauses) {
  Session session({});
  const auto motion = std::make_shared<SmallModel>();
  motion->playing = true;
  session.open(LiveMode::kMotion, motion);
  session.show(LiveMode::kMotion);
  EXPECT_TRUE(motion->playing);
  session.open(LiveMode::kTendons, std::make_shared<SmallModel>());
  EXPECT_FALSE(motion->playing);
}

TEST(Session, SaysWhichMethodOpensWhatIsNotOpen) {
  Session session({});
  EXPECT_EQ(message_of([&] { session.show(LiveMode::kTendons); }),
            "no digit is open: call tendons.open");
  EXPECT_EQ(message_of([&] { (void)session.model<SmallModel>(LiveMode::kWorld); }),
            "no world is open: call world.new or world.load");
  EXPECT_EQ(message_of([&] { (void)session.model<SmallModel>(LiveMode::kFit); }),
            "no fit is open: call fit.open");
  EXPECT_EQ(session.find_model<SmallModel>(LiveMode::kMotion), nullptr);
  EXPECT_EQ(message_of([&] { session.show(LiveMode::kMotion); }),
            "no scene that moves is open: call motion.open or motion.record");
}

}  // namespace
}  // namespace thenar
