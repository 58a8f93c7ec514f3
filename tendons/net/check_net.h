#pragma once

#include "hand/chain.h"
#include "tendons/net/net.h"

namespace thenar {

/// @throws InputError naming the node, band or surface that is wrong: an index out of range, a
/// band between a node and itself, over a surface that is neither sphere nor cylinder, without
/// slack length or stiffness where it needs them, or a number that is not finite.
void check_net(const Net& net);

/// @throws InputError if a drive does not fit the net: shape, sign, or a muscle given by length
/// that pulls a band without stiffness.
void check_drive(const Net& net, const NetDrive& drive);

/// @throws InputError if the net rides on more links than `state` has, or a pose is not finite.
void check_state(const Net& net, const TreeState<double>& state);

}  // namespace thenar
