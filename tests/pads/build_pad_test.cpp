// Tests for pads/build_pad.cpp.

#include "pads/build_pad.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

PadSpec plain_pad() {
  PadSpec spec;
  spec.name = "plain";
  spec.length = 24e-3;
  spec.width = 16e-3;
  spec.height = 10e-3;
  spec.bone_length = 14e-3;
  spec.bone_width = 7e-3;
  spec.bone_height = 4.5e-3;
  spec.pulp.shear_modulus = 12e3;
  spec.pulp.poisson_ratio = 0.49;
  return spec;
}

TEST(BuildPad, KnowsAllNamesOfFiles) {
  for (const std::string& name : tissue_law_names())
    EXPECT_EQ(name_of(tissue_law_named(name)), name);
  for (const std::string& name : pad_element_names())
    EXPECT_EQ(name_of(pad_element_named(name)), name);
  EXPECT_EQ(message_of([] { (void)tissue_law_named("ogdon"); }),
            "no law of tissue 'ogdon', did you mean 'ogden'? there are neo-hookean, ogden, "
            "veronda-westmann");
}

TEST(BuildPad, OrdersTissuesFromTheInsideOut) {
  PadSpec spec = plain_pad();
  for (const double thickness : {0.2e-3, 1e-3}) {  // from the outside in
    PadTissueSpec layer = spec.pulp;
    layer.thickness = thickness;
    layer.shear_modulus = 1e6 * thickness;
    spec.layers.push_back(layer);
  }
  spec.pulp.relaxation_share = {0.3};
  spec.pulp.relaxation_time = {2};
  const PadModel model = build_pad(spec);
  ASSERT_EQ(model.tissues.size(), 3U);
  EXPECT_EQ(model.tissues[0].shear_modulus, 12e3);
  EXPECT_EQ(model.tissues[0].relaxation.at(0).share, 0.3);
  EXPECT_EQ(model.tissues[0].relaxation.at(0).time, 2);
  EXPECT_DOUBLE_EQ(model.tissues[1].shear_modulus, 1e3);  // next to the pulp
  EXPECT_DOUBLE_EQ(model.tissues[2].shear_modulus, 0.2e3);
  EXPECT_EQ(model.shape.layers.at(0).thickness, 0.2e-3);  // the outermost
}

TEST(BuildPad, TakesASkinOfItsOwn) {
  PadSpec spec = plain_pad();
  ShapeSpec ball;
  ball.size[0] = 11e-3;
  spec.skin = ball;
  EXPECT_NEAR(PadChart(build_pad(spec).shape).place({0.3, 0.2, 1}).norm(), 11e-3, 2e-9);
}

TEST(BuildPad, RefusesWhatDoesNotFit) {
  PadSpec spec = plain_pad();
  spec.bone_width = 17e-3;
  EXPECT_THROW((void)build_pad(spec), InputError);
  spec = plain_pad();
  spec.pulp.poisson_ratio = 0.5;
  EXPECT_THROW((void)build_pad(spec), InputError);
  spec = plain_pad();
  spec.pulp.relaxation_share = {0.5};
  EXPECT_THROW((void)build_pad(spec), InputError);
}

}  // namespace
}  // namespace thenar
