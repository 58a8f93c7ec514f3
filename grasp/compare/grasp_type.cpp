#include "grasp/compare/grasp_type.h"

#include <map>
#include <set>

#include <fmt/format.h>

namespace thenar {
namespace {

/// What touches.
struct Touching {
  std::map<std::string, Eigen::Vector3d> push;  // digit -> sum of its normals
  bool palm = false;
  bool inner = false;  // a link before the last of a digit
};

Touching find_touching(const Hand& hand, const std::vector<HandContact>& contacts) {
  std::set<int> last;
  for (const HandTip& tip : hand.layout().tip_points) last.insert(tip.link);
  Touching touching;
  for (const HandContact& contact : contacts) {
    const LinkSurface& surface = hand.surfaces()[contact.surface];
    if (surface.digit.empty()) {
      touching.palm = true;
      continue;
    }
    if (last.count(surface.link) == 0) touching.inner = true;
    auto [at, fresh] = touching.push.emplace(surface.digit, Eigen::Vector3d::Zero());
    at->second += contact.contact.n;
  }
  return touching;
}

/// The digit that pushes most against the rest; empty with fewer than two.
std::string opposing(const Hand& hand, const Touching& touching) {
  const std::string thumb = thumb_of(hand);
  if (!thumb.empty()) return touching.push.count(thumb) > 0 ? thumb : "";
  std::string found;
  double least = 0;
  for (const auto& [digit, push] : touching.push) {
    Eigen::Vector3d rest(0, 0, 0);
    for (const auto& [other, its] : touching.push)
      if (other != digit) rest += its.normalized();
    const double along = push.normalized().dot(rest);
    if (along < least - 1e-9) {
      least = along;
      found = digit;
    }
  }
  return found;
}

std::string counted(std::size_t digits) {
  return fmt::format("{} digit{}", digits, digits == 1 ? "" : "s");
}

}  // namespace

std::string thumb_of(const Hand& hand) {
  for (const LinkSurface& surface : hand.surfaces())
    if (surface.digit == "thumb") return "thumb";
  for (const std::string& tip : hand.layout().tips)
    if (tip == "thumb") return "thumb";
  return "";
}

std::string grasp_type(const Hand& hand, const std::vector<HandContact>& contacts) {
  const Touching touching = find_touching(hand, contacts);
  const std::string thumb = opposing(hand, touching);
  const std::size_t others = touching.push.size() - (thumb.empty() ? 0 : 1);
  if (touching.push.empty()) return "palm alone";
  if (touching.palm) return "power, palm, " + counted(others);
  if (touching.push.size() == 1) return "one digit";
  if (thumb.empty()) return "intermediate, side, " + counted(others);
  return (touching.inner ? "power, pad, " : "precision, pad, ") + counted(others);
}

}  // namespace thenar
