#include "pads/pad_fit_problem.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/data_folder.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

PadSpec sheet() {
  PadSpec pad;
  pad.name = "sheet";
  pad.length = 24e-3;
  pad.width = 16e-3;
  pad.height = 10e-3;
  pad.bone_length = 14e-3;
  pad.bone_width = 7e-3;
  pad.bone_height = 4.5e-3;
  pad.pulp.shear_modulus = 9e3;
  pad.pulp.poisson_ratio = 0.48;
  pad.pulp.relaxation_share = {0.3, 0.2};
  pad.pulp.relaxation_time = {0.07, 1.4};
  pad.pulp.source = "Guess";
  pad.pulp.assumed = {"law", "shear_modulus_kPa"};
  PadTissueSpec skin = pad.pulp;
  skin.relaxation_share.clear();
  skin.relaxation_time.clear();
  skin.thickness = 0.3e-3;
  skin.shear_modulus = 30e3;
  pad.layers = {skin, skin};
  pad.layers[1].thickness = 0.8e-3;
  return pad;
}

const std::string kHead = R"(title = "Presses"
pad = "sheet"
source = "Own"
[sources]
Own = "x"
)";
const std::string kPress = R"([[press]]
name = "tilted"
object = "cylinder"
radius_mm = 5
angle_deg = 30
pace = "ramp"
ramp_s = 2
imposed = "indentation"
[[press.data]]
indentation_mm = [1, 0.5]
force_N = [0.4, 0.1]
sd_force_N = [0.1, 0.1]
[[press.data]]
indentation_mm = [0.5]
part_of = "area"
part = [0.5]
sd_part = [0.1]
at_indentation_mm = 2
)";

PadFitProblem problem_of(const std::string& constants, const std::string& press = kPress) {
  return pad_fit_problem(parse_pad_data(kHead + constants + press, "data.toml"), sheet());
}

TEST(PadFitProblem, NamesConstantsAsTheFileDoes) {
  const PadFitProblem problem = problem_of(R"([[constant]]
constant = "thickness"
layer = 1
[[constant]]
constant = "thickness"
layer = 2
[[constant]]
constant = "share"
term = 2
[[constant]]
constant = "shear_modulus"
start_kPa = 3
)");
  const auto value = [&](std::size_t i) {
    return value_of(problem.pad, problem.constants[i].constant);
  };
  EXPECT_EQ(value(0), 0.3e-3);
  EXPECT_EQ(value(1), 0.8e-3);
  EXPECT_EQ(value(2), 0.2);
  EXPECT_NEAR(value(3), 3e3, 1e-9);
}

TEST(PadFitProblem, LoadsRiseInTime) {
  const PadFitProblem problem = problem_of("[[constant]]\nconstant = \"shear_modulus\"\n");
  const PressRecord& record = problem.records.at(0);
  ASSERT_EQ(record.course.loads.size(), 3U);
  EXPECT_NEAR(record.course.loads[0].indentation, 0.5e-3, 1e-18);
  EXPECT_NEAR(record.course.loads[2].indentation, 2e-3, 1e-18);
  EXPECT_NEAR(record.course.loads[1].time, 0.5, 1e-12);  // of 2 s to 2 mm
  EXPECT_NEAR(record.course.loads[2].time, 1.0, 1e-12);
  ASSERT_EQ(record.data.size(), 3U);
  EXPECT_EQ(record.data[0].load, 1);
  EXPECT_EQ(record.data[1].load, 0);
  EXPECT_EQ(record.data[2].over, 2);
  EXPECT_NEAR(record.course.along[0], -0.5, 1e-12);
  // The cylinder touches the skin on its way, its axis across the finger.
  const PressCurves curves = press_curves({problem.pad}, record.course);
  EXPECT_EQ(curves.status, Status::kSolved) << curves.message;
  EXPECT_LT((record.course.X_PO.R * Eigen::Vector3d(0, 0, 1)).head<1>().norm(), 1e-12);
}

TEST(PadFitProblem, WhatThePadLacksIsNamedWithItsLine) {
  const auto complaint = [](const std::string& lines, const std::string& press = kPress) {
    return message_of<DataError>(
        [&] { (void)problem_of("[[constant]]\nconstant = " + lines + "\n", press); });
  };
  EXPECT_EQ(complaint("\"shear_modulus\"\nlayer = 3"),
            "data.toml:6: pad 'sheet' has 2 layers of skin, wanted layer 3");
  EXPECT_EQ(complaint("\"exponent\""), "data.toml:6: the law 'neo-hookean' has no exponent");
  EXPECT_EQ(complaint("\"share\"\nterm = 3"),
            "data.toml:6: this tissue has 2 terms of relaxation, wanted term 3");
  EXPECT_THAT(complaint("\"bone_height\"\n[[constant]]\nconstant = \"bone_height\""),
              HasSubstr("data.toml:8: bone height is free already"));
  std::string at_once = kPress;
  at_once.replace(at_once.find("pace = \"ramp\"\nramp_s = 2\n"), 25, "");
  EXPECT_THAT(complaint("\"poisson_ratio\"\nstart = 0.5"), HasSubstr("data.toml:6: "));
  EXPECT_THAT(complaint("\"share\"", at_once), HasSubstr("no press takes time"));
}

// The pad of data/pads that is fitted to data/presses meets what is published within one sd of each
// value, and more of it: the patch grows far slower than the 2/3 of Hertz's contact.
TEST(PadFitProblem, TheFittedPadMeetsWhatIsPublished) {
  const PadData data = read_pad_data(kData + "/presses/index_published.toml");
  PadData as_fitted = data;
  for (PadDataConstant& constant : as_fitted.constants) constant.start.reset();
  const PadFitProblem problem =
      pad_fit_problem(as_fitted, read_pad(kData + "/pads/" + data.pad + ".toml"));
  PressRecord record = problem.records.at(0);
  const std::vector<PressCurves> curves = press_records(problem.pad, problem.records);
  ASSERT_EQ(curves[0].status, Status::kSolved) << curves[0].message;
  const std::vector<PressPoint>& points = curves[0].points[0];
  EXPECT_EQ(record.data.size(), 3U);
  for (const PressDatum& datum : record.data)
    EXPECT_NEAR(predicted(datum, points), datum.value, datum.sd) << name_of(datum.quantity);
  const PressPoint &first = points.front(), &last = points.back();
  EXPECT_LT(std::log(last.area / first.area) / std::log(last.force / first.force), 0.4);
}

TEST(PadFitProblem, AFittedPadTellsWhatIsAssumedStill) {
  const PadData data = parse_pad_data(kHead + R"([[constant]]
constant = "shear_modulus"
[[constant]]
constant = "shear_modulus"
layer = 2
)" + kPress,
                                      "data.toml");
  PadSpec pad = sheet();
  pad.layers[1].assumed = {"law"};  // its modulus is said to be measured
  pad.own_sources = {{"Guess", "g"}, {"Own", "y"}};
  const PadFitProblem problem = pad_fit_problem(data, pad);
  PadFitResult result;
  result.estimates.resize(2);
  result.estimates[0].value = 5e3;
  result.estimates[0].determined = true;
  result.estimates[1].value = 60e3;
  const PadSpec fitted = fitted_pad(pad, data, problem, result);
  EXPECT_EQ(fitted.pulp.shear_modulus, 5e3);
  EXPECT_EQ(fitted.layers[0].shear_modulus, 30e3);
  EXPECT_EQ(fitted.layers[1].shear_modulus, 60e3);
  EXPECT_THAT(fitted.pulp.assumed, ElementsAre("law"));
  EXPECT_EQ(fitted.pulp.source, "Guess, Own");
  EXPECT_THAT(fitted.layers[1].assumed, UnorderedElementsAre("law", "shear_modulus_kPa"));
  EXPECT_EQ(fitted.layers[1].source, "Guess");
  // Both files have a source of their own by the name of "Own".
  EXPECT_EQ(fitted.own_sources.at("Own"), "y; x");
  EXPECT_EQ(fitted.own_sources.at("Guess"), "g");
}

}  // namespace
}  // namespace thenar
