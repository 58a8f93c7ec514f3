#include "base/rung_names.h"

namespace thenar {

std::vector<std::string> path_names() { return names_in(kPathNames); }
Path path_named(const std::string& name) { return value_in(kPathNames, name, "path"); }
std::string name_of(Path path) {
  const std::string name = name_in(kPathNames, path);
  if (!name.empty()) return name;
  return path == Path::kConstant ? "constant" : "none";
}
std::string asked_paths(const std::optional<Path>& asked) {
  return asked ? name_of(*asked) : kSubjectsPaths;
}

std::vector<std::string> hood_names() { return names_in(kHoodNames); }
Hood hood_named(const std::string& name) { return value_in(kHoodNames, name, "hood"); }

Muscle muscle_named(const std::string& name) { return value_in(kMuscleNames, name, "muscle"); }

}  // namespace thenar
