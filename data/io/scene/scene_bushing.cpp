#include "data/io/scene/scene_bushing.h"

#include "base/error.h"

namespace thenar::internal {
namespace {

/// Stiffness at rest of three ways and their damping, from entry `first` on.
void read_three(TomlTable& table, const std::string& name, bool turns, std::size_t first,
                SceneBushingSpec& out) {
  const Dimension stiffness = turns ? Dimension::kAngularStiffness : Dimension::kLinearStiffness;
  const Dimension damping = turns ? Dimension::kAngularDamping : Dimension::kLinearDamping;
  const Dimension size = turns ? Dimension::kAngle : Dimension::kLength;
  if (!table.has(stiffness, name)) return;
  const std::vector<double> numbers = table.numbers(stiffness, name, 3, Range::kNotNegative);
  const double damped = table.number_or(damping, name + "_damping", 0, Range::kNotNegative);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    out.stiffness[first + i] = numbers[i];
    out.damping[first + i] = damped;
  }
  double& toe = turns ? out.rotation_toe : out.translation_toe;
  if (table.has(size, name + "_toe")) toe = table.number(size, name + "_toe", Range::kPositive);
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
  if (table.has("axis")) out.axis = table.direction("axis");
  read_three(table, "translation", false, 0, out);
  read_three(table, "rotation", true, 3, out);
  if (out.stiffness == std::array<double, 6>{})
    table.fail("[[bushing]] needs a 'translation' or 'rotation' that is not zero");
  out.stiffening = table.number_or(Dimension::kNumber, "stiffening", out.stiffening);
  if (out.stiffening < 1)
    table.fail(fmt::format("wanted 'stiffening' from 1 up, got {:g}", out.stiffening),
               "stiffening");
  table.done();
  return out;
}

}  // namespace thenar::internal
