#include "data/io/axis_variability.h"

#include "base/error.h"
#include "data/io/toml_node.h"
#include "data/io/toml_table.h"

namespace thenar {
namespace {

AxisVariability read_axis_variability(TomlTable& table) {
  AxisVariability axis;
  // Which axis, and what its places are counted from.
  axis.joint = table.text("joint");
  axis.beside = table.text_or("beside", axis.joint);
  axis.bone = table.text("bone");
  // Places along the bone are parts of its length.
  const double length = table.number(Dimension::kLength, "bone_length", Range::kPositive);
  axis.along = length * table.number_or(Dimension::kNumber, "along_ratio", 0);
  axis.along_sd = length * table.number(Dimension::kNumber, "along_sd_ratio", Range::kNotNegative);
  axis.across_sd = table.number(Dimension::kLength, "across_sd", Range::kNotNegative);
  axis.tilt_sd = table.number(Dimension::kAngle, "tilt_sd", Range::kNotNegative);
  axis.source = table.source();
  if (table.has("assumed")) axis.assumed = table.texts("assumed");
  // Only numbers of this table can be assumed.
  for (const std::string& key : axis.assumed)
    if (!table.has(key)) table.fail(fmt::format("there is no number '{}' to assume", key));
  return axis;
}

NormalQuestion read_question(TomlTable& table) {
  NormalQuestion question;
  question.first = table.text("first");
  question.second = table.text("second");
  question.toward = table.choice("toward", kDigitDirectionNames);
  table.done();
  return question;
}

}  // namespace

DigitVariability read_variability(const std::string& path) {
  return parse_variability(read_text_file(path), path);
}

DigitVariability parse_variability(const std::string& text, const std::string& path) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  DigitVariability out;
  out.name = top.text("name");
  out.description = top.text_or("description", "");
  out.mean_subject = top.text("mean_subject");
  read_each(top, "axis", out.axes, read_axis_variability);
  if (out.axes.empty()) top.fail("wanted at least one [[axis]], got none");
  TomlTable second =
      needed_table(top, "second", "wanted [second], the second criterion of types, got none");
  out.second = read_question(second);
  top.done();
  return out;
}

}  // namespace thenar
