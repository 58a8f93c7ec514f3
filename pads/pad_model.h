#pragma once

/// A finger pad as data, and what a press of it gives at one instant.

#include <cstddef>
#include <vector>

#include "base/spatial.h"
#include "pads/pad_shape.h"
#include "pads/press_goal.h"
#include "pads/tissue_element.h"

namespace thenar {

/// A pad; constant.
struct PadModel {
  PadShape shape;
  PadCells cells;               // of the coarsest mesh
  std::vector<Tissue> tissues;  // the pulp, then layers of skin from the inside out
  HexElement element = HexElement::kMeanDilatation;  // quadratic ones are not refined
};

struct PadPressOptions {
  PressOptions step;
  double force_error = 0.02;      // of the estimate below which the mesh does [1]
  int max_elements = 20000;       // a mesh is not refined beyond
  double max_penetration = 1e-6;  // of the object into faces between their nodes [m]
  int pieces = 60;                // of a step that fails, tried in all
  double refined = 0.3;  // share of the error's energy whose elements are refined at once [1]
};

/// A press at one instant.
struct [[nodiscard]] PadPressResult {
  PressOutcome solved;     // of the last step
  Wrench push;             // of the object on the pad, about the pad's origin
  double area = 0;         // of the patch, deformed [m^2]
  double stick = 0;        // share of the normal force on nodes that stick [1]
  double force_error = 0;  // estimated, relative [1]
  double penetration = 0;  // deepest point of the object within a face [m]
  std::size_t elements = 0;
  int iterations = 0;  // since the pad was built
  int cuts = 0;        // halvings of the step
};

}  // namespace thenar
