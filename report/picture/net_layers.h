#pragma once

/// An extensor net at rest as layers of a 3D picture.

#include "report/blocks.h"
#include "tendons/net/net_tendons.h"

namespace thenar {

/// Returns the bones of the finger as the net knows them, the metacarpal as well.
[[nodiscard]] Json finger_layer(const NetTendons& tendons, const TreeState<double>& state);

/// Returns surfaces of bones over which the net slides.
[[nodiscard]] Json surface_layer(const NetTendons& tendons, const TreeState<double>& state);

/// Returns bands: those that pull carry their tension as `value` [N], slack ones are dashed.
[[nodiscard]] Json band_layers(const NetTendons& tendons, const TreeState<double>& state,
                               const NetEquilibrium& rest);

/// Returns muscles from where they leave the net, with the tension that they give it as `value`, by
/// name.
[[nodiscard]] Json muscle_layer(const NetTendons& tendons, const TreeState<double>& state,
                                const Eigen::VectorXd& t);

}  // namespace thenar
