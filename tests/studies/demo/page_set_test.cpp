// Tests for studies/demo/page_set.cpp.

#include "studies/demo/page_set.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

Json scene_with(const std::string& mesh) {
  return {{"type", "scene"},
          {"layers",
           Json::array({layer("skin", "#dfab8f", Json::array({{{"kind", "mesh"}, {"mesh", mesh}}})),
                        layer("bones", "#b8a48a", Json::array({{{"kind", "segment"}}}))})}};
}

/// A page whose scene stands in a row, and which has one mesh more than that shows.
SetPage page(const std::string& file, const std::string& line) {
  SetPage made;
  made.file = file;
  made.title = "Title of " + file;
  made.opening = {"Asked?", "Done.", "Learnt from " + file};
  made.line = line;
  made.page = {
      {"meshes", {{"m0", "of " + file}, {"m1", "not shown"}}},
      {"sections", Json::array({section(
                       "s", "S", "", Json::array({row_block(Json::array({scene_with("m0")}))}))})}};
  made.figure = first_block(made.page, "scene");
  return made;
}

TEST(PageSet, FindsBlocksInRows) {
  EXPECT_EQ(first_block(page("a.html", "").page, "scene")["type"], "scene");
  EXPECT_TRUE(first_block(page("a.html", "").page, "bars").is_null());
}

TEST(PageSet, FrontPageHasALineAndASectionOfEachPageWithALine) {
  SetPage front;
  fill_front_page({page("a.html", "Line of a."), page("b.html", ""), page("c.html", "Line of c.")},
                  front);
  ASSERT_EQ(front.page["summary"].size(), 2u);
  EXPECT_EQ(front.page["summary"][1]["text"], "Line of c.");
  EXPECT_EQ(front.page["summary"][1]["file"], "c.html");
  ASSERT_EQ(front.page["sections"].size(), 2u);
  EXPECT_EQ(front.page["sections"][0]["text"], "Learnt from a.html");
  EXPECT_EQ(front.page["sections"][0]["blocks"][1]["link"]["file"], "a.html");
}

// Both pages call a mesh of their own "m0".
TEST(PageSet, FiguresKeepTheirOwnMeshes) {
  SetPage front;
  fill_front_page({page("a.html", "Line."), page("c.html", "Line.")}, front);
  EXPECT_EQ(front.page["meshes"].size(), 2u);
  for (const std::size_t s : {0u, 1u}) {
    const Json& shown = front.page["sections"][s]["blocks"][0]["layers"][0]["items"][0]["mesh"];
    EXPECT_EQ(front.page["meshes"][shown.get<std::string>()], s == 0 ? "of a.html" : "of c.html");
  }
}

TEST(PageSet, EveryPageKnowsItselfAndAllOthers) {
  std::vector<SetPage> pages{page("a.html", ""), page("b.html", "")};
  link_pages(pages);
  for (const SetPage& each : pages) {
    EXPECT_EQ(each.page["file"], each.file);
    EXPECT_EQ(each.page["pages"].size(), 2u);
    EXPECT_EQ(each.page["opening"]["learnt"], "Learnt from " + each.file);
  }
}

}  // namespace
}  // namespace thenar
