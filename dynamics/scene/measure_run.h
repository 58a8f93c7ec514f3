#pragma once

/// Measures of a scene's run: slip, contact forces, energies.

#include <optional>
#include <vector>

#include "base/spatial.h"
#include "data/io/scene/scene.h"
#include "dynamics/scene/measure_pulls.h"
#include "dynamics/stepping/energy_balance.h"

namespace thenar {

struct TreeModel;

/// Measures of two bodies that were in contact.
struct PairMeasure {
  int a = 0, b = 0;                       // indices of the bodies, a < b
  double first = 0, last = 0;             // first and last instant with contact [s]
  double slip = 0;                        // distance that one body slid on the other [m]
  double largest_force = 0;               // largest sum of the normal forces at an instant [N]
  Eigen::Vector3d force{0, 0, 0};         // force on a at the end [N] (3)
  int points = 0;                         // number of contact points at the end
  ContactMode mode = ContactMode::kOpen;  // mode at the end: slides if any point slides
  // Values of a pad at the end; 0 for rigid contacts
  double area = 0;     // area of the contact patch [m^2]
  double stick = 0;    // share of the normal force on sticking parts of the patch [1]
  double torsion = 0;  // moment on a about the normal [N m]
};

/// Measures over the instants of a run.
struct RunMeasures {
  std::vector<PairMeasure> pairs;      // pairs by rising (a, b)
  double work = 0;                     // work of forces, drives and muscles on the scene [J]
  double dissipated = 0;               // energy lost in contacts, impacts, friction, dampers [J]
  std::optional<FlowBalance> balance;  // energy balance at the end; none: the method has no flows
  std::optional<FlowBalance> worst;    // worst energy balance of all instants, worst_balance()
  std::vector<std::vector<Pose<double>>> X_WB;  // poses of the bodies (instants, bodies)
  std::vector<std::size_t> moving;              // indices of moving_bodies()
  RunPulls pulls;                               // muscles of human hands
  std::vector<SceneVelocity> velocity;  // velocities of the centres of mass at the end (bodies)
};

/// Returns the indices of bodies that have mass or a surface and are not fixed to the world.
[[nodiscard]] std::vector<std::size_t> moving_bodies(const Mechanism& mechanism,
                                                     const TreeModel& model);

/// Returns the velocities of the centres of mass of all bodies at positions q and speeds v; zero
/// for bodies that are fixed to the world (bodies).
[[nodiscard]] std::vector<SceneVelocity> body_velocities(const Mechanism& mechanism,
                                                         const TreeModel& model,
                                                         const Eigen::VectorXd& q,
                                                         const Eigen::VectorXd& v);

/// Measures a run from its samples.
///
/// The slip of a pair is the sum of slips_between() consecutive samples.
///
/// Work and dissipation are those of the steps (SceneSample::w), whatever samples were kept.
/// Compliant methods do not record them; their work is then integrated between samples: exactly for
/// a constant force, along the rotation for a moment, and by three-point Gauss quadrature for a
/// drive, on the cubic Hermite interpolation of its coordinate. A force acts in an interval if it
/// acts in its middle. The dissipation is what remains in the energy balance.
[[nodiscard]] RunMeasures measure_run(const MovingScene& scene, const SceneRun& run);

}  // namespace thenar
