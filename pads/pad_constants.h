#pragma once

/// Constants of a pad by name, and coordinates in which fits move them.

#include <string>
#include <vector>

#include "pads/pad_model.h"

namespace thenar {

/// Kinds of constants of a pad.
enum class PadConstantKind {
  kShearModulus,  // of a tissue [Pa]
  kExponent,      // of a tissue's law [1]
  kPoissonRatio,  // of a tissue [1]
  kShare,         // of a tissue's relaxation term [1]
  kThickness,     // of a layer of skin [m]
  kBoneHeight     // of the phalanx: what is left above it is pulp and skin [m]
};

/// One constant of a pad.
struct PadConstant {
  PadConstantKind kind = PadConstantKind::kShearModulus;
  int tissue = 0;  // of PadModel::tissues; unused by kBoneHeight
  int term = 0;    // of the tissue's relaxation; of kShare
};

/// "pulp: shear modulus", "pulp: share of 0.07 s", "bone height".
[[nodiscard]] std::string name_of(const PadModel& pad, const PadConstant& constant);

/// "kPa", "mm" or "", and how many of them are one in SI.
struct DisplayUnit {
  std::string name;
  double per_si = 1;
};
[[nodiscard]] DisplayUnit display_unit(PadConstantKind kind);

/// @throws InputError if the pad has no such tissue, layer or term.
[[nodiscard]] double value_of(const PadModel& pad, const PadConstant& constant);
void set_value(PadModel& pad, const PadConstant& constant, double value);

/// Coordinate of a value, log(value); of Poisson's ratio log(1/2 - nu), which is the log of how
/// compressible a tissue is. Ogden's exponent may be negative: log |k|, of the sign it has.
/// @throws InputError if it has none.
[[nodiscard]] double coordinate_of(const PadConstant& constant, double value);
/// @param like  a value of the same sign
[[nodiscard]] double value_at(const PadConstant& constant, double coordinate, double like);

/// Returns the reason why a pad is impossible: a tissue that check_tissue() refuses, a bone outside
/// of the skin; or empty.
[[nodiscard]] std::string why_impossible(const PadModel& pad);

}  // namespace thenar
