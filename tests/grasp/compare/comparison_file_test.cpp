// Tests for grasp/compare/comparison_file.cpp; tests/apps/compare_command_test.py goes on with
// files.

#include "grasp/compare/comparison_file.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file_io.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

std::string same(const std::string& name) { return name; }

Comparison one_cell() {
  HandOnObject cell;
  cell.hand = "jaw";
  cell.object = "ball";
  cell.approaches = 2;
  cell.closures = 1;
  cell.outcomes[0] = 2;
  cell.success = 0.5;
  cell.epsilon = Eigen::VectorXd::Constant(1, 0.1);
  cell.hand_epsilon = Eigen::VectorXd::Constant(1, std::numeric_limits<double>::infinity());
  cell.types = {{"pinch", 1}};
  BestGrasp best;
  best.margin = {{"pull", 2}};
  best.with_structure = {{"pull", std::numeric_limits<double>::infinity()}};
  cell.best = {best};
  Comparison comparison;
  comparison.cells = {cell};
  return comparison;
}

RunRecord run_at(const std::string& date) { return {{"compare"}, "/here", "", date}; }

using ComparisonFile = TemporaryFolder;

TEST_F(ComparisonFile, IsReadAsItWasWritten) {
  const JsonNode inputs = JsonNode().set("seed", 1);
  write_comparison(path("a.json"), one_cell(), inputs, JsonNode());
  const SavedComparison kept = read_comparison(path("a.json"), inputs, same);
  ASSERT_EQ(kept.cells.size(), 1U);
  EXPECT_EQ(kept.cells[0].hand, "jaw");
  EXPECT_EQ(kept.cells[0].epsilon[0], 0.1);
  EXPECT_TRUE(std::isinf(kept.cells[0].hand_epsilon[0]));
  EXPECT_EQ(kept.provenance.kind, JsonKind::kNull);
  ASSERT_EQ(kept.cells[0].best.size(), 1U);
  EXPECT_EQ(kept.cells[0].best[0].margin.at("pull"), 2);
  EXPECT_TRUE(std::isinf(kept.cells[0].best[0].with_structure.at("pull")));
}

// Older files have one load, with structure: what efforts bear of it is not known.
TEST(ComparisonCells, OfBeforeLoadsWereToldApartAreReadAsWithStructure) {
  const JsonNode file = comparison_node(one_cell());
  JsonNode cell = file.find("cells")->items[0];
  JsonNode best = cell.find("best")->items[0];
  best.set("margin", *best.find("margin_with_structure"));
  best.erase("margin_with_structure");
  JsonNode list(JsonKind::kArray), all(JsonKind::kArray);
  list.items.push_back(best);
  cell.set("best", list);
  all.items.push_back(cell);
  const std::vector<HandOnObject> cells = parse_cells(all, "a.json");
  EXPECT_TRUE(std::isnan(cells[0].best[0].margin.at("pull")));
  EXPECT_TRUE(std::isinf(cells[0].best[0].with_structure.at("pull")));
}

// A mesh changed: the object's content differs, and of its files the mesh.
TEST_F(ComparisonFile, NamesTheFileThatChanged) {
  const auto contents = [](const char* hash) {
    return JsonNode().set("contents", JsonNode().set("object cone", hash));
  };
  const JsonNode provenance = continued_provenance(
      JsonNode(), run_at("1"), {{"cone.stl", "0123456789"}, {"cone.toml", "ab"}});
  write_comparison(path("a.json"), one_cell(), contents("1"), provenance);
  const auto message = [&](const FileDigests& files) {
    return message_of<InputError>(
        [&] { (void)read_comparison(path("a.json"), contents("2"), same, files); });
  };
  EXPECT_NE(message({{"cone.stl", "9876543210"}, {"cone.toml", "ab"}})
                .find("another 'cone.stl' (SHA-256 01234567 then, 98765432 now): name"),
            std::string::npos);
  EXPECT_NE(message({}).find("another object 'cone': name"), std::string::npos);
}

TEST_F(ComparisonFile, RefusesOtherInputsAndBrokenSeals) {
  write_comparison(path("a.json"), one_cell(), JsonNode().set("seed", 1), JsonNode());
  EXPECT_NE(message_of<InputError>([&] {
              (void)read_comparison(path("a.json"), JsonNode().set("seed", 2), same);
            }).find("another 'seed'"),
            std::string::npos);
  std::string text = read_file(path("a.json"), 1U << 20);
  text.replace(text.find("0.1"), 3, "0.2");
  write_file(path("a.json"), text);
  EXPECT_THROW((void)read_comparison(path("a.json"), JsonNode().set("seed", 1), same), DataError);
}

TEST_F(ComparisonFile, NamesTheRunsThatComputedIt) {
  const JsonNode first = continued_provenance(JsonNode(), run_at("1"));
  EXPECT_EQ(first.find("earlier_runs"), nullptr);
  const JsonNode third =
      continued_provenance(continued_provenance(first, run_at("2")), run_at("3"));
  EXPECT_EQ(third.find("date")->text, "3");
  const JsonNode& earlier = *third.find("earlier_runs");
  ASSERT_EQ(earlier.items.size(), 2U);
  EXPECT_EQ(earlier.items[0], first);
  EXPECT_EQ(earlier.items[1].find("date")->text, "2");
}

}  // namespace
}  // namespace thenar
