#pragma once

/// Subjects: a hand, or one digit, as plain data.
///
/// Everything is stated in one reference posture, in one right-handed frame of the subject, in SI.
/// A joint is an axis (point and direction) fixed in its parent segment; at the reference posture
/// every joint angle is zero.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/enum_names.h"
#include "base/units.h"

namespace thenar {

/// A rigid bone with the soft tissue that moves with it.
struct Segment {
  std::string name;              // e.g. "PP3": proximal phalanx of the middle finger
  double mass = 0;               // [kg]; 0 if unknown
  Eigen::Vector3d com{0, 0, 0};  // centre of mass [m] (3)
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // inertia about com [kg m^2] (3, 3)
  Eigen::Vector3d proximal{0, 0, 0};                  // end nearer the wrist [m] (3)
  Eigen::Vector3d distal{0, 0, 0};                    // end nearer the tip   [m] (3)
  double radius = 0;  // radius of the skin around the bone [m]; 0 if unknown
};

/// Joint `name` turns by  ratio * (angle of leader) + offset  instead of freely.
struct Coupling {
  std::string leader;  // name of the joint that leads
  double ratio = 1;    // [rad/rad]
  double offset = 0;   // [rad]
};

/// One end of a joint's passive moment: capsule, ligaments and skin that stiffen as the joint turns
/// by x past its rest,  moment (exp(x / width) - 1), against the turn.
struct PassiveEnd {
  double moment = 0;  // [N m]; 0: none
  double width = 1;   // turn by which the moment grows e-fold [rad], above 0
};

/// Switch of the joints' passive moments.
enum class PassiveMoments { kOn, kOff };
inline constexpr std::array kPassiveNames{EnumName{PassiveMoments::kOn, "on"},
                                          EnumName{PassiveMoments::kOff, "off"}};

/// A hinge about a general (skewed) axis. A universal joint is two hinges in a row.
struct JointAxis {
  std::string name;                    // name; in our files "MCP3_FE", "PIP3", "CMC1_AA"
  std::string parent;                  // segment that carries the axis
  std::string child;                   // segment that it moves
  Eigen::Vector3d direction{1, 0, 0};  // unit; angle + flexes, turns radially, pronates (3)
  Eigen::Vector3d point{0, 0, 0};      // any point of the axis [m] (3)
  double direction_sd = 0;             // sd of repeated measurements [rad]; 0 if unknown
  double point_sd = 0;                 // sd of repeated measurements [m]; 0 if unknown
  double lower = -kPi;                 // joint limit [rad]
  double upper = kPi;                  // joint limit [rad]
  double rest = 0;                     // angle without passive torque [rad]
  double stiffness = 0;                // passive torque = -stiffness (q - rest) [N m/rad], less
  PassiveEnd flexing, extending;       // passive moment towards each end, see passive_moment()
  double passive_spread = 0;           // sd of the logarithm of passive moments between people
                                       // [1]; 0 if unknown
  double damping = 0;                  // [N m s/rad]
  std::optional<Coupling> coupling;    // absent: the joint is free
};

/// Shapes of wrapping surfaces.
enum class SurfaceShape { kCylinder, kSphere, kEllipsoid, kCapsule, kTorus };
inline constexpr std::array kSurfaceShapeNames{
    EnumName{SurfaceShape::kCylinder, "cylinder"}, EnumName{SurfaceShape::kSphere, "sphere"},
    EnumName{SurfaceShape::kEllipsoid, "ellipsoid"}, EnumName{SurfaceShape::kCapsule, "capsule"},
    EnumName{SurfaceShape::kTorus, "torus"}};

/// A surface of a bone or a pulley, over which tendons slide. In its own frame:
///   cylinder   radius size[0] about z, endless; size[1] half length, for drawing only
///   sphere     radius size[0]
///   ellipsoid  semi-axes size[0..2] along x, y, z
///   capsule    radius size[0] about the segment |z| <= size[1]
///   torus      tube of radius size[0] about the ring of radius size[1] in the plane z = 0
struct Surface {
  std::string name;
  std::string segment;  // segment that carries it
  SurfaceShape shape = SurfaceShape::kSphere;
  Eigen::Vector3d size{0, 0, 0};                       // [m] (3)
  Eigen::Vector3d center{0, 0, 0};                     // reference posture [m] (3)
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // columns x, y, z of its frame (3, 3)
};

/// A point of a tendon's path, fixed in a segment, or a surface over which the path bends.
struct PathPoint {
  std::string segment;         // segment that carries the point
  Eigen::Vector3d p{0, 0, 0};  // position at the reference posture [m] (3)
  double sd = 0;               // sd of each coordinate [m]; 0 if unknown
  std::string surface;   // surface over which the path bends where necessary, on the side where p
                         // is; or empty
  std::string rides_on;  // strand from which the path originates and with which it moves
                         // (lumbricals); or empty
};

/// A run of tendon under one tension.
struct Strand {
  std::string name;                    // "FDP", or a band of the hood: "TE", "RB", "UB", "ES"
  std::vector<PathPoint> path;         // points from insertion to origin; empty: arms only
  std::map<std::string, double> arms;  // joint -> constant moment arm, flexion + [m]
};

/// A muscle: a bounded pull on one strand.
struct MuscleUnit {
  std::string name;                 // "EDC"
  std::string strand;               // strand on which it pulls with its whole force: "LE"
  std::optional<double> max_force;  // F0 [N]; absent if unknown, 0 for a muscle that cannot pull
  double pcsa = 0;                  // physiological cross-section [m^2]; 0 if unknown
  double fibre_length = 0;          // optimal [m]; 0 if unknown
  double tendon_slack = 0;          // tendon slack length [m]; 0 if unknown
  double pennation = 0;             // [rad]
};

/// Lateral band of the hood that a muscle feeds.
enum class HoodSide { kRadial, kUlnar, kBoth };
inline constexpr std::array kHoodSideNames{EnumName{HoodSide::kRadial, "radial"},
                                           EnumName{HoodSide::kUlnar, "ulnar"},
                                           EnumName{HoodSide::kBoth, "both"}};

/// Share of a muscle in the extensor hood: of its tension t, `into_hood * t` enters the hood,
/// `to_central` of this goes to the central slip and the rest to the lateral band(s).
struct HoodBranch {
  std::string muscle;
  HoodSide side = HoodSide::kBoth;
  double into_hood = 1;     // [1], in 0..1
  double to_central = 0.5;  // [1], in 0..1
};

/// Fixed-fraction rule of the extensor mechanism of one digit. The terminal slip carries the sum of
/// both lateral bands.
struct HoodRule {
  std::string central_slip;  // strand names
  std::string radial_band;
  std::string ulnar_band;
  std::string terminal_slip;
  std::vector<HoodBranch> branches;
};

/// A digit: its tip, its own directions, and its hood.
struct Digit {
  std::string name;                   // thumb|index|middle|ring|little
  std::string tip_segment;            // segment of the fingertip: "DP3"
  Eigen::Vector3d tip{0, 0, 0};       // point at which fingertip forces act [m] (3)
  Eigen::Vector3d proximal{0, 1, 0};  // unit, fixed in the tip segment (3)
  Eigen::Vector3d dorsal{0, 0, 1};    // unit, fixed in the tip segment (3)
  Eigen::Vector3d radial{1, 0, 0};    // unit, fixed in the tip segment (3)
  std::optional<HoodRule> hood;
};

/// A published map from tendon tensions to tip force and torque, at one posture.
struct TipMap {
  std::string name;  // name of this map
  std::string digit;
  std::vector<std::string> rows;     // "Fx", "Fy", "Fz" [N], "tx".. [N m]
  std::vector<std::string> muscles;  // columns
  Eigen::MatrixXd A;                 // tip wrench per unit tension (rows, muscles) [1], [m]
};

struct Experiment;

/// Forces to which a subject's numbers were fitted: those of an experiment, or of all specimens of
/// a publication.
struct CalibratedOn {
  std::string experiment;   // "synek2019_H01"; empty: all of `source`
  std::string specimen;     // "H01"
  std::string source = {};  // citation key, "Synek2019"; empty: this experiment alone
};

/// Returns whether one of `seen` is this experiment, another one on the same specimen, or all of
/// the publication that it comes from. Predictions of its forces are then not independent of the
/// data.
[[nodiscard]] bool has_seen(const std::vector<CalibratedOn>& seen, const Experiment& experiment);

/// A whole subject; joints are in order from the wrist to the tips.
struct Subject {
  std::string name;
  std::string description;
  std::string side;             // "right" or "left"
  std::string base;             // segment that does not move
  double reference_length = 0;  // length that normalised path points [m]; 0: none
  std::vector<Segment> segments;
  std::vector<JointAxis> joints;
  std::vector<Surface> surfaces;
  std::vector<Strand> strands;
  std::vector<MuscleUnit> muscles;
  std::vector<Digit> digits;
  std::vector<TipMap> tip_maps;
  std::map<std::string, double> lengths;    // hand length, breadth... [m]
  std::vector<CalibratedOn> calibrated_on;  // empty: no number was fitted to measured forces
};

/// Returns "on" or "off" as people type it. @throws InputError for any other word
[[nodiscard]] PassiveMoments passive_named(const std::string& word);

/// Returns the subject with joints that turn without passive moments, dampers apart, or as it is.
[[nodiscard]] Subject with_passive(Subject subject, PassiveMoments passive);

/// Returns the joints between the base and a segment, the last first; they point into the subject.
[[nodiscard]] std::vector<const JointAxis*> joints_to(const Subject& subject, std::string segment);

/// Returns whether a joint has a passive moment.
[[nodiscard]] bool has_passive(const JointAxis& joint);

/// Reads a subject from TOML; the format is in docs/data_format.md.
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] Subject read_subject(const std::string& path);

/// Parses a subject from text already in memory; `path` only names it in messages.
[[nodiscard]] Subject parse_subject(const std::string& text, const std::string& path);

}  // namespace thenar
