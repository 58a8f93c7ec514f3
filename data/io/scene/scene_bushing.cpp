#include "data/io/scene/scene_bushing.h"

#include <cmath>

#include "base/error.h"
#include "data/io/scene/scene_compliance.h"

namespace thenar::internal {
namespace {

/// Stiffness at rest of three ways and their damping, from entry `first` on.
void read_three(TomlTable& table, const std::string& name, std::size_t first, double& toe,
                SceneBushingSpec& out) {
  if (!table.has(spring_dimension(name), name)) return;
  const SpringKeys springs = read_springs(table, name, 3, Range::kNotNegative);
  for (std::size_t i = 0; i < 3; ++i) {
    out.stiffness[first + i] = springs.stiffness[i];
    out.damping[first + i] = springs.damping;
  }
  toe = springs.toe;
}

}  // namespace

SceneBushingSpec read_scene_bushing(TomlTable& table) {
  SceneBushingSpec out;
  out.line = table.line();
  out.from = table.text_or("from", "");
  out.to = table.text("to");
  out.name = table.text_or("name", "bushing of " + out.to);
  if (out.from == out.to) table.fail(fmt::format("'{}' cannot be held by itself", out.to), "to");
  out.point = table.vector(Dimension::kLength, "point");
  if (table.has("axis")) out.axis = read_direction(table, "axis");
  read_three(table, "translation", 0, out.translation_toe, out);
  read_three(table, "rotation", 3, out.rotation_toe, out);
  if (out.stiffness == std::array<double, 6>{})
    table.fail("[[bushing]] needs a 'translation' or 'rotation' that is not zero");
  out.stiffening = read_stiffening(
      table, std::isfinite(out.translation_toe) || std::isfinite(out.rotation_toe), out.stiffening);
  return out;
}

}  // namespace thenar::internal
