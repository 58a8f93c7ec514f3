// Tests for api/pads/fit_pad.cpp.

#include "api/pads/fit_pad.h"

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/api/pads/small_presses.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class FitPad : public TemporaryFolder {
 protected:
  /// A fit that begins at 20 kPa and 0.7.
  [[nodiscard]] PadFitRequest request(const std::string& presses) const {
    std::ofstream(path("pad.toml")) << sample::pad_text(20, 0.7);
    std::ofstream(path("presses.toml")) << presses;
    PadFitRequest out;
    out.presses = path("presses.toml");
    out.check_mesh = false;
    out.points = 4;
    return out;
  }
};

TEST_F(FitPad, FindsTheConstantsThatMadeItsData) {
  const FittedPad fitted = fit_pad(request(sample::kPressesHead + sample::press_of(8, 1.5)));
  ASSERT_TRUE(fitted.fit.solution.converged()) << fitted.fit.solution.message;
  const std::vector<ConstantEstimate>& found = fitted.fit.estimates;
  ASSERT_EQ(found.size(), 2U);
  for (const ConstantEstimate& each : found) EXPECT_TRUE(each.determined);
  // The data have no noise: what is left is the search's tolerance, far below an sd.
  EXPECT_LT(std::abs(std::log(found[0].value / 8e3)), 0.02 * found[0].sd);
  EXPECT_LT(std::abs(std::log(found[1].value / 1.5)), 0.02 * found[1].sd);
  EXPECT_THAT(fitted.spec.pulp.assumed, IsEmpty());
  EXPECT_EQ(refusal_of(fitted), "");
  // The curve goes through what was predicted.
  ASSERT_EQ(fitted.curves.size(), 1U);
  EXPECT_EQ(fitted.curves[0].loads.size(), fitted.curves[0].points.size());
  EXPECT_EQ(fitted.curves[0].loads.back(), 3);
  EXPECT_NEAR(fitted.curves[0].points.back().force, 3, 1e-6);
  EXPECT_NEAR(fitted.curves[0].points.back().indentation, fitted.fit.predictions[0][2].value, 1e-8);
}

// Where indentations are imposed, forces of one tissue scale with its modulus, and their parts tell
// nothing of it.
TEST_F(FitPad, AConstantThatNoDatumSpeaksOfIsNotDetermined) {
  const FittedPad fitted = fit_pad(request(sample::kPressesHead + R"([[press]]
name = "shape of a curve"
object = "plane"
imposed = "indentation"
[[press.data]]
indentation_mm = [0.4, 0.8]
part_of = "force"
part = [0.1, 0.4]
sd_part = [0.01, 0.02]
at_indentation_mm = 1.2
)"));
  const std::vector<ConstantEstimate>& found = fitted.fit.estimates;
  ASSERT_EQ(found.size(), 2U);
  EXPECT_FALSE(found[0].determined);
  EXPECT_TRUE(std::isinf(found[0].sd));
  EXPECT_TRUE(std::isfinite(found[1].sd));
  EXPECT_THAT(fitted.outcome.warnings,
              testing::Contains(HasSubstr("pulp: shear modulus is not determined by the data")));
  EXPECT_THAT(fitted.spec.pulp.assumed, testing::Contains("shear_modulus_kPa"));
  EXPECT_THAT(fitted.outcome.warnings, testing::Contains(HasSubstr("is assumed, not measured")));
}

TEST_F(FitPad, ItsTextIsAPadWithSourcesOfBoth) {
  const FittedPad fitted = fit_pad(request(sample::kPressesHead + sample::press_of(8, 1.5)));
  const std::string text = fitted_pad_text(fitted, path("mine.toml"));
  EXPECT_THAT(text, testing::StartsWith("# Fitted to Two presses: "));
  const PadSpec pad = parse_pad(text, "mine.toml");
  EXPECT_EQ(pad.name, "mine");
  EXPECT_NEAR(pad.pulp.shear_modulus, fitted.fit.estimates[0].value, 1e-9);
  EXPECT_EQ(pad.across, 2);
  EXPECT_EQ(pad.pulp.source, "Guess, Own");
  EXPECT_EQ(pad.own_sources.at("Guess"), "A guess");
  EXPECT_EQ(pad.own_sources.at("Own"), "Own measurement");
}

TEST_F(FitPad, AMeshOfTheSkinIsNamedFromWhereTheTextIs) {
  FittedPad fitted;
  fitted.pad.path = path("pads/pad.toml");
  fitted.spec.skin = ShapeSpec{};
  fitted.spec.skin->kind = ShapeKind::kMesh;
  fitted.spec.skin->mesh_file = "skin.obj";
  fitted.fit.estimates.resize(1);
  fitted.problem.pad.tissues = {Tissue{}};
  fitted.problem.constants = {{{PadConstantKind::kBoneHeight, 0, 0}}};
  EXPECT_THAT(fitted_pad_text(fitted, path("fitted/pad.toml")),
              HasSubstr("file = \"../pads/skin.obj\"\n"));
}

TEST_F(FitPad, AStopBeforeAnEstimateSaysSo) {
  Progress progress;
  progress.stop_requested = [] { return true; };
  const FittedPad fitted =
      fit_pad(request(sample::kPressesHead + sample::press_text({1, 2, 3}, {50, 90})), progress);
  EXPECT_TRUE(fitted.outcome.stopped());
  EXPECT_THAT(fitted.fit.estimates, IsEmpty());
  EXPECT_THAT(fitted.curves, IsEmpty());
  EXPECT_EQ(message_of([&] { (void)fitted_pad_text(fitted, "x.toml"); }),
            "a fit without estimates makes no pad");
}

TEST_F(FitPad, ASearchThatDidNotConvergeIsNoPadUnlessAllowed) {
  FittedPad fitted;
  fitted.fit.solution.status = Status::kStalled;
  fitted.fit.solution.message = "no step helps";
  EXPECT_EQ(refusal_of(fitted), "the search did not converge (not stationary: no step helps)");
  fitted.request.allow_unconverged = true;
  EXPECT_EQ(refusal_of(fitted), "");
}

TEST_F(FitPad, WhatCannotBeIsToldWithItsPlace) {
  const std::string press = sample::press_text({1, 2, 3}, {50, 90});
  // [[press]] is on line 14 of the file.
  std::string crushed = press;
  for (const std::string loads : {"[0.2, 0.6, 3]", "[0.6, 3]"})
    crushed.replace(crushed.find(loads) + loads.size() - 2, 1, "1e6");
  const PadFitRequest heavy = request(sample::kPressesHead + crushed);
  EXPECT_THAT(message_of<DataError>([&] { (void)fit_pad(heavy); }),
              HasSubstr("presses.toml:14: press 'flat' cannot be done where the search begins"));
  std::string elsewhere = sample::kPressesHead;
  elsewhere.replace(elsewhere.find("pad.toml"), 8, "nowhere!");
  PadFitRequest lost = request(elsewhere + press);
  EXPECT_THAT(message_of([&] { (void)fit_pad(lost); }),
              HasSubstr("presses.toml: there is no pad 'nowhere!'"));
  lost.points = 0;
  EXPECT_EQ(message_of([&] { (void)fit_pad(lost); }), "wanted 1 to 1000 points of a curve, got 0");
}

}  // namespace
}  // namespace thenar
