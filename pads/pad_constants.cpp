#include "pads/pad_constants.h"

#include <cmath>

#include "base/enum_names.h"
#include "base/error.h"

namespace thenar {
namespace {

constexpr std::array kTissueConstantWords{
    EnumName{PadConstantKind::kShearModulus, "shear modulus"},
    EnumName{PadConstantKind::kExponent, "exponent"},
    EnumName{PadConstantKind::kPoissonRatio, "Poisson's ratio"},
    EnumName{PadConstantKind::kThickness, "thickness"}};

/// Returns a reference to the value of a constant.
double& constant_entry(PadModel& pad, const PadConstant& constant) {
  if (constant.kind == PadConstantKind::kBoneHeight) return pad.shape.bone_height;
  // Check that the tissue exists.
  const auto count = static_cast<int>(pad.tissues.size());
  require(constant.tissue >= 0 && constant.tissue < count, "a pad of {} tissues has no tissue {}",
          count, constant.tissue);
  Tissue& tissue = pad.tissues[constant.tissue];
  switch (constant.kind) {
    case PadConstantKind::kShearModulus:
      return tissue.shear_modulus;
    case PadConstantKind::kExponent:
      return tissue.exponent;
    case PadConstantKind::kPoissonRatio:
      return tissue.poisson_ratio;
    case PadConstantKind::kShare: {
      const auto terms = static_cast<int>(tissue.relaxation.size());
      require(constant.term >= 0 && constant.term < terms,
              "'{}' has {} terms of relaxation, wanted number {}", tissue.name, terms,
              constant.term + 1);
      return tissue.relaxation[constant.term].share;
    }
    default: {
      // Tissues are ordered from the inside out, layers from the outside in.
      const auto layers = static_cast<int>(pad.shape.layers.size());
      require(constant.tissue > 0 && constant.tissue <= layers,
              "'{}' is not a layer of skin, and has no thickness", tissue.name);
      return pad.shape.layers[layers - constant.tissue].thickness;
    }
  }
}

}  // namespace

std::string name_of(const PadModel& pad, const PadConstant& constant) {
  if (constant.kind == PadConstantKind::kBoneHeight) return "bone height";
  const Tissue& tissue = pad.tissues.at(static_cast<std::size_t>(constant.tissue));
  if (constant.kind == PadConstantKind::kShare)
    return fmt::format("{}: share of {:g} s", tissue.name,
                       tissue.relaxation.at(constant.term).time);
  return tissue.name + ": " + name_in(kTissueConstantWords, constant.kind);
}

DisplayUnit display_unit(PadConstantKind kind) {
  if (kind == PadConstantKind::kShearModulus) return {"kPa", 1e-3};
  const bool is_length =
      kind == PadConstantKind::kThickness || kind == PadConstantKind::kBoneHeight;
  return is_length ? DisplayUnit{"mm", 1e3} : DisplayUnit{};
}

double value_of(const PadModel& pad, const PadConstant& constant) {
  PadModel copy = pad;  // constant_entry() needs write access
  return constant_entry(copy, constant);
}

void set_value(PadModel& pad, const PadConstant& constant, double value) {
  constant_entry(pad, constant) = value;
}

double coordinate_of(const PadConstant& constant, double value) {
  const double size = constant.kind == PadConstantKind::kPoissonRatio ? 0.5 - value
                      : constant.kind == PadConstantKind::kExponent   ? std::abs(value)
                                                                      : value;
  require(size > 0 && std::isfinite(size), "a constant of {:g} cannot be fitted by its logarithm",
          value);
  return std::log(size);
}

double value_at(const PadConstant& constant, double coordinate, double like) {
  const double size = std::exp(coordinate);
  if (constant.kind == PadConstantKind::kPoissonRatio) return 0.5 - size;
  return constant.kind == PadConstantKind::kExponent ? std::copysign(size, like) : size;
}

std::string why_impossible(const PadModel& pad) {
  try {
    for (const Tissue& tissue : pad.tissues) check_tissue(tissue);
    (void)PadChart(pad.shape);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

}  // namespace thenar
