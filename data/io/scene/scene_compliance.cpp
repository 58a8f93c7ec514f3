#include "data/io/scene/scene_compliance.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/nearest_name.h"

namespace thenar {

namespace internal {
namespace {

// Number of ways that are translations, the first of all ways
constexpr std::size_t kTranslationCount = 3;

/// Reads the ways that yield: those of 'ways', or all.
std::array<bool, 5> read_ways(TomlTable& table) {
  // In the order of SceneComplianceSpec::Way.
  static const std::vector<std::string> names{"across", "along", "axial", "abduction", "twist"};
  std::array<bool, 5> gives{true, true, true, true, true};
  if (!table.has("ways")) return gives;
  gives.fill(false);
  for (const std::string& word : table.texts("ways")) {
    const auto at = std::find(names.begin(), names.end(), word);
    if (at == names.end())
      table.fail(fmt::format("there is no way '{}'{}", word, did_you_mean(word, names)), "ways");
    gives[at - names.begin()] = true;
  }
  return gives;
}

/// Stiffness and damping of the ways from `first` on that give.
void read_group(TomlTable& table, const std::string& name, bool turns,
                const std::array<bool, 5>& gives, SceneComplianceSpec& out) {
  const std::size_t first = turns ? kTranslationCount : 0, end = turns ? 5 : kTranslationCount;
  const bool any = std::find(gives.begin() + static_cast<std::ptrdiff_t>(first),
                             gives.begin() + static_cast<std::ptrdiff_t>(end),
                             true) != gives.begin() + static_cast<std::ptrdiff_t>(end);
  if (!any) {
    if (table.has(spring_dimension(name), name))
      table.fail("none of its ways gives: see 'ways'", name);
    return;
  }
  const SpringKeys springs =
      read_springs(table, name, static_cast<int>(end - first), Range::kPositive);
  for (std::size_t i = first; i < end; ++i) {
    if (!gives[i]) continue;
    out.stiffness[i] = springs.stiffness[i - first];
    out.damping[i] = springs.damping;
  }
  (turns ? out.rotation_toe : out.translation_toe) = springs.toe;
}

/// The toe of twist, where it has one of its own.
double read_twist_toe(TomlTable& table, const std::array<bool, 5>& gives, double usual) {
  if (!table.has(Dimension::kAngle, "twist_toe")) return usual;
  if (!gives[SceneComplianceSpec::kTwist])
    table.fail("a twist that is rigid has no toe", "twist_toe");
  return table.number(Dimension::kAngle, "twist_toe", Range::kPositive);
}

}  // namespace

Dimension spring_dimension(const std::string& name) {
  return name == "rotation" ? Dimension::kAngularStiffness : Dimension::kLinearStiffness;
}

SpringKeys read_springs(TomlTable& table, const std::string& name, int ways, Range range) {
  const bool turns = name == "rotation";
  const Dimension damping = turns ? Dimension::kAngularDamping : Dimension::kLinearDamping;
  const Dimension size = turns ? Dimension::kAngle : Dimension::kLength;
  SpringKeys out;
  out.stiffness = table.numbers(spring_dimension(name), name, ways, range);
  out.damping = table.number_or(damping, name + "_damping", 0, Range::kNotNegative);
  if (table.has(size, name + "_toe")) out.toe = table.number(size, name + "_toe", Range::kPositive);
  return out;
}

double read_stiffening(TomlTable& table, bool has_toe, double usual) {
  const bool stated = table.has(Dimension::kNumber, "stiffening");
  const double value = table.number_or(Dimension::kNumber, "stiffening", usual);
  if (!(value >= 1))
    table.fail(fmt::format("wanted 'stiffening' from 1 up, got {:g}", value), "stiffening");
  if (stated && !has_toe)
    table.fail(
        "springs without a toe are straight: 'stiffening' needs a 'translation_toe' or "
        "'rotation_toe'",
        "stiffening");
  return value;
}

SceneComplianceSpec read_scene_compliance(TomlTable& table) {
  SceneComplianceSpec out;
  out.line = table.line();
  out.joint = table.text("joint");
  out.stiffness.fill(std::numeric_limits<double>::infinity());
  const std::array<bool, 5> gives = read_ways(table);
  read_group(table, "translation", false, gives, out);
  read_group(table, "rotation", true, gives, out);
  out.twist_toe = read_twist_toe(table, gives, out.rotation_toe);
  if (table.has("bone")) out.bone = read_direction(table, "bone");
  out.stiffening =
      read_stiffening(table,
                      std::isfinite(out.translation_toe) || std::isfinite(out.rotation_toe) ||
                          std::isfinite(out.twist_toe),
                      out.stiffening);
  out.twist_follows = table.number_or(Dimension::kNumber, "twist_follows", 0);
  if (out.twist_follows != 0 && !gives[SceneComplianceSpec::kTwist])
    table.fail("a twist that is rigid follows nothing", "twist_follows");
  return out;
}

SceneLigamentSpec read_scene_ligament(TomlTable& table) {
  SceneLigamentSpec out;
  out.line = table.line();
  out.from = table.text_or("from", "");
  out.to = table.text("to");
  out.name = table.text_or("name", "ligament of " + out.to);
  if (out.from == out.to) table.fail(fmt::format("'{}' cannot be tied to itself", out.to), "to");
  out.from_point = table.vector(Dimension::kLength, "from_point");
  out.to_point = table.vector(Dimension::kLength, "to_point");
  out.stiffness = table.number(Dimension::kForce, "stiffness", Range::kPositive);
  out.slack_length = number_if(table, Dimension::kLength, "slack_length", Range::kPositive);
  out.toe_strain =
      table.number_or(Dimension::kNumber, "toe_strain", out.toe_strain, Range::kPositive);
  out.damping = table.number_or(Dimension::kTime, "damping", 0, Range::kNotNegative);
  return out;
}

}  // namespace internal
}  // namespace thenar
