#pragma once

/// Reduced laws, kinds of elements and meshes side by side: error of the force over processor time.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"

namespace thenar {

struct PressResult;

/// A press by a reduced law, or by one kind of element on one mesh, at once and without friction.
struct PressRung {
  std::string element;   // "soft finger", "Q1P0"
  std::string mesh;      // "law", "1152 even cells", "refined to 4 %"
  bool refined = false;  // the mesh is refined adaptively
  std::size_t elements = 0;
  double force = 0;               // [N]
  double error = 0;               // |force / force of the finest - 1| [1]; 0 for the finest
  double cpu = 0;                 // [s]
  bool finest = false;            // the one that all others are held to
  std::string message;            // why there is no force; empty: it was solved
  bool reduced = false;           // a law without elements
  std::optional<double> area;     // area of the patch [m^2]
  std::optional<double> torsion;  // largest torque per normal force, with the press's friction [m]
  std::string note;               // pad and depth that a law was calibrated for
};

/// Presses the pad of `pressed` at once, in one step and without friction, to the depth where its
/// way ended: by reduced laws, by each kind of element on even meshes, and by mean-dilatation
/// elements that refine. Laws are those of the file  laws/NAME.toml  beside the pad's, if they have
/// the pad's name and relaxation and the pad has the tissue of its file; otherwise their rows say
/// why they are missing. Their time is the median of many calls with the gap at hand.
/// Errors are against the finest, a mesh that refines to a quarter of the error that was asked for;
/// those below its own error mean nothing. A press that fails says why. Stopped: those that were
/// done.
/// @param pressed  its way was solved
[[nodiscard]] std::vector<PressRung> compare_rungs(const PressResult& pressed,
                                                   const Progress& progress = {});

/// Returns a warning where the laws that compare_rungs() takes were fitted to another version of
/// the pad;
/// "" if they fit, or there are none.
[[nodiscard]] std::string doubt_of_laws(const PressResult& pressed);

}  // namespace thenar
