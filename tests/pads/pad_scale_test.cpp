// Tests for pads/pad_scale.h: pads of other sizes against laws and elements pressed there.

#include "pads/pad_scale.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "data/io/pad/law_file.h"
#include "geometry/primitives.h"
#include "pads/pad_press.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

constexpr double kScale = 1.3;

/// Force of elements of a pad times s, pressed 1 mm times s by a ball of 20 mm times s [N].
double force_at_scale(double s) {
  PadModel model;
  model.shape = scaled_shape(PadShape(), s);
  model.tissues.resize(1);
  model.tissues[0].shear_modulus = 12e3;
  model.tissues[0].poisson_ratio = 0.49;
  PadPressOptions options;
  options.max_elements = 1;
  Pose<double> X;
  X.p.z() = model.shape.height + s * 20e-3 - s * 1e-3;
  Pose<double> far = X;
  far.p.z() += s * 5e-3;
  PadPress press(model, {build_sphere(s * 20e-3), 0.5}, far, options);
  PressGoal goal;
  goal.X_PO = X;
  const PadPressResult result = press.step(goal);
  EXPECT_EQ(result.solved.status, Status::kSolved);
  return result.push.force.norm();
}

TEST(PadScale, ElementsOfASimilarPadHaveForcesAsTheSquare) {
  const double force = force_at_scale(1);
  ASSERT_GT(force, 0.05);
  EXPECT_NEAR(force_at_scale(kScale), kScale * kScale * force, 1e-6 * force);
}

TEST(PadScale, LawsOfASimilarPadHaveForcesAsTheSquareAndPatchesAsTheLength) {
  const CalibratedLaws laws = read_laws(kData + "/pads/laws/index_pad.toml");
  const CalibratedLaws large = scaled_laws(laws, kScale);
  const auto expect_similar = [](const ContactLaw& before, const ContactLaw& after) {
    const RelativeCurvatures gap{150, 60}, wide{150 / kScale, 60 / kScale};  // [1/m]
    const LawContact a = before.at_depth(gap, 1e-3, 0.5);
    const LawContact b = after.at_depth(wide, kScale * 1e-3, 0.5);
    EXPECT_NEAR(b.force, kScale * kScale * a.force, 1e-12 * b.force);
    EXPECT_NEAR(b.area, kScale * kScale * a.area, 1e-12 * b.area);
    EXPECT_NEAR(b.patch.torsion, kScale * a.patch.torsion, 1e-12 * b.patch.torsion);
  };
  expect_similar(PowerLaw(laws.power), PowerLaw(large.power));
  expect_similar(SoftFinger(laws.soft_finger), SoftFinger(large.soft_finger));
  expect_similar(ElasticFoundation(laws.foundation), ElasticFoundation(large.foundation));
}

TEST(PadScale, RefusesNoScale) {
  EXPECT_THROW((void)scaled_shape(PadShape(), 0), InputError);
  EXPECT_THROW((void)scaled_laws({}, -1), InputError);
}

}  // namespace
}  // namespace thenar
