#pragma once

/// Colours of a quantity on meshes; items of pictures get theirs in the browser.

#include <vector>

#include <Eigen/Core>

#include "report/picture/mesh_table.h"

namespace thenar {

/// Returns the colour of a fraction, which is clamped to 0..1: the ramp of
/// viewer/picture/color_scale.js, so that the scale below a picture also applies to meshes.
[[nodiscard]] MeshColor ramp_color(double fraction);

/// Returns the bytes of a colour "#rrggbb". @throws InputError if the text has another form
[[nodiscard]] MeshColor color_of_hex(const std::string& hex);

/// Returns a colour for every value on a scale from 0 to `high`; `none` for values <= 0.
[[nodiscard]] std::vector<MeshColor> ramp_colors(const Eigen::VectorXd& values, double high,
                                                 const MeshColor& none);

}  // namespace thenar
