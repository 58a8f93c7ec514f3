#include "data/io/pad/pad_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "data/io/toml_table.h"

namespace thenar {
namespace {

constexpr int kMaxCells = 64;  // Most cells each way: a fit presses its mesh some hundred times
constexpr std::size_t kMaxNumbers = 1000;  // Most numbers of one list
constexpr double kMaxAngle = 1.2;          // Largest angle [rad]

int count_in(TomlTable& table, const std::string& key, int fallback, int most) {
  const double number = table.number_or(Dimension::kNumber, key, fallback);
  if (number != std::floor(number) || number < 1 || number > most)
    table.fail(
        fmt::format("wanted '{}' as a whole number from 1 to {}, got {:g}", key, most, number),
        key);
  return static_cast<int>(number);
}

PadDataConstant read_constant(TomlTable& table) {
  PadDataConstant out;
  out.line = table.line();
  out.constant = table.choice("constant", {"shear_modulus", "exponent", "poisson_ratio", "share",
                                           "thickness", "bone_height"});
  if (out.constant != "bone_height" && table.has(Dimension::kNumber, "layer"))
    out.layer = count_in(table, "layer", 1, 20);
  if (out.constant == "thickness" && out.layer == 0)
    table.fail("wanted the 'layer' of skin that has the thickness, got none", "constant");
  const Dimension dimension = out.constant == "shear_modulus" ? Dimension::kStress
                              : out.constant == "thickness" || out.constant == "bone_height"
                                  ? Dimension::kLength
                                  : Dimension::kNumber;
  out.start = number_if(table, dimension, "start");
  if (out.constant == "share") out.term = count_in(table, "term", 1, 20);
  out.lower_factor = table.number_or(Dimension::kNumber, "lower_factor", 0.01, Range::kPositive);
  out.upper_factor = table.number_or(Dimension::kNumber, "upper_factor", 100, Range::kPositive);
  if (out.lower_factor > 1)
    table.fail(fmt::format("wanted 'lower_factor' up to 1, got {:g}", out.lower_factor),
               "lower_factor");
  if (out.upper_factor < 1)
    table.fail(fmt::format("wanted 'upper_factor' of 1 and more, got {:g}", out.upper_factor),
               "upper_factor");
  out.prior_factor = number_if(table, Dimension::kNumber, "prior_factor", Range::kPositive);
  if (out.prior_factor && !(*out.prior_factor > 1))
    table.fail(fmt::format("wanted 'prior_factor' above 1, got {:g}", *out.prior_factor),
               "prior_factor");
  return out;
}

/// A list, each entry above 0.
std::vector<double> list_of(TomlTable& table, Dimension dimension, const std::string& key,
                            std::size_t count) {
  std::vector<double> out =
      table.numbers(dimension, key, static_cast<int>(count), Range::kPositive);
  if (out.empty() || out.size() > kMaxNumbers)
    table.fail(
        fmt::format("wanted from 1 to {} numbers in '{}', got {}", kMaxNumbers, key, out.size()),
        key);
  return out;
}

// Keys of measured quantities
constexpr std::array kMeasuredKeys{std::pair{"indentation", Dimension::kLength},
                                   std::pair{"force", Dimension::kForce},
                                   std::pair{"area", Dimension::kArea}};

/// Measured numbers in units, with their sds.
void read_values(TomlTable& table, PadDataRows& rows, const std::string& imposed) {
  for (const auto& [quantity, dimension] : kMeasuredKeys) {
    const std::string sd = std::string("sd_") + quantity;
    if (!table.has(dimension, sd)) continue;
    if (!rows.quantity.empty())
      table.fail(fmt::format("one quantity is measured in a [[press.data]], got sds of {} and {}",
                             rows.quantity, quantity));
    if (quantity == imposed)
      table.fail(fmt::format("{} is imposed in this press, and has no sd", imposed), sd);
    rows.quantity = quantity;
    rows.values = list_of(table, dimension, quantity, rows.loads.size());
    rows.sds = list_of(table, dimension, sd, rows.loads.size());
  }
  if (rows.quantity.empty())
    table.fail(
        "a [[press.data]] needs what was measured with its sd: 'indentation_mm' and "
        "'sd_indentation_mm', 'force_N' and 'sd_force_N', 'area_mm2' and 'sd_area_mm2', or "
        "'part_of', 'part' and 'sd_part'");
}

PadDataRows read_rows(TomlTable& table, bool by_force) {
  PadDataRows rows;
  rows.line = table.line();
  const std::string imposed = by_force ? "force" : "indentation";
  const Dimension dimension = by_force ? Dimension::kForce : Dimension::kLength;
  rows.loads = list_of(table, dimension, imposed, 0);
  if (table.has("part_of")) {
    rows.quantity = table.choice("part_of", {by_force ? "indentation" : "force", "area"});
    rows.part_at = table.number(dimension, "at_" + imposed, Range::kPositive);
    rows.values = list_of(table, Dimension::kNumber, "part", rows.loads.size());
    rows.sds = list_of(table, Dimension::kNumber, "sd_part", rows.loads.size());
    if (std::count(rows.loads.begin(), rows.loads.end(), *rows.part_at) > 0)
      table.fail("a load of which numbers are parts cannot be among the loads", "part");
  } else {
    read_values(table, rows, imposed);
  }
  rows.source = table.source();
  if (rows.source.empty()) table.fail("measured numbers need a 'source'");
  return rows;
}

PadDataPress read_press(TomlTable& table) {
  PadDataPress out;
  out.line = table.line();
  out.name = table.text("name");
  out.object = table.choice("object", {"plane", "sphere", "cylinder"});
  if (out.object != "plane")
    out.radius = table.number(Dimension::kLength, "radius", Range::kPositive);
  out.angle = table.number_or(Dimension::kAngle, "angle", 0);
  if (std::abs(out.angle) > kMaxAngle)
    table.fail(fmt::format("wanted 'angle' within {:g} rad, got {:g}", kMaxAngle, out.angle),
               "angle");
  out.friction = table.number_or(Dimension::kNumber, "friction", 0, Range::kNotNegative);
  out.by_force = table.choice("imposed", {"force", "indentation"}) == "force";
  const std::string pace = table.has("pace") ? table.choice("pace", {"at once", "ramp", "relaxed"})
                                             : std::string("at once");
  if (pace == "ramp")
    out.ramp = table.number(Dimension::kTime, "ramp", Range::kPositive);
  else if (pace == "relaxed")
    out.ramp = std::numeric_limits<double>::infinity();
  read_each(table, "data", out.rows, read_rows, out.by_force);
  if (out.rows.empty()) table.fail(fmt::format("press '{}' has no [[press.data]]", out.name));
  return out;
}

}  // namespace

PadData read_pad_data(const std::string& path) {
  return parse_pad_data(read_text_file(path), path);
}

PadData parse_pad_data(const std::string& text, const std::string& path) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  PadData out;
  out.path = path;
  out.own_sources = file.own_sources();
  out.title = top.text("title");
  out.pad = top.text("pad");
  if (std::optional<TomlTable> cells = top.table("cells")) {
    out.cells.across = count_in(*cells, "across", out.cells.across, kMaxCells);
    out.cells.around = count_in(*cells, "around", out.cells.around, kMaxCells);
    out.cells.through = count_in(*cells, "through", out.cells.through, kMaxCells);
    cells->done();
  }
  read_each(top, "constant", out.constants, read_constant);
  if (out.constants.empty()) top.fail("a fit needs a [[constant]] that is free");
  read_each(top, "press", out.presses, read_press);
  if (out.presses.empty()) top.fail("a fit needs a [[press]] with data");
  top.done();
  return out;
}

}  // namespace thenar
