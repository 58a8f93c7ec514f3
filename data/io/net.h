#pragma once

/// The extensor mechanism of a finger described once, as plain data, for the finger of any subject.
///
/// Places are stated on the four bones of one reference finger, by role, so that the same net can be
/// laid on any finger. Bones' lines run between joint centres, heights are measured from them.

#include <map>
#include <string>
#include <vector>

#include "data/io/subject.h"

namespace thenar {

/// The bones of a finger, from the palm outwards.
enum class BoneRole { kMetacarpal, kProximal, kMiddle, kDistal };

/// The joints between them.
enum class FingerJoint { kMcp, kPip, kDip };

/// How far something stands from the line of its bone, or how large it is.
struct NetSize {
  double length = 0;         // [m], in the reference finger
  double height_ratio = 0;   // multiple of the extensor's height over the joints at the bone's two
                             // ends, interpolated between them [1]; 0: `length` counts
};

/// A place on a bone.
struct NetPlace {
  BoneRole bone = BoneRole::kProximal;
  double along = 0;  // 0 at the bone's proximal end, 1 at its distal end; may lie beyond [1]
  double angle = 0;  // about the bone: 0 dorsal, +90 degrees radial, 180 palmar [rad]
  NetSize height;    // from the bone's line
};

/// A point of a path of the subject.
struct StrandPoint {
  std::vector<std::string> strands;  // names that it may have; empty: no such point
  int point = 0;                     // from the insertion; negative: from the origin, -1 the last
};

/// A surface on which nodes may rest and over which bands may bend.
struct NetSurface {
  std::string name;
  SurfaceShape shape = SurfaceShape::kSphere;  // sphere, cylinder or capsule
  NetPlace center;
  NetSize radius;
  bool across = false;     // its axis runs along the joint's axis, not along the bone
  double half_length = 0;  // of the axis, reference finger [m]
};

/// A knot of the net.
struct NetNodePlan {
  std::string name;
  bool floating = true;
  NetPlace place;                     // where it is, or where a floating node starts
  StrandPoint strand;                 // instead of `place`
  std::vector<std::string> surfaces;  // on which a floating node may rest
};

/// A band between two nodes.
struct NetBandPlan {
  std::string name;
  std::string from, to;  // nodes
  double slack = 0;      // in the reference finger [m]; 0: fitted to the straight finger
  double EA = 0;         // tension per strain [N]
  double toe = 0;        // strain up to which fibres are recruited [1]
  std::string over;      // surface that it bends over; empty: straight
  double side = 0;       // from that surface's centre towards the band, about the bone, as
                         // NetPlace::angle [rad]
};

/// One place where a muscle pulls on the net.
struct NetPullPlan {
  std::string node;
  double share = 1;    // of the muscle's tension [1]
  StrandPoint exit;    // where it leaves the net; none: where the muscle's own path is left
  std::string over;    // surface that it bends over; empty: straight
  double EA = 0;       // of the run inside the net, for muscles given by length [N]
};

/// What pulls the net. Shares that do not add up to one leave the rest to the bone, along the whole
/// path of the muscle.
struct NetMusclePlan {
  std::string role;                // "EDC"
  std::vector<std::string> names;  // of the subject's muscles that have this role
  BoneRole exit = BoneRole::kMetacarpal;  // its own path is left at its last point up to this bone
  bool optional = false;                  // a finger without it still has the net
  bool hood_share = false;  // the subject's own fraction into the hood, if it has a rule, goes
                            // before the shares here
  std::vector<NetPullPlan> pulls;
};

/// Bands whose tensions make up the slips of the hood.
struct NetSlips {
  std::vector<std::string> central, radial, ulnar, terminal;
};

struct NetDescription {
  std::string name;
  std::string description;
  std::string source;                                      // citation keys, "A, B"
  std::map<BoneRole, double> bone_lengths;                 // of the reference finger [m]
  std::map<FingerJoint, std::vector<std::string>> height;  // strands whose arm at the straight
                                                           // finger is the extensor's height
  double friction = 0;                                     // of nodes on bone [1]
  std::vector<NetSurface> surfaces;
  std::vector<NetNodePlan> nodes;
  std::vector<NetBandPlan> bands;
  std::vector<NetMusclePlan> muscles;
  NetSlips slips;
};

/// Reads a net from TOML; the format is in docs/data_format.md.
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] NetDescription read_net(const std::string& path);

/// The same from text already in memory; `path` only names it in messages.
[[nodiscard]] NetDescription parse_net(const std::string& text, const std::string& path);

}  // namespace thenar
