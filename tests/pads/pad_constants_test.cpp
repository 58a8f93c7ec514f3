// Tests for pads/pad_constants.cpp.

#include "pads/pad_constants.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

/// Pulp, dermis and epidermis; layers of the shape go from the outside in.
PadModel layered_pad() {
  PadModel pad;
  pad.tissues.resize(3);
  const char* names[] = {"pulp", "dermis", "epidermis"};
  for (std::size_t i = 0; i < 3; ++i) {
    pad.tissues[i].name = names[i];
    pad.tissues[i].shear_modulus = 1e4 * static_cast<double>(i + 1);
  }
  pad.tissues[0].relaxation = {{0.3, 0.07}, {0.2, 2}};
  pad.shape.layers = {{0.2e-3}, {1e-3}};
  return pad;
}

TEST(PadConstants, NamesTissueAndConstant) {
  const PadModel pad = layered_pad();
  EXPECT_EQ(name_of(pad, {PadConstantKind::kShearModulus, 1}), "dermis: shear modulus");
  EXPECT_EQ(name_of(pad, {PadConstantKind::kShare, 0, 0}),
            fmt::format("pulp: share of {:g} s", pad.tissues[0].relaxation[0].time));
  EXPECT_EQ(name_of(pad, {PadConstantKind::kBoneHeight, 7}), "bone height");
}

// The outermost layer of the shape is the last of the tissues.
TEST(PadConstants, FindsALayerFromTheOutsideIn) {
  const PadModel pad = layered_pad();
  EXPECT_EQ(value_of(pad, {PadConstantKind::kThickness, 2}), 0.2e-3);
  EXPECT_EQ(value_of(pad, {PadConstantKind::kThickness, 1}), 1e-3);
}

// Each constant that is set is read back, and nothing else has changed.
TEST(PadConstants, SetsOneConstantAlone) {
  const std::vector<PadConstant> all{
      {PadConstantKind::kShearModulus, 0}, {PadConstantKind::kShearModulus, 2},
      {PadConstantKind::kExponent, 1},     {PadConstantKind::kPoissonRatio, 1},
      {PadConstantKind::kShare, 0, 0},     {PadConstantKind::kShare, 0, 1},
      {PadConstantKind::kThickness, 1},    {PadConstantKind::kThickness, 2},
      {PadConstantKind::kBoneHeight}};
  const PadModel before = layered_pad();
  for (std::size_t i = 0; i < all.size(); ++i) {
    PadModel pad = before;
    set_value(pad, all[i], 0.123);
    for (std::size_t j = 0; j < all.size(); ++j)
      EXPECT_EQ(value_of(pad, all[j]), i == j ? 0.123 : value_of(before, all[j])) << i << " " << j;
  }
}

TEST(PadConstants, CoordinatesAreLogarithms) {
  EXPECT_DOUBLE_EQ(coordinate_of({PadConstantKind::kShearModulus}, std::exp(3.0)), 3);
  EXPECT_DOUBLE_EQ(coordinate_of({PadConstantKind::kPoissonRatio}, 0.25), std::log(0.25));
  EXPECT_DOUBLE_EQ(coordinate_of({PadConstantKind::kExponent}, -std::exp(2.0)), 2);
}

// value_at() is the inverse of coordinate_of(), with the sign of the value that it is like.
TEST(PadConstants, GoesToCoordinatesAndBack) {
  const auto back = [](PadConstantKind kind, double value) {
    return value_at({kind}, coordinate_of({kind}, value), value);
  };
  EXPECT_NEAR(back(PadConstantKind::kShearModulus, 12e3), 12e3, 1e-10);
  EXPECT_NEAR(back(PadConstantKind::kPoissonRatio, 0.495), 0.495, 1e-15);
  EXPECT_NEAR(back(PadConstantKind::kPoissonRatio, -0.3), -0.3, 1e-15);
  EXPECT_NEAR(back(PadConstantKind::kExponent, -5), -5, 1e-14);
}

TEST(PadConstants, RefusesWhatAPadHasNot) {
  const PadModel pad = layered_pad();
  EXPECT_EQ(message_of([&] {
              (void)value_of(pad, {PadConstantKind::kExponent, 3});
            }),
            "a pad of 3 tissues has no tissue 3");
  EXPECT_EQ(message_of([&] {
              (void)value_of(pad, {PadConstantKind::kShare, 0, 2});
            }),
            "'pulp' has 2 terms of relaxation, wanted number 3");
  EXPECT_EQ(message_of([&] {
              (void)value_of(pad, {PadConstantKind::kThickness, 0});
            }),
            "'pulp' is not a layer of skin, and has no thickness");
  EXPECT_EQ(message_of([] { (void)coordinate_of({PadConstantKind::kPoissonRatio}, 0.5); }),
            "a constant of 0.5 cannot be fitted by its logarithm");
}

TEST(PadConstants, SaysWhyAPadIsImpossible) {
  PadModel pad = layered_pad();
  EXPECT_EQ(why_impossible(pad), "");
  set_value(pad, {PadConstantKind::kBoneHeight}, pad.shape.height);
  EXPECT_EQ(why_impossible(pad), "the bone of a pad must lie within its skin");
  pad = layered_pad();
  set_value(pad, {PadConstantKind::kShare, 0, 0}, 0.8);  // with 0.2 all of it
  EXPECT_NE(why_impossible(pad), "");
}

// A modulus is shown in kPa and a length in mm: a value of one unit shown is 1.
TEST(PadConstants, ShowsUnitsOfTheField) {
  EXPECT_EQ(display_unit(PadConstantKind::kShearModulus).name, "kPa");
  EXPECT_DOUBLE_EQ(display_unit(PadConstantKind::kShearModulus).per_si * 1000, 1);
  EXPECT_EQ(display_unit(PadConstantKind::kBoneHeight).name, "mm");
  EXPECT_DOUBLE_EQ(display_unit(PadConstantKind::kThickness).per_si * 0.001, 1);
  EXPECT_EQ(display_unit(PadConstantKind::kShare).name, "");
}

}  // namespace
}  // namespace thenar
