#include <Eigen/Geometry>

#include "data/io/subject_parts.h"

namespace thenar::internal {
namespace {

using Eigen::Vector3d;

/// Directions that are published rounded may be off square by this much.
constexpr double kSquare = 0.05;  // [rad]

HoodBranch read_branch(TomlTable& table, const SubjectDraft& draft) {
  HoodBranch branch;
  branch.muscle = reference(table, "muscle", "muscle", names_of(draft.subject.muscles));
  const std::string side = table.choice("side", {"radial", "ulnar", "both"});
  branch.side = side == "radial"  ? HoodSide::kRadial
                : side == "ulnar" ? HoodSide::kUlnar
                                  : HoodSide::kBoth;
  branch.into_hood = table.number_or(Dimension::kNumber, "into_hood", 1, Range::kFraction);
  branch.to_central = table.number_or(Dimension::kNumber, "to_central", 0.5, Range::kFraction);
  table.done();
  return branch;
}

/// Proximal is kept, dorsal is made square to it, radial completes them on the given side.
void read_directions(TomlTable& table, const std::string& side, Digit& digit) {
  digit.proximal = table.direction("proximal");
  const Vector3d dorsal = table.direction("dorsal");
  if (std::abs(digit.proximal.dot(dorsal)) > kSquare)
    table.fail(fmt::format("'dorsal' of digit '{}' is not perpendicular to 'proximal': their "
                           "cosine is {:.3g}",
                           digit.name, digit.proximal.dot(dorsal)),
               "dorsal");
  digit.dorsal = (dorsal - digit.proximal * digit.proximal.dot(dorsal)).normalized();
  digit.radial = digit.proximal.cross(digit.dorsal) * (side == "right" ? 1 : -1);
  if (!table.has("radial")) return;
  const Vector3d radial = table.direction("radial");
  if (radial.cross(digit.radial).norm() > kSquare || radial.dot(digit.radial) < 0)
    table.fail(fmt::format("'radial' of digit '{}' does not complete 'proximal' and 'dorsal' of a "
                           "{} hand",
                           digit.name, side),
               "radial");
}

Vector3d read_tip(TomlTable& table, const std::string& digit, const SubjectDraft& draft) {
  const auto end = draft.chain_ends.find(digit);
  if (end == draft.chain_ends.end()) return table.vector(Dimension::kLength, "tip");
  return table.vector_or(Dimension::kLength, "tip", end->second);
}

Digit read_digit(TomlTable& table, const SubjectDraft& draft) {
  Digit digit;
  digit.name = new_name(table, names_of(draft.subject.digits));
  digit.tip_segment = segment_reference(table, "tip_segment", draft);
  digit.tip = read_tip(table, digit.name, draft);
  read_directions(table, draft.subject.side, digit);
  if (std::optional<TomlTable> hood = table.table("hood")) digit.hood = read_hood(*hood, draft);
  table.done();
  return digit;
}

}  // namespace

HoodRule read_hood(TomlTable& table, const SubjectDraft& draft) {
  const std::vector<std::string> strands = names_of(draft.subject.strands);
  HoodRule hood;
  hood.central_slip = reference(table, "central_slip", "strand", strands);
  hood.radial_band = reference(table, "radial_band", "strand", strands);
  hood.ulnar_band = reference(table, "ulnar_band", "strand", strands);
  hood.terminal_slip = reference(table, "terminal_slip", "strand", strands);
  for (TomlTable& branch : table.tables("branches"))
    hood.branches.push_back(read_branch(branch, draft));
  table.done();
  return hood;
}

void read_digits(TomlTable& top, SubjectDraft& draft) {
  for (TomlTable& table : top.tables("digit"))
    draft.subject.digits.push_back(read_digit(table, draft));
  for (const auto& [name, end] : draft.chain_ends)
    check_reference(top, "dh_chain", "digit", name, names_of(draft.subject.digits));
}

}  // namespace thenar::internal
