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
  std::string on;                    // body, or "HAND/LINK", that carries it
  std::vector<std::string> against;  // bodies, or "HAND/LINK"; each meets a pad of its own
  std::string pad = "index_pad";     // pad as written: a file, or a built-in name
  std::string laws;  // laws as written: a file, or a built-in name; empty: those of a built-in pad
  std::string rung = "elements";     // one of pad_rung_names()
  std::optional<Pose<double>> X_BP;  // pose of the pad in the body; absent: that of a fingertip
  std::optional<double> scale;  // factor on all its lengths [1]; absent: as broad as the fingertip
                                // where X_BP is absent, otherwise 1
  double force_error = 0.05;    // see PadElementOptions [1]
  std::optional<double> friction;     // [1]; absent: that of the pair
  PadSpec spec;                       // content of the pad's file
  std::optional<CalibratedLaws> law;  // content of the laws' file
  FileDigests files;                  // digests of the files that were read for them
  int line = 1;                       // line in the file
};

/// Returns "elements", "foundation", "soft-finger", "power-law", "hard-point": the finest first.
[[nodiscard]] const std::vector<std::string>& pad_rung_names();

namespace internal {

/// Reads [[pad]]. @param folder  folder of the scene
[[nodiscard]] ScenePadSpec read_scene_pad(TomlTable& table, const std::string& folder);

}  // namespace internal
}  // namespace thenar
