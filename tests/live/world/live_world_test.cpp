// Tests for live/live_world.cpp, world_state.cpp, world_files.cpp and world_edits.cpp.

#include "live/world/live_world.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "api/named/files.h"
#include "api/named/portable_world.h"
#include "base/error.h"
#include "base/file_io.h"
#include "live/world/world_edits.h"
#include "live/world/world_files.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

/// A working folder of the test, empty at first.
std::string working_folder(const std::string& name) {
  const fs::path folder = fs::path(testing::TempDir()) / ("thenar_live_" + name);
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder.string();
}

std::string toml_of_hand(const LiveWorld& live) {
  WorldSpec world = world_spec(live.state());
  world.bodies.clear();
  return world_toml(world);
}

LiveWorldFolders places(const std::string& folder = ".") { return {kData, folder}; }

const std::vector<std::string>& world_names() {
  static const std::vector<std::string> names{"arm_cube", "barrett_bobbin", "human_mug", "jaw_box"};
  return names;
}

// ---- files

TEST(LiveWorld, BeginsEmptyAndCanBeShownAndSaved) {
  LiveWorld live(places(working_folder("empty")));
  check_instant(live.shape(), live.instant());
  EXPECT_TRUE(live.shape().bodies.empty());
  const std::string file = save_live_world(live, "a/empty.toml");
  EXPECT_TRUE(read_world(file).bodies.empty());
}

TEST(LiveWorld, LoadsEveryWorldWithoutLoss) {
  for (const std::string& name : world_names()) {
    LiveWorld live(places());
    (void)load_world(live, name);
    check_instant(live.shape(), live.instant());
    const std::string file = kData + "/worlds/" + name + ".toml";
    EXPECT_EQ(world_toml(world_spec(live.state())), world_toml(read_world(file))) << name;
    EXPECT_FALSE(live.edit_state().unsaved);
  }
}

TEST(LiveWorld, IsTheSameAfterSavingAndLoadingElsewhere) {
  for (const std::string& name : world_names()) {
    const std::string folder = working_folder("save");
    LiveWorld live(places(folder));
    (void)load_world(live, name);
    const LiveInstant before = live.instant();
    std::string file = save_live_world(live, "deep/er/saved.toml");
    EXPECT_THAT(read_source(file).text, Not(HasSubstr("..")));
    // Moved to a folder of another depth.
    fs::rename(fs::path(folder) / "deep" / "er", fs::path(folder) / "moved");
    file = folder + "/moved/saved.toml";
    LiveWorld again(places(folder));
    (void)load_world(again, file);
    const LiveInstant after = again.instant();
    ASSERT_EQ(after.bodies.size(), before.bodies.size()) << name;
    for (std::size_t i = 0; i < before.bodies.size(); ++i) {
      EXPECT_EQ(after.bodies[i].R, before.bodies[i].R) << name;  // to the bit
      EXPECT_EQ(after.bodies[i].p, before.bodies[i].p) << name;
    }
    EXPECT_EQ(after.joints, before.joints);
    // Saved once more it is the same text; seen from where it came from, that of the original.
    EXPECT_EQ(read_source(save_live_world(again, "moved/twice.toml")).text, read_source(file).text);
    const std::string home = kData + "/worlds";
    EXPECT_EQ(world_toml(seen_from_folder(world_spec(again.state()), home)),
              world_toml(seen_from_folder(world_spec(live.state()), home)));
  }
}

TEST(LiveWorld, TextLoadsFromTheWorkingFolder) {
  const std::string folder = working_folder("text");
  LiveWorld live(places(folder));
  (void)load_world(live, "jaw_box");
  const std::string text = world_text(live);
  LiveWorld again(places(folder));
  (void)load_world_text(again, text, "mine");
  EXPECT_EQ(world_text(again), text);
  EXPECT_EQ(again.instant().joints, live.instant().joints);
}

TEST(LiveWorld, SavesNowhereButInItsFolder) {
  const std::string folder = working_folder("inside"), other = working_folder("outside");
  fs::create_directory_symlink(other, fs::path(folder) / "link");
  // Links that lead nowhere yet, and to a file of somebody else.
  fs::create_symlink(other + "/new.toml", fs::path(folder) / "dangling.toml");
  fs::create_directory_symlink(other + "/deep", fs::path(folder) / "gone");
  fs::create_symlink("within.toml", fs::path(folder) / "alias.toml");
  LiveWorld live(places(folder));
  for (const std::string& file :
       {std::string(), std::string("/tmp/x.toml"), std::string("../x.toml"),
        std::string("a/../../x.toml"), std::string("x.txt"), std::string(".toml"),
        std::string("link/x.toml"), std::string("a/b/../../../x.toml"),
        std::string("dangling.toml"), std::string("gone/x.toml"), std::string("alias.toml"),
        std::string(".x.toml"), std::string(".config/x.toml"), std::string(".bashrc\0.toml", 13),
        std::string("x\0.toml", 7), std::string("x\n.toml"), std::string("x.toml/")}) {
    EXPECT_THROW((void)save_live_world(live, file), InputError) << file;
    EXPECT_THROW((void)save_live_world(live, file, Overwrite::kAnything), InputError) << file;
  }
  EXPECT_TRUE(fs::is_empty(other));
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  EXPECT_THAT(names, testing::ElementsAre("alias.toml", "dangling.toml", "gone", "link"));
}

TEST(LiveWorld, RefusesNamesThatTheSystemDoesNotTake) {
  const std::string folder = working_folder("names");
  fs::create_symlink("circle.toml", fs::path(folder) / "circle.toml");
  LiveWorld live(places(folder));
  for (const std::string& file : {std::string(600, 'a') + ".toml",
                                  std::string(600, 'a') + "/x.toml", std::string("circle.toml")})
    EXPECT_THAT([&] { (void)save_live_world(live, file); },
                ThrowsMessage<InputError>(HasSubstr("cannot be written: ")))
        << file;
}

// The file that a world was loaded from or saved to is its own; any other one is somebody else's.
TEST(LiveWorld, ReplacesNoFileOfOthersUnlessToldTo) {
  const std::string folder = working_folder("over");
  write_file(folder + "/scene.toml", "# somebody else's\n");

  LiveWorld live(places(folder));
  (void)load_world(live, "jaw_box");
  EXPECT_THAT([&] { (void)save_live_world(live, "scene.toml"); },
              ThrowsMessage<InputError>(HasSubstr("'overwrite' replaces it")));
  EXPECT_EQ(read_source(folder + "/scene.toml").text, "# somebody else's\n");
  // A new file, then the same one again, also by another name of it.
  (void)save_live_world(live, "new.toml");
  place_thing(live, "box", Eigen::Vector3d(1, 0, 0), {});
  (void)save_live_world(live, "./new.toml");
  LiveWorld again(places(folder));
  (void)load_world(again, folder + "/new.toml");
  (void)save_live_world(again, "new.toml");
  // Another world does not take its place, a new one of the same session neither.
  new_world(again);
  EXPECT_THROW((void)save_live_world(again, "new.toml"), InputError);
  EXPECT_EQ(read_world_at(folder + "/new.toml", kData).hands.size(), 1U);
  (void)save_live_world(again, "new.toml", Overwrite::kAnything);
  EXPECT_TRUE(read_world(folder + "/new.toml").hands.empty());
}

TEST(LiveWorld, StaysAsItWasWhereALoadFails) {
  LiveWorld live(places());
  (void)load_world(live, "jaw_box");
  const std::string before = world_toml(world_spec(live.state()));
  const unsigned long changes = live.changes();
  EXPECT_THROW((void)load_world(live, "jaw_bix"), InputError);
  EXPECT_THROW((void)load_world_text(live, "name = 3", "x"), DataError);
  EXPECT_THROW(
      (void)load_world_text(live, "name = 'x'\nsource = 'Scene'\n[[hand]]\nname = 'nobody'", "x"),
      Error);
  EXPECT_EQ(world_toml(world_spec(live.state())), before);
  EXPECT_EQ(live.changes(), changes);
}

/// A robot whose palm is a tetrahedron of this height [m], in a file beside it.
void write_mesh_robot(const std::string& folder, double height) {
  write_file(folder + "/palm.obj", fmt::format("v 0 0 0\nv .02 0 0\nv 0 .02 0\nv 0 0 {}\n"
                                               "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
                                               height));
  write_file(folder + "/own.urdf",
             "<robot name='own'><link name='palm'><collision><geometry><mesh filename='palm.obj'/>"
             "</geometry></collision></link><link name='finger'><collision><geometry>"
             "<box size='.01 .01 .03'/></geometry></collision></link>"
             "<joint name='bend' type='revolute'><parent link='palm'/><child link='finger'/>"
             "<origin xyz='0 0 .05'/><axis xyz='1 0 0'/><limit lower='0' upper='1' effort='1'"
             " velocity='1'/></joint></robot>");
  write_file(folder + "/own.toml",
             "name = 'own'\nsource = 'Scene'\n[sources]\nScene = 'Made up'\n"
             "[camera]\neye_m = [1, 0, 0]\ntarget_m = [0, 0, 0]\n"
             "[[hand]]\nname = 'own'\nfile = 'own.urdf'\n");
}

/// The highest corner of the first body of a world [m].
double top_of(const LiveWorld& live) {
  return live.shape().bodies.at(0).mesh->vertices.row(2).maxCoeff();
}

TEST(LiveWorld, ReadsAHandAnewWhoseMeshWasEdited) {
  const std::string folder = working_folder("edited");
  write_mesh_robot(folder, 0.03);
  LiveWorld live(places(folder));
  (void)load_world(live, folder + "/own.toml");
  EXPECT_NEAR(top_of(live), 0.03, 1e-9);
  write_mesh_robot(folder, 0.04);
  (void)load_world(live, folder + "/own.toml");
  EXPECT_NEAR(top_of(live), 0.04, 1e-9);
  // A step back shows what was there.
  (void)live.undo();
  EXPECT_NEAR(top_of(live), 0.03, 1e-9);
}

// ---- edits

TEST(LiveWorld, NothingIsBuiltAgainBecauseSomethingMoves) {
  LiveWorld live(places());
  (void)load_world(live, "barrett_bobbin");
  const unsigned long shape = live.shape_changes();
  const LiveHand* hand = live.state().hands[0].built.get();
  const BuiltBody* body = live.state().bodies[0].built.get();
  place_thing(live, "bobbin", Eigen::Vector3d(0.1, 0, 0.2), {});
  place_thing(live, "barrett", Eigen::Vector3d(0, 0, 0.5), {});
  (void)set_joints(live, "barrett", {{"spread", 0.3}});
  (void)live.undo();
  EXPECT_EQ(live.shape_changes(), shape);
  EXPECT_EQ(live.state().hands[0].built.get(), hand);
  EXPECT_EQ(live.state().bodies[0].built.get(), body);
  // Nor where it is loaded again.
  (void)load_world(live, "barrett_bobbin");
  EXPECT_EQ(live.state().hands[0].built.get(), hand);
  EXPECT_EQ(live.shape_changes(), shape + 1);
}

TEST(LiveWorld, MovesWhatIsPlacedAndLeavesTheRest) {
  LiveWorld live(places());
  (void)load_world(live, "jaw_box");
  const std::string hand = toml_of_hand(live);
  place_thing(live, "box", Eigen::Vector3d(0.1, 0.2, 0.3), {});
  EXPECT_EQ(live.instant().bodies[live.shape().bodies.size() - 3].p,
            Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(toml_of_hand(live), hand);  // its posture as written: the motor's name, not the joint's
}

TEST(LiveWorld, SaysOnWhatAHandIsMounted) {
  LiveWorld live(places());
  (void)load_world(live, "arm_cube");
  EXPECT_THAT([&] { place_thing(live, "parallel_jaw", Eigen::Vector3d::Zero(), {}); },
              ThrowsMessage<InputError>(
                  testing::AllOf(HasSubstr("mounted on 'puma560' (link 6)"), HasSubstr("xr4000"))));
  // All of it moves with what stands on the ground.
  const Eigen::Vector3d by(0.3, -0.2, 0.1);
  const LiveInstant before = live.instant();
  place_thing(live, "xr4000", before.bodies[0].p + by, {});
  const LiveInstant after = live.instant();
  const std::size_t hand_bodies = live.state().hands[0].built->bodies.size();
  for (std::size_t i = 0; i < hand_bodies; ++i)
    EXPECT_TRUE(matrix_near(after.bodies[i].p, before.bodies[i].p + by, 1e-12));
}

TEST(LiveWorld, KeepsJointsWithinTheirLimitsAndTellsWhich) {
  LiveWorld live(places());
  (void)load_world(live, "human_mug");
  const HandLayout& layout = live.state().hands[0].built->model().layout();
  const std::string joint = layout.coordinates[3];
  const JointChange set = set_joints(live, "", {{joint, 100}});
  EXPECT_EQ(set.limited, std::vector<std::string>{joint});
  EXPECT_EQ(set.joints.at(joint), layout.upper[3]);
  EXPECT_THROW((void)set_joints(live, "", {{joint, NAN}}), InputError);
  EXPECT_THAT(
      [&] {
        (void)set_joints(live, "", {{joint + "x", 0}});
      },
      ThrowsMessage<InputError>(HasSubstr("did you mean '" + joint + "'")));
}

TEST(LiveWorld, CoupledJointsFollowTheirLeader) {
  LiveWorld live(places());
  (void)load_world(live, "barrett_bobbin");
  const LiveHand& hand = *live.state().hands[0].built;
  const std::vector<std::string>& names = hand.model().layout().coordinates;
  int pairs = 0;
  for (std::size_t f = 0; f < names.size(); ++f) {
    if (hand.couplings[f].leader < 0) continue;
    const std::string leader = names[static_cast<std::size_t>(hand.couplings[f].leader)];
    const JointChange set = set_joints(live, "", {{leader, 0.9}});
    EXPECT_NEAR(set.joints.at(names[f]), 0.9 * hand.couplings[f].ratio, 1e-15);
    EXPECT_TRUE(set.parted.empty());
    // A posture in which the clutch is open can be set as a whole, and is told.
    const JointChange open = set_joints(live, "", {{leader, 0.9}, {names[f], 0.5}});
    EXPECT_EQ(open.joints.at(leader), 0.9);
    EXPECT_EQ(open.joints.at(names[f]), 0.5);
    EXPECT_THAT(open.parted, testing::ElementsAre(names[f]));
    EXPECT_THAT(set_joints(live, "", {{"spread", 0.1}}).parted, testing::ElementsAre(names[f]));
    // One motor moves both: the follower alone takes its leader along.
    const JointChange led = set_joints(live, "", {{names[f], 0.25}});
    EXPECT_EQ(led.joints.at(names[f]), 0.25);
    EXPECT_NEAR(led.joints.at(leader), 0.25 / hand.couplings[f].ratio, 1e-15);
    EXPECT_TRUE(led.parted.empty());
    // Beyond its limit both stop where the drive does.
    const JointChange limited = set_joints(live, "", {{names[f], 5}});
    EXPECT_THAT(limited.limited, testing::UnorderedElementsAre(leader, names[f]));
    EXPECT_TRUE(limited.parted.empty());
    ++pairs;
  }
  EXPECT_EQ(pairs, 3);  // three fingers
}

TEST(LiveWorld, AddsObjectsAndHandsUnderNamesThatAreFree) {
  LiveWorld live(places(working_folder("add")));
  EXPECT_EQ(add_object(live, "mug", true, {}).name, "mug");
  EXPECT_EQ(add_object(live, "mug", false, {}).name, "mug 2");
  EXPECT_EQ(add_hand(live, "barrett", {}).name, "barrett");
  EXPECT_EQ(add_hand(live, "barrett", {}).name, "barrett 2");
  EXPECT_EQ(add_hand(live, "human", {}).name, "human:tendons");
  EXPECT_THROW(add_hand(live, "human:tendons", {}), InputError);
  EXPECT_EQ(add_hand(live, kData + "/subjects/human_hand.toml:soft", {}).name, "human_hand:soft");
  EXPECT_EQ(add_hand(live, kData + "/subjects/human_hand.toml:soft", {}).name, "human_hand 2:soft");
  check_instant(live.shape(), live.instant());
  // What was added is there after saving.
  LiveWorld again(places());
  (void)load_world(again, save_live_world(live, "all.toml"));
  EXPECT_EQ(again.shape().bodies.size(), live.shape().bodies.size());
}

TEST(LiveWorld, RemovesAHandAndLeavesItsArm) {
  LiveWorld live(places());
  (void)load_world(live, "arm_cube");
  EXPECT_THROW(remove_thing(live, "puma560"), InputError);
  remove_thing(live, "parallel_jaw");
  EXPECT_EQ(hand_names(live.state()), std::vector<std::string>{"puma560"});
  remove_thing(live, "puma560");
  EXPECT_EQ(hand_names(live.state()), std::vector<std::string>{"xr4000"});
  remove_thing(live, "xr4000");
  EXPECT_TRUE(live.state().hands.empty());
  for (int i = 0; i < 3; ++i) (void)live.undo();
  EXPECT_EQ(world_toml(world_spec(live.state())),
            world_toml(read_world(kData + "/worlds/arm_cube.toml")));
}

// ---- undo

TEST(LiveWorld, UndoesAGestureAsOneStep) {
  LiveWorld live(places());
  (void)load_world(live, "jaw_box");
  const auto drag_box = [&](double to, const std::string& gesture) {
    for (int i = 1; i <= 10; ++i)
      place_thing(live, "box", Eigen::Vector3d(0.1 * to * i, 0, 0), {}, gesture);
  };
  drag_box(0.5, "first drag");
  drag_box(1, "second drag");
  for (int i = 1; i <= 10; ++i) (void)set_joints(live, "", {{"opening", 0.001 * i}}, "slider");
  drag_box(2, "second drag");  // something came between
  const auto x = [&] { return live.state().bodies[0].X_WB.p.x(); };
  EXPECT_EQ(x(), 2);
  (void)live.undo();
  EXPECT_EQ(x(), 1);
  EXPECT_EQ(joints_of(live.state(), 0)["opening"], 0.01);
  (void)live.undo();
  EXPECT_EQ(joints_of(live.state(), 0)["opening"], 0.05);  // as the world has it
  (void)live.undo();
  EXPECT_EQ(x(), 0.5);
  (void)live.undo();
  EXPECT_EQ(x(), 0);
}

TEST(LiveWorld, UndoesMovesOfNoGestureOneByOne) {
  LiveWorld live(places());
  (void)load_world(live, "jaw_box");
  for (const double x : {0.1, 0.2, 0.3}) {
    place_thing(live, "box", Eigen::Vector3d(x, 0, 0), {});
    (void)set_joints(live, "", {{"opening", 0.1 * x}});
    (void)set_joints(live, "", {{"opening", 0.05 * x}});
  }
  for (const double x : {0.3, 0.2, 0.1}) {
    EXPECT_EQ(joints_of(live.state(), 0)["opening"], 0.05 * x);
    (void)live.undo();
    EXPECT_EQ(joints_of(live.state(), 0)["opening"], 0.1 * x);
    (void)live.undo();
    EXPECT_EQ(live.state().bodies[0].X_WB.p.x(), x);
    (void)live.undo();
  }
  EXPECT_EQ(live.state().bodies[0].X_WB.p.x(), 0);
}

TEST(LiveWorld, AnEditAfterUndoIsOneOfItsOwn) {
  LiveWorld live(places());
  (void)load_world(live, "jaw_box");
  place_thing(live, "box", Eigen::Vector3d(1, 0, 0), {});
  place_thing(live, "table", Eigen::Vector3d(1, 0, 0), {});
  (void)live.undo();
  place_thing(live, "box", Eigen::Vector3d(2, 0, 0), {});
  EXPECT_FALSE(live.edit_state().redo);
  (void)live.undo();
  EXPECT_EQ(live.state().bodies[0].X_WB.p.x(), 1);
}

/// One edit drawn at random; those that are refused are none.
void edit_at_random(LiveWorld& live, std::mt19937& random) {
  const auto draw = [&](int count) {
    return static_cast<int>(random() % static_cast<unsigned>(count));
  };
  const auto pick = [&](const std::vector<std::string>& names) {
    return names.empty() ? std::string("nobody")
                         : names[static_cast<std::size_t>(draw(static_cast<int>(names.size())))];
  };
  const Eigen::Vector3d p(0.01 * draw(50), 0.01 * draw(50), 0.01 * draw(50));
  const Eigen::Matrix3d R = Eigen::AngleAxisd(0.1 * draw(60), Eigen::Vector3d::UnitX()).matrix();
  try {
    switch (draw(9)) {
      case 0:
        add_object(live, pick({"box", "sphere_25", "cube_50"}), draw(2) == 0, {R, p});
        break;
      case 1:
        add_hand(live, pick({"barrett", "parallel_jaw", "shadow"}), {R, p});
        break;
      case 2:
        if (live.state().bodies.size() + live.state().hands.size() > 6)
          remove_thing(
              live, draw(2) == 0 ? pick(body_names(live.state())) : pick(hand_names(live.state())));
        break;
      case 3:
        new_world(live);
        break;
      case 4:
        (void)load_world(live, pick({"arm_cube", "jaw_box"}));
        break;
      case 5:
      case 6:
        place_thing(live,
                    draw(2) == 0 ? pick(body_names(live.state())) : pick(hand_names(live.state())),
                    p, R);
        break;
      default: {
        const std::string hand = pick(hand_names(live.state()));
        const std::size_t index = hand_index(live.state(), hand);
        const auto& names = live.state().hands[index].built->model().layout().coordinates;
        (void)set_joints(live, hand, {{pick(names), 0.05 * draw(60) - 1}});
      }
    }
  } catch (const InputError&) {
  }
}

TEST(LiveWorld, UndoAndRedoOf500EditsGoThroughTheSameWorlds) {
  LiveWorld live(places());
  std::mt19937 random(7);
  std::vector<std::string> tomls{world_toml(world_spec(live.state()))};
  for (int i = 0; i < 500; ++i) {
    const std::optional<std::string> top = live.edit_state().undo;
    const unsigned long before = live.changes();
    edit_at_random(live, random);
    if (live.changes() == before) continue;
    tomls.push_back(world_toml(world_spec(live.state())));
  }
  ASSERT_GT(tomls.size(), 250U);
  // Back, as far as it goes. Merged edits skip worlds, but never their order.
  std::vector<std::string> way{tomls.back()};
  while (live.edit_state().undo) {
    (void)live.undo();
    way.push_back(world_toml(world_spec(live.state())));
    check_instant(live.shape(), live.instant());
  }
  EXPECT_EQ(way.size(), LiveWorld::kMaxUndoSteps + 1);
  std::size_t at = tomls.size();
  for (const std::string& toml : way) {
    while (at > 0 && tomls[at - 1] != toml) --at;
    ASSERT_GT(at, 0U) << "a world that never was";
  }
  // And forth, the same way.
  for (std::size_t i = way.size() - 1; i-- > 0;) {
    (void)live.redo();
    EXPECT_EQ(world_toml(world_spec(live.state())), way[i]);
  }
  EXPECT_FALSE(live.edit_state().redo);
  EXPECT_THROW((void)live.redo(), InputError);
}

TEST(LiveWorld, KnowsWhetherItIsSaved) {
  LiveWorld live(places(working_folder("unsaved")));
  (void)load_world(live, "jaw_box");
  place_thing(live, "box", Eigen::Vector3d(1, 0, 0), {});
  EXPECT_TRUE(live.edit_state().unsaved);
  const std::string file = save_live_world(live, "x.toml");
  EXPECT_FALSE(live.edit_state().unsaved);
  (void)live.undo();
  EXPECT_TRUE(live.edit_state().unsaved);
  EXPECT_EQ(live.edit_state().file, file);  // to which it would be saved again
  (void)live.redo();
  EXPECT_FALSE(live.edit_state().unsaved);
}

}  // namespace
}  // namespace thenar
