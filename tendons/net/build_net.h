#pragma once

/// Construction of a net on the finger of a subject.

#include <string>
#include <vector>

#include "data/io/net_description.h"
#include "tendons/net/finger_frame.h"
#include "tendons/net/net.h"

namespace thenar {

/// Origin of slack lengths.
enum class NetSlack {
  kStated,   // the description's, scaled by how much longer the band is here than in the reference
             // finger; fitted where it states none
  kStraight  // all fitted: every band is just taut in the straight finger
};

/// How bands and muscles run between knots.
enum class NetRuns {
  kBent,     // over the surfaces that the description names
  kStraight  // through whatever lies between, as through via points
};

/// Options of build_net().
struct NetBuildOptions {
  NetRuns runs = NetRuns::kBent;
  NetSlack slack = NetSlack::kStated;
  double taut_load = 1;   // pull of every muscle at which slack lengths are fitted in the straight
                          // finger: enough to spread a hood, too little to stretch it [N]
  double pretension = 0;  // strain of fitted bands before that load [1]
};

/// Pull of one muscle of the digit on the net.
struct MuscleAttachment {
  int muscle;    // of the digit's
  double share;  // of its tension [1]
};

/// Path and share of one muscle of the digit.
struct NetMuscle {
  int muscle;              // of the digit's
  double to_net;           // share of its tension that enters the net [1]
  TendonPath<double> own;  // path from where it leaves the net to its origin
};

/// A net with its relation to the digit.
struct BuiltNet {
  Net net;                              // its `muscles` are the pulls
  std::vector<MuscleAttachment> pulls;  // one a muscle of the net
  std::vector<NetMuscle> muscles;
  std::vector<int> central, radial, ulnar, terminal;  // bands of the slips
  FingerFrame frame;
};

/// Lays a net on a finger. Lengths along bones are parts of the bones' lengths; lengths across them
/// are parts of the extensor's heights, so that its moment arms in the straight finger are those
/// measured on the subject. Capsules take the smaller of the two ratios at their bone's ends, so
/// that no shaft stands out over a head.
/// @throws InputError naming what the subject lacks.
[[nodiscard]] BuiltNet build_net(const Subject& subject, const TendonDigit& digit,
                                 const NetDescription& description,
                                 const NetBuildOptions& options = {});

/// Returns the net without one of its bands. @throws InputError if it has no such band.
[[nodiscard]] BuiltNet cut(const BuiltNet& built, const std::string& band);

/// Index of a band. @throws InputError naming the bands there are.
[[nodiscard]] int band_named(const Net& net, const std::string& name);

/// Index of a node. @throws InputError naming the nodes there are.
[[nodiscard]] int node_named(const Net& net, const std::string& name);

}  // namespace thenar
