#pragma once

/// Demo of the main applications on real data: middle fingers of two hands fitted to measured
/// forces, and more.

#include <optional>
#include <string>
#include <vector>

#include "api/compare.h"
#include "api/pads/press_pad.h"
#include "api/scenes/compare_rungs.h"
#include "api/scenes/simulate_scene.h"
#include "api/tendon_solve.h"
#include "base/parallel_tasks.h"
#include "base/progress.h"
#include "dynamics/scene/pad_angle.h"
#include "dynamics/scene/work_precision.h"
#include "kinematics_fit/bands/hood_comparison.h"
#include "posterior/run/posterior_summary.h"
#include "solvers/status.h"
#include "studies/questions/fit_study.h"
#include "studies/questions/study.h"

namespace thenar {

struct DemoRequest {
  std::string data;               // folder with subjects/, fits/ and experiments/
  std::string output;             // folder for results: NAME.h5 of fits, NAME.nc of posteriors
  RunRecord run;                  // record of the run for the files
  std::optional<Path> path = {};  // tendon paths of human hands in scenes; absent: default_path()
};

/// Posterior sampled by the demo.
struct DemoPosterior {
  std::string name;  // name of the experiment, or "population"
  PosteriorRun run;
  std::vector<Prediction> fitted,
      unseen;  // of each experiment of the run; of each other one
  LeftOutObservations left_out;
};

/// Extensor hood of the middle finger during flexion, with DIP at two thirds of PIP.
struct DemoHood {
  TendonSweepResult sweep;
  std::vector<HoodComparison> rungs;  // every rung of hood beside each experiment
};

/// Thumb with its posture.
struct DemoThumb {
  std::string title;
  Subject subject;
  std::map<std::string, double> posture;  // joint -> angle [rad]
  Eigen::Vector3d dorsal{0, 1, 0};        // dorsal direction of the palm, subject's frame (3)
};

/// Simulated scenes.
struct DemoMotion {
  SceneResult glass;                 // figure 3 of [Miller2005]: data/scenes/wine_glass.toml
  SceneResult thumb, thumb_on_pins;  // figure 8 of [Miller2005]: thumb_mug.toml, with compliant and
                                     // with rigid joints
  std::vector<PadState> pad, pad_on_pins;  // states of the thumb's pad against the mug
  std::vector<WorkPoint> work;             // ball_on_ball.toml: cost, error of the ball's place [m]
};

struct DemoResult {
  StudyInputs inputs;
  std::vector<SpecimenStudy> specimens;       // each specimen alone
  std::optional<PopulationStudy> population;  // both specimens together; absent: stopped
  std::vector<DemoPosterior> posteriors;      // posteriors of each specimen alone, and of both
  ThumbStudyResult thumb_study;
  ThumbRecoveryResult thumb_recovery;  // simulated data, and measurements
  DemoHood hood;
  std::vector<DemoThumb> thumbs;
  DemoMotion motion;
  CompareResult hands;             // a human and three robot hands on two objects
  PressResult pad;                 // press by a ball
  RungComparison pencil;           // pencil pinched by pads, on every rung
  std::vector<std::string> files;  // written files
  Outcome outcome;                 // stopped: parts are missing, and no fit was written
};

/// Fits by every solver, cross-validates, predicts unseen specimens, samples posteriors, computes
/// the information of forces about a thumb's axes, recovers a thumb from simulated forces and
/// muscle activity and adds measurements, flexes a finger with its hood, simulates scenes, compares
/// hands in grasping and presses pads. Takes some minutes of all cores. Results are bitwise equal
/// for any number of cores, except times and the last digits of Ipopt, whose BLAS depends on memory
/// alignment.
/// @throws InputError if data are missing or the folder cannot be written.
[[nodiscard]] DemoResult run_demo_study(const DemoRequest& request, const Progress& progress = {});

/// Returns tasks that simulate the scenes of the demo.
/// @param data  folder with scenes/, robots/ ..; empty: the usual ones
/// @param path  see DemoRequest
/// @param motion  receives their results; must outlive them
[[nodiscard]] std::vector<ParallelTask> demo_scene_tasks(const std::string& data,
                                                         const std::optional<Path>& path,
                                                         DemoMotion& motion);

/// Simulates the scenes of the demo, which takes some seconds.
[[nodiscard]] DemoMotion move_demo_scenes(const std::string& data, const Progress& progress = {},
                                          const std::optional<Path>& path = {});

}  // namespace thenar
