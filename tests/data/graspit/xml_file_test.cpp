// Tests for data/io/graspit/xml_file.cpp.

#include "data/io/graspit/xml_file.h"

#include <gmock/gmock.h>
#include <pugixml.hpp>

#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

TEST(XmlFile, RemembersLines) {
  const XmlFile file("<a>\n  <b/>\n\n  <c>1</c>\n</a>", "f.xml");
  EXPECT_EQ(file.line(file.root()), 1);
  EXPECT_EQ(file.line(file.root().child("b")), 2);
  EXPECT_EQ(file.line(file.root().child("c")), 4);
  EXPECT_THAT(message_of<DataError>([&] { file.fail(file.root().child("c"), "no"); }),
              StartsWith("f.xml:4: no"));
  EXPECT_THAT(message_of<DataError>([] { XmlFile("<a>\n<b>\n</a>", "f.xml"); }),
              StartsWith("f.xml:3: "));
}

TEST(XmlFile, ReadsNumbersBetweenAnySeparators) {
  const XmlFile file("<a><v> (1, 2.5)\n[-3e-1] </v><w>1 two</w></a>", "f.xml");
  EXPECT_THAT(file.numbers(file.root().child("v"), 3), ElementsAre(1, 2.5, -0.3));
  EXPECT_THAT(message_of<DataError>([&] { (void)file.numbers(file.root().child("v"), 4); }),
              HasSubstr("wanted 4 numbers in <v>, got 3"));
  EXPECT_THAT(message_of<DataError>([&] { (void)file.numbers(file.root().child("w")); }),
              HasSubstr("wanted finite numbers in <w>"));
}

TEST(XmlFile, ReadsLatin1AsUtf8) {
  const XmlFile latin("<a>M\xFCller</a>", "f.xml"), utf8("<a>M\xC3\xBCller</a>", "f.xml");
  EXPECT_EQ(latin.text(latin.root()), "M\xC3\xBCller");
  EXPECT_EQ(utf8.text(utf8.root()), "M\xC3\xBCller");
}

TEST(XmlFile, SettlesTheCaseOfNames) {
  XmlFile file("<Robot><DOF/><Dof/><other/></Robot>", "f.xml");
  file.settle_case("robot dof");
  EXPECT_EQ(file.root_name(), "robot");
  const auto found = file.root().children("dof");
  EXPECT_EQ(std::distance(found.begin(), found.end()), 2);
  EXPECT_TRUE(file.root().child("other"));
}

TEST(XmlFile, WalksInTheOrderOfTheText) {
  const XmlFile file("<a><b><c/></b><d/></a>", "f.xml");
  std::string order;
  for (pugi::xml_node node = file.root(); node; node = internal::next_below(file.root(), node))
    order += node.name();
  EXPECT_EQ(order, "abcd");
}

}  // namespace
}  // namespace thenar
