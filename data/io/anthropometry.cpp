#include "data/io/anthropometry.h"

#include <cmath>

#include <Eigen/Geometry>

#include "base/error.h"
#include "data/io/toml_table.h"

namespace thenar {
namespace {

SimpleJoint read_joint(TomlTable& table) {
  SimpleJoint joint;
  joint.name = table.text("name");
  joint.axis = table.choice("axis", kSimpleAxisNames);
  // Range of motion, with its bounds in order.
  const std::vector<double> range = table.numbers(Dimension::kAngle, "range", 2);
  if (range[0] > range[1])
    table.fail(fmt::format("wanted the range of joint '{}' as [lower, upper], got lower above "
                           "upper",
                           joint.name),
               "range_deg");
  joint.lower = range[0];
  joint.upper = range[1];
  return joint;
}

SegmentProportion read_segment(TomlTable& table) {
  SegmentProportion segment;
  segment.name = table.text("name");
  segment.length = table.number(Dimension::kNumber, "length_ratio", Range::kFraction);
  read_each(table, "joints", segment.joints, read_joint);
  if (segment.joints.empty()) table.fail(fmt::format("segment '{}' needs 'joints'", segment.name));
  return segment;
}

DigitProportion read_digit(TomlTable& table) {
  DigitProportion digit;
  digit.name = table.text("name");
  digit.joint_distal = table.number(Dimension::kNumber, "joint_distal_ratio");
  digit.joint_radial = table.number(Dimension::kNumber, "joint_radial_ratio");
  digit.splay = table.number_or(Dimension::kAngle, "splay", 0);
  digit.roll = table.number_or(Dimension::kAngle, "roll", 0);
  // Bones from the knuckle outwards; a digit has at least one.
  read_each(table, "segment", digit.segments, read_segment);
  if (digit.segments.empty())
    table.fail(fmt::format("digit '{}' needs at least one [[digit.segment]]", digit.name));
  return digit;
}

}  // namespace

HandProportions parse_proportions(const std::string& text, const std::string& path) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  HandProportions hand;
  hand.name = top.text("name");
  hand.description = top.text_or("description", "");
  read_each(top, "digit", hand.digits, read_digit);
  top.done();
  return hand;
}

HandProportions read_proportions(const std::string& path) {
  return parse_proportions(read_text_file(path), path);
}

namespace {

using Eigen::Vector3d;

const char* const kPalm = "Palm";

/// Directions of a digit that lies flat on a right hand, splayed and rolled.
Digit make_digit(const DigitProportion& from) {
  const Vector3d z = Vector3d::UnitZ();
  const Vector3d across(std::cos(from.splay), std::sin(from.splay), 0);
  Digit digit;
  digit.name = from.name;
  digit.proximal = Vector3d(-std::sin(from.splay), std::cos(from.splay), 0);
  digit.radial = std::cos(from.roll) * across - std::sin(from.roll) * z;
  digit.dorsal = digit.radial.cross(digit.proximal);
  return digit;
}

/// Flexion is about the radial direction, abduction (towards radial) about the dorsal one.
JointAxis make_joint(const SimpleJoint& from, const Digit& digit, const Vector3d& point) {
  JointAxis joint;
  joint.name = from.name;
  joint.direction = from.axis == SimpleAxis::kFlexion ? digit.radial : digit.dorsal;
  joint.point = point;
  joint.lower = from.lower;
  joint.upper = from.upper;
  return joint;
}

Segment make_segment(const std::string& name, const Vector3d& proximal, const Vector3d& distal) {
  Segment segment;
  segment.name = name;
  segment.proximal = proximal;
  segment.distal = distal;
  segment.com = (proximal + distal) / 2;
  return segment;
}

/// Appends the joints at the start of a bone, then the bone. All joints but the last move a link
/// without length that is named after them.
void add_segment(const SegmentProportion& from, const Digit& digit, const Vector3d& start,
                 const Vector3d& end, std::string parent, Subject& subject) {
  for (const SimpleJoint& simple : from.joints) {
    const bool last = simple.name == from.joints.back().name;
    JointAxis joint = make_joint(simple, digit, start);
    joint.parent = parent;
    joint.child = last ? from.name : simple.name + "_link";
    parent = joint.child;
    subject.segments.push_back(make_segment(joint.child, start, last ? end : start));
    subject.joints.push_back(joint);
  }
}

void add_digit(const DigitProportion& from, const HandSize& size, Subject& subject) {
  Digit digit = make_digit(from);
  // From the knuckle outwards, bone after bone.
  Vector3d at(from.joint_radial * size.breadth, -from.joint_distal * size.length, 0);
  std::string parent = kPalm;
  for (const SegmentProportion& segment : from.segments) {
    const Vector3d end = at - segment.length * size.length * digit.proximal;
    add_segment(segment, digit, at, end, parent, subject);
    parent = segment.name;
    at = end;
  }
  // The tip is the end of the last bone.
  digit.tip_segment = parent;
  digit.tip = at;
  subject.digits.push_back(digit);
}

}  // namespace

Subject scale_hand(const HandProportions& proportions, const HandSize& size) {
  require(size.length > 0 && std::isfinite(size.length), "hand length must be > 0 m, got {}",
          size.length);
  require(size.breadth > 0 && std::isfinite(size.breadth), "hand breadth must be > 0 m, got {}",
          size.breadth);
  // Header of the subject.
  Subject subject;
  subject.name = proportions.name;
  subject.description = proportions.description;
  subject.side = "right";
  subject.base = kPalm;
  subject.lengths = {{"hand_length", size.length}, {"hand_breadth", size.breadth}};
  // The palm reaches to the most distal knuckle.
  double knuckles = 0;
  for (const DigitProportion& digit : proportions.digits)
    if (digit.joint_distal > knuckles) knuckles = digit.joint_distal;
  subject.segments.push_back(
      make_segment(kPalm, Vector3d::Zero(), Vector3d(0, -knuckles * size.length, 0)));
  // Digits hang on the palm.
  for (const DigitProportion& digit : proportions.digits) add_digit(digit, size, subject);
  return subject;
}

}  // namespace thenar
