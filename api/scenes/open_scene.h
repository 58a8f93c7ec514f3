#pragma once

/// Scenes of bodies and hands, opened with the options of a request.

#include <optional>
#include <string>
#include <vector>

#include "base/fidelity.h"
#include "base/provenance.h"
#include "dynamics/scene/build_scene.h"

namespace thenar {

/// Number of a scene that varies from run to run; names and units as in set_number().
struct SceneVariation {
  std::string name;         // "friction", "mass/BODY"
  double from = 0, to = 0;  // first and last value, in SI
  int count = 1;            // number of values, evenly spaced, including both ends

  [[nodiscard]] double value(int i) const {
    return count == 1 ? from : from + (to - from) * i / (count - 1);
  }
};

/// Options of a scene's simulation; absent values are taken from the scene's file.
struct SceneRequest {
  std::string scene;                     // file, or name of one of scenes/; required
  std::string data;                      // folder with scenes/, robots/ ..; empty: the usual ones
  std::optional<SteppingMethod> method;  // absent: that of the scene
  std::string pads;                      // rung of all its [[pad]], of pad_rung_names()
  std::optional<Path> path = {};         // tendon paths of human hands that state none; absent:
                                         // default_path()
  bool on_pins = false;                  // ignore [[compliance]]: every joint is rigid
  std::optional<double> seconds;         // duration [s]
  std::optional<double> sample;          // time between stored instants [s]
  std::optional<double> step;            // fixed step size [s]
  std::optional<double> tolerance;       // error of a step [m] or [rad]
  std::vector<SceneVariation> vary;      // the last one varies fastest; empty: one run
};

/// Returns true if a name or file is a scene, rather than a subject.
[[nodiscard]] bool is_scene(const std::string& name_or_path, const std::string& data);

/// Scene built from its file and the robots that it names.
struct OpenScene {
  BuiltScene built;                 // bodies, hands, drives and options
  std::vector<SourceText> sources;  // texts of all files; empty: not of a file
  FileDigests files;                // digests of all files that were read
};
/// Builds a scene. @param data  folder with robots/ ..; empty: the usual ones
/// @param path  tendon paths of human hands that state none; absent: default_path()
/// @throws DataError at the line of an error, InputError if a hand is not found.
[[nodiscard]] OpenScene open_scene(const SceneSpec& scene, const std::string& data = "",
                                   const std::optional<Path>& path = {});

/// Scene with the options of a request.
struct RequestedScene {
  SceneSpec spec;        // scene with the pads and joints of the request
  OpenScene open;        // scene as it is simulated
  SceneRequest request;  // request that was applied
};
/// Reads and builds the requested scene, with the method, pads and times of the request.
/// @throws as open_scene(), or InputError for an unknown name in the request.
[[nodiscard]] RequestedScene open_requested_scene(const SceneRequest& request);
[[nodiscard]] RequestedScene open_requested_scene(SceneSpec scene, const SceneRequest& request);

/// Returns the data from which the hands of a scene are built, in the order of the scene.
/// @param data, path  see open_scene()
/// @param files  receives the digests of their files
/// @throws as open_scene()
[[nodiscard]] std::vector<SceneHand> hands_of_scene(const SceneSpec& scene, const std::string& data,
                                                    FileDigests& files,
                                                    const std::optional<Path>& path = {});

}  // namespace thenar
