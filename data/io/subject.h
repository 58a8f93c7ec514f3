#pragma once

/// A hand (or one digit of it) described once, as plain data.
///
/// Everything is stated in one reference posture, in one right-handed frame of the
/// subject, in SI: a joint is an axis (point and direction) fixed in its parent
/// segment, and at the reference posture every joint angle is zero.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/units.h"

namespace thenar {

/// A rigid bone with the soft tissue that moves with it.
struct Segment {
  std::string name;              // e.g. "PP3": proximal phalanx of the middle finger
  double mass = 0;               // [kg]; 0 if unknown
  Eigen::Vector3d com{0, 0, 0};  // centre of mass [m] (3)
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about com [kg m^2] (3, 3)
  Eigen::Vector3d proximal{0, 0, 0};                  // end nearer the wrist [m] (3)
  Eigen::Vector3d distal{0, 0, 0};                    // end nearer the tip   [m] (3)
  double radius = 0;  // of the skin around the bone [m]; 0 if unknown
};

/// Joint `name` turns by  ratio * (angle of leader) + offset  instead of freely.
struct Coupling {
  std::string leader;  // name of the joint that leads
  double ratio = 1;    // [rad/rad]
  double offset = 0;   // [rad]
};

/// One hinge: a general (skewed) axis. A universal joint is two of these in a row.
struct JointAxis {
  std::string name;                    // ISB style: "MCP3_FE", "PIP3", "CMC1_AA"
  std::string parent;                  // segment that carries the axis
  std::string child;                   // segment that it moves
  Eigen::Vector3d direction{1, 0, 0};  // unit; positive angle flexes, abducts, pronates (3)
  Eigen::Vector3d point{0, 0, 0};      // any point of the axis [m] (3)
  double direction_sd = 0;             // of repeated measurements [rad]; 0 if unknown
  double point_sd = 0;                 // of repeated measurements [m]; 0 if unknown
  double lower = -kPi;                 // joint limit [rad]
  double upper = kPi;                  // joint limit [rad]
  double rest = 0;                     // angle without passive torque [rad]
  double stiffness = 0;                // passive torque = -stiffness (q - rest) [N m/rad]
  double damping = 0;                  // [N m s/rad]
  std::optional<Coupling> coupling;    // absent: the joint is free
};

/// Shapes of wrapping surfaces.
enum class SurfaceShape { kCylinder, kSphere, kEllipsoid, kCapsule, kTorus };

/// A surface of a bone, or of a pulley, over which tendons slide. In its own frame:
///   cylinder   radius size[0] about z, endless; size[1] half length, for drawing only
///   sphere     radius size[0]
///   ellipsoid  semi-axes size[0..2] along x, y, z
///   capsule    radius size[0] about the segment |z| <= size[1]
///   torus      tube of radius size[0] about the ring of radius size[1] in the plane z = 0
struct Surface {
  std::string name;
  std::string segment;  // that carries it
  SurfaceShape shape = SurfaceShape::kSphere;
  Eigen::Vector3d size{0, 0, 0};                       // [m] (3)
  Eigen::Vector3d center{0, 0, 0};                     // reference posture [m] (3)
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // columns x, y, z of its frame (3, 3)
};

/// A point that a tendon runs through, fixed in a segment, or a surface that it bends over.
struct PathPoint {
  std::string segment;         // segment that carries the point
  Eigen::Vector3d p{0, 0, 0};  // at the reference posture [m] (3)
  double sd = 0;               // of each coordinate [m]; 0 if unknown
  std::string surface;         // not empty: bends over it where it must, on the side where p is
  std::string rides_on;        // not empty: grows from this strand and moves with it (lumbricals)
};

/// A run of tendon under one tension.
struct Strand {
  std::string name;                    // "FDP", or a band of the hood: "TE", "RB", "UB", "ES"
  std::vector<PathPoint> path;         // from insertion to origin; empty: arms only
  std::map<std::string, double> arms;  // joint -> constant moment arm, flexion + [m]
};

/// A muscle, as a bounded pull on one strand.
struct MuscleUnit {
  std::string name;                 // "EDC"
  std::string strand;               // the strand that it pulls whole: "LE"
  std::optional<double> max_force;  // F0 [N]; absent if unknown, 0 for a muscle that cannot pull
  double pcsa = 0;                  // physiological cross-section [m^2]; 0 if unknown
  double fibre_length = 0;          // optimal [m]; 0 if unknown
  double tendon_slack = 0;          // tendon slack length [m]; 0 if unknown
  double pennation = 0;             // [rad]
};

/// Which lateral band of the hood a muscle feeds.
enum class HoodSide { kRadial, kUlnar, kBoth };

/// What a muscle gives to the extensor hood: of tension t, `into_hood * t` enters it,
/// `to_central` of that goes to the central slip and the rest to the lateral band(s).
struct HoodBranch {
  std::string muscle;
  HoodSide side = HoodSide::kBoth;
  double into_hood = 1;     // [1], in 0..1
  double to_central = 0.5;  // [1], in 0..1
};

/// The fixed-fraction rule of the extensor mechanism of one digit.
/// The terminal slip carries the sum of both lateral bands.
struct HoodRule {
  std::string central_slip;  // strand names
  std::string radial_band;
  std::string ulnar_band;
  std::string terminal_slip;
  std::vector<HoodBranch> branches;
};

/// A digit: its tip, its own directions, its tendons' hood.
struct Digit {
  std::string name;                   // thumb|index|middle|ring|little
  std::string tip_segment;            // "DP3"
  Eigen::Vector3d tip{0, 0, 0};       // where fingertip forces act [m] (3)
  Eigen::Vector3d proximal{0, 1, 0};  // unit, fixed in the tip segment (3)
  Eigen::Vector3d dorsal{0, 0, 1};    // unit, fixed in the tip segment (3)
  Eigen::Vector3d radial{1, 0, 0};    // unit, fixed in the tip segment (3)
  std::optional<HoodRule> hood;
};

/// A published map from tendon tensions to tip force and torque, at one posture.
struct TipMap {
  std::string name;  // which of the subject's maps
  std::string digit;
  std::vector<std::string> rows;     // "Fx", "Fy", "Fz" [N], "tx".. [N m]
  std::vector<std::string> muscles;  // columns
  Eigen::MatrixXd A;                 // tip wrench per unit tension (rows, muscles)
};

/// A specimen whose measured forces a subject's numbers were fitted to.
struct CalibratedOn {
  std::string experiment;  // its name: "synek2019_H01"
  std::string specimen;    // that it was done on: "H01"
};

/// Was one of them this experiment, or another one on its specimen? Whoever predicts such forces
/// has seen the specimen before.
[[nodiscard]] bool has_seen(const std::vector<CalibratedOn>& seen, const std::string& experiment,
                            const std::string& specimen);

/// The whole description; joints stand in order from the wrist to the tips.
struct Subject {
  std::string name;
  std::string description;
  std::string side;             // "right" or "left"
  std::string base;             // segment that does not move
  double reference_length = 0;  // that path points were normalised by [m]; 0 if none
  std::vector<Segment> segments;
  std::vector<JointAxis> joints;
  std::vector<Surface> surfaces;
  std::vector<Strand> strands;
  std::vector<MuscleUnit> muscles;
  std::vector<Digit> digits;
  std::vector<TipMap> tip_maps;
  std::map<std::string, double> lengths;    // hand length, breadth... [m]
  std::vector<CalibratedOn> calibrated_on;  // empty: its numbers come from no measured force
};

/// Reads a subject from TOML; the format is in docs/data_format.md.
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] Subject read_subject(const std::string& path);

/// The same from text already in memory; `path` only names it in messages.
[[nodiscard]] Subject parse_subject(const std::string& text, const std::string& path);

}  // namespace thenar
