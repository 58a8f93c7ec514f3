#pragma once

/// Options and results of a scene's simulation: sampled states, cost and accuracy.

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/enum_names.h"
#include "contact/contact_solver.h"
#include "dynamics/stepping/contact_compliance.h"
#include "dynamics/stepping/contact_sample.h"

namespace thenar {

/// Method of time integration.
enum class SteppingMethod {
  kEvents,            // extrapolated steps between events, step size by an error estimate
  kTimeStepping,      // midpoint steps of fixed length, events within them, no restitution
  kCompliantSimbody,  // compliant contacts, all by Simbody: see dynamics/compliant/
  kCompliantSundials  // compliant contacts, by this project's multibody code and CVODE
};
inline constexpr std::array kSteppingMethodNames{
    EnumName{SteppingMethod::kEvents, "events"},
    EnumName{SteppingMethod::kTimeStepping, "time-stepping"},
    EnumName{SteppingMethod::kCompliantSimbody, "compliant-simbody"},
    EnumName{SteppingMethod::kCompliantSundials, "compliant-sundials"}};

/// Options of a simulation. A comment names the methods that use an option; without one, all do.
struct SceneOptions {
  SteppingMethod method = SteppingMethod::kEvents;
  double duration = 1;            // simulated time [s]
  double sample_interval = 1e-2;  // time between samples [s]
  double step_length = 1e-3;      // kTimeStepping: step length [s]
  double max_step = 2e-2;         // all but kTimeStepping: longest step; five times that by kEvents
                                  // without elements while nothing moves by 0.1 mm, 0.1 mrad [s]
  double tolerance = 1e-9;  // all but kTimeStepping: error of a step in positions [m], [rad], and
                            // in velocities over 100 [m/s], [rad/s]
  double min_step = 1e-9;   // kEvents, kTimeStepping: shortest step [s]
  double touch = 1e-9;      // kEvents: largest gap that counts as closed [m]
  double recovery = 0.1;  // kEvents, kTimeStepping: speed at which penetration is pushed out [m/s]
  ContactSolverOptions contacts{};  // contact solver; kPyramid: the complementarity problem of
                                    // [Miller2005]; ContactStep sets the tolerance of fixed steps
  int columns = 5;                  // kEvents: highest order of extrapolation, 2..8
  bool sleep = true;  // kEvents: a resting scene is not integrated until something switches
  ContactCompliance compliance{};  // kCompliantSimbody, kCompliantSundials: laws of contact
};

/// Checks options. @throws InputError if one is out of range.
void check_scene_options(const SceneOptions& options);

/// Energies at a state.
struct SceneEnergy {
  double kinetic = 0, weight = 0;  // kinetic energy; gravitational energy [J]
  double springs = 0;              // energy of springs of joints, and of all elements [J]
  double of_elements = 0;          // part of `springs` in elements that are not passive [J]
  double of_passive = 0;           // part of `springs` in passive elements [J]
  [[nodiscard]] double total() const { return kinetic + weight + springs; }
};

/// Sampled state of a simulation.
struct SceneSample {
  double t = 0;                         // time [s]
  Eigen::VectorXd q, v, z;              // positions, velocities, element states: SceneState
  std::vector<ContactSample> contacts;  // closed contacts; forces are means over the last substep,
                                        // accurate to first order in its length
  SceneEnergy energy;                   // energies [J]; `springs` includes compliant contacts
  Eigen::VectorXd w;  // EnergyFlows since the start [J] (7); empty: not computed by the method
};

/// Status of a simulation.
enum class SceneStatus {
  kDone,       // simulated to the end
  kStopped,    // stopped by the caller
  kUnsolved,   // simulated to the end, but contact problems missed their tolerance: see `unsolved`
  kNotFinite,  // positions or velocities became infinite; earlier samples are kept
  kFailed,     // integrator failed, see `message`; earlier samples are kept
  kUnbalanced  // simulated to the end, but its energy does not balance: FlowBalance::holds()
};
inline constexpr std::array kSceneStatusNames{
    EnumName{SceneStatus::kDone, "done"},
    EnumName{SceneStatus::kStopped, "stopped"},
    EnumName{SceneStatus::kUnsolved, "unsolved"},
    EnumName{SceneStatus::kNotFinite, "not finite"},
    EnumName{SceneStatus::kFailed, "failed"},
    EnumName{SceneStatus::kUnbalanced, "energy does not balance"}};
[[nodiscard]] inline std::string name_of(SceneStatus status) {
  return name_in(kSceneStatusNames, status);
}

/// Cost and accuracy of a simulation.
struct SceneCost {
  long steps = 0;             // accepted steps
  long rejected = 0;          // trial steps rejected for their error or an event
  long substeps = 0;          // contact problems solved and accelerations evaluated
  long impacts = 0;           // instants at which impacts were resolved
  long chatter_bursts = 0;    // bursts of fixed steps through chattering contacts
  long unsolved = 0;          // contact problems that missed the tolerance
  long tunnelling_steps = 0;  // fixed steps, divided into the shortest parts, in which surfaces may
                              // still have passed through each other
  long inaccurate_steps = 0;  // shortest steps whose error exceeded the tolerance
  double worst_residual = 0;  // largest ContactResidual::natural of any step [1]
  double max_penetration = 0;      // largest penetration at the end of any step but the first [m]
  Eigen::VectorXd limit_excess{};  // largest excess over a limit at the end of any step [rad] or
                                   // [m] (joints); empty: not recorded
  double rest_time = 0;            // simulated time at rest [s]
  double cpu_seconds = 0;          // processor time of the calling thread [s]
};

/// Result of a simulation.
struct [[nodiscard]] SceneRun {
  SceneStatus status = SceneStatus::kDone;
  std::vector<SceneSample> samples;  // sampled states, the initial one first
  SceneCost cost;
  std::string message;  // kFailed: cause and instant of the failure
};

}  // namespace thenar
