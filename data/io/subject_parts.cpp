#include "data/io/subject_parts.h"

#include <Eigen/Geometry>

#include "base/nearest_name.h"

namespace thenar::internal {

std::string new_name(TomlTable& table, const std::vector<std::string>& taken) {
  std::string name = table.text("name");
  if (contains(taken, name))
    table.fail(fmt::format("{} '{}' is given twice", table.title(), name), "name");
  return name;
}

void check_reference(const TomlTable& table, const std::string& key, const std::string& what,
                     const std::string& name, const std::vector<std::string>& names) {
  if (!contains(names, name))
    table.fail(
        fmt::format("'{}' names the unknown {} '{}'{}", key, what, name, did_you_mean(name, names)),
        key);
}

std::string reference(TomlTable& table, const std::string& key, const std::string& what,
                      const std::vector<std::string>& names) {
  std::string name = table.text(key);
  check_reference(table, key, what, name, names);
  return name;
}

std::string segment_reference(TomlTable& table, const std::string& key, const SubjectDraft& draft) {
  std::string name = table.text(key);
  const auto alias = draft.aliases.find(name);
  if (alias != draft.aliases.end()) return alias->second;
  check_reference(table, key, "segment", name, names_of(draft.subject.segments));
  return name;
}

namespace {

using Eigen::Vector3d;

/// Largest cosine of published, rounded directions that should be perpendicular, 3 deg [1].
constexpr double kPerpendicularCosine = 0.05;

HoodBranch read_branch(TomlTable& table, const SubjectDraft& draft) {
  HoodBranch branch;
  branch.muscle = reference(table, "muscle", "muscle", names_of(draft.subject.muscles));
  branch.side = table.choice("side", kHoodSideNames);
  branch.into_hood = table.number_or(Dimension::kNumber, "into_hood", 1, Range::kFraction);
  branch.to_central = table.number_or(Dimension::kNumber, "to_central", 0.5, Range::kFraction);
  return branch;
}

/// Reads a digit's directions: proximal is kept, dorsal made perpendicular, radial follows by side.
void read_directions(TomlTable& table, const std::string& side, Digit& digit) {
  digit.proximal = read_direction(table, "proximal");
  const Vector3d dorsal = read_direction(table, "dorsal");
  // Rounded directions are accepted, skew ones are not.
  if (std::abs(digit.proximal.dot(dorsal)) > kPerpendicularCosine)
    table.fail(fmt::format("'dorsal' of digit '{}' is not perpendicular to 'proximal': their "
                           "cosine is {:.3g}, wanted at most {} either way",
                           digit.name, digit.proximal.dot(dorsal), kPerpendicularCosine),
               "dorsal");
  digit.dorsal = (dorsal - digit.proximal * digit.proximal.dot(dorsal)).normalized();
  digit.radial = digit.proximal.cross(digit.dorsal) * (side == "right" ? 1 : -1);
  if (!table.has("radial")) return;
  // A stated radial direction must agree.
  const Vector3d radial = read_direction(table, "radial");
  if (radial.cross(digit.radial).norm() > kPerpendicularCosine || radial.dot(digit.radial) < 0)
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
  read_each(table, "branches", hood.branches, read_branch, draft);
  table.done();
  return hood;
}

void read_digits(TomlTable& top, SubjectDraft& draft) {
  read_each(top, "digit", draft.subject.digits, read_digit, draft);
  for (const auto& [name, end] : draft.chain_ends)
    check_reference(top, "dh_chain", "digit", name, names_of(draft.subject.digits));
}

namespace {

const std::vector<std::string> kRows{"Fx", "Fy", "Fz", "tx", "ty", "tz"};

void read_rows(TomlTable& table, TipMap& map) {
  const std::vector<NamedNumbers> lists = table.lists("rows");
  const auto columns = static_cast<Eigen::Index>(map.muscles.size());
  map.A.resize(static_cast<Eigen::Index>(lists.size()), columns);
  // One row of the matrix for each named component.
  for (const NamedNumbers& list : lists) {
    check_reference(table, "rows", "wrench component", list.name, kRows);
    if (list.values.size() != map.muscles.size())
      table.fail(fmt::format("row '{}' of tip map '{}' needs {} numbers, one a muscle, got {}",
                             list.name, map.name, columns, list.values.size()),
                 "rows");
    map.A.row(static_cast<Eigen::Index>(map.rows.size())) =
        Eigen::Map<const Eigen::RowVectorXd>(list.values.data(), columns);
    map.rows.push_back(list.name);
  }
}

TipMap read_tip_map(TomlTable& table, const SubjectDraft& draft) {
  TipMap map;
  map.name = new_name(table, names_of(draft.subject.tip_maps));
  map.digit = table.text("digit");
  map.muscles = table.texts("muscles");
  for (const std::string& muscle : map.muscles)
    check_reference(table, "muscles", "muscle", muscle, names_of(draft.subject.muscles));
  read_rows(table, map);
  return map;
}

}  // namespace

void read_tip_maps(TomlTable& top, SubjectDraft& draft) {
  read_each(top, "tip_map", draft.subject.tip_maps, read_tip_map, draft);
}

}  // namespace thenar::internal
