#include <tuple>
#include <utility>

#include <Eigen/Eigenvalues>

#include "base/lists.h"
#include "data/io/dh.h"
#include "data/io/subject_parts.h"

namespace thenar::internal {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Reads `inertia = [xx, yy, zz]` or `[xx, yy, zz, xy, xz, yz]`.
Matrix3d read_tensor(TomlTable& table) {
  std::vector<double> I = table.numbers(Dimension::kInertia, "inertia");
  if (I.size() == 3) I.resize(6, 0.0);
  if (I.size() != 6)
    table.fail(fmt::format("wanted 3 (xx yy zz) or 6 (and xy xz yz) moments of inertia, got {}",
                           I.size()));
  Matrix3d tensor;
  tensor << I[0], I[3], I[4],  //
      I[3], I[1], I[5],        //
      I[4], I[5], I[2];
  return tensor;
}

/// Reads the inertia of a slender body: one moment about the line from proximal to distal, one
/// across.
Matrix3d read_slender(TomlTable& table, const Segment& segment) {
  const double axial = table.number(Dimension::kInertia, "inertia_axial", Range::kNotNegative);
  const double across =
      table.number(Dimension::kInertia, "inertia_transverse", Range::kNotNegative);
  const Vector3d bone = segment.distal - segment.proximal;
  if (bone.norm() < 1e-9) table.fail("inertia_axial needs 'proximal' and 'distal' that differ");
  const Vector3d u = bone.normalized();
  return across * Matrix3d::Identity() + (axial - across) * u * u.transpose();
}

/// Refuses principal moments of which one exceeds the sum of the others: no body has these.
void check_inertia(const TomlTable& table, const Matrix3d& inertia) {
  const Vector3d I = Eigen::SelfAdjointEigenSolver<Matrix3d>(inertia).eigenvalues();
  if (I(0) < 0 || I(2) > (I(0) + I(1)) * (1 + 1e-9))
    table.fail(
        fmt::format("no body has the principal moments of inertia {:.6g}, {:.6g}, {:.6g} "
                    "kg m^2: the largest exceeds the sum of the others",
                    I(0), I(1), I(2)));
}

Matrix3d read_inertia(TomlTable& table, const Segment& segment) {
  const bool slender = table.has(Dimension::kInertia, "inertia_axial");
  const bool tensor = table.has(Dimension::kInertia, "inertia");
  if (!slender && !tensor) return Matrix3d::Zero();
  Matrix3d inertia = slender ? read_slender(table, segment) : read_tensor(table);
  check_inertia(table, inertia);
  return inertia;
}

void read_aliases(TomlTable& table, const std::string& name, SubjectDraft& draft) {
  if (!table.has("aliases")) return;
  for (const std::string& alias : table.texts("aliases"))
    if (!draft.aliases.emplace(alias, name).second)
      table.fail(fmt::format("alias '{}' is given twice", alias), "aliases");
}

Segment read_segment(TomlTable& table, SubjectDraft& draft) {
  Segment segment;
  // Names, then ends and skin.
  segment.name = new_name(table, names_of(draft.subject.segments));
  read_aliases(table, segment.name, draft);
  segment.proximal = table.vector_or(Dimension::kLength, "proximal", Vector3d::Zero());
  segment.distal = table.vector_or(Dimension::kLength, "distal", segment.proximal);
  segment.radius = table.number_or(Dimension::kLength, "radius", 0, Range::kNotNegative);
  // Mass, at the middle of the bone unless stated.
  segment.mass = table.number_or(Dimension::kMass, "mass", 0, Range::kNotNegative);
  segment.com = table.vector_or(Dimension::kLength, "com", (segment.proximal + segment.distal) / 2);
  segment.inertia = read_inertia(table, segment);
  if (segment.mass == 0 && !segment.inertia.isZero(0))
    table.fail(fmt::format("segment '{}' has 'inertia' but no 'mass'", segment.name));
  return segment;
}

}  // namespace

void read_segments(TomlTable& top, SubjectDraft& draft) {
  read_each(top, "segment", draft.subject.segments, read_segment, draft);
  const std::vector<std::string> names = names_of(draft.subject.segments);
  // An alias must not hide a segment.
  for (const auto& [alias, name] : draft.aliases)
    if (contains(names, alias))
      top.fail(fmt::format("'{}' is both a segment and an alias of '{}'", alias, name));
  if (names.empty()) return;
  // The base is one of the segments.
  if (draft.subject.base.empty()) top.fail("the top level needs 'base' (a segment)");
  check_reference(top, "base", "segment", draft.subject.base, names);
}

namespace {

Coupling read_coupling(TomlTable& table, const SubjectDraft& draft) {
  Coupling coupling;
  coupling.leader = reference(table, "to", "joint", names_of(draft.subject.joints));
  coupling.ratio = table.number_or(Dimension::kNumber, "ratio", 1);
  coupling.offset = table.number_or(Dimension::kAngle, "offset", 0);
  table.done();
  return coupling;
}

/// Reads the range of a joint and its passive resistance.
void read_resistance(TomlTable& table, JointAxis& joint) {
  read_range(table, joint);
  joint.rest = table.number_or(Dimension::kAngle, "rest", 0);
  joint.stiffness =
      table.number_or(Dimension::kAngularStiffness, "stiffness", 0, Range::kNotNegative);
  joint.damping = table.number_or(Dimension::kAngularDamping, "damping", 0, Range::kNotNegative);
}

void read_axis(TomlTable& table, JointAxis& joint) {
  joint.direction = read_sign(table, "direction_sign") * read_direction(table, "direction");
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
  // The parent must be the base or moved by an earlier joint, the child moved by no other.
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
    table.fail(fmt::format("joint '{}' hangs on segment '{}', which no earlier joint moves: joints "
                           "must be in order from the base '{}'",
                           joint.name, joint.parent, subject.base),
               "parent");
  draft.subject.joints.push_back(joint);
}

void read_joints(TomlTable& top, SubjectDraft& draft) {
  for (TomlTable& table : top.tables("joint")) add_joint(table, read_joint(table, draft), draft);
}

namespace {

Pose<double> read_base(TomlTable& table) {
  return {read_quaternion(table, "base_quaternion_wxyz"),
          table.vector(Dimension::kLength, "base_position")};
}

/// Joint about z of frame X.
JointAxis read_joint(TomlTable& table, const std::string& parent, const Pose<double>& X,
                     const SubjectDraft& draft) {
  JointAxis joint;
  // Names are unique.
  joint.name = table.text("joint");
  if (find_named(draft.subject.joints, joint.name) != nullptr)
    table.fail(fmt::format("joint '{}' is given twice", joint.name), "joint");
  joint.parent = parent;
  joint.child = segment_reference(table, "child", draft);
  read_range(table, joint);
  // A negative sign reverses the axis, and with it the range.
  const double sign = read_sign(table, "sign");
  joint.point = X.p;
  joint.direction = sign * X.R.col(2);
  if (sign < 0) std::tie(joint.lower, joint.upper) = std::pair(-joint.upper, -joint.lower);
  return joint;
}

/// Reads one [[dh_chain]]: a digit's joints as published in a Denavit-Hartenberg table.
void read_chain(TomlTable& table, SubjectDraft& draft) {
  const std::string digit = table.text("digit");
  std::string parent = segment_reference(table, "parent", draft);
  Pose<double> X = read_base(table);
  // Each row adds a joint about z of the frame before it.
  for (TomlTable& row : table.tables("rows")) {
    const JointAxis joint = read_joint(row, parent, X, draft);
    X = X * dh_motion(read_dh_row(row));
    row.done();
    add_joint(row, joint, draft);
    parent = joint.child;
  }
  // The chain ends at the tip of the digit.
  draft.chain_ends[digit] = X.p;
  table.done();
}

}  // namespace

void read_dh_chains(TomlTable& top, SubjectDraft& draft) {
  for (TomlTable& table : top.tables("dh_chain")) read_chain(table, draft);
}

}  // namespace thenar::internal
