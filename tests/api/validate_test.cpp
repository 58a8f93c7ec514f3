// Tests for api/validate.cpp.

#include "api/validate.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "api/scenes/simulate_scene.h"
#include "api/scenes/write_scene_run.h"
#include "api/simulate.h"
#include "base/error.h"
#include "data/io/toml_node.h"
#include "tests/data/mutated_arrays.h"
#include "tests/data_folder.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::IsSubsetOf;

ValidateRequest things_for(const std::vector<std::string>& things, const std::string& subject) {
  return {things, subject, "", kData};
}

TEST(Validate, JudgesEachThingByItself) {
  const Validation found = validate(things_for({"winslow", "nobody", "barrett"}, ""));
  ASSERT_EQ(found.files.size(), 3U);
  EXPECT_TRUE(found.files[0].valid());
  EXPECT_FALSE(found.files[1].valid());
  EXPECT_NE(found.files[1].error.find("'nobody'"), std::string::npos);
  EXPECT_TRUE(std::holds_alternative<RobotSpec>(*found.files[2].thing));
  EXPECT_FALSE(found.valid());
}

TEST(Validate, HoldsExperimentsToASubject) {
  EXPECT_TRUE(validate(things_for({"synek2019_H01"}, "synek2019_middle")).valid());
  const Validation index = validate(things_for({"synek2019_H01"}, "an_chao_index"));
  EXPECT_TRUE(index.files[0].error.empty());
  EXPECT_EQ(index.files[0].check.misfits.size(), 1U);  // it has no middle finger
  EXPECT_FALSE(index.valid());
  EXPECT_EQ(message_of([] { (void)validate(things_for({"winslow"}, "an_chao_index")); }),
            "a subject is what experiments are held to; none of the files is an experiment");
}

class ValidateSubjects : public TemporaryFolder {};

// A path point inside the surface that its tendon bends over: other questions refuse it, too.
TEST_F(ValidateSubjects, WhosePointsLieInsideSurfacesAreRefused) {
  std::string text = read_text_file(std::string(kData) + "/subjects/human_hand.toml");
  const std::string point = "{segment = \"MC2\", point_mm = [50.7, -84, 11.3]}";
  const std::size_t at = text.find(point);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, point.size(), "{segment = \"MC2\", point_mm = [48.0, -86, 7.0]}");
  std::ofstream(path("inside.toml")) << text;
  const Validation found = validate(things_for({path("inside.toml")}, ""));
  EXPECT_THAT(found.files.front().error,
              HasSubstr("point 7 of strand 'EDC2' lies 2.69 mm inside surface 'MCP2_head'"));
}

class ValidateResults : public TemporaryFolder {
 protected:
  /// Changes of a result that validate does not refuse.
  [[nodiscard]] MutationVerdicts accepted(const std::string& file) const {
    const MutationVerdicts verdicts =
        verdicts_on_mutations(read_result(path(file)), path(file), [](const std::string& changed) {
          const Validation found = validate(things_for({changed}, ""));
          require(found.valid(), "{}", found.files.front().error);
        });
    EXPECT_GE(verdicts.size(), kMinMutations);
    return read_all_the_same(verdicts);
  }
};

TEST_F(ValidateResults, MotionsWithAnyArrayChangedAreRefused) {
  DigitMotionRequest request;
  request.digit.subject = kData + "/subjects/an_chao_index.toml";
  request.excitation = {{"FDP", 0.2}};
  request.seconds = 0.02;
  write_motion(simulate_digit(request), path("motion.h5"));
  EXPECT_TRUE(validate(things_for({path("motion.h5")}, "")).valid());
  // Fibres are rigid, and nothing strays, in some motions.
  EXPECT_THAT(accepted("motion.h5"), IsSubsetOf({"fibre missing", "stray not a number"}));
}

TEST_F(ValidateResults, RunsOfScenesWithAnyArrayChangedAreRefused) {
  SceneRequest request;
  request.scene = "wine_glass";
  request.data = kData;
  request.seconds = 0.02;
  const SceneResult run = simulate_scene(request);
  write_scene_run(run, path("run.h5"));
  EXPECT_TRUE(validate(things_for({path("run.h5")}, "")).valid());
  EXPECT_THAT(
      accepted("run.h5"),
      IsSubsetOf({"element_state missing", "energy_error missing", "energy_turned_over missing",
                  "worst_residual missing", "worst_residual not a number"}));
}

TEST_F(ValidateResults, SweepsWithAnyArrayChangedAreRefused) {
  SceneRequest request;
  request.scene = "falling_ball";
  request.data = kData;
  request.seconds = 0.02;
  request.vary = {{"mass/ball", 0.1, 0.2, 2}};
  const std::optional<SceneSweepResult> sweep = sweep_scene(request);
  ASSERT_TRUE(sweep.has_value());
  write_scene_sweep(*sweep, path("sweep.h5"));
  EXPECT_TRUE(validate(things_for({path("sweep.h5")}, "")).valid());
  for (const std::string& change : accepted("sweep.h5"))
    EXPECT_THAT(change,
                AnyOf(HasSubstr("energy_error missing"), HasSubstr("energy_turned_over missing"),
                      HasSubstr("worst_residual")));
}

}  // namespace
}  // namespace thenar
