// Tests for report/answers/catalogue.cpp.

#include "report/answers/catalogue.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

const Catalogue kTwoKinds{
    {{"hand", "jaw", "a gripper", "Own", "jaw.toml"}, {"joint", "PIP3", "MP3 on PP3", "", ""}}, {}};

TEST(CatalogueText, HasATableForEachKindAndNoEmptyColumn) {
  EXPECT_EQ(text_of(kTwoKinds),
            "hand  about      source\njaw   a gripper  Own\n\njoint  about\nPIP3   MP3 on PP3\n");
  EXPECT_EQ(text_of(Catalogue{}), "none\n");
}

TEST(CatalogueTable, HasARowForEachName) {
  EXPECT_EQ(csv(table_of(kTwoKinds)),
            "kind,name,about,source,file\nhand,jaw,a gripper,Own,jaw.toml\njoint,PIP3,MP3 on "
            "PP3,,\n");
  EXPECT_EQ(json_of(kTwoKinds)[1]["name"], "PIP3");
}

}  // namespace
}  // namespace thenar
