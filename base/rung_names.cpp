#include "base/rung_names.h"

#include "base/nearest_name.h"

namespace thenar {
namespace {

template <typename Rung>
struct NamedRung {
  const char* name;
  Rung rung;
};

constexpr NamedRung<Path> kPathNames[] = {
    {"via", Path::kViaPoint}, {"fitted", Path::kFitted}, {"wrapped", Path::kWrapped}};
constexpr NamedRung<Hood> kHoodNames[] = {
    {"separate", Hood::kSeparate}, {"fractions", Hood::kFractions}, {"net", Hood::kFloatingNet}};
constexpr NamedRung<Muscle> kMuscleNames[] = {{"bounds", Muscle::kBounds},
                                              {"rigid-tendon", Muscle::kRigidTendon},
                                              {"elastic-tendon", Muscle::kElasticTendon}};

template <typename Rung, std::size_t n>
std::vector<std::string> names_of(const NamedRung<Rung> (&rungs)[n]) {
  std::vector<std::string> names;
  for (const NamedRung<Rung>& each : rungs) names.emplace_back(each.name);
  return names;
}

template <typename Rung, std::size_t n>
Rung rung_named(const NamedRung<Rung> (&rungs)[n], const std::string& name,
                const std::string& kind) {
  return rungs[index_of_name(name, names_of(rungs), kind)].rung;
}

}  // namespace

std::vector<std::string> path_names() { return names_of(kPathNames); }
Path path_named(const std::string& name) { return rung_named(kPathNames, name, "path"); }
std::string name_of(Path path) {
  for (const NamedRung<Path>& each : kPathNames)
    if (each.rung == path) return each.name;
  return path == Path::kConstant ? "constant" : "none";
}
std::string asked_paths(const std::optional<Path>& asked) {
  return asked ? name_of(*asked) : kSubjectsPaths;
}

std::vector<std::string> hood_names() { return names_of(kHoodNames); }
Hood hood_named(const std::string& name) { return rung_named(kHoodNames, name, "hood"); }

std::vector<std::string> muscle_names() { return names_of(kMuscleNames); }
Muscle muscle_named(const std::string& name) { return rung_named(kMuscleNames, name, "muscle"); }

}  // namespace thenar
