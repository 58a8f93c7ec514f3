#include "grasp/compare/grasp_type.h"

#include <map>
#include <set>

#include <fmt/format.h>

#include "base/lists.h"

namespace thenar {
namespace {

/// Parts of the hand in contact with the object.
struct TouchedSegments {
  std::map<std::string, Eigen::Vector3d> push;  // digit -> sum of its normals
  bool palm = false;
  bool inner = false;  // whether a link before the last of a digit is in contact
};

TouchedSegments find_touched_parts(const Hand& hand, const std::vector<HandContact>& contacts) {
  // Last links of all digits.
  std::set<int> last;
  for (const HandTip& tip : hand.layout().tip_points) last.insert(tip.link);
  TouchedSegments touching;
  for (const HandContact& contact : contacts) {
    const LinkSurface& surface = hand.surfaces()[contact.surface];
    if (surface.digit.empty()) {
      touching.palm = true;
      continue;  // contacts of the palm have no digit
    }
    if (last.count(surface.link) == 0) touching.inner = true;
    touching.push.emplace(surface.digit, Eigen::Vector3d::Zero()).first->second +=
        contact.contact.n;
  }
  return touching;
}

/// Returns whether a digit pushes against the others: the thumb, or any digit in a hand without
/// one.
bool is_opposed(bool has_thumb, const TouchedSegments& touching) {
  if (has_thumb) return touching.push.count("thumb") > 0;
  // A digit opposes if its normals point against those of the others.
  return any_of(touching.push, [&](const auto& digit) {
    Eigen::Vector3d rest(0, 0, 0);
    for (const auto& [other, push] : touching.push)
      if (other != digit.first) rest += push.normalized();
    return digit.second.normalized().dot(rest) < -1e-9;
  });
}

/// Returns the digits in words: "thumb and 2 digits", "2 digits", "thumb".
std::string digits_in_words(const TouchedSegments& touching) {
  const std::size_t thumbs = touching.push.count("thumb"), digits = touching.push.size() - thumbs;
  if (digits == 0) return "thumb";
  return fmt::format("{}{} digit{}", thumbs > 0 ? "thumb and " : "", digits,
                     digits == 1 ? "" : "s");
}

}  // namespace

std::string opposing_digit(const Hand& hand) {
  const bool has_thumb =
      contains(hand.layout().tips, "thumb") ||
      any_of(hand.surfaces(), [](const LinkSurface& each) { return each.digit == "thumb"; });
  return has_thumb ? "thumb" : "";
}

bool is_pinch(const std::string& type) { return type.rfind("precision, pad", 0) == 0; }

std::string grasp_type(const Hand& hand, const std::vector<HandContact>& contacts) {
  // Power with the palm; otherwise by the number of digits and their opposition.
  const TouchedSegments touching = find_touched_parts(hand, contacts);
  if (touching.push.empty()) return "palm alone";
  if (touching.palm) return "power, palm, " + digits_in_words(touching);
  if (touching.push.size() == 1) return "one digit";
  if (!is_opposed(!opposing_digit(hand).empty(), touching))
    return "intermediate, side, " + digits_in_words(touching);
  return (touching.inner ? "power, pad, " : "precision, pad, ") + digits_in_words(touching);
}

}  // namespace thenar
