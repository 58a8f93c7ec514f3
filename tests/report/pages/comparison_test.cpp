// Tests for report/pages/comparison.cpp.

#include "report/pages/comparison.h"

#include <cmath>

#include <gtest/gtest.h>

#include "data/io/robot/robot.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/robot/robot_hand.h"
#include "report/answers/comparison.h"

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
  card.outcomes[static_cast<std::size_t>(GraspOutcome::kGrasped)] = 4;
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
  EXPECT_EQ(row[1], 37.5);        // 3 of 8 approaches
  EXPECT_EQ(row[2], "14 to 69");  // of Wilson, 95 %
  EXPECT_EQ(row[3], 1);           // of two objects
  EXPECT_EQ(row[4], 0.4);         // the best on the only object held
  EXPECT_TRUE(row[5].is_null());
}

// 20 of 40 against 14 of 40: the interval of the first begins at 35.2 %, above the second's share
// of 35 %, but so large a difference comes by chance in a quarter of equal pairs.
TEST(ComparePage, MarksAWinnerOnlyBeyondChance) {
  for (const auto& [second, wins] : {std::pair(10, true), std::pair(14, false)}) {
    Comparison comparison = sample();
    comparison.hands.emplace_back("other");
    for (HandOnObject& cell : comparison.cells) cell.approaches = cell.closures = 20;
    comparison.cells[1].closures = 0;
    for (HandOnObject cell : std::vector<HandOnObject>(comparison.cells)) {
      cell.hand = "other";
      cell.closures = cell.object == "ball" ? second : 0;
      comparison.cells.push_back(cell);
    }
    MeshTable meshes;
    const Json page = compare_page(comparison, {}, {}, meshes);
    EXPECT_EQ(section_of(page, "glance")["blocks"][1].contains("highlight_best"), wins) << second;
  }
}

TEST(ComparePage, ShowsQuantilesWhereThereAreGrasps) {
  Comparison comparison = sample();
  comparison.cells[0].hand_epsilon = Eigen::Vector2d(1, 3);  // efforts are known for two of three
  MeshTable meshes;
  const Json page = compare_page(comparison, {}, {}, meshes);
  const Json& pairs = section_of(page, "quality")["blocks"];
  const Json& geometric = pairs[0]["blocks"][0]["rows"][0];
  EXPECT_EQ(geometric["estimate"], 0.2);
  EXPECT_EQ(geometric["high"], 0.4);
  const Json& limited = pairs[0]["blocks"][1]["rows"][0];
  EXPECT_EQ(limited["estimate"], 2.0);
  EXPECT_EQ(limited["display"], "2, n = 2 of 3");
  for (const Json& chart : pairs[1]["blocks"])
    EXPECT_EQ(chart["rows"][0]["display"], "no closure in 4");
}

// Ends of 0.4, 0.5 and 9: the last is beyond thrice the median, the axis ends a tenth past 0.5.
TEST(ComparePage, CutsTheAxisWhereOneHandWouldStretchIt) {
  Comparison comparison = sample();
  comparison.hands = {"jaws", "fingers", "vice"};
  HandOnObject fingers = comparison.cells[0], vice = comparison.cells[0];
  fingers.hand = "fingers";
  fingers.epsilon[2] = 0.5;
  vice.hand = "vice";
  vice.epsilon[2] = 9;
  MeshTable meshes;
  const auto chart = [&] {
    const Json page = compare_page(comparison, {}, {}, meshes);
    return section_of(page, "quality")["blocks"][0]["blocks"][0];
  };
  comparison.cells = {comparison.cells[0], fingers};
  EXPECT_FALSE(chart().contains("x_most"));
  comparison.cells.push_back(vice);
  EXPECT_DOUBLE_EQ(chart()["x_most"], 0.55);
  EXPECT_NE(chart()["caption"].get<std::string>().find("cut"), std::string::npos);
}

TEST(ComparePage, SaysThatEffortsAreUnknown) {
  MeshTable meshes;
  const Json page = compare_page(sample(), {}, {}, meshes);
  const Json& limited = section_of(page, "quality")["blocks"][0]["blocks"][1];
  EXPECT_EQ(limited["rows"][0]["display"], "efforts unknown");
  EXPECT_TRUE(limited["rows"][0]["estimate"].is_null());
}

// A grasp that nobody knows the load of does not hide one of which it is known.
TEST(ComparePage, TakesTheBestOfTheLoadsThatAreKnown) {
  Comparison comparison = sample();
  comparison.tasks.emplace_back("hold-weight");
  BestGrasp known, unknown;
  known.margin["hold-weight"] = 7;
  known.with_structure["hold-weight"] = 9;
  unknown.margin["hold-weight"] = unknown.with_structure["hold-weight"] = NAN;
  unknown.reasons["hold-weight"] = "the effort of 'motor' is unknown";
  comparison.cells[0].best = {known, unknown};
  MeshTable meshes;
  const Json page = compare_page(comparison, {}, {}, meshes);
  const Json& blocks = section_of(page, "grasps")["blocks"];
  const Json& row = blocks[3]["rows"][0];
  EXPECT_EQ(row[row.size() - 2], 7.0);
  EXPECT_EQ(row.back(), 9.0);
  EXPECT_EQ(blocks[4]["rows"][0], Json::array({"jaws", "card", "4 touched without force closure"}));
  EXPECT_EQ(blocks[5]["rows"][0],
            Json::array({"jaws", "ball",
                         "epsilon 3 of 3, hold-weight 1 of 2: the effort of 'motor' is unknown"}));
  EXPECT_EQ(blocks[6]["rows"][0],
            Json::array({"jaws", "hold-weight", "the effort of 'motor' is unknown", 1}));
}

TEST(ComparePage, TellsVersionsOfTheHumanHandApart) {
  Comparison comparison = sample();
  comparison.hands = {"human:skewed", "jaws", "human:tendons"};
  MeshTable meshes;
  const Json blocks = section_of(compare_page(comparison, {}, {}, meshes), "glance")["blocks"];
  ASSERT_EQ(blocks.size(), 4U);
  EXPECT_NE(blocks[2]["text"].get<std::string>().find("strength of its own"), std::string::npos);
  EXPECT_NE(blocks[3]["text"].get<std::string>().find("human:tendons: "), std::string::npos);
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

TEST(CompareWords, TellHowApproachesEndedTheMostFrequentFirst) {
  HandOnObject cell;
  cell.outcomes = {5, 0, 7, 0, 0, 1};
  cell.closures = 2;
  EXPECT_EQ(describe_outcome(cell),
            "7 missed the object, 3 touched without force closure, 1 closed without touching");
  cell.between_two = 2;
  EXPECT_EQ(describe_outcome(cell),
            "7 missed the object, 2 held between 2 hard points, 1 touched without force closure, 1 "
            "closed without touching");
}

TEST(CompareWords, RoundToWhatIsKnown) {
  EXPECT_EQ(rounded_to(467.8, 127.4), 500);
  EXPECT_EQ(rounded_to(166.5, 31.9), 170);
  EXPECT_DOUBLE_EQ(rounded_to(1.234, 0.05), 1.23);
  EXPECT_EQ(rounded_to(3, 0), 3);
  EXPECT_EQ(in_two_digits(1271), 1300);
  EXPECT_EQ(in_two_digits(0), 0);
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

// Nails are on the back of a hand, where a look at the palm does not show them.
TEST(ComparePage, ShowsHandsWithNailsFromTheBackToo) {
  const auto jaws =
      std::make_shared<RobotHand>(read_robot(THENAR_DATA_DIR "/robots/parallel_jaw.toml"));
  MeshTable meshes;
  const Json blocks = hands_section({{"nails", jaws, {SkinPatch{}}}, {"none", jaws, {}}},
                                    meshes)["blocks"][0]["blocks"];
  ASSERT_EQ(blocks.size(), 3U);
  EXPECT_LT(blocks[0]["view"][0].get<double>() * blocks[1]["view"][0].get<double>(), 0);
}

}  // namespace
}  // namespace thenar
