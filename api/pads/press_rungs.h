#pragma once

/// Comparison of reduced laws, kinds of elements and meshes: error of the force over processor
/// time.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"

namespace thenar {

struct PressResult;

/// Press by a reduced law, or by one kind of element on one mesh, instantaneous and without
/// friction.
struct PressRung {
  std::string element;            // "soft finger", "Q1P0"
  std::string mesh;               // "law", "1152 even cells", "refined to 4 %"
  bool refined = false;           // the mesh is refined adaptively
  std::size_t elements = 0;       // number of elements; 0: a law
  double force = 0;               // [N]
  double error = 0;               // |force / force of the finest - 1| [1]; 0 for the finest
  double cpu = 0;                 // [s]
  bool finest = false;            // reference of all errors
  std::string message;            // why there is no force; empty: it was solved
  bool reduced = false;           // a law without elements
  std::optional<double> area;     // area of the patch [m^2]
  std::optional<double> torsion;  // largest torque per normal force, with the press's friction [m]
  std::string note;               // pad and depth that a law was calibrated for
};

/// Presses the pad of `pressed` instantaneously, in one step and without friction, to the final
/// depth of its motion: by reduced laws, by each kind of element on even meshes, and by
/// mean-dilatation elements with refinement. Laws are read from  laws/NAME.toml  beside the pad's
/// file if they have the pad's name and relaxation and the pad has the tissue of its file;
/// otherwise their messages say why they are missing. Their time is the median of many calls with
/// the gap given. Errors are relative to the finest rung, a mesh refined to a quarter of the
/// requested error; errors below its own error are not significant. A failed press has a message.
/// If stopped, returns the rungs so far.
/// @param pressed  press whose motion was solved
[[nodiscard]] std::vector<PressRung> compare_rungs(const PressResult& pressed,
                                                   const Progress& progress = {});

/// Returns a warning if the laws of compare_rungs() were fitted to another version of the pad; ""
/// if they match or there are none.
[[nodiscard]] std::string laws_warning(const PressResult& pressed);

}  // namespace thenar
