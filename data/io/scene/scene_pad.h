#pragma once

/// Finger pads on bodies of a scene, as plain data.

#include <optional>
#include <string>
#include <vector>

#include "base/spatial.h"
#include "data/io/pad/pad.h"
#include "data/io/toml_table.h"
#include "pad_laws/calibrated_laws.h"

namespace thenar {

/// A pad on a body, and the bodies that press on it.
struct ScenePadSpec {
  std::string on;                     // body, or "HAND/LINK", that carries it
  std::vector<std::string> against;   // bodies, or "HAND/LINK"; each meets a pad of its own
  std::string pad = "index_pad";      // as written: a file, or what is built in
  std::string laws;                   // the same of its laws; empty: those of a pad built in
  std::string rung = "elements";      // of pad_rung_names()
  std::optional<Pose<double>> X_BP;   // of the pad in the body; absent: where a fingertip has it
  std::optional<double> scale;        // of all its lengths [1]; absent: as broad as the fingertip
                                      // where X_BP is absent, otherwise 1
  double force_error = 0.05;          // of PadElementOptions [1]
  std::optional<double> friction;     // [1]; absent: that of the pair
  PadSpec spec;                       // what the pad's file says
  std::optional<CalibratedLaws> law;  // what the laws' file says
  FileDigests files;                  // that were read for them
  int line = 1;                       // of the file
};

/// Returns "elements", "foundation", "soft-finger", "power-law", "hard-point": the finest first.
[[nodiscard]] const std::vector<std::string>& pad_rung_names();

namespace internal {

/// [[pad]]. @param folder  of the scene
[[nodiscard]] ScenePadSpec read_scene_pad(TomlTable& table, const std::string& folder);

}  // namespace internal
}  // namespace thenar
