#include "viewer/compare_words.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace thenar {
namespace {

/// What each version is, as build_human_hand() makes them.
constexpr std::array<const char*, 4> kVersions{
    "rigid skin, hard contacts, axes of the thumb at right angles; every joint "
    "has a strength of "
    "its own",
    "as tier 1, but the axes of the thumb are skewed as measured; every joint "
    "still has a strength "
    "of its own",
    "as tier 2, but pads are soft: a contact also resists twisting; every "
    "joint still has a "
    "strength of its own",
    "as tier 3, but tendons in place of strengths: joints share muscles "
    "through the net, and the "
    "hand closes as its flexors run in"};

}  // namespace

std::vector<std::string> version_lines(const Comparison& comparison) {
  std::vector<std::string> lines;
  for (std::size_t tier = 0; tier < kVersions.size(); ++tier) {
    const std::string ending = fmt::format(":tier{}", tier + 1);
    for (const std::string& hand : comparison.hands)
      if (hand.size() > ending.size() &&
          hand.compare(hand.size() - ending.size(), ending.size(), ending) == 0)
        lines.push_back(fmt::format("{}: {}.", hand, kVersions[tier]));
  }
  return lines;
}

std::string reading_words(const Comparison& comparison) {
  return fmt::format(
      "Force closure: whatever the disturbance, some contact forces within friction "
      "balance it. Epsilon: the largest disturbance that is balanced from whatever "
      "direction, in units of the contacts' own forces (their normal forces sum up to 1), "
      "torques divided by the object's reach; 0 is the edge of slipping. A larger object, "
      "softer pads or more contacts raise it; the strength of the hand does "
      "not.\n\nEpsilon of the hand: the same disturbance in newtons, with the forces that "
      "the hand's own motors or tendons, stops and drives that do not run back can make at "
      "that posture. A grasp of good geometry may have none: a joint that nothing holds "
      "gives way. Stops and such drives are taken for unbreakable, as no source states "
      "their strength: hundreds of newtons, or no limit, mean that they bear the load and "
      "not that the hand would. Loads are limited alike.\n\nn/a stands where nothing was "
      "measured or an effort is unknown. Approaches are random: shares have the interval "
      "that is given with them, and the best of few approaches is not the best there "
      "is.\n\nSeed {}, {} approaches, objects {}.",
      comparison.seed, comparison.approaches,
      comparison.normalise_size ? "scaled with the reach of the hand" : "in their own size");
}

}  // namespace thenar
