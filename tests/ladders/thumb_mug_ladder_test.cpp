// The founding paper's figure 8 twice: as the file data/scenes/thumb_mug.toml, a whole hand whose
// joints give by [[compliance]], and as code with a thumb alone. Both must say the same.

#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "dynamics/scene/build_scene.h"
#include "tests/data_folder.h"
#include "tests/dynamics/ligament/thumb_on_mug.h"

namespace thenar {
namespace {

using sample::ThumbOnMug;
using sample::ThumbOnMugState;

constexpr double kHolds = 1;  // from which force on the mug stays on the thumb [N]
// Hinges of the hand have 0.002 N m s/rad beside the 0.2 of the muscles, its number of digits
// changes the order of sums, and a facet is some degrees of the pad's angle.
constexpr double kSamePadAngle = 0.5;  // [deg]
constexpr double kSamePush = 0.2;      // [N]

/// The file's scene, on pins or as it is, as if it was the code's.
ThumbOnMug scene_of_file(bool compliant) {
  SceneSpec spec = read_scene(kData + "/scenes/thumb_mug.toml");
  if (!compliant) spec.compliances.clear();
  HumanModel model{default_human(), HumanVersion::kSkewedThumb};
  model.options.skin.triangles = spec.hands.front().skin_triangles;
  model.options.passive = PassiveMoments::kOff;  // as the scene says
  BuiltScene built = build_scene(spec, {model});
  ThumbOnMug out = sample::thumb_on_mug({});  // for the bone and the pad
  out.scene = std::move(built.scene);
  out.options = built.options;
  out.distal = body_named(out.scene.mechanism, "human:skewed/DP1");
  out.mug = body_named(out.scene.mechanism, "mug");
  return out;
}

std::vector<ThumbOnMugState> states_of_run(const ThumbOnMug& made) {
  SceneOptions options = made.options;
  options.sample_interval = 0.05;
  const SceneRun run = simulate_scene(made.scene, options);
  EXPECT_EQ(run.cost.unsolved, 0);
  return states_of(made, run);
}

class ThumbMugFile : public testing::TestWithParam<bool> {};

TEST_P(ThumbMugFile, SaysWhatTheCodeSays) {
  sample::ThumbOnMugOptions options;
  options.compliant = GetParam();
  const std::vector<ThumbOnMugState> code = states_of_run(sample::thumb_on_mug(options));
  const std::vector<ThumbOnMugState> file = states_of_run(scene_of_file(GetParam()));
  ASSERT_EQ(code.size(), file.size());
  for (std::size_t i = 0; i < code.size(); ++i) {
    if (code[i].force < kHolds) continue;
    EXPECT_NEAR(file[i].force, code[i].force, kSamePush);
    EXPECT_NEAR(file[i].pad_angle / kDegree, code[i].pad_angle / kDegree, kSamePadAngle);
    EXPECT_NEAR(file[i].roll / kDegree, code[i].roll / kDegree, kSamePadAngle);
  }
}
INSTANTIATE_TEST_SUITE_P(PinsAndJointsThatGive, ThumbMugFile, testing::Bool());

}  // namespace
}  // namespace thenar
