// No crafted robot file ends the program, or takes more than seconds and some memory.

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/stat.h>

#include "base/file_io.h"
#include "data/io/graspit/graspit_link.h"
#include "data/io/robot/import_robot.h"
#include "tests/data/robot/sample_files.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::HasSubstr;

std::string times(const std::string& text, int n) {
  std::string all;
  for (int i = 0; i < n; ++i) all += text;
  return all;
}

std::string tag(const std::string& name, int number, const std::string& rest = "/>") {
  return "<" + name + std::to_string(number) + rest;
}

class HostileRobot : public TemporaryFolder {
 protected:
  [[nodiscard]] std::string written(const std::string& name, const std::string& content) const {
    write_file(path(name), content);
    return path(name);
  }
  [[nodiscard]] std::string refusal(const std::string& name, const std::string& content) const {
    const std::string file = written(name, content);
    return message_of<DataError>([&] { (void)import_robot(file); });
  }
  ~HostileRobot() override {
    rusage used{};
    (void)getrusage(RUSAGE_SELF, &used);
    EXPECT_LT(1024.0 * static_cast<double>(used.ru_maxrss), 1.5e9);  // [bytes]
  }
};

// Walks and parsers that recurse need a piece of stack for each level.
TEST_F(HostileRobot, MayNotNestDeeply) {
  constexpr int kDeep = 100'000;
  const auto nested = [](const std::string& before, const std::string& element,
                         const std::string& after) {
    return before + times("<" + element + ">", kDeep) + times("</" + element + ">", kDeep) + after;
  };
  const std::string deep = "1: wanted XML that nests at most 128 deep";
  EXPECT_THAT(refusal("a.urdf", nested("<robot name='a'><link name='b'/>", "link", "</robot>")),
              HasSubstr(deep));
  EXPECT_THAT(refusal("a.xml", nested("<mujoco><worldbody>", "body", "</worldbody></mujoco>")),
              HasSubstr(deep));
  EXPECT_THAT(refusal("a.xml", nested("<mujoco><default>", "default", "</default></mujoco>")),
              HasSubstr(deep));
  EXPECT_THAT(refusal("a.xml", nested("<robot><palm>", "dof", "</palm></robot>")), HasSubstr(deep));
  const std::string link = written("link.xml", nested("<root>", "mass", "</root>"));
  EXPECT_THAT(message_of<DataError>([&] { (void)read_graspit_link(link); }), HasSubstr(deep));
  // As deep as may be, all walks of a file hold.
  EXPECT_THAT(refusal("a.xml", "<mujoco><worldbody>" + times("<body>", 120) +
                                   times("</body>", 120) + "</worldbody></mujoco>"),
              HasSubstr("nothing was thrown"));
}

// Depth adds up over files, each of which includes the next at its deepest place.
TEST_F(HostileRobot, MayNotNestDeeplyOverFiles) {
  for (int i = 0; i < 100; ++i)
    (void)written(std::to_string(i) + ".xml", "<mujocoinclude>" + times("<body>", 100) +
                                                  tag("include file='", i + 1, ".xml'/>") +
                                                  times("</body>", 100) + "</mujocoinclude>");
  EXPECT_THAT(refusal("a.xml", "<mujoco><worldbody><include file='0.xml'/></worldbody></mujoco>"),
              HasSubstr("<include> stands more than 128 elements deep"));
  EXPECT_THAT(refusal("b.xml", "<mujoco><worldbody><include file='b.xml'/></worldbody></mujoco>"),
              HasSubstr("included twice"));
}

// Links that name one mesh that cannot be read: tried once, said for each.
TEST_F(HostileRobot, ReadsAMeshOfManyLinksOnce) {
  const std::string script = written("reader", "#!/bin/sh\necho once >> " + path("count") + "\n");
  ASSERT_EQ(chmod(script.c_str(), 0700), 0);
  ASSERT_EQ(setenv("THENAR_MESH_READER", script.c_str(), 1), 0);
  (void)written("a.dae", "<COLLADA/>");
  std::string text = "<robot name='a'><link name='l0'/>";
  for (int i = 1; i <= 20; ++i)
    text += tag("link name='l", i, "'>") +
            "<collision><geometry><mesh filename='a.dae'/></geometry></collision></link>" +
            tag("joint name='j", i, "' type='fixed'><parent link='l0'/>") +
            tag("child link='l", i, "'/></joint>");
  const RobotSpec robot = import_robot(written("a.urdf", text + "</robot>"));
  ASSERT_EQ(unsetenv("THENAR_MESH_READER"), 0);
  EXPECT_EQ(std::filesystem::file_size(path("count")), 5U);
  EXPECT_EQ(std::count_if(robot.warnings.begin(), robot.warnings.end(),
                          [](const std::string& warning) {
                            return warning.find("UNREADABLE MESH") != std::string::npos;
                          }),
            20);
}

// A class takes no more memory than it says itself, whatever stands around it.
TEST_F(HostileRobot, DefaultsGrowWithTheirText) {
  std::string text = "<mujoco><default><geom";
  for (int i = 0; i < 20'000; ++i) text += " a" + std::to_string(i) + "='1'";
  text += " size='0.01'/>";
  for (int i = 0; i < 20'000; ++i) text += tag("default class='c", i, "'/>");
  text += "</default><worldbody><body><geom class='c7'/></body></worldbody></mujoco>";
  const std::string file = written("a.xml", text);
  const RobotSpec robot = import_robot(file);
  ASSERT_EQ(robot.links.back().shapes.size(), 1U);
  EXPECT_EQ(robot.links.back().shapes[0].size.x(), 0.01);
}

TEST_F(HostileRobot, DefaultsOfOneNameDoNotCircle) {
  EXPECT_EQ(refusal("a.xml",
                    "<mujoco><default><default class='a'><default class='b'>"
                    "<default class='a'><default class='b'/></default></default></default>"
                    "</default><worldbody><body><geom class='a' size='1'/></body></worldbody>"
                    "</mujoco>"),
            "nothing was thrown");
}

TEST_F(HostileRobot, MayHaveManyUnknownElements) {
  std::string text = "<robot name='a'><link name='b'/>\n";
  for (int i = 0; i < 60'000; ++i) text += tag("x", i) + "\n";
  const std::string file = written("a.urdf", text + "</robot>");
  EXPECT_EQ(import_robot(file).warnings.size(), 60'000U);
}

TEST_F(HostileRobot, MayNotHaveLinksWithoutNumber) {
  std::string urdf = "<robot name='a'><link name='l0'/>", bodies;
  for (int i = 1; i < 20'000; ++i) {
    urdf += tag("link name='l", i, "'/>") + tag("joint type='fixed' name='j", i, "'>") +
            tag("parent link='l", i - 1, "'/>") + tag("child link='l", i, "'/></joint>");
    bodies += "<body/>";
  }
  EXPECT_THAT(refusal("a.urdf", urdf + "</robot>"),
              HasSubstr("wanted at most 1000 links, got 20000"));
  EXPECT_THAT(refusal("a.xml", "<mujoco><worldbody>" + bodies + "</worldbody></mujoco>"),
              HasSubstr("wanted at most 1000 bodies"));
}

// What refers to copies is copied with them.
TEST_F(HostileRobot, MayNotCopyReferencesWithoutNumber) {
  EXPECT_THAT(refusal("a.xml",
                      "<mujoco><worldbody><replicate count='1000'><body><joint name='j'/></body>"
                      "</replicate></worldbody><actuator>" +
                          times("<motor joint='j'/>", 10'000) + "</actuator></mujoco>"),
              HasSubstr("makes more than 100000 elements"));
}

// Expressions are matched by recursion, a step a letter.
TEST_F(HostileRobot, MayNotHaveADriveOfManyLetters) {
  std::string text = sample::graspit_file();
  const std::size_t drive = text.find("<theta>") + 7;
  text.insert(drive, std::string(500'000, '1'));
  write_file(path("seg.xml"), sample::graspit_body_file());
  write_file(path("seg.off"), sample::wedge_off());
  EXPECT_THAT(refusal("a.xml", text), HasSubstr("letters"));
}

}  // namespace
}  // namespace thenar
