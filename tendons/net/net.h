#pragma once

/// An extensor mechanism as a net of tension-only bands that floats on moving bones.

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "hand/chain.h"
#include "tendons/tension_law.h"
#include "tendons/wrapping/bone_surface.h"

namespace thenar {

/// A knot of the net, or a point of a bone where a band ends.
struct NetNode {
  std::string name;
  bool free = true;            // floats; otherwise it rides on `link`
  int link = -1;               // that carries it, or that a floating node starts with; -1: base
  Eigen::Vector3d p{0, 0, 0};  // at the reference posture [m] (3)
  std::vector<int> surfaces;   // on which a floating node may rest
};

/// A band between two nodes. Its tension is never negative; with strain  e = (L - slack) / slack:
///   EA e^2 / (2 toe)     for 0 <= e <= toe
///   EA (e - toe / 2)     beyond;  toe = 0 is Hooke's law.
/// A band of a muscle carries the tension that the muscle is given, or, if the muscle is given a
/// length, that length takes the place of `slack`.
struct NetBand {
  std::string name;
  int a = -1, b = -1;             // nodes
  int over = -1;                  // surface that it bends over; -1: straight
  Eigen::Vector3d side{0, 1, 0};  // from that surface towards the side it passes, frame S (3)
  double slack = 0;               // length without tension [m]
  double EA = 0;                  // modulus times area: tension per strain [N]
  double toe = 0;                 // strain up to which fibres are recruited [1]
  int muscle = -1;                // that pulls it; -1: a passive band
  double most_strain = std::numeric_limits<double>::infinity();  // that its tissue bears [1]
};

/// A net; constant once built.
struct Net {
  std::string name;
  std::vector<NetNode> nodes;
  std::vector<NetBand> bands;
  std::vector<BoneSurface> surfaces;
  std::vector<std::string> muscles;  // that pull it
  double friction = 0;               // of nodes on bone (Coulomb); not 0: see net_friction.h [1]
  double blend = 0;  // strain over which passive bands go from slack to taut (band_law.h), with
                     // tension, though little, at any length; 0: at once [1]
  double most_load = std::numeric_limits<double>::infinity();  // tension of a passive band, per sum
                                                               // of the muscles' pulls [1]
};

/// Inputs by which muscles drive the net.
struct NetDrive {
  Eigen::VectorXd tension;  // of each muscle, >= 0 [N] (muscles)
  Eigen::VectorXd length;   // finite: this musculotendon length instead of a tension [m] (muscles);
                            // empty: all by tension
  std::vector<std::shared_ptr<const TensionLaw>> law{};  // by the length of its band instead of
                                                         // either (muscles); null or empty: none
};

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
