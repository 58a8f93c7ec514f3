#include "data/io/anthropometry.h"

#include "data/io/toml_table.h"

namespace thenar {
namespace {

SimpleJoint read_joint(TomlTable& table) {
  SimpleJoint joint;
  joint.name = table.text("name");
  joint.axis = table.choice("axis", {"flexion", "abduction"}) == "flexion" ? SimpleAxis::kFlexion
                                                                           : SimpleAxis::kAbduction;
  const std::vector<double> range = table.numbers(Dimension::kAngle, "range", 2);
  if (range[0] > range[1])
    table.fail(fmt::format("wanted the range of joint '{}' as [lower, upper], got lower above "
                           "upper",
                           joint.name),
               "range_deg");
  joint.lower = range[0];
  joint.upper = range[1];
  table.done();
  return joint;
}

SegmentProportion read_segment(TomlTable& table) {
  SegmentProportion segment;
  segment.name = table.text("name");
  segment.length = table.number(Dimension::kNumber, "length_ratio", Range::kFraction);
  for (TomlTable& joint : table.tables("joints")) segment.joints.push_back(read_joint(joint));
  if (segment.joints.empty()) table.fail(fmt::format("segment '{}' needs 'joints'", segment.name));
  table.done();
  return segment;
}

DigitProportion read_digit(TomlTable& table) {
  DigitProportion digit;
  digit.name = table.text("name");
  digit.joint_distal = table.number(Dimension::kNumber, "joint_distal_ratio");
  digit.joint_radial = table.number(Dimension::kNumber, "joint_radial_ratio");
  digit.splay = table.number_or(Dimension::kAngle, "splay", 0);
  digit.roll = table.number_or(Dimension::kAngle, "roll", 0);
  for (TomlTable& segment : table.tables("segment"))
    digit.segments.push_back(read_segment(segment));
  if (digit.segments.empty())
    table.fail(fmt::format("digit '{}' needs at least one [[digit.segment]]", digit.name));
  table.done();
  return digit;
}

}  // namespace

HandProportions parse_proportions(const std::string& text, const std::string& path) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  HandProportions hand;
  hand.name = top.text("name");
  hand.description = top.text_or("description", "");
  for (TomlTable& digit : top.tables("digit")) hand.digits.push_back(read_digit(digit));
  top.done();
  return hand;
}

HandProportions read_proportions(const std::string& path) {
  return parse_proportions(read_text_file(path), path);
}

}  // namespace thenar
