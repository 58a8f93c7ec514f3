#include "report/picture/color_ramp.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

// Equal steps of "plasma" (Smith and van der Walt, matplotlib, CC0), as STOPS of the viewer.
constexpr std::array kColorStops{"#4c02a1", "#7e03a8", "#a82296", "#cb4679",
                                 "#e56b5d", "#f89441", "#fdc328"};

}  // namespace

MeshColor color_of_hex(const std::string& hex) {
  require(hex.size() == 7 && hex[0] == '#' &&
              hex.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos,
          "wanted a colour as #rrggbb, got '{}'", hex);
  MeshColor color;
  for (int i = 0; i < 3; ++i)
    color[i] = static_cast<unsigned char>(
        std::stoi(hex.substr(1 + 2 * static_cast<std::size_t>(i), 2), nullptr, 16));
  return color;
}

MeshColor ramp_color(double fraction) {
  const double place = std::clamp(fraction, 0.0, 1.0) * (kColorStops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kColorStops.size() - 2);
  const Eigen::Vector3d from = color_of_hex(kColorStops[below]).cast<double>(),
                        to = color_of_hex(kColorStops[below + 1]).cast<double>();
  const Eigen::Vector3d mixed = from + (place - static_cast<double>(below)) * (to - from);
  return mixed.array().round().matrix().cast<unsigned char>();
}

std::vector<MeshColor> ramp_colors(const Eigen::VectorXd& values, double high,
                                   const MeshColor& none) {
  return transformed(values, [&](double value) {
    return value > 0 && high > 0 ? ramp_color(value / high) : none;
  });
}

}  // namespace thenar
