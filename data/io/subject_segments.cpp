#include <algorithm>

#include <Eigen/Eigenvalues>

#include "data/io/subject_parts.h"

namespace thenar::internal {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d symmetric(const std::vector<double>& I) {
  Matrix3d result;
  result << I[0], I[3], I[4],  //
      I[3], I[1], I[5],        //
      I[4], I[5], I[2];
  return result;
}

/// `inertia = [xx, yy, zz]` or `[xx, yy, zz, xy, xz, yz]`.
Matrix3d read_tensor(TomlTable& table) {
  std::vector<double> I = table.numbers(Dimension::kInertia, "inertia");
  if (I.size() == 3) I.resize(6, 0.0);
  if (I.size() != 6)
    table.fail(fmt::format("wanted 3 (xx yy zz) or 6 (and xy xz yz) moments of inertia, got {}",
                           I.size()));
  return symmetric(I);
}

/// A slender body: one moment about the line from proximal to distal, one across it.
Matrix3d read_slender(TomlTable& table, const Segment& segment) {
  const double axial = table.number(Dimension::kInertia, "inertia_axial", Range::kNotNegative);
  const double across =
      table.number(Dimension::kInertia, "inertia_transverse", Range::kNotNegative);
  const Vector3d bone = segment.distal - segment.proximal;
  if (bone.norm() < 1e-9) table.fail("inertia_axial needs 'proximal' and 'distal' that differ");
  const Vector3d u = bone.normalized();
  return across * Matrix3d::Identity() + (axial - across) * u * u.transpose();
}

/// Real masses have principal moments of which no one exceeds the sum of the others.
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
  segment.name = new_name(table, names_of(draft.subject.segments));
  read_aliases(table, segment.name, draft);
  segment.proximal = table.vector_or(Dimension::kLength, "proximal", Vector3d::Zero());
  segment.distal = table.vector_or(Dimension::kLength, "distal", segment.proximal);
  segment.radius = table.number_or(Dimension::kLength, "radius", 0, Range::kNotNegative);
  segment.mass = table.number_or(Dimension::kMass, "mass", 0, Range::kNotNegative);
  segment.com = table.vector_or(Dimension::kLength, "com", (segment.proximal + segment.distal) / 2);
  segment.inertia = read_inertia(table, segment);
  if (segment.mass == 0 && !segment.inertia.isZero(0))
    table.fail(fmt::format("segment '{}' has 'inertia' but no 'mass'", segment.name));
  table.done();
  return segment;
}

}  // namespace

void read_segments(TomlTable& top, SubjectDraft& draft) {
  for (TomlTable& table : top.tables("segment"))
    draft.subject.segments.push_back(read_segment(table, draft));
  const std::vector<std::string> names = names_of(draft.subject.segments);
  for (const auto& [alias, name] : draft.aliases)
    if (std::find(names.begin(), names.end(), alias) != names.end())
      top.fail(fmt::format("'{}' is both a segment and an alias of '{}'", alias, name));
  if (names.empty()) return;
  if (draft.subject.base.empty()) top.fail("the top level needs 'base' (a segment)");
  check_reference(top, "base", "segment", draft.subject.base, names);
}

}  // namespace thenar::internal
