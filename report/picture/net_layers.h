#pragma once

/// An extensor net at rest as layers of a 3D picture.

#include "report/blocks.h"
#include "tendons/net/net_tendons.h"

namespace thenar {

/// Returns a layer with the bones of the net's finger frame, including the metacarpal.
[[nodiscard]] Json finger_layer(const NetTendons& tendons, const TreeState<double>& state);

/// Returns a layer with the bone surfaces over which the net slides.
[[nodiscard]] Json surface_layer(const NetTendons& tendons, const TreeState<double>& state);

/// Returns layers of bands: taut ones have their tension as `value` [N], slack ones are dashed.
[[nodiscard]] Json band_layers(const NetTendons& tendons, const TreeState<double>& state,
                               const NetEquilibrium& rest);

/// Returns a layer of muscles by name, from their exits from the net, with their tension on it as
/// `value`.
[[nodiscard]] Json muscle_layer(const NetTendons& tendons, const TreeState<double>& state,
                                const Eigen::VectorXd& t);

}  // namespace thenar
