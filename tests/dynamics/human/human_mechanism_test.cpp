// Tests for dynamics/human/human_mechanism.cpp and dynamics/scene/scene_humans.cpp.

#include "dynamics/human/human_mechanism.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/units.h"
#include "dynamics/human/digit_pull.h"
#include "dynamics/mechanism/tree_motion.h"
#include "dynamics/scene/build_scene.h"
#include "dynamics/stepping/meeting_pairs.h"
#include "dynamics/stepping/simulate_scene.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// Without skin, which takes a second.
HumanModel bare(HumanVersion version) {
  HumanModel model{default_human(), version};
  model.options.cover = Cover::kNone;
  return model;
}

const HumanMechanism& skewed() {
  static const HumanMechanism hand = human_mechanism(bare(HumanVersion::kSkewedThumb));
  return hand;
}

BuiltScene built(const std::string& text) {
  const std::string head =
      "name = \"x\"\nsource = \"Mine\"\n[sources]\nMine = \"Own\"\n[stepping]\nduration_s = 1\n"
      "[[hand]]\nname = \"h\"\n";
  return build_scene(parse_scene(head + text, "s.toml"),
                     std::vector<SceneHand>{bare(HumanVersion::kSkewedThumb)});
}

/// The same without passive moments of joints.
BuiltScene built_tendons_alone(const std::string& text) {
  HumanModel model = bare(HumanVersion::kSkewedThumb);
  model.options.passive = PassiveMoments::kOff;
  const std::string head =
      "name = \"x\"\nsource = \"Mine\"\n[sources]\nMine = \"Own\"\n[stepping]\nduration_s = 1\n"
      "[[hand]]\nname = \"h\"\n";
  return build_scene(parse_scene(head + text, "s.toml"), std::vector<SceneHand>{model});
}

// Bodies on one joint, and roots of digits in one web, never touch; all others of a hand may.
TEST(HumanMechanism, NeighboursInFleshAreApart) {
  HumanModel model{default_human(), HumanVersion::kSkewedThumb};
  model.options.skin.triangles = 100;
  const BuiltScene scene = build_scene(
      parse_scene("name = \"x\"\nsource = \"Mine\"\n[sources]\nMine = \"Own\"\n[stepping]\n"
                  "duration_s = 1\n[[hand]]\nname = \"h\"\n",
                  "s.toml"),
      std::vector<SceneHand>{model});
  std::vector<std::string> meet;
  const std::vector<MechanismBody>& bodies = scene.scene.mechanism.bodies;
  for (const auto& [a, b] : pairs_that_may_meet(scene.scene, tree_model(scene.scene.mechanism)))
    meet.push_back(bodies[static_cast<std::size_t>(a)].name + " " +
                   bodies[static_cast<std::size_t>(b)].name);
  // Of one digit and its root.
  for (const std::string pair :
       {"h/Palm h/PP2", "h/PP2 h/MP2", "h/MP2 h/DP2", "h/Palm h/MC1", "h/MC1 h/PP1", "h/PP1 h/DP1"})
    EXPECT_THAT(meet, Not(Contains(pair)));
  // Of one web.
  for (const std::string pair : {"h/PP2 h/PP3", "h/PP3 h/PP4", "h/PP4 h/PP5", "h/MC1 h/PP2"})
    EXPECT_THAT(meet, Not(Contains(pair)));
  // All others.
  for (const std::string pair :
       {"h/MP2 h/MP3", "h/DP1 h/DP2", "h/PP2 h/MP3", "h/PP2 h/DP2", "h/Palm h/DP3", "h/PP1 h/PP2"})
    EXPECT_THAT(meet, Contains(pair));
}

// Links are where the interface of hands says, in any posture.
TEST(HumanMechanism, StandsAsTheHandDoes) {
  const HumanMechanism& human = skewed();
  const HumanHand hand = build_human_hand(default_human(), HumanVersion::kSkewedThumb,
                                          bare(HumanVersion::kSkewedThumb).options);
  const TreeModel model = tree_model(human.mechanism);
  TreeMotion<double> motion(model);
  const int n = human.skeleton.coordinates();
  ASSERT_EQ(model.layout.q, n);
  Eigen::VectorXd u(n), q(n);
  for (int c = 0; c < n; ++c) {
    const CoordinateLimits& range = human.skeleton.limits[static_cast<std::size_t>(c)];
    u[c] = range.lower + (0.2 + 0.02 * c) * (range.upper - range.lower);
    q[model.layout.coordinate_q[static_cast<std::size_t>(c)]] = u[c];
  }
  motion.set_position(q);
  const std::vector<Pose<double>> links = hand.hand->pose(u);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Pose<double> X = motion.pose(static_cast<int>(i) + 1);
    EXPECT_TRUE(matrix_near(X.p, links[i].p, 1e-15)) << i;
    EXPECT_TRUE(matrix_near(X.R, links[i].R, 1e-14)) << i;
  }
}

TEST(HumanMechanism, HasTheMassesOfItsSubject) {
  const HumanMechanism& human = skewed();
  double sum = 0;
  for (const MechanismBody& body : human.mechanism.bodies) sum += body.mass.mass;
  double wanted = 0;
  for (const Segment& segment : default_human().segments) wanted += segment.mass;
  EXPECT_NEAR(sum, wanted, 1e-12);
  EXPECT_EQ(human.mechanism.bodies.front().name, "Palm");
  EXPECT_EQ(human.mechanism.bodies[static_cast<std::size_t>(body_named(human.mechanism, "DP1"))]
                .mass.mass,
            0.01008);
}

TEST(HumanMechanism, HasADigitForEachOfItsSubjectWithAllMuscles) {
  const HumanMechanism& human = skewed();
  std::vector<std::string> names;
  for (const HumanDigit& digit : human.digits) names.push_back(digit.name);
  EXPECT_THAT(names, ElementsAre("thumb", "index", "middle", "ring", "little"));
  EXPECT_THAT(human.digits[1].tendons->digit().names.muscles, Contains("FDP2"));
}

TEST(HumanScene, BeginsWhereTheFileSaysWithStopsAndPulls) {
  const BuiltScene scene =
      built("angles_deg = {PIP2 = 40}\n[[tendon]]\nhand = \"h\"\ntension_N = {FDP2 = 5}\n");
  const MechanismLayout layout = layout_of(scene.scene.mechanism);
  std::size_t pip = 0;
  while (scene.scene.mechanism.coordinates.at(pip).name != "h/PIP2") ++pip;
  EXPECT_DOUBLE_EQ(scene.scene.q[layout.coordinate_q[pip]], 40 * kDegree);
  ASSERT_EQ(scene.scene.elements.size(), 2U);
  EXPECT_EQ(scene.scene.elements[0]->name(), "h/stops");
  EXPECT_EQ(scene.scene.elements[1]->name(), "h/index");
  EXPECT_THAT(scene.warnings, Not(Contains(HasSubstr("moves freely"))));
  EXPECT_THAT(built("").warnings, Contains("nothing drives hand 'h': it moves freely"));
}

// Tensions at the start are torques by the moment arms of the digit.
TEST(HumanScene, TensionsActByTheirMomentArms) {
  const BuiltScene scene =
      built_tendons_alone("[[tendon]]\nhand = \"h\"\ntension_N = {FDP2 = 5, FPL = 2}\n");
  SceneElements elements(scene.scene.elements, scene.scene.v.size());
  const TreeModel model = tree_model(scene.scene.mechanism);
  const TreeMotion<double> motion(model);
  const Eigen::VectorXd z = elements.initial_states(scene.scene.q);
  ASSERT_TRUE(elements.compute_action({0, 0, scene.scene.q, scene.scene.v, z, motion, 0}));
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(scene.scene.v.size());
  const HumanMechanism& human = skewed();
  for (const HumanDigit& digit : human.digits) {
    const std::vector<std::string>& muscles = digit.tendons->digit().names.muscles;
    Eigen::VectorXd q(static_cast<Eigen::Index>(digit.coordinates.size()));
    for (std::size_t i = 0; i < digit.coordinates.size(); ++i)
      q[static_cast<Eigen::Index>(i)] =
          scene.scene.q[model.layout.coordinate_q[static_cast<std::size_t>(digit.coordinates[i])]];
    Eigen::VectorXd t = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(muscles.size()));
    for (std::size_t m = 0; m < muscles.size(); ++m)
      t[static_cast<Eigen::Index>(m)] = muscles[m] == "FDP2" ? 5 : muscles[m] == "FPL" ? 2 : 0;
    const Eigen::VectorXd tau = digit.tendons->evaluate(q, t).tau;
    for (std::size_t i = 0; i < digit.coordinates.size(); ++i)
      wanted[model.layout.coordinate_v[static_cast<std::size_t>(digit.coordinates[i])]] +=
          tau[static_cast<Eigen::Index>(i)];
  }
  EXPECT_GT(wanted.cwiseAbs().maxCoeff(), 0.02);
  EXPECT_TRUE(matrix_near(elements.action().tau, wanted, 1e-15));
}

// Coordinates that a hinge that gives adds stand behind those of the hand; stops, tendons and
// drives still find theirs. A hinge as stiff as bone moves as the pin does, to load over stiffness.
TEST(HumanScene, TendonsPullAHingeThatGivesAsThePin) {
  const std::string tendons =
      "[[tendon]]\nhand = \"h\"\ntension_N = {FDP2 = 2, EDC2 = 0.5, FDP3 = 1}\n"
      "[[drive]]\ncoordinate = \"h/MCP2_FE\"\nstiffness_Nm_per_rad = 1\n"
      "damping_Nms_per_rad = 0.05\ntarget_deg = 20\n";
  BuiltScene pin = built(tendons);
  BuiltScene gives = built(tendons +
                           "[[compliance]]\njoint = \"h/PIP2\"\n"
                           "translation_N_per_mm = [1e5, 1e5, 1e5]\n"
                           "translation_damping_Ns_per_m = 1e4\n"
                           "rotation_Nm_per_rad = [1e4, 1e4]\nrotation_damping_Nms_per_rad = 1\n");
  ASSERT_EQ(gives.scene.mechanism.coordinates.size(), pin.scene.mechanism.coordinates.size() + 5);
  for (BuiltScene* scene : {&pin, &gives}) {
    scene->options.method = SteppingMethod::kTimeStepping;
    scene->options.step_length = 2e-4;
    scene->options.duration = 0.04;
    scene->options.sample_interval = 0.01;
  }
  const SceneRun a = simulate_scene(pin.scene, pin.options);
  const SceneRun b = simulate_scene(gives.scene, gives.options);
  ASSERT_EQ(a.status, SceneStatus::kDone);
  ASSERT_EQ(b.status, SceneStatus::kDone);
  const MechanismLayout of_a = layout_of(pin.scene.mechanism);
  const MechanismLayout of_b = layout_of(gives.scene.mechanism);
  double way = 0;
  for (std::size_t c = 0; c < pin.scene.mechanism.coordinates.size(); ++c) {
    const std::string& name = pin.scene.mechanism.coordinates[c].name;
    ASSERT_EQ(gives.scene.mechanism.coordinates[c].name, name);
    const double moved = a.samples.back().q[of_a.coordinate_q[c]];
    EXPECT_NEAR(b.samples.back().q[of_b.coordinate_q[c]], moved, 1e-4) << name;
    if (name == "h/PIP2") way = std::abs(moved - a.samples.front().q[of_a.coordinate_q[c]]);
  }
  EXPECT_GT(way, 0.1);
}

// The first dorsal interosseus comes from the thumb's metacarpal: index and thumb contract as one.
TEST(HumanScene, DigitsThatShareAContractingMuscleAreOne) {
  const BuiltScene scene = built(
      "[[muscle]]\nhand = \"h\"\nexcitation = {FDP2 = 0.1}\nrung = \"bounds\"\n[[tendon]]\nhand = "
      "\"h\"\n"
      "tension_N = {FDP3 = 5}\n");
  std::vector<std::string> names;
  for (const auto& element : scene.scene.elements) names.push_back(element->name());
  EXPECT_THAT(names, ElementsAre("h/stops", "h/thumb-index", "h/middle"));
  EXPECT_THAT(element_state_names(scene.scene.elements),
              Contains("h/thumb-index/activation DI1_MC1 [1]"));
}

TEST(HumanScene, SaysWhatDoesNotFit) {
  const auto complaint = [](const std::string& text) {
    return message_of<DataError>([&] { (void)built(text); });
  };
  EXPECT_THAT(complaint("[[tendon]]\nhand = \"h\"\ntension_N = {FDPX = 5}\n"),
              HasSubstr("s.toml:9: no muscle 'FDPX', did you mean 'FDP2'?"));
  EXPECT_THAT(complaint("angles_deg = {PIPX = 5}\n"),
              HasSubstr("s.toml:7: no joint of hand 'h' 'PIPX', did you mean 'PIP2'?"));
  EXPECT_THAT(complaint("angles_deg = {PIP2 = 170}\n"),
              HasSubstr("joint 'PIP2' of hand 'h' begins at 170 deg, beyond its range"));
  EXPECT_THAT(complaint("[[muscle]]\nhand = \"h\"\nexcitation = {FDP2 = 0.1}\nrung = \"rigid\"\n"),
              HasSubstr("s.toml:9: "));
  EXPECT_THAT(complaint("[[tendon]]\nhand = \"h\"\ntension_N = {FDP2 = 5}\n[[muscle]]\nhand = "
                        "\"h\"\nexcitation = {FDP2 = 0.1}\nrung = \"bounds\"\n"),
              HasSubstr("'FDP2' has a tension or cannot contract, and is excited"));
}

// The line that is told is that of what does not fit, whatever is said after it.
TEST(HumanScene, TellsTheLineOfWhatDoesNotFit) {
  const auto complaint = [](const std::string& text) {
    return message_of<DataError>([&] { (void)built(text); });
  };
  const std::string others = "[[tendon]]\nhand = \"h\"\ntension_N = {FDP4 = 5}\n";
  const std::string tendon = "[[tendon]]\nhand = \"h\"\ntension_N = {FDP3 = 5}\n";
  const std::string muscle =
      "[[muscle]]\nhand = \"h\"\nexcitation = {FDP3 = 0.1}\nrung = \"bounds\"\n";
  EXPECT_THAT(complaint(others + tendon + muscle + others + "from_s = 1\n"),
              HasSubstr("s.toml:15: 'FDP3' has a tension or cannot contract"));
  EXPECT_THAT(complaint(tendon + tendon + others),
              HasSubstr("s.toml:12: two drives give 'FDP3' its tension at once"));
  // No fibre lengths of the little finger.
  EXPECT_THAT(complaint("[[muscle]]\nhand = \"h\"\nexcitation = {FDP5 = 0.1}\nrung = "
                        "\"rigid-tendon\"\n" +
                        others),
              HasSubstr("s.toml:9: muscle '"));
}

// As `simulate` of a digit does, with a warning.
TEST(HumanScene, MusclesWithoutFibresPullByTheirBounds) {
  const std::string muscle = "[[muscle]]\nhand = \"h\"\nexcitation = {FDP5 = 0.1}\n";
  EXPECT_THAT(built(muscle).warnings, Contains(HasSubstr("of little pull by their bounds alone")));
  EXPECT_THAT(built(muscle + "rung = \"bounds\"\n").warnings,
              Not(Contains(HasSubstr("pull by their bounds alone"))));
}

}  // namespace
}  // namespace thenar
