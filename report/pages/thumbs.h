#pragma once

#include <string>
#include <vector>

#include "data/io/subject.h"
#include "report/blocks.h"

namespace thenar {

/// A thumb to show, at a posture of its own.
struct ThumbCase {
  std::string title;
  Subject subject;
  std::map<std::string, double> posture;  // joint -> angle [rad]
};

/// Thumbs side by side: axes, feasible thumbtip forces, largest forces along the thumb's own
/// directions.
[[nodiscard]] Json thumb_page(const std::vector<ThumbCase>& cases);

}  // namespace thenar
