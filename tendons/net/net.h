#pragma once

/// Extensor mechanism as a net of tension-only bands that floats on moving bones.

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "hand/chain.h"
#include "tendons/tension_law.h"
#include "tendons/wrapping/bone_surface.h"

namespace thenar {

/// Node of the net: a floating knot, or a point of a bone where a band ends.
struct NetNode {
  std::string name;
  bool free = true;            // true: it floats; false: it is fixed to `link`
  int link = -1;               // link that carries it, or where a floating node starts; -1: base
  Eigen::Vector3d p{0, 0, 0};  // position at the reference posture [m] (3)
  std::vector<int> surfaces;   // surfaces with which a floating node may be in contact
};

/// Band between two nodes. Its tension is never negative; with strain  e = (L - slack) / slack:
///   EA e^2 / (2 toe)     for 0 <= e <= toe
///   EA (e - toe / 2)     beyond;  toe = 0 is Hooke's law.
/// The band of a muscle carries the muscle's given tension; where a muscle has a given length
/// instead, that length replaces `slack`.
struct NetBand {
  std::string name;
  int a = -1, b = -1;  // nodes at its ends
  int over = -1;       // surface that it bends over; -1: straight
  Eigen::Vector3d side{0, 1,
                       0};  // direction from that surface towards the side it passes, frame S (3)
  double slack = 0;         // slack length: length without tension [m]
  double EA = 0;            // axial stiffness, modulus times area: tension per strain [N]
  double toe = 0;           // strain up to which fibres are recruited [1]
  int muscle = -1;          // muscle that pulls it; -1: a passive band
  /// Largest strain that its tissue tolerates [1].
  double max_strain = std::numeric_limits<double>::infinity();
};

/// Net of bands; constant once built.
struct Net {
  std::string name;
  std::vector<NetNode> nodes;
  std::vector<NetBand> bands;
  std::vector<BoneSurface> surfaces;
  std::vector<std::string> muscles;  // muscles that pull it
  double friction = 0;  // Coulomb friction of nodes on bone; not 0: see net_friction.h [1]
  double blend = 0;     // strain over which passive bands change from slack to taut (band_law.h),
                        // which keeps some tension at any length; 0: a sharp change [1]
  /// Largest tension of a passive band over the sum of the muscles' pulls [1].
  double max_load = std::numeric_limits<double>::infinity();
};

/// Inputs by which muscles drive the net.
struct NetDrive {
  Eigen::VectorXd tension;  // tension of each muscle, >= 0 [N] (muscles)
  Eigen::VectorXd length;   // musculotendon length that replaces a tension where it is finite [m]
                            // (muscles); empty: all by tension
  /// Law of the band's length that replaces either (muscles); null or empty: none.
  std::vector<std::shared_ptr<const TensionLaw>> law{};
};

/// Checks a net.
/// @throws InputError naming the node, band or surface that is wrong: an index out of range, a band
/// between a node and itself, over a surface that is neither sphere nor cylinder, without slack
/// length or stiffness where it needs them, or a number that is not finite.
void check_net(const Net& net);

/// Checks a drive.
/// @throws InputError if it does not fit the net: shape, sign, or a muscle given by length that
/// pulls a band without stiffness.
void check_drive(const Net& net, const NetDrive& drive);

/// Checks a state of the links.
/// @throws InputError if the net is fixed to more links than `state` has, or a pose is not finite.
void check_state(const Net& net, const TreeState<double>& state);

/// Checks initial nodes, if there are any.
/// @throws InputError if they are not as many as the net's, or not finite.
void check_start(const Net& net, const Eigen::Matrix3Xd* start);

}  // namespace thenar
