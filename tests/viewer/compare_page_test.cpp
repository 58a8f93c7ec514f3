// Tests for viewer/compare_page.cpp.

#include "viewer/compare_page.h"

#include <cmath>

#include <gtest/gtest.h>

#include "data/io/robot/robot.h"
#include "grasp/closing_drives.h"
#include "grasp/robot_hand.h"

namespace thenar {
namespace {

/// One hand on two objects: three of four approaches closed on the ball, none on the card.
Comparison sample() {
  Comparison comparison;
  comparison.hands = {"jaws"};
  comparison.objects = {"ball", "card"};
  comparison.tasks = {"force-closure"};
  comparison.approaches = 4;
  comparison.complete = true;
  HandOnObject ball;
  ball.hand = "jaws";
  ball.object = "ball";
  ball.approaches = 4;
  ball.closures = 3;
  ball.success = 0.75;
  ball.epsilon = Eigen::Vector3d(0.1, 0.2, 0.4);
  HandOnObject card = ball;
  card.object = "card";
  card.closures = 0;
  card.success = 0;
  card.epsilon.resize(0);
  comparison.cells = {ball, card};
  HandAbilities abilities;
  abilities.hand = "jaws";
  abilities.opposition = NAN;
  comparison.abilities = {abilities};
  return comparison;
}

const Json& section_of(const Json& page, const std::string& id) {
  for (const Json& each : page)
    if (each["id"] == id) return each;
  throw std::runtime_error("no section " + id);
}

TEST(ComparePage, CountsOverAllObjects) {
  MeshTable meshes;
  const Json page = compare_page(sample(), {}, {}, meshes);
  const Json& row = section_of(page, "glance")["blocks"][1]["rows"][0];
  EXPECT_EQ(row[0], "jaws");
  EXPECT_EQ(row[1], 37.5);  // 3 of 8 approaches
  EXPECT_EQ(row[2], 1);     // of two objects
  EXPECT_TRUE(row[4].is_null());
}

TEST(ComparePage, ShowsQuantilesWhereThereAreGrasps) {
  MeshTable meshes;
  const Json page = compare_page(sample(), {}, {}, meshes);
  const Json& pair = section_of(page, "quality")["blocks"][0]["blocks"];
  EXPECT_EQ(pair[0]["rows"][0]["estimate"], 0.2);
  EXPECT_EQ(pair[0]["rows"][0]["high"], 0.4);
  EXPECT_EQ(pair[1]["rows"][0]["display"], "no force closure");
}

TEST(ComparePage, SaysWhatIsMissingOfOneThatWasStopped) {
  Comparison comparison = sample();
  comparison.complete = false;
  comparison.cells.pop_back();
  MeshTable meshes;
  const Json page = compare_page(comparison, {}, {}, meshes);
  const Json& banner = section_of(page, "glance")["blocks"][0];
  EXPECT_EQ(banner["ok"], false);
  EXPECT_EQ(banner["title"], "Not finished: 1 of 2 cells");
}

// Every mesh that a picture names is in the table, once however many pictures show it.
TEST(ComparePage, SharesMeshesBetweenPictures) {
  const auto jaws =
      std::make_shared<RobotHand>(read_robot(THENAR_DATA_DIR "/robots/parallel_jaw.toml"));
  MeshTable meshes;
  const std::vector<ComparePicture> pictures{{"jaws", jaws, {}}, {"again", jaws, {}}};
  const Json blocks = hands_section(pictures, meshes)["blocks"][0]["blocks"];
  ASSERT_EQ(blocks.size(), 2U);
  EXPECT_LE(meshes.json().size(), jaws->surfaces().size());
  for (const Json& layer : blocks[1]["layers"])
    for (const Json& item : layer["items"]) EXPECT_TRUE(meshes.json().contains(item["mesh"]));
}

}  // namespace
}  // namespace thenar
