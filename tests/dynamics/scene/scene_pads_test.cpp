// Tests for dynamics/scene/scene_pads.cpp: pads of scene files, against statics.

#include "dynamics/scene/scene_pads.h"

#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dynamics/pads/pad_element.h"
#include "dynamics/stepping/simulate_scene.h"
#include "hand/skin/skin_landmarks.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;
using testing::StartsWith;

constexpr double kG = 9.81;
constexpr double kMass = 0.03;          // of the cube [kg]
constexpr double kWeight = kMass * kG;  // [N]
constexpr double kDamping = 3;          // of its slide [N s/m]

const std::string kTimeAndFriction =
    "name = \"x\"\nsource = \"Mine\"\n[sources]\nMine = \"Own\"\n[stepping]\n"
    "duration_s = 0.5\ntolerance = 1e-6\nsample_ms = 50\n[[friction]]\ncoefficient = 0.8\n";

/// A finger whose hard top is as high as the pad's, 10 mm, and a cube 0.1 mm above on a slide.
const std::string kPress = R"([[body]]
name = "finger"
mass_g = 10
joint = {kind = "weld"}
[[body.shape]]
kind = "box"
size_mm = [20, 20, 20]
[[body]]
name = "cube"
mass_g = 30
position_mm = [0, 0, 20.1]
joint = {kind = "slide", axis = [0, 0, 1], damping_Ns_per_m = 3}
[[body.shape]]
kind = "box"
size_mm = [20, 20, 20]
)";

std::string pad_on(const std::string& more) {
  return "[[pad]]\non = \"finger\"\nagainst = [\"cube\"]\n" + more;
}
const std::string kHere = "position_mm = [0, 0, 0]\n";

BuiltScene scene_of(const std::string& text) {
  return build_scene(parse_scene(kTimeAndFriction + text, "s.toml"), {});
}

SceneRun pads_run(const BuiltScene& built) { return simulate_scene(built.scene, built.options); }

class ScenePadRung : public testing::TestWithParam<std::string> {};

TEST_P(ScenePadRung, CarriesAWeight) {
  const BuiltScene built =
      scene_of(kPress + pad_on(kHere + "force_error = 0.01\nrung = \"" + GetParam() + "\"\n"));
  EXPECT_EQ(built.pads, 1);
  const SceneRun run = pads_run(built);
  ASSERT_EQ(run.status, SceneStatus::kDone) << run.message;
  const SceneSample& last = run.samples.back();
  ASSERT_EQ(last.contacts.size(), 1U);
  // What is left of the creep is borne by the damper.
  const double borne = std::abs(last.contacts[0].force.z()) - kDamping * last.v[0];
  EXPECT_NEAR(borne, kWeight, 0.01 * kWeight);
  EXPECT_GT(last.contacts[0].area, 1e-5);
  EXPECT_LT(last.q[0], -0.3e-3) << "pads yield, from 0.1 mm above";
  EXPECT_GT(last.q[0], -3e-3);
}

INSTANTIATE_TEST_SUITE_P(Soft, ScenePadRung,
                         testing::Values("elements", "foundation", "soft-finger", "power-law"));

TEST(ScenePads, HardPointIsTheSceneWithoutPads) {
  const SceneRun without = pads_run(scene_of(kPress));
  const BuiltScene built = scene_of(kPress + pad_on(kHere + "rung = \"hard-point\"\n"));
  EXPECT_EQ(built.pads, 0);
  EXPECT_TRUE(built.scene.elements.empty());
  const SceneRun hard = pads_run(built);
  ASSERT_EQ(hard.status, SceneStatus::kDone);
  ASSERT_EQ(hard.samples.size(), without.samples.size());
  for (std::size_t i = 0; i < hard.samples.size(); ++i)
    EXPECT_EQ(hard.samples[i].q, without.samples[i].q);
  double force = 0;
  for (const ContactSample& contact : hard.samples.back().contacts) force += contact.force.z();
  EXPECT_NEAR(std::abs(force), kWeight, 1e-6);
}

TEST(ScenePads, HardPointHasTheFrictionOfItsPad) {
  const BuiltScene built =
      scene_of(kPress + pad_on(kHere + "friction = 0.3\nrung = \"hard-point\"\n"));
  EXPECT_EQ(pair_friction(built.scene, 0, 1).coefficient, 0.3);
}

TEST(ScenePads, LieWhereTheFileSaysAndKeepTheirPairApart) {
  // The pad looks along x of a finger that stands at 3 mm, and is half as large: its top is at
  // 3 + 1 + 10/2 mm, where the cube's face was pushed in by 0.4 mm.
  const std::string text = R"([[body]]
name = "finger"
mass_g = 10
position_mm = [3, 0, 0]
joint = {kind = "weld"}
[[body.shape]]
kind = "sphere"
size_mm = [1]
[[body]]
name = "cube"
mass_g = 30
position_mm = [18.6, 0, 0]
joint = {kind = "slide", axis = [1, 0, 0]}
[[body.shape]]
kind = "box"
size_mm = [20, 20, 20]
)" + pad_on("position_mm = [1, 0, 0]\naxis = [0, 1, 0]\nangle_deg = 90\nscale = 0.5\n"
            "rung = \"soft-finger\"\n");
  const BuiltScene built = scene_of(text);
  ASSERT_EQ(built.scene.excluded_pairs.size(), 1U);
  EXPECT_EQ(built.scene.excluded_pairs[0], (std::pair<int, int>{0, 1}));
  const SceneRun run = pads_run(scene_of(text + "[[drive]]\ncoordinate = \"cube\"\ntarget_mm = 0\n"
                                                "stiffness_N_per_mm = 1000\n"
                                                "damping_Ns_per_m = 300\n"));
  ASSERT_EQ(run.status, SceneStatus::kDone) << run.message;
  ASSERT_EQ(run.samples.back().contacts.size(), 1U);
  const Vector3d at = run.samples.back().contacts[0].point;
  EXPECT_NEAR(at.x(), 9e-3, 0.5e-3);
  EXPECT_LT(std::hypot(at.y(), at.z()), 1e-4);
  EXPECT_LT(run.samples.back().contacts[0].force.x(), 0) << "on the finger";
}

TEST(ScenePads, TwoHoldAFreeBox) {
  for (const std::string rung : {"soft-finger", "foundation"}) {
    SCOPED_TRACE(rung);
    std::string text;
    for (const int side : {-1, 1}) {
      const std::string name = side < 0 ? "left" : "right";
      text += fmt::format(
          "[[body]]\nname = \"{0}\"\nmass_g = 20\nposition_mm = [{1}, 0, 0]\n"
          "joint = {{kind = \"slide\", axis = [{2}, 0, 0]}}\n"
          "[[body.shape]]\nkind = \"sphere\"\nsize_mm = [4]\n"
          "[[drive]]\ncoordinate = \"{0}\"\neffort_N = 1\ndamping_Ns_per_m = 10\n"
          "[[pad]]\non = \"{0}\"\nagainst = [\"box\"]\nposition_mm = [0, 0, 0]\n"
          "axis = [0, 1, 0]\nangle_deg = {3}\nrung = \"{4}\"\nforce_error = 0.01\n",
          name, side * 19.9, -side, -side * 90, rung);
    }
    text +=
        "[[body]]\nname = \"box\"\nmass_g = 30\n[[body.shape]]\nkind = \"box\"\n"
        "size_mm = [20, 20, 20]\n";
    BuiltScene built = scene_of(text);
    built.options.sample_interval = 1e-3;
    const SceneRun run = pads_run(built);
    ASSERT_EQ(run.status, SceneStatus::kDone) << run.message;
    // It swings on its pads: forces over the last 0.4 s are its weight and its change of momentum.
    const std::size_t first = 100, last = run.samples.size() - 1;
    const auto fall = [&](std::size_t i) { return run.samples[i].v.tail<1>()[0]; };
    double carried = 0, squeezed = 0;
    for (std::size_t i = first; i <= last; ++i) {
      ASSERT_EQ(run.samples[i].contacts.size(), 2U);
      const double share = (i == first || i == last ? 0.5 : 1) / static_cast<double>(last - first);
      for (const ContactSample& contact : run.samples[i].contacts) {
        // Forces are on the first body of a contact: the fingers, which come before the box.
        carried -= share * contact.force.z();
        squeezed += share * std::abs(contact.force.x()) / 2;
      }
    }
    const double seconds = run.samples[last].t - run.samples[first].t;
    const double wanted = kWeight + kMass * (fall(last) - fall(first)) / seconds;
    EXPECT_NEAR(carried, wanted, 0.02 * kWeight);
    EXPECT_NEAR(squeezed, 1, 0.02);
    EXPECT_GT(run.samples[last].q.tail<1>()[0], -5e-3) << "held, where free fall is 1.2 m";
  }
}

TEST(ScenePads, LieOnTheirFingertip) {
  HumanModel model{default_human(), HumanVersion::kSkewedThumb};
  model.options.cover = Cover::kNone;
  const HumanMechanism hand = human_mechanism(model);
  PadSpec pad;
  pad.width = 16e-3;
  pad.height = 10e-3;
  const PadPlace place = fingertip_pad_place(hand, "DP2", pad, {});
  const std::vector<SkinPatch> patches = skin_patches(find_anatomy(hand.subject), hand.skeleton);
  const SkinLandmark& middle = pad_of(patches, "index");
  // The top of the pad is the middle of the patch, and looks outward.
  EXPECT_LT((place.X_BP * Vector3d(0, 0, place.scale * pad.height) - middle.p).norm(), 1e-12);
  EXPECT_LT((place.X_BP.R.col(2) - middle.outward).norm(), 1e-9);
  EXPECT_NEAR(place.X_BP.R.determinant(), 1, 1e-12);
  for (const SkinPatch& patch : patches)
    if (patch.kind == PatchKind::kPad && patch.middle.digit == "index") {
      EXPECT_GT(place.X_BP.R.col(0).dot(patch.along), 0.9);
      EXPECT_NEAR(place.scale * pad.width, 2 * patch.half_breadth, 1e-12);
    }
  EXPECT_EQ(fingertip_pad_place(hand, "DP2", pad, 0.7).scale, 0.7);
  EXPECT_EQ(message_of([&] { (void)fingertip_pad_place(hand, "PP2", pad, {}); }),
            "a pad needs a 'position': 'PP2' is not a fingertip");
}

TEST(ScenePads, TellWhatIsAssumedAndLawsOfAnotherPad) {
  using testing::Contains;
  const auto warnings_of = [](const std::string& rung, const std::string& name) {
    SceneSpec spec = parse_scene(kTimeAndFriction + kPress + pad_on(kHere + rung), "s.toml");
    spec.pads.at(0).spec.name = name;
    return build_scene(spec, {}).warnings;
  };
  const auto own = warnings_of("rung = \"soft-finger\"\n", "index_pad");
  EXPECT_THAT(own, Contains(StartsWith("pad 'index_pad' is assumed, not measured, in 10 numbers")));
  EXPECT_THAT(own, testing::Not(Contains(HasSubstr("calibrated for"))));
  EXPECT_THAT(
      warnings_of("rung = \"soft-finger\"\n", "thumb_pad"),
      Contains(StartsWith("pad 'thumb_pad' has laws that were calibrated for 'index_pad'")));
  EXPECT_THAT(warnings_of("rung = \"elements\"\n", "thumb_pad"),
              testing::Not(Contains(HasSubstr("calibrated for"))));
}

TEST(ScenePads, TellLawsOfAnotherVersionOfThePad) {
  SceneSpec spec =
      parse_scene(kTimeAndFriction + kPress + pad_on(kHere + "rung = \"soft-finger\"\n"), "s.toml");
  const auto doubted = [&] {
    return testing::Matches(testing::Contains(HasSubstr("another version of pad 'index_pad'")))(
        build_scene(spec, {}).warnings);
  };
  EXPECT_FALSE(doubted());
  spec.pads.at(0).spec.pulp.shear_modulus *= 1.1;
  EXPECT_TRUE(doubted());
  spec.pads.at(0).rung = "elements";
  EXPECT_FALSE(doubted());
}

TEST(ScenePads, SayAtTheirLineWhatDoesNotFit) {
  const auto error_of = [](const std::string& text) {
    return message_of<DataError>([&] { (void)scene_of(text); });
  };
  // [[pad]] stands on line 26.
  EXPECT_THAT(error_of(kPress + pad_on("")), StartsWith("s.toml:26: a pad needs a 'position'"));
  HumanModel hand{default_human(), HumanVersion::kSkewedThumb};
  hand.options.cover = Cover::kNone;
  const auto error_on = [&](const std::string& link) {
    const std::string text = "[[hand]]\nname = \"human:skewed\"\n" + kPress +
                             "[[pad]]\non = \"human:skewed/" + link + "\"\nagainst = [\"cube\"]\n";
    const SceneSpec spec = parse_scene(kTimeAndFriction + text, "s.toml");
    return message_of<DataError>([&] { (void)build_scene(spec, {hand}); });
  };
  EXPECT_THAT(error_on("PP2"), StartsWith("s.toml:28: a pad needs a 'position': 'PP2' is no"));
  EXPECT_THAT(error_on("DP9"), AllOf(StartsWith("s.toml:28: "), HasSubstr("DP9")));
  const BuiltScene built = scene_of(kPress + pad_on(kHere + "rung = \"soft-finger\"\n"));
  BuiltScene changed = built;
  EXPECT_THAT(message_of([&] { set_number(changed, "friction", 0.2); }), HasSubstr("[[pad]]"));
}

}  // namespace
}  // namespace thenar
