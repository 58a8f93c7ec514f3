#include <algorithm>

#include "data/io/nearest_name.h"
#include "data/io/subject_parts.h"

namespace thenar::internal {

std::string new_name(TomlTable& table, const std::vector<std::string>& taken) {
  std::string name = table.text("name");
  if (std::find(taken.begin(), taken.end(), name) != taken.end())
    table.fail(fmt::format("{} '{}' is given twice", table.title(), name), "name");
  return name;
}

void check_reference(const TomlTable& table, const std::string& key, const std::string& what,
                     const std::string& name, const std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), name) == names.end())
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

}  // namespace thenar::internal
