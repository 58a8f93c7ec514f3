// [[dh_chain]]: a digit's joints as published in a Denavit-Hartenberg table.

#include <cmath>
#include <tuple>
#include <utility>

#include "data/io/dh.h"
#include "data/io/subject_parts.h"

namespace thenar::internal {
namespace {

Pose<double> read_base(TomlTable& table) {
  const std::vector<double> q = table.numbers(Dimension::kNumber, "base_quaternion_wxyz", 4);
  const Eigen::Quaterniond quaternion(q[0], q[1], q[2], q[3]);
  if (std::abs(quaternion.norm() - 1) > 1e-3)
    table.fail(
        fmt::format("wanted 'base_quaternion_wxyz' of length 1, got {:.6g}", quaternion.norm()),
        "base_quaternion_wxyz");
  return {quaternion.normalized().toRotationMatrix(),
          table.vector(Dimension::kLength, "base_position")};
}

DhRow read_row(TomlTable& table) {
  return {table.number_or(Dimension::kAngle, "theta", 0),
          table.number_or(Dimension::kLength, "d", 0), table.number_or(Dimension::kLength, "a", 0),
          table.number_or(Dimension::kAngle, "alpha", 0)};
}

/// The joint about z of frame X.
JointAxis read_joint(TomlTable& table, const std::string& parent, const Pose<double>& X,
                     const SubjectDraft& draft) {
  JointAxis joint;
  joint.name = table.text("joint");
  for (const JointAxis& other : draft.subject.joints)
    if (other.name == joint.name)
      table.fail(fmt::format("joint '{}' is given twice", joint.name), "joint");
  joint.parent = parent;
  joint.child = segment_reference(table, "child", draft);
  read_range(table, joint);
  const double sign = table.sign("sign");
  joint.point = X.p;
  joint.direction = sign * X.R.col(2);
  if (sign < 0) std::tie(joint.lower, joint.upper) = std::pair(-joint.upper, -joint.lower);
  return joint;
}

void read_chain(TomlTable& table, SubjectDraft& draft) {
  const std::string digit = table.text("digit");
  std::string parent = segment_reference(table, "parent", draft);
  Pose<double> X = read_base(table);
  for (TomlTable& row : table.tables("rows")) {
    const JointAxis joint = read_joint(row, parent, X, draft);
    X = X * dh_motion(read_row(row));
    row.done();
    add_joint(row, joint, draft);
    parent = joint.child;
  }
  draft.chain_ends[digit] = X.p;
  table.done();
}

}  // namespace

void read_dh_chains(TomlTable& top, SubjectDraft& draft) {
  for (TomlTable& table : top.tables("dh_chain")) read_chain(table, draft);
}

}  // namespace thenar::internal
