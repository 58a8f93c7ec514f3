#pragma once

/// Construction of a net on the finger of a subject.

#include <string>
#include <vector>

#include "data/io/net_description.h"
#include "tendons/net/finger_frame.h"
#include "tendons/net/net.h"

namespace thenar {

/// Source of the slack lengths of bands.
enum class NetSlack {
  kStated,  // from the description, scaled by the ratio of the band's length here to that in the
            // reference finger; fitted where it states none
  kFittedStraightFinger  // all fitted: every band is just taut in the straight finger
};

/// Paths of bands and muscles between nodes.
enum class NetPaths {
  kWrapped,       // over the surfaces that the description names
  kStraightLines  // straight from node to node, through any bone between
};

/// Options of build_net().
struct NetBuildOptions {
  NetPaths paths = NetPaths::kWrapped;
  NetSlack slack = NetSlack::kStated;
  double taut_load = 1;  // pull of every muscle while slack lengths are fitted in the straight
                         // finger [N]. Our choice: spreads the net but hardly stretches it
  double prestrain = 0;  // strain of fitted bands in the straight finger without that load [1]
};

/// Pull of one muscle of the digit on the net.
struct MuscleAttachment {
  int muscle = 0;    // index of the muscle in the digit
  double share = 0;  // fraction of its tension that it pulls with [1]
};

/// Muscle of the digit that pulls the net, with the path of its tendon outside the net.
struct NetMuscle {
  int muscle = 0;               // index of the muscle in the digit
  double to_net = 0;            // share of its tension that enters the net [1]
  TendonPath<double> own_path;  // path from its exit, where it leaves the net, to its origin
};

/// Net with its relation to the digit.
struct BuiltNet {
  Net net;                              // the net; its `muscles` are the pulls
  std::vector<MuscleAttachment> pulls;  // one for each muscle of the net, in its order
  std::vector<NetMuscle> muscles;
  std::vector<int> central, radial, ulnar, terminal;  // bands of each slip
  FingerFrame frame;
};

/// Builds a net on a finger with all joints free, whichever of the digit's are frozen: the angle of
/// a frozen joint does not affect the bands. Points scale along a bone with the length of the bone,
/// and across it with the distance of the extensor tendon from the joint axes, so that the straight
/// finger has the moment arms measured on the subject. Capsules, the wrapping surfaces of bone
/// shafts, scale by the smaller ratio of the two ends of their bone, so that no shaft is thicker
/// than the bone's head.
/// @throws InputError naming what the subject lacks.
[[nodiscard]] BuiltNet build_net(const Subject& subject, const TendonDigit& digit,
                                 const NetDescription& description,
                                 const NetBuildOptions& options = {});

/// Returns the net without one of its bands. @throws InputError if it has no such band.
[[nodiscard]] BuiltNet cut(const BuiltNet& built, const std::string& band);

/// Returns the index of a band. @throws InputError listing the bands of the net.
[[nodiscard]] int band_index(const Net& net, const std::string& name);

}  // namespace thenar
