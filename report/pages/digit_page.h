#pragma once

/// What every page about a fingertip has in common: its frame, the digit in space.

#include <functional>
#include <string>

#include "api/digit_sweep.h"
#include "report/blocks.h"
#include "report/sweep_axes.h"

namespace thenar {

/// The whole page. @param what  "Tip force"
[[nodiscard]] Json digit_page(const DigitSweep& about, const std::string& what, Json sections);

/// The text of a first section: what was asked at which postures, and every warning.
[[nodiscard]] std::string digit_introduction(const DigitSweep& about, const std::string& words);

/// What else is drawn at a posture. @param tint  colour of the posture
using AddLayers = std::function<void(std::size_t point, const std::string& tint, Json& layers)>;

/// Bones at up to five of the postures, each a layer, and tendons where they run straight; null for
/// a map. @param layers  adds to each posture's bones
[[nodiscard]] Json digit_scene(const DigitSweep& about, const std::string& caption,
                               const AddLayers& add);

/// Arrows from the tip: how long one newton is drawn [mm/N], so that the largest force is 40 mm.
[[nodiscard]] double arrow_scale(double largest);

/// A layer with one arrow. @param from  [m] (3);  @param vector  as drawn [mm] (3)
[[nodiscard]] Json arrow_layer(const std::string& name, const std::string& color,
                               const Eigen::Vector3d& from, const Eigen::Vector3d& vector);

/// Charts side by side, two a row.
[[nodiscard]] Json paired(const Json& charts);

}  // namespace thenar
