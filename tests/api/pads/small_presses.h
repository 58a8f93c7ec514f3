#pragma once

/// A pad and its measured presses as files, small enough to fit in a second.

#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "data/io/pad/pad.h"
#include "data/io/pad/pad_data.h"
#include "pads/pad_fit_problem.h"

namespace thenar::sample {

/// The head of a pad's file: all before its pulp.
inline const std::string kPadHead = R"(name = "pad"
source = "Guess"
[sources]
Guess = "A guess"
[shape]
length_mm = 24
width_mm = 16
height_mm = 10
bone_length_mm = 14
bone_width_mm = 7
bone_height_mm = 4.5
)";

/// A pad of an exponential pulp whose two constants are assumed.
inline std::string pad_text(double shear_modulus_kPa, double exponent) {
  return kPadHead + fmt::format(R"([pulp]
law = "veronda-westmann"
shear_modulus_kPa = {}
exponent = {}
poisson_ratio = 0.48
assumed = ["shear_modulus_kPa", "exponent"]
)",
                                shear_modulus_kPa, exponent);
}

/// The head of a data file for pad.toml beside it, with both constants free.
inline const std::string kPressesHead = R"(title = "Two presses"
pad = "pad.toml"
source = "Own"
[sources]
Own = "Own measurement"
[cells]
across = 2
around = 1
through = 2
[[constant]]
constant = "shear_modulus"
[[constant]]
constant = "exponent"
)";

/// Depths under three forces, areas under two, each with an sd of 5 %.
inline std::string press_text(const std::vector<double>& depths_mm,
                              const std::vector<double>& areas_mm2) {
  const auto sds = [](std::vector<double> values) {
    for (double& value : values) value *= 0.05;
    return values;
  };
  return fmt::format(R"([[press]]
name = "flat"
object = "plane"
imposed = "force"
[[press.data]]
force_N = [0.2, 0.6, 3]
indentation_mm = {}
sd_indentation_mm = {}
[[press.data]]
force_N = [0.6, 3]
area_mm2 = {}
sd_area_mm2 = {}
)",
                     depths_mm, sds(depths_mm), areas_mm2, sds(areas_mm2));
}

/// What a pad of these constants shows in that press, without noise.
inline std::string press_of(double shear_modulus_kPa, double exponent) {
  const PadSpec pad = parse_pad(pad_text(shear_modulus_kPa, exponent), "pad.toml");
  const PadFitProblem problem = pad_fit_problem(
      parse_pad_data(kPressesHead + press_text({1, 1, 1}, {1, 1}), "presses.toml"), pad);
  const std::vector<PressPoint> points =
      press_records(problem.pad, problem.records).at(0).points.at(0);
  std::vector<double> depths, areas;
  for (const PressPoint& point : points) {
    depths.push_back(1e3 * point.indentation);
    areas.push_back(1e6 * point.area);
  }
  return press_text(depths, {areas[1], areas[2]});
}

}  // namespace thenar::sample
