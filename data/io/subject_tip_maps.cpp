#include "data/io/subject_parts.h"

namespace thenar::internal {
namespace {

const std::vector<std::string> kRows{"Fx", "Fy", "Fz", "tx", "ty", "tz"};

void read_rows(TomlTable& table, TipMap& map) {
  const std::vector<NamedNumbers> lists = table.lists("rows");
  const auto columns = static_cast<Eigen::Index>(map.muscles.size());
  map.A.resize(static_cast<Eigen::Index>(lists.size()), columns);
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
  table.done();
  return map;
}

}  // namespace

void read_tip_maps(TomlTable& top, SubjectDraft& draft) {
  for (TomlTable& table : top.tables("tip_map"))
    draft.subject.tip_maps.push_back(read_tip_map(table, draft));
}

}  // namespace thenar::internal
