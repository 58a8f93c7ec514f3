#pragma once

/// Options of a run of a scene, and what it gives: states at instants, cost and accuracy.

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
  kEvents,            // extrapolated steps between events, their length by an error estimate
  kTimeStepping,      // midpoint steps of a fixed length, events within them, no bounces
  kCompliantSimbody,  // springs for contacts, all by Simbody: see dynamics/compliant/
  kCompliantSundials  // springs for contacts, by our own machine and CVODE: the same
};
inline constexpr std::array kSteppingMethodNames{
    EnumName{SteppingMethod::kEvents, "events"},
    EnumName{SteppingMethod::kTimeStepping, "time-stepping"},
    EnumName{SteppingMethod::kCompliantSimbody, "compliant-simbody"},
    EnumName{SteppingMethod::kCompliantSundials, "compliant-sundials"}};

struct SceneOptions {
  SteppingMethod method = SteppingMethod::kEvents;
  double seconds = 1;       // how long [s]
  double sample = 1e-2;     // between the instants that are kept [s]
  double step = 1e-3;       // kTimeStepping: of every step [s]
  double longest = 2e-2;    // all but kTimeStepping: step; by events five times that where nothing
                            // moves by 0.1 mm [s]
  double tolerance = 1e-9;  // the same: error of a step, in positions [m], [rad], and in speeds
                            // over 100 [m/s], [rad/s]
  double shortest = 1e-9;   // kEvents, kTimeStepping: no step is halved below this [s]
  double touch = 1e-9;      // kEvents: gaps below this touch [m]
  double recovery = 0.1;    // speed at which depth at the start is pushed out [m/s]
  ContactSolverOptions contacts{};  // kPyramid: the complementarity problem of [Miller2005]; the
                                    // tolerance of fixed steps is what ContactStep allows them
  int columns = 5;                  // kEvents: most of the extrapolation, 2..8; its highest order
  bool sleep = true;                // kEvents: what rests stays as it is until something switches
  ContactCompliance compliance{};   // kCompliantSimbody, kCompliantSundials
};

/// @throws InputError if an option is impossible.
void check_scene_options(const SceneOptions& options);

/// Energies at a state. Springs are those of joints and elements.
struct SceneEnergy {
  double kinetic = 0, weight = 0, springs = 0;  // [J]
  double of_elements = 0;  // the part of `springs` in elements that are not passive [J]
  double of_passive = 0;   // the part of `springs` in passive elements [J]
  [[nodiscard]] double total() const { return kinetic + weight + springs; }
};

/// One instant of a run.
struct SceneSample {
  double t = 0;                         // [s]
  Eigen::VectorXd q, v, z;              // as SceneState
  std::vector<ContactSample> contacts;  // that do not open; forces are means of the last substep,
                                        // of first order in its length
  SceneEnergy energy;                   // [J]; springs also hold that of compliant contacts
  Eigen::VectorXd w;  // EnergyFlows since the start [J] (7); empty: the method has none
};

/// Ending of a run.
enum class SceneStatus {
  kDone,
  kStopped,    // the caller asked for it
  kUnsolved,   // went on, but contact problems missed their tolerance: see `unsolved`
  kNotFinite,  // positions or speeds became infinite; all before that is kept
  kFailed,     // the integrator could not go on, see `message`; all before that is kept
  kUnbalanced  // at the end, but its energy does not balance: FlowBalance::holds()
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

/// Cost of a run, and its accuracy.
struct SceneCost {
  long steps = 0;     // accepted
  long rejected = 0;  // for their error, or an event within them
  long substeps = 0;  // contact problems or accelerations
  long impacts = 0;
  long passed = 0;            // piles of events that steps of fixed length went through
  long unsolved = 0;          // contact problems beyond the tolerance
  long leaps = 0;             // steps of fixed length in parts as short as can be in which surfaces
                              // moved so far that they may have gone through each other
  long coarse = 0;            // steps as short as can be whose error is beyond the tolerance
  double worst_residual = 0;  // ContactResidual::natural over all steps [1]
  double deepest = 0;         // penetration at the end of any step, after the first [m]
  Eigen::VectorXd beyond{};   // of joints, the farthest way beyond a limit at the end of any step
                              // [rad] or [m] (joints); empty: not asked
  double asleep = 0;          // time that passed at rest [s]
  double cpu_seconds = 0;     // of this thread
};

struct [[nodiscard]] SceneRun {
  SceneStatus status = SceneStatus::kDone;
  std::vector<SceneSample> samples;  // the start first
  SceneCost cost;
  std::string message;  // what went wrong, and when, where the status is kFailed
};

}  // namespace thenar
