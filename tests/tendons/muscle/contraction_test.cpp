// Tests for tendons/muscle/contraction.cpp.

#include "tendons/muscle/contraction.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/tendons/muscle/moving_samples.h"

namespace thenar {
namespace {

Subject bare_index() {
  return read_subject(std::string(THENAR_DATA_DIR) + "/subjects/an_chao_index.toml");
}

std::string complaint(const Subject& subject, Muscle rung) {
  try {
    (void)musculotendons(subject, build_tendon_digit(subject, "index"), rung);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(Contraction, NamesMuscleAndKeyThatARungLacks) {
  Subject subject = bare_index();
  EXPECT_EQ(complaint(subject, Muscle::kRigidTendon), "");
  EXPECT_EQ(complaint(subject, Muscle::kElasticTendon),
            "muscle 'EDC' of subject 'an_chao_index' needs 'tendon_slack_mm' to pull as "
            "'elastic-tendon'; 'rigid-tendon' does without");
  subject.muscles[2].fibre_length = 0;
  EXPECT_EQ(complaint(subject, Muscle::kRigidTendon),
            "muscle 'FDP' of subject 'an_chao_index' needs 'fibre_length_mm' to pull as "
            "'rigid-tendon'; 'bounds' does without");
  EXPECT_EQ(complaint(subject, Muscle::kElasticTendon),
            "muscle 'EDC' of subject 'an_chao_index' needs 'tendon_slack_mm' to pull as "
            "'elastic-tendon'; 'rigid-tendon' does without");
  subject.muscles[1].max_force.reset();
  EXPECT_EQ(complaint(subject, Muscle::kBounds),
            "muscle 'EIP' of subject 'an_chao_index' needs 'max_force_N' to pull as 'bounds'");
  subject.muscles[0].fibre_length = 1;
  EXPECT_EQ(
      complaint(subject, Muscle::kRigidTendon),
      "muscle 'EIP' of subject 'an_chao_index' needs 'max_force_N' to pull as 'rigid-tendon'");
}

// F0 = PCSA times specific tension, 4.79 cm^2 30 N/cm^2; pennation 12.1 deg.
TEST(Contraction, TakesConstantsFromTheSubject) {
  const Subject subject = bare_index();
  const auto muscles =
      musculotendons(subject, build_tendon_digit(subject, "index"), Muscle::kRigidTendon);
  EXPECT_EQ(muscles[2].name, "FDP");
  EXPECT_NEAR(muscles[2].F0, 143.7, 1e-10);
  EXPECT_NEAR(muscles[2].optimal_fibre_length, 0.066, 1e-15);
  EXPECT_NEAR(muscles[2].pennation, 12.1 * kDegree, 1e-15);
}

// At the optimal length and at rest all rungs pull with a F0 cos(pennation), but for the stretch of
// the elastic tendon and the pennation, which bounds know nothing of.
TEST(Contraction, RungsAgreeAtOptimalLengthAtRest) {
  Musculotendon muscle{"M", 100, 0.06, 0.2, 0};
  const double length = musculotendon_length_at_optimum(muscle);
  for (const double a : {0.0, 0.3, 1.0}) {
    const auto bounds = build_contraction({muscle}, Muscle::kBounds);
    const auto rigid = build_contraction({muscle}, Muscle::kRigidTendon);
    const auto elastic = build_contraction({muscle}, Muscle::kElasticTendon, {10, 0.1, 1e-7});
    EXPECT_NEAR(bounds->tension(0, {a, length, 0, 0}), 100 * a, 1e-12);
    EXPECT_NEAR(rigid->tension(0, {a, length, 0, 0}), 100 * a, 1e-12);
    const double projected_fibre = elastic->isometric_projected_fibre(0, a, length);
    EXPECT_NEAR(elastic->tension(0, {a, length, 0, projected_fibre}), 100 * a,
                1e-4);  // of the stretch
  }
}

TEST(Contraction, BoundsFollowActivationWhateverTheMotion) {
  const auto bounds = build_contraction({{"M", 100, 0, 0, 0}}, Muscle::kBounds);
  EXPECT_EQ(bounds->tension(0, {0.25, 7, -3, 0}), 25);
  EXPECT_EQ(bounds->tension(0, {-1e-12, 7, -3, 0}), 0);
}

}  // namespace
}  // namespace thenar
