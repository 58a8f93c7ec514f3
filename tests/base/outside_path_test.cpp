// Tests for base/outside_path.cpp.

#include "base/outside_path.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file_io.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::vector<std::string> with_control_characters() {
  std::vector<std::string> names;
  for (int c = 0; c < 0x20; ++c) names.push_back(std::string("a") + static_cast<char>(c) + "b");
  for (const char* name : {"\x7f", "\xC2\x80", "x\xC2\x9F.toml"}) names.emplace_back(name);
  names.push_back(std::string(".bashrc\0.toml", 13));
  return names;
}

TEST(OutsidePath, HasNoControlCharacters) {
  for (const std::string& name : with_control_characters())
    for (const OutsideUse use : {OutsideUse::kRead, OutsideUse::kInside})
      EXPECT_THROW((void)outside_path(name, use), InputError) << name;
  EXPECT_EQ(*outside_fault(std::string("ab\0", 3), OutsideUse::kRead),
            "a control character at byte 2");
}

TEST(OutsidePath, KeepsWhatIsReadAsItIs) {
  for (const char* name : {"", "jaw_box", "human:soft", "/a//b/../c.toml", "../x", ".x",
                           "a b\xC3\xA9\xC2\xA0.toml", "\xE2\x98\x83"})
    EXPECT_EQ(outside_path(name, OutsideUse::kRead), name);
}

TEST(OutsidePath, StaysInsideItsFolder) {
  for (const char* name : {"", ".", "..", "/", "/x", "../x", "a/..", "a/../b", "a/../../b", "a/",
                           "./", "a/.", ".x", "a/.x", ".a/x", "...", "a\\b", "..\\x"})
    EXPECT_THROW((void)outside_path(name, OutsideUse::kInside), InputError) << name;
  EXPECT_EQ(outside_path("./a//b./c..toml", OutsideUse::kInside), "a/b./c..toml");
  EXPECT_EQ(outside_path("x", OutsideUse::kInside), "x");
}

TEST(OutsidePath, TellsFaultsWithoutWhatATerminalObeys) {
  EXPECT_THAT([] { (void)outside_path("\x1b[2J", OutsideUse::kRead); },
              ThrowsMessage<InputError>("wanted a name or the path of a file, got '?[2J' with a "
                                        "control character at byte 0"));
  EXPECT_THAT([] { (void)outside_path("a/../b", OutsideUse::kInside); },
              ThrowsMessage<InputError>(HasSubstr("'..', which leads out of the folder")));
}

TEST(OutsidePath, IsOfBoundedLength) {
  EXPECT_FALSE(outside_fault(std::string(kMaxOutsidePath, 'x'), OutsideUse::kRead));
  EXPECT_TRUE(outside_fault(std::string(kMaxOutsidePath + 1, 'x'), OutsideUse::kRead));
  // Nor does a client grow a tree that nobody can remove.
  std::string deep = "x";
  for (int i = 0; i < 31; ++i) deep.insert(0, "a/");
  EXPECT_FALSE(outside_fault(deep, OutsideUse::kInside));
  EXPECT_TRUE(outside_fault("a/" + deep, OutsideUse::kInside));
}

class Links : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    for (const char* folder : {"drops/1/deep", "drops/2", "other"})
      fs::create_directories(path(folder));
    for (const char* file : {"drops/1/a.obj", "drops/1/deep/b.obj", "drops/2/c.obj", "other/d.obj"})
      write_file(path(file), "o");
    fs::create_symlink(path("other/d.obj"), path("drops/1/link.obj"));
    fs::create_directory_symlink(path("other"), path("drops/1/out"));
  }
};

TEST_F(Links, LeadAnywhereWithoutAFence) {
  EXPECT_EQ(linked_path(path("drops/1"), "../../other/d.obj"), path("other/d.obj"));
  EXPECT_EQ(linked_path("", "a.obj"), "a.obj");
  EXPECT_EQ(linked_path(path("drops/1"), path("other/d.obj")), path("other/d.obj"));
  EXPECT_TRUE(may_link(path("drops/1"), path("other/d.obj")));
  for (const std::string& name : with_control_characters())
    EXPECT_THROW((void)linked_path(path("drops/1"), name), InputError);
}

TEST_F(Links, StayInTheirSubfolderOfAFence) {
  {
    const LinkFence fence(path("drops"));
    EXPECT_EQ(linked_path(path("drops/1/deep"), "../a.obj"), path("drops/1/a.obj"));
    EXPECT_EQ(linked_path(path("drops/1"), "deep/b.obj"), path("drops/1/deep/b.obj"));
    for (const std::string& name :
         {std::string("../2/c.obj"), std::string("../../other/d.obj"), path("other/d.obj"),
          std::string("link.obj"), std::string("out/d.obj"), std::string("../1x/a.obj"),
          std::string("/etc/passwd"), std::string("..")})
      EXPECT_THROW((void)linked_path(path("drops/1"), name), InputError) << name;
    EXPECT_TRUE(may_link(path("other"), path("drops/1/a.obj")));  // from outside all may be named
  }
  EXPECT_TRUE(may_link(path("drops/1"), path("other/d.obj")));  // it is gone
}

}  // namespace
}  // namespace thenar
