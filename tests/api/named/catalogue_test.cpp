// Tests for api/named/catalogue.cpp.

#include "api/named/catalogue.h"

#include <gtest/gtest.h>

#include "tests/data_folder.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

const CatalogueEntry* find(const Catalogue& catalogue, const std::string& name) {
  for (const CatalogueEntry& entry : catalogue.entries)
    if (entry.name == name) return &entry;
  return nullptr;
}

TEST(ListNames, TellsTitlesAndSources) {
  const Catalogue found = list_names({"nets", "", "", kData});
  const CatalogueEntry* winslow = find(found, "winslow");
  ASSERT_NE(winslow, nullptr);
  EXPECT_EQ(winslow->kind, "net");
  EXPECT_EQ(winslow->about, "Extensor mechanism as Winslow's rhombus with its ligaments");
  EXPECT_EQ(winslow->source, "Synek2019, An1979, Dogadov2017");
  EXPECT_TRUE(found.warnings.empty());
}

TEST(ListNames, HasAllKinds) {
  const Catalogue found = list_names({"", "", "", kData});
  for (const char* name : {"an_chao_index", "synek2019_H01", "jaw_box", "barrett",
                           "human:orthogonal", "mug", "two_soft_fingers", "rubber"})
    EXPECT_NE(find(found, name), nullptr) << name;
  EXPECT_TRUE(found.warnings.empty());
}

TEST(ListNames, ListsPartsOfASubjectOrARobot) {
  const Catalogue joints = list_names({"joints", "synek2019_middle", "", kData});
  ASSERT_EQ(joints.entries.size(), 4U);  // MCP has two axes, PIP and DIP one each
  EXPECT_EQ(joints.entries[0].name, "MCP3_FE");
  EXPECT_NE(find(list_names({"muscles", "synek2019_middle", "", kData}), "FDP"), nullptr);
  EXPECT_EQ(list_names({"joints", "barrett", "", kData}).entries.size(), 8U);
  EXPECT_EQ(list_names({"digits", "mirakhorlo2016", "", kData}).entries.size(), 5U);
}

TEST(ListNames, RefusesOtherWords) {
  EXPECT_NE(message_of([] {
              (void)list_names({"subject", "", "", kData});
            }).find("did you mean 'subjects'?"),
            std::string::npos);
  EXPECT_EQ(message_of([] {
              (void)list_names({"muscles", "", "", kData});
            }),
            "wanted a subject: thenar list muscles SUBJECT");
}

}  // namespace
}  // namespace thenar
