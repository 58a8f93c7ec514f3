// Tests for hand_versions/muscle_forces.cpp: stated forces, and those of namesakes.

#include "hand_versions/muscle_forces.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "hand/skin/hand_anatomy.h"
#include "tests/hand/skin/human_subjects.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

/// A muscle's entry of a subject.
MuscleUnit& unit_of(Subject& subject, const std::string& name) {
  for (MuscleUnit& each : subject.muscles)
    if (each.name == name) return each;
  throw InputError("no muscle " + name);
}

TEST(MuscleForces, TakesWhatTheSubjectStates) {
  Subject subject = sample::subject("mirakhorlo2016");
  unit_of(subject, "FDP2").max_force = 123;
  unit_of(subject, "FDP3").max_force = 0;  // a muscle that cannot pull
  const MuscleForces forces = muscle_forces(subject, {"FDP2", "FDP3"});
  EXPECT_EQ(forces.max_force.at("FDP2"), 123);
  EXPECT_EQ(forces.max_force.at("FDP3"), 0);
  EXPECT_TRUE(forces.assumed.empty());
}

// Namesake of the middle finger times the ratio of the radii of both proximal phalanges, squared.
TEST(MuscleForces, ScalesTheNamesakeByTheCrossSection) {
  Subject subject = sample::subject("mirakhorlo2016");
  unit_of(subject, "FDP4").max_force.reset();
  unit_of(subject, "FDP5").max_force.reset();
  unit_of(subject, "FDP3").max_force = 200;
  const HandAnatomy anatomy = find_anatomy(subject);
  const double middle = digit_named(anatomy, "middle")->bones[0].radius;
  const MuscleForces forces = muscle_forces(subject, {"FDP4", "FDP5"});
  for (const auto& [muscle, digit] : {std::pair("FDP4", "ring"), std::pair("FDP5", "little")}) {
    const double ratio = digit_named(anatomy, digit)->bones[0].radius / middle;
    EXPECT_NEAR(forces.max_force.at(muscle), 200 * ratio * ratio, 1e-10) << muscle;
    EXPECT_LT(forces.max_force.at(muscle), 200) << muscle;
  }
  ASSERT_EQ(forces.assumed.size(), 2U);
  EXPECT_EQ(forces.assumed[0].find("FDP4: "), 0U);
  EXPECT_NE(forces.assumed[0].find("as FDP3 times"), std::string::npos);
}

TEST(MuscleForces, RefusesWhatHasNoNamesake) {
  Subject subject = sample::subject("mirakhorlo2016");
  unit_of(subject, "FDP2").max_force.reset();
  EXPECT_EQ(message_of([&] { (void)muscle_forces(subject, {"FDP2"}); }),
            "largest tension of muscle 'FDP2' of 'mirakhorlo2016' is unknown, and so is that of a "
            "like one on the middle finger");
  EXPECT_EQ(message_of([&] { (void)muscle_forces(subject, {"XYZ"}); }),
            "subject 'mirakhorlo2016' has no muscle 'XYZ'");
}

}  // namespace
}  // namespace thenar
