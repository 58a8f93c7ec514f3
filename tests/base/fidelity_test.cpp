// Tests for base/fidelity.h.

#include "base/fidelity.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace thenar {
namespace {

TEST(Fidelity, IsTheCheapestHandByDefault) {
  EXPECT_EQ(describe({}),
            "posed, hinge axes, no tendons, separate tendons, force bounds, no contact");
}

TEST(Fidelity, JoinsToTheRicherRungOfEveryLadder) {
  const Fidelity joined = Fidelity(Motion::kDynamic, Path::kConstant) |
                          Fidelity(Motion::kStatic, Path::kWrapped, ContactModel::kSoftFinger);
  EXPECT_EQ(joined.motion, Motion::kDynamic);
  EXPECT_EQ(joined.path, Path::kWrapped);
  EXPECT_EQ(joined.contact, ContactModel::kSoftFinger);
  EXPECT_EQ(joined.joint, Joint::kHinge);
  EXPECT_EQ(joined.hood, Hood::kSeparate);
  EXPECT_EQ(joined.muscle, Muscle::kBounds);
}

TEST(Fidelity, DescribesTheRichestHand) {
  EXPECT_EQ(
      describe(Fidelity(Motion::kDynamic, Joint::kCompliant, Path::kWrapped, Hood::kFloatingNet,
                        Muscle::kElasticTendon, ContactModel::kFiniteElement)),
      "dynamic, compliant joints, wrapped paths, floating net, elastic tendon, "
      "finite-element pad");
}

TEST(Fidelity, ServesAnyPoorerQuestion) {
  const Fidelity have(Motion::kDynamic, Path::kViaPoint);
  EXPECT_NO_THROW(require_fidelity(have, Fidelity(Motion::kStatic, Path::kConstant), "tip force"));
  EXPECT_NO_THROW(require_fidelity(have, have, "the same"));
}

TEST(Fidelity, NamesTheRungThatIsMissing) {
  try {
    require_fidelity(Fidelity(Motion::kStatic), Fidelity(Motion::kStatic, Path::kConstant),
                     "tip force");
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(
        e.what(),
        "tip force needs 'constant moment arms', but the model was built with 'no tendons'");
  }
}

}  // namespace
}  // namespace thenar
