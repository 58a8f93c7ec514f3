#pragma once

/// Readers of any file, given by path or name: subjects, experiments, nets, worlds ..

#include <string>
#include <variant>
#include <vector>

#include "api/named/files.h"
#include "data/io/anthropometry.h"
#include "data/io/axis_variability.h"
#include "data/io/experiment.h"
#include "data/io/fit_settings.h"
#include "data/io/net_description.h"
#include "data/io/pad/law_file.h"
#include "data/io/pad/pad.h"
#include "data/io/pad/pad_data.h"
#include "data/io/result_file.h"
#include "data/io/robot/robot.h"
#include "data/io/scene/scene.h"
#include "data/io/subject.h"
#include "data/io/world/world.h"
#include "kinematics_fit/fit.h"
#include "posterior/run/sample_posterior.h"
#include "tendons/forces/key_pinch.h"

namespace thenar {

/// Content of a file; a ResultFile is a motion or a run of a scene, as `thenar simulate` writes
/// them.
using Thing =
    std::variant<Subject, Experiment, FitSettings, HandProportions, DigitVariability, PinchLosses,
                 NetDescription, Materials, RobotSpec, BodySpec, WorldSpec, SceneSpec, PadSpec,
                 CalibratedLaws, PadData, Fit, PosteriorRun, ResultFile>;

/// Kind of thing that a command accepts by name.
struct ThingKind {
  std::string plural;  // word that `thenar list` accepts: "hands"
  std::string kind;    // FileContents::kind of its files: "robot"
  std::string folder;  // data folder of its files: "robots"
  std::string ending;  // ".toml"
};

/// Returns all kinds: subjects, experiments, worlds, scenes, hands, objects, pads, nets, contacts,
/// settings and proportions.
[[nodiscard]] const std::vector<ThingKind>& thing_kinds();

/// Returns the path itself if it is a file; else the file of that name among all kinds, in the
/// order of thing_kinds().
/// @param data  folder with subjects/ ..; empty: the usual ones
/// @throws InputError with the nearest name if there is neither.
[[nodiscard]] std::string named_thing(const std::string& name_or_path, const std::string& data);

/// Reads a file of any kind that Thing can hold.
/// @throws Error with what is wrong, or with the command that accepts a file of its kind.
[[nodiscard]] Thing read_thing(const std::string& path);

}  // namespace thenar
