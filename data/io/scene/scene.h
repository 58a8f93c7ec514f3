#pragma once

/// Moving scenes as plain data: bodies and hands on joints, what acts on them, and how to step.

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/error.h"
#include "data/io/scene/joint_kind.h"
#include "data/io/scene/scene_bushing.h"
#include "data/io/scene/scene_compliance.h"
#include "data/io/scene/scene_pad.h"
#include "data/io/world/world.h"

namespace thenar {

/// A joint between a body, or the base of a hand, and its parent at the start: its axis and point
/// in world, where the body then is.
struct SceneJointSpec {
  JointKind kind = JointKind::kFree;
  std::string parent;              // body, or "HAND/LINK"; empty: the world
  Eigen::Vector3d axis{0, 0, 1};   // axis of hinge and slide: unit (3)
  Eigen::Vector3d point{0, 0, 0};  // point on the axis of a hinge, centre of a ball joint [m] (3)
  double start = 0;                // initial value of hinge and slide [rad] or [m]
  double speed = 0;                // initial rate of hinge and slide [rad/s] or [m/s]
  Eigen::Vector3d spin{0, 0, 0};   // initial angular velocity of a ball joint [rad/s] (3)
  double lower = -std::numeric_limits<double>::infinity();  // [rad] or [m]
  double upper = std::numeric_limits<double>::infinity();   // [rad] or [m]
  double stiffness = 0;  // stiffness of a spring to `rest` [N m/rad] or [N/m]
  double rest = 0;       // [rad] or [m]
  double damping = 0;    // [N m s/rad] or [N s/m]
  double friction = 0;   // Coulomb's [N m] or [N]
  int line = 1;          // line in the file
};

/// Velocity of a free body at the start.
struct SceneVelocity {
  Eigen::Vector3d linear{0, 0, 0};   // velocity of the centre of mass [m/s] (3)
  Eigen::Vector3d angular{0, 0, 0};  // [rad/s] (3)
};

/// A body at the start.
struct SceneBodySpec {
  PlacedBody placed;  // body with its pose; its `dynamic` is ignored
  SceneJointSpec joint;
  SceneVelocity velocity;
  int line = 1;
};

/// A hand at the start: a robot or a human hand, by name or file.
struct SceneHandSpec {
  std::string version;                // version of a human hand: "skewed", "tendons:wrapped"
  int skin_triangles = 0;             // human hand: most triangles of a link; 0: default
  std::optional<bool> skin_capsules;  // human hand: links of digits are tapered capsules
  std::optional<bool> passive;        // human hand: its joints have their passive moments
  PlacedHand placed;                  // pose in the world; its carrier is the joint's parent
  SceneJointSpec joint;               // joint of its base; a weld if not stated
  SceneVelocity velocity;
  int line = 1;
};

/// A force or moment of constant direction in world.
struct SceneForceSpec {
  std::string name, body;  // body, or "HAND/LINK"
  std::optional<Eigen::Vector3d>
      point;                        // point in the body's frame [m] (3); absent: its centre of mass
  Eigen::Vector3d force{0, 0, 0};   // [N] (3)
  Eigen::Vector3d moment{0, 0, 0};  // [N m] (3)
  double from = 0;                  // [s]
  double to = std::numeric_limits<double>::infinity();  // [s]
  int line = 1;
};

/// A motor: effort + stiffness (target - value) - damping (rate - speed), cut to the largest.
struct SceneDriveSpec {
  std::string name, coordinate;      // coordinate: a body on a hinge or slide, or "HAND/MOTOR"
  bool turns = false;                // rotational: quantities are those of angles
  double effort = 0;                 // [N m] or [N]
  double stiffness = 0;              // [N m/rad] or [N/m]
  double damping = 0;                // [N m s/rad] or [N s/m]
  double target = 0;                 // initial target [rad] or [m]
  double speed = 0;                  // rate of the target [rad/s] or [m/s]
  std::string target_file;           // table of the target over time; as written; may be empty
  std::optional<double> max_effort;  // [N m] or [N]; absent: the motor's own, if it is known
  double from = 0;                   // [s]
  double to = std::numeric_limits<double>::infinity();  // [s]
  int line = 1;
};

/// Tensions or excitations of a human hand's muscles during a span of time.
struct SceneMuscleSpec {
  std::string hand;
  bool tensions = false;                // [[tendon]]: tensions; [[muscle]]: excitations
  std::map<std::string, double> value;  // tension [N] or excitation 0..1 [1] of muscles
  std::string file;                     // table of the same over time; as written; may be empty
  std::string rung;                     // muscle model of [[muscle]]; empty: rigid tendons
                                        // where fibre lengths are known, else bounds
  double from = 0;                      // [s]
  double to = std::numeric_limits<double>::infinity();  // [s]
  int line = 1;
};

/// Friction of one pair, or the default for pairs without an entry.
struct SceneFrictionSpec {
  std::vector<std::string> between;      // two of body, hand, "HAND/LINK"; empty: all others
  std::optional<double> coefficient;     // [1]; absent: that of the materials
  std::optional<double> torsion_radius;  // [m]
  std::optional<double> restitution;     // 0..1 [1]
  int line = 1;
};

/// Two bodies or links between which contacts are ignored.
struct SceneApartSpec {
  std::vector<std::string> between;  // two of body, hand, "HAND/LINK"
  int line = 1;
};

/// Options of time stepping; absent values are the method's defaults.
struct SteppingSpec {
  std::string method = "events";    // a name of the simulator
  double duration = 1;              // [s]
  double sample = 1e-2;             // time between stored instants [s]
  std::optional<double> step;       // step size of time-stepping [s]
  std::optional<double> longest;    // step between events [s]
  std::optional<double> tolerance;  // error of a step [m] or [rad]
  std::optional<double> recovery;   // speed at which depth is pushed out [m/s]

  // Of contacts that yield.
  std::optional<double> modulus;      // [Pa]
  std::optional<double> stiffness;    // [N/m]
  std::optional<double> dissipation;  // [s/m]
  std::optional<double> layer;        // layer thickness of meshes [m]
  std::optional<double> transition;   // slip speed from which friction is Coulomb's [m/s]
  std::string friction_ramp;          // a name of the simulator; empty: its own
  int line = 1;
};

/// A whole scene.
struct SceneSpec {
  std::string name;
  std::string description;
  std::string source;                    // citation keys of its numbers
  std::string path;                      // path of the file, for messages
  std::string folder;                    // folder of the file, to which its paths are relative
  Eigen::Vector3d gravity{0, 0, -9.81};  // acceleration of free fall [m/s^2] (3)
  std::string materials_file;  // materials file as written; empty: the built-in table alone
  Materials materials = built_in_materials();
  std::vector<SceneBodySpec> bodies;
  std::vector<SceneHandSpec> hands;
  std::vector<SceneForceSpec> forces;
  std::vector<SceneDriveSpec> drives;
  std::vector<SceneMuscleSpec> muscles;  // [[tendon]] and [[muscle]]
  std::vector<SceneFrictionSpec> frictions;
  std::vector<SceneApartSpec> apart;
  std::vector<SceneComplianceSpec> compliances;
  std::vector<SceneLigamentSpec> ligaments;
  std::vector<SceneBushingSpec> bushings;
  std::vector<ScenePadSpec> pads;
  SteppingSpec stepping;
  std::optional<Camera> camera;
  FileDigests files = {};  // digests of all input files except hands
};

/// Largest number of instants that a run keeps [1].
inline constexpr double kMaxSceneSamples = 1e6;

/// Reads a scene (data/scenes) from TOML; docs/data_format.md describes the format. Files named in
/// it are relative to its folder.
/// @param places  folders with robots/, subjects/ and objects/ that names of hands and bodies are
///                found in, as in read_world(), in the order of search; empty: files alone
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] SceneSpec read_scene(const std::string& path,
                                   const std::vector<std::string>& places = {});
[[nodiscard]] SceneSpec parse_scene(const std::string& text, const std::string& path,
                                    const std::vector<std::string>& places = {});

/// Checks that parts have names of their own and name only what is there, that parents lead to the
/// world, and that there is something to move; parse_scene() does.
/// @throws DataError at the line of the part.
void check_scene_spec(const SceneSpec& scene);

}  // namespace thenar
