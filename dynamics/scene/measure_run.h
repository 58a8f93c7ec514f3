#pragma once

/// Measures of a run of a scene: slip, forces, energy.

#include <optional>
#include <vector>

#include "base/spatial.h"
#include "data/io/scene/scene.h"
#include "dynamics/scene/measure_pulls.h"
#include "dynamics/stepping/energy_balance.h"

namespace thenar {

struct TreeModel;

/// Two bodies that touched.
struct PairMeasure {
  int a = 0, b = 0;                       // bodies, a < b
  double first = 0, last = 0;             // instants with contact [s]
  double slip = 0;                        // way that one slid on the other [m]
  double largest_force = 0;               // of the instants: sum of the normal forces [N]
  Eigen::Vector3d force{0, 0, 0};         // on a at the end [N] (3)
  int points = 0;                         // with a force at the end
  ContactMode mode = ContactMode::kOpen;  // at the end: slides if one of its points does
  // Of pads, at the end; 0: rigid.
  double area = 0;     // of the patch [m^2]
  double stick = 0;    // share of the normal force on what sticks [1]
  double torsion = 0;  // on a about the normal [N m]
};

/// Measures over the instants of a run.
struct RunMeasures {
  std::vector<PairMeasure> pairs;      // by rising (a, b)
  double work = 0;                     // of forces, drives and muscles on the scene [J]
  double dissipated = 0;               // by contacts, impacts, friction and dampers [J]
  std::optional<FlowBalance> balance;  // to the end; nothing: the method has no flows of energy
  std::optional<FlowBalance> worst;    // worst_balance()
  std::vector<std::vector<Pose<double>>> X_WB;  // (instants, bodies)
  std::vector<std::size_t> moving;              // moving_bodies()
  RunPulls pulls;                               // of human hands
  std::vector<SceneVelocity> velocity;  // of the bodies at the end, centres of mass (bodies)
};

/// Bodies with mass or surface that are not fixed to the world; frames of joints have neither.
[[nodiscard]] std::vector<std::size_t> moving_bodies(const Mechanism& mechanism,
                                                     const TreeModel& model);

/// Velocities of all bodies at positions and speeds: of their centres of mass, those of bodies that
/// are fixed to the world 0 (bodies).
[[nodiscard]] std::vector<SceneVelocity> body_velocities(const Mechanism& mechanism,
                                                         const TreeModel& model,
                                                         const Eigen::VectorXd& q,
                                                         const Eigen::VectorXd& v);

/// Measures a run from the instants that it kept.
///
/// Slip of a pair is the sum of slips_between() its instants.
///
/// Work and dissipation are those of the steps, whatever instants were kept (SceneSample::w).
///
/// Where the method has none (springs for contacts), work is summed over the instants: of a force
/// that acts all along, exact; of a drive, by Gauss's three points on the cubic through its
/// coordinate and rate; of a moment, along the turn. What begins or ends between two instants
/// counts by the instant in their middle. Then what is dissipated is what the balance leaves.
[[nodiscard]] RunMeasures measure_run(const MovingScene& scene, const SceneRun& run);

}  // namespace thenar
