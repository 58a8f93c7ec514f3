#pragma once

/// Where the answers of `thenar simulate` go.

#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "tendons/digit_tendons.h"
#include "tendons/muscle/simulate.h"

namespace thenar {

/// A trajectory with what it was made from.
struct MotionAnswer {
  std::string subject, digit;
  const DigitTendons& tendons;
  const Trajectory& trajectory;
  std::map<std::string, std::string> inputs;  // path -> text
};

/// @throws InputError unless the ending is .csv, .h5 or .html and the file may be written.
void require_motion_path(const std::string& path);

/// By the ending of the path: a table, an HDF5 file that xarray opens, or a page.
void write_motion(const MotionAnswer& motion, const std::string& path);

void print_text(const MotionAnswer& motion);
[[nodiscard]] nlohmann::ordered_json json_of(const MotionAnswer& motion);

}  // namespace thenar
