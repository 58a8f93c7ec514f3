#pragma once

/// Naming conventions of joints and muscles: "MCP2_AA" abducts, "RU_PS" pronates, "FDP2" flexes.

#include <initializer_list>
#include <string>

namespace thenar {

/// Returns whether a name ends with the given text.
[[nodiscard]] inline bool ends_with(const std::string& name, const std::string& ending) {
  return name.size() >= ending.size() &&
         name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

/// Returns whether a joint flexes: its name is neither one of abduction nor of pronation.
[[nodiscard]] inline bool is_flexion_joint(const std::string& joint) {
  return !ends_with(joint, "_AA") && !ends_with(joint, "_PS");
}

/// Returns whether a muscle is FDS, FDP or FPL of any digit, which run in a sheath along the flexor
/// side of every joint.
[[nodiscard]] inline bool is_long_flexor(const std::string& muscle) {
  return muscle.rfind("FDS", 0) == 0 || muscle.rfind("FDP", 0) == 0 || muscle.rfind("FPL", 0) == 0;
}

/// Returns the action of a muscle on a flexion joint of a finger or thumb, by its name: 1 flexes
/// it, -1 extends it, 0 if the name does not say. Long flexors and extensors act alike at every
/// joint except the wrist and the carpometacarpal joints of the thumb, whose axes are skew to the
/// digit. Interosseous muscles of fingers flex the metacarpophalangeal joint and extend those
/// beyond. Lumbricals extend those beyond too, but at the metacarpophalangeal joint they unload the
/// deep flexor by their own pull.
[[nodiscard]] inline int named_action(const std::string& muscle, const std::string& joint) {
  const auto begins = [](const std::string& text, std::initializer_list<const char*> with) {
    for (const char* start : with)
      if (text.rfind(start, 0) == 0) return true;
    return false;
  };
  if (!is_flexion_joint(joint) || begins(joint, {"CMC", "TMC", "WRIST", "RC_"})) return 0;
  if (is_long_flexor(muscle)) return 1;
  if (begins(muscle, {"ED", "EIP", "EPL"}) || muscle == "EI") return -1;
  if (!begins(muscle, {"LU", "DI", "PI"}) && muscle != "RI" && muscle != "UI") return 0;
  if (begins(joint, {"MCP"})) return begins(muscle, {"LU"}) ? 0 : 1;
  return begins(joint, {"PIP", "DIP"}) ? -1 : 0;
}

}  // namespace thenar
