#include <algorithm>

#include "data/io/subject_parts.h"

namespace thenar::internal {
namespace {

Coupling read_coupling(TomlTable& table, const SubjectDraft& draft) {
  Coupling coupling;
  coupling.leader = reference(table, "to", "joint", names_of(draft.subject.joints));
  coupling.ratio = table.number_or(Dimension::kNumber, "ratio", 1);
  coupling.offset = table.number_or(Dimension::kAngle, "offset", 0);
  table.done();
  return coupling;
}

/// How far a joint goes, and what it resists with.
void read_resistance(TomlTable& table, JointAxis& joint) {
  read_range(table, joint);
  joint.rest = table.number_or(Dimension::kAngle, "rest", 0);
  joint.stiffness =
      table.number_or(Dimension::kAngularStiffness, "stiffness", 0, Range::kNotNegative);
  joint.damping = table.number_or(Dimension::kAngularDamping, "damping", 0, Range::kNotNegative);
}

void read_axis(TomlTable& table, JointAxis& joint) {
  joint.direction = table.sign("direction_sign") * table.direction("direction");
  joint.point = table.vector(Dimension::kLength, "point");
  joint.direction_sd = table.number_or(Dimension::kAngle, "direction_sd", 0, Range::kNotNegative);
  joint.point_sd = table.number_or(Dimension::kLength, "point_sd", 0, Range::kNotNegative);
}

JointAxis read_joint(TomlTable& table, const SubjectDraft& draft) {
  JointAxis joint;
  joint.name = new_name(table, names_of(draft.subject.joints));
  joint.parent = segment_reference(table, "parent", draft);
  joint.child = segment_reference(table, "child", draft);
  read_axis(table, joint);
  read_resistance(table, joint);
  if (std::optional<TomlTable> couple = table.table("couple"))
    joint.coupling = read_coupling(*couple, draft);
  table.done();
  return joint;
}

}  // namespace

void read_range(TomlTable& table, JointAxis& joint) {
  if (!table.has(Dimension::kAngle, "range")) return;
  const std::vector<double> range = table.numbers(Dimension::kAngle, "range", 2);
  if (range[0] > range[1])
    table.fail(fmt::format(
        "wanted the range of joint '{}' as [lower, upper], got lower above upper", joint.name));
  joint.lower = range[0];
  joint.upper = range[1];
}

void add_joint(TomlTable& table, const JointAxis& joint, SubjectDraft& draft) {
  const Subject& subject = draft.subject;
  bool carried = joint.parent == subject.base;
  for (const JointAxis& before : subject.joints) {
    carried = carried || before.child == joint.parent;
    if (before.child == joint.child)
      table.fail(fmt::format("joint '{}' moves segment '{}', which joint '{}' moves already",
                             joint.name, joint.child, before.name),
                 "child");
  }
  if (joint.child == subject.base)
    table.fail(fmt::format("joint '{}' moves the base '{}'", joint.name, joint.child), "child");
  if (!carried)
    table.fail(fmt::format("joint '{}' hangs on segment '{}', which no earlier joint moves: "
                           "joints stand in order from the base '{}'",
                           joint.name, joint.parent, subject.base),
               "parent");
  draft.subject.joints.push_back(joint);
}

void read_joints(TomlTable& top, SubjectDraft& draft) {
  for (TomlTable& table : top.tables("joint")) add_joint(table, read_joint(table, draft), draft);
}

}  // namespace thenar::internal
