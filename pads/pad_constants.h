#pragma once

/// Constants of a pad by name, and the coordinates in which they are fitted.

#include <string>

#include "pads/pad_model.h"

namespace thenar {

/// Kinds of constants of a pad.
enum class PadConstantKind {
  kShearModulus,  // shear modulus of a tissue [Pa]
  kExponent,      // exponent of a tissue's law [1]
  kPoissonRatio,  // Poisson's ratio of a tissue [1]
  kShare,         // share of a tissue's relaxation term [1]
  kThickness,     // thickness of a layer of skin [m]
  kBoneHeight     // height of the phalanx, above which pulp and skin fill the pad [m]
};

/// One constant of a pad.
struct PadConstant {
  PadConstantKind kind = PadConstantKind::kShearModulus;
  int tissue = 0;  // index in PadModel::tissues; unused for kBoneHeight
  int term = 0;    // index of the relaxation term, for kShare
};

/// Returns a name for messages: "pulp: shear modulus", "pulp: share of 0.07 s", "bone height".
[[nodiscard]] std::string name_of(const PadModel& pad, const PadConstant& constant);

/// Unit in which a constant is displayed.
struct DisplayUnit {
  std::string name;   // "kPa", "mm" or ""
  double per_si = 1;  // display units in one SI unit
};
[[nodiscard]] DisplayUnit display_unit(PadConstantKind kind);

/// @throws InputError if the pad has no such tissue, layer or term.
[[nodiscard]] double value_of(const PadModel& pad, const PadConstant& constant);
void set_value(PadModel& pad, const PadConstant& constant, double value);

/// Returns the coordinate of a value: log(value); for Poisson's ratio log(1/2 - nu), the log of a
/// measure of compressibility; for an exponent, which may be negative, log |k|.
/// @throws InputError if the value has no coordinate.
[[nodiscard]] double coordinate_of(const PadConstant& constant, double value);
/// Returns the value at a coordinate.
/// @param like  value with the sign of the result
[[nodiscard]] double value_at(const PadConstant& constant, double coordinate, double like);

/// Returns the reason why a pad is invalid: a tissue that check_tissue() rejects, or a bone outside
/// the skin; empty if it is valid.
[[nodiscard]] std::string why_impossible(const PadModel& pad);

}  // namespace thenar
