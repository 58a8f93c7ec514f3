#pragma once

/// Construction of a net on the finger of a subject.

#include <string>
#include <vector>

#include "data/io/net_description.h"
#include "tendons/net/finger_frame.h"
#include "tendons/net/net.h"

namespace thenar {

/// Origin of the slack lengths of bands.
enum class NetSlack {
  kStated,  // the description's, scaled by how much longer the band is here than in the reference
            // finger; fitted where it states none
  kFittedStraightFinger  // all fitted: every band is just taut in the straight finger
};

/// Paths of bands and muscles between knots.
enum class NetPaths {
  kWrapped,       // over the surfaces that the description names
  kStraightLines  // straight from knot to knot, through whatever lies between
};

/// Options of build_net().
struct NetBuildOptions {
  NetPaths paths = NetPaths::kWrapped;
  NetSlack slack = NetSlack::kStated;
  double taut_load = 1;  // pull of every muscle at which slack lengths are fitted in the straight
                         // finger, a choice of ours: spreads the net, hardly stretches it [N]
  double prestrain = 0;  // strain of fitted bands in the straight finger without that load [1]
};

/// Pull of one muscle of the digit on the net.
struct MuscleAttachment {
  int muscle;    // index among the digit's muscles
  double share;  // of its tension [1]
};

/// Path of one muscle of the digit to the net, and its share in the net.
struct NetMuscle {
  int muscle;              // index among the digit's muscles
  double to_net;           // share of its tension that enters the net [1]
  TendonPath<double> own;  // path from where it leaves the net to its origin
};

/// A net with its relation to the digit.
struct BuiltNet {
  Net net;                              // its `muscles` are the pulls
  std::vector<MuscleAttachment> pulls;  // one per muscle of the net, in its order
  std::vector<NetMuscle> muscles;
  std::vector<int> central, radial, ulnar, terminal;  // bands of each slip
  FingerFrame frame;
};

/// Lays a net on a finger with all its joints free, whichever of the digit's are frozen: where a
/// joint stands changes no band. Points scale along a bone with the length of the bone, and across
/// it with the distance of the extensor tendon from the joint axes, so that the straight finger has
/// the moment arms measured on the subject. Capsules, the wrapping surfaces of bone shafts, scale
/// by the smaller ratio of the two ends of their bone, so that no shaft is thicker than the bone's
/// head.
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
