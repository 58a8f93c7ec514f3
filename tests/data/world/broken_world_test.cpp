// No broken world or body file does harm.

#include <gtest/gtest.h>

#include "data/io/world/graspit_body.h"
#include "data/io/world/graspit_world.h"
#include "tests/data/broken_files.h"
#include "tests/data/robot/sample_files.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

const std::string kWorld = R"(<?xml version="1.0" ?>
<world>
  <graspableBody><filename>seg.xml</filename>
    <transform><fullTransform>(+0.6 +0 +0.8 +0)[+1 +2 -100]</fullTransform></transform>
  </graspableBody>
  <obstacle><filename>seg.off</filename>
    <transform><translation>1 2 3</translation><rotation>30 y</rotation></transform></obstacle>
  <robot><filename>claw.xml</filename><dofValues>+0.1 +0.2 +0 +10</dofValues></robot>
  <robot><filename>claw.xml</filename><dofValues>+0.1 +0.2 +1 -0.3 +0.2 +10</dofValues></robot>
  <connection><parentRobot>0</parentRobot><parentChain>1</parentChain><childRobot>1</childRobot>
    <transform><translation>0 0 50</translation></transform></connection>
  <camera><position>0 0 400</position><orientation>0 0 0 1</orientation>
    <focalDistance>300</focalDistance></camera>
</world>
)";

class BrokenWorld : public TemporaryFolder {
 protected:
  BrokenWorld() {
    write_file(path("seg.off"), sample::wedge_off());
    write_file(path("seg.xml"), sample::graspit_body_file());
    write_file(path("claw.xml"), sample::graspit_file());
  }
};

TEST_F(BrokenWorld, OfGraspitDoesNoHarm) {
  expect_no_harm(kWorld, path("world.xml"), [](const std::string& file) {
    const GraspitWorld read = read_graspit_world(file);
    (void)parse_world(world_toml(read.world), file);
  });
}

TEST_F(BrokenWorld, BodiesOfGraspitDoNoHarm) {
  expect_no_harm(sample::graspit_body_file(), path("other.xml"),
                 [](const std::string& file) { (void)object_toml(read_graspit_body(file).body); });
}

TEST_F(BrokenWorld, OfTomlDoesNoHarm) {
  write_file(path("world.xml"), kWorld);
  const std::string text = world_toml(read_graspit_world(path("world.xml")).world);
  expect_no_harm(text, path("world.toml"),
                 [](const std::string& file) { (void)world_toml(read_world(file)); });
}

}  // namespace
}  // namespace thenar
