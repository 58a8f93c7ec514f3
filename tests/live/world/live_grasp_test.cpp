// Tests for live/live_grasp.cpp, live_quality.cpp and hand_contact_cache.cpp.

#include "live/world/live_grasp.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "api/close.h"
#include "base/error.h"
#include "base/progress_parts.h"
#include "live/world/live_quality.h"
#include "live/world/world_edits.h"
#include "live/world/world_files.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

std::unique_ptr<LiveWorld> loaded_world(const std::string& name) {
  auto live = std::make_unique<LiveWorld>(LiveWorldFolders{kData, "."});
  (void)load_world(*live, name);
  return live;
}

GraspResult command_answer(const std::string& world, bool approach = true) {
  GraspRequest request;
  request.world.world = world;
  request.world.data = kData;
  request.approach = approach;
  return measure_grasp(request);
}

void expect_same_epsilon(const Epsilon& a, const Epsilon& b) {
  EXPECT_EQ(a.lower, b.lower);
  EXPECT_EQ(a.upper, b.upper);
  EXPECT_EQ(a.force_closure, b.force_closure);
  EXPECT_EQ(a.rank, b.rank);
  EXPECT_EQ(a.worst_wrench, b.worst_wrench);
}

// ---- the same as the command

TEST(LiveGrasp, GraspsAndMeasuresAsTheCommandDoes) {
  for (const char* name : {"barrett_bobbin", "jaw_box", "human_mug"}) {
    SCOPED_TRACE(name);
    const auto live = loaded_world(name);
    const GraspResult told = command_answer(name);
    const HandClosing closing = grasp_object(*live, {}, 1);
    EXPECT_EQ(closing.outcome, told.grasp.outcome);
    // The same posture to the bit, and one step to undo.
    const HandPlacement& placement = live->state().hands[0].placement;
    EXPECT_EQ(placement.q, told.grasp.closed.q);
    EXPECT_EQ(placement.X_WH.p, told.grasp.approached.X_WH.p);
    const GraspResult found = measured_grasp(*live, {});
    expect_same_epsilon(found.grasp.quality, told.grasp.quality);
    ASSERT_EQ(found.grasp.contacts.size(), told.grasp.contacts.size());
    EXPECT_EQ(found.measures->volume.lower, told.measures->volume.lower);
    EXPECT_EQ(found.measures->weight.value, told.measures->weight.value);
    EXPECT_EQ(found.measures->hold.value, told.measures->hold.value);
    EXPECT_EQ(found.outcome.warnings, told.outcome.warnings);
    EXPECT_EQ(found.grasp.closed.stopped, told.grasp.closed.stopped);
    EXPECT_EQ(live->undo(), "grasp with " + hand_name(live->state(), live->state().hands[0]));
    EXPECT_EQ(world_toml(world_spec(live->state())),
              world_toml(read_world(kData + "/worlds/" + name + ".toml")));
  }
}

TEST(LiveGrasp, ClosesAsTheCommandDoes) {
  for (const char* name : {"jaw_box", "arm_cube"}) {
    SCOPED_TRACE(name);
    const auto live = loaded_world(name);
    CloseRequest request;
    request.world.world = name;
    request.world.data = kData;
    const GraspResult told = close_in_world(request).grasp;
    const HandClosing closing = close_on_object(*live, {});
    EXPECT_EQ(closing.outcome, told.grasp.outcome);
    EXPECT_EQ(live->state().hands[0].placement.q, told.grasp.closed.q);
    EXPECT_EQ(closing.closed.stopped, told.grasp.closed.stopped);
  }
}

TEST(LiveGrasp, OfASavedGraspHasTheQualityOfThePosture) {
  const auto live = loaded_world("barrett_bobbin");
  (void)grasp_object(*live, {}, 1);
  const Epsilon before = current_grasp(*live, {}).grasp.quality;
  // Through the text of the world, which keeps every bit.
  LiveWorld again({kData, "."});
  (void)load_world_text(again, world_text(*live), "grasped");
  expect_same_epsilon(current_grasp(again, {}).grasp.quality, before);
}

// An edit replaces the state of the world; a setup keeps the hand as it was.
TEST(LiveGrasp, SetupsStayAsTheyWere) {
  const auto live = loaded_world("jaw_box");
  const LivePairSetup setup = pair_setup(*live, {});
  const HandPlacement before = live->state().hands[0].placement;
  (void)grasp_object(*live, {}, 1);
  new_world(*live);
  EXPECT_EQ(setup.state_hand.placement.q, before.q);
  EXPECT_EQ(setup.state_hand.placement.X_WH.p, before.X_WH.p);
  EXPECT_EQ(setup.collision.hand, &setup.state_hand.built->model());
}

// ---- moving

TEST(LiveGrasp, OpensTheHandAndNotItsArm) {
  const auto live = loaded_world("arm_cube");
  const Eigen::VectorXd before = live->state().hands[0].placement.q;
  (void)close_on_object(*live, {});
  open_hand(*live, "");
  const Eigen::VectorXd after = live->state().hands[0].placement.q;
  const WorldHand& hand = live->state().hands[0].built->hand;
  for (std::size_t part = 1; part < hand.places.size(); ++part)
    for (const int c : hand.places[part]) EXPECT_EQ(after[c], before[c]);
  const Eigen::VectorXd open = open_posture(hand.named.hand->layout());
  for (const int c : hand.places.front()) EXPECT_EQ(after[c], open[c]);
}

TEST(LiveGrasp, AMountedHandDoesNotApproach) {
  const auto live = loaded_world("arm_cube");
  EXPECT_THAT([&] { (void)approach_object(*live, {}, 1); },
              ThrowsMessage<InputError>(HasSubstr("mounted on 'xr4000'")));
}

TEST(LiveGrasp, ApproachEndsAtTheObject) {
  const auto live = loaded_world("barrett_bobbin");
  const ApproachResult met = approach_object(*live, {}, 1);
  EXPECT_TRUE(met.touches);
  EXPECT_EQ(met.body, "bobbin");
  EXPECT_EQ(live->state().hands[0].placement.X_WH.p, met.X_WH.p);
  EXPECT_EQ(live->undo(), "approach with barrett");
}

TEST(LiveGrasp, AHandThatMissesStaysAndSaysSo) {
  const auto live = loaded_world("barrett_bobbin");
  place_thing(*live, "barrett", Eigen::Vector3d(1, 0, 0.4), {});
  const std::string before = world_toml(world_spec(live->state()));
  EXPECT_EQ(grasp_object(*live, {}, 0.1).outcome, GraspOutcome::kMissed);
  EXPECT_FALSE(approach_object(*live, {}, 0.1).touches);
  EXPECT_EQ(world_toml(world_spec(live->state())), before);
  for (const double distance : {0.0, -1.0, std::nan("")})
    EXPECT_THROW((void)grasp_object(*live, {}, distance), InputError);
}

TEST(LiveGrasp, ThatIsStoppedLeavesTheHandWhereItWas) {
  auto live = std::make_unique<LiveWorld>(LiveWorldFolders{kData, "."});
  (void)load_world(*live, "human_mug");
  const std::string before = world_toml(world_spec(live->state()));
  Progress progress;
  progress.stop_requested = [] { return true; };
  EXPECT_THROW((void)grasp_object(*live, {}, 1, progress), Stopped);
  EXPECT_THROW((void)close_on_object(*live, {}, progress), Stopped);
  EXPECT_EQ(world_toml(world_spec(live->state())), before);
}

// ---- contacts

TEST(LiveGrasp, ContactsOfAnInstantLieOnTheObject) {
  const auto live = loaded_world("jaw_box");
  EXPECT_TRUE(live->instant().contacts.empty());
  (void)grasp_object(*live, {}, 1);
  const LiveInstant instant = live->instant();
  check_instant(live->shape(), instant);
  ASSERT_GE(instant.contacts.size(), 6U);  // two flat jaws, each with an area
  const GraspBody& box = live->state().bodies[0].built->body;
  const Pose<double> X_BW = live->state().bodies[0].X_WB.inverse();
  for (const LiveContact& contact : instant.contacts) {
    EXPECT_EQ(live->shape().bodies[static_cast<std::size_t>(contact.b)].name, "box");
    EXPECT_EQ(live->shape().bodies[static_cast<std::size_t>(contact.a)].role, LiveRole::kLink);
    EXPECT_NEAR(box.solid.shape->distance(X_BW * contact.point), 0, 1e-9);
    // The normal leads out of the box: the contact is less deep along it.
    EXPECT_GT(box.solid.shape->distance(X_BW * (contact.point + 1e-3 * contact.normal)), 5e-4);
    EXPECT_GT(contact.friction, 0);
  }
  // Gone once the box is away.
  place_thing(*live, "box", Eigen::Vector3d(1, 1, 1), {});
  EXPECT_TRUE(live->instant().contacts.empty());
}

TEST(LiveGrasp, DeepOverlapsAreTold) {
  const auto live = loaded_world("jaw_box");
  (void)grasp_object(*live, {}, 1);
  EXPECT_TRUE(current_contacts(*live, {}).warnings.empty());
  // Moved by 5 mm into one jaw, which was up to 0.1 mm away.
  Eigen::Vector3d p = live->state().bodies[0].X_WB.p;
  const LiveContact contact = live->instant().contacts[0];
  place_thing(*live, "box", p + 5e-3 * contact.normal, {});
  const LiveContacts found = current_contacts(*live, {});
  ASSERT_EQ(found.warnings.size(), 1U);
  EXPECT_THAT(found.warnings[0], testing::ContainsRegex("is (4[.]9|5[.]0) mm deep in box"));
}

// ---- quality

TEST(LiveGrasp, ShowsTheWorstDisturbanceUntilSomethingMoves) {
  const auto live = loaded_world("barrett_bobbin");
  (void)grasp_object(*live, {}, 1);
  const auto arrows = [&] { return live->instant().arrows; };
  EXPECT_EQ(arrows()[0].vector.norm() + arrows()[1].vector.norm(), 0);
  const GraspResult found = show_quality(*live, {});
  const GraspBody& object = found.setting.setup.object;
  const ScaledWrench& worst = found.grasp.quality.worst_wrench;
  EXPECT_TRUE(matrix_near(arrows()[0].from, object.X_WB * object.com, 1e-15));
  EXPECT_TRUE(matrix_near(arrows()[0].vector, object.X_WB.R * worst.force, 1e-15));
  EXPECT_TRUE(matrix_near(arrows()[1].vector,
                          object.torque_scale * (object.X_WB.R * worst.moment_over_length), 1e-15));
  place_thing(*live, "table", Eigen::Vector3d(0, 0, -0.02), {});
  EXPECT_EQ(arrows()[0].vector.norm() + arrows()[1].vector.norm(), 0);
}

TEST(LiveGrasp, OfOneFingerIsNotClosedAndMissesADirection) {
  const auto live = loaded_world("barrett_bobbin");
  EXPECT_EQ(current_grasp(*live, {}).grasp.outcome, GraspOutcome::kEmpty);
  // The hand comes near and touches from above alone.
  (void)approach_object(*live, {}, 1);
  const GraspResult found = current_grasp(*live, {});
  ASSERT_EQ(found.grasp.outcome, GraspOutcome::kGrasped);
  EXPECT_FALSE(found.grasp.quality.force_closure);
  ASSERT_TRUE(found.grasp.quality.has_missing_direction);
  // Nothing that pushes from above lifts the object: no wrench along the missing direction.
  for (const WrenchCap& cap : found.wrenches.caps)
    EXPECT_LE(cap.c.dot(found.grasp.quality.missing_direction) +
                  (cap.A.transpose() * found.grasp.quality.missing_direction.vector()).norm(),
              1e-9);
}

TEST(LiveGrasp, WrenchSetsHoldTheirForces) {
  const auto live = loaded_world("barrett_bobbin");
  EXPECT_THROW((void)live_wrench_set(*live, {}, {0, 1, 2}, PictureKind::kProjection,
                                     WrenchLimits::kGeometric, 4),
               InputError);
  (void)grasp_object(*live, {}, 1);
  const GraspResult found = current_grasp(*live, {});
  const WrenchSetMesh mesh =
      live_wrench_set(*live, {}, {0, 1, 2}, PictureKind::kProjection, WrenchLimits::kGeometric, 6);
  EXPECT_EQ(mesh.failed, 0);
  // Corners are wrenches of the set: none goes beyond its support function in any direction.
  for (Eigen::Index i = 0; i < mesh.mesh.vertices.cols(); ++i) {
    const ScaledWrench u{mesh.mesh.vertices.col(i).normalized(), {0, 0, 0}};
    EXPECT_LE(mesh.mesh.vertices.col(i).norm(), support(found.wrenches, u, ForceNorm::kL1) + 1e-7);
  }
  // The ball of epsilon fits in.
  EXPECT_GE(mesh.mesh.vertices.colwise().norm().minCoeff(), found.grasp.quality.lower - 1e-7);
  EXPECT_THROW(
      (void)live_wrench_set(*live, {}, {0, 0, 2}, PictureKind::kSlice, WrenchLimits::kGeometric, 4),
      InputError);
}

TEST(LiveGrasp, AsksWhichHandWhereThereAreSeveral) {
  const auto live = loaded_world("barrett_bobbin");
  (void)add_hand(*live, "shadow", {Eigen::Matrix3d::Identity(), Eigen::Vector3d(1, 1, 1)});
  EXPECT_THAT([&] { open_hand(*live, ""); },
              ThrowsMessage<InputError>(HasSubstr("choose one with 'hand'")));
  EXPECT_THAT([&] { open_hand(*live, "barett"); },
              ThrowsMessage<InputError>(HasSubstr("did you mean 'barrett'")));
  EXPECT_THAT(
      [&] {
        (void)current_contacts(*live, {"barrett", "table"});
      },
      ThrowsMessage<InputError>(HasSubstr("is an obstacle")));
}

}  // namespace
}  // namespace thenar
