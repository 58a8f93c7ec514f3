#pragma once

/// Data of a finger pad, options and result of a press on it.

#include <cstddef>
#include <vector>

#include "base/spatial.h"
#include "pads/pad_shape.h"
#include "pads/press_goal.h"
#include "pads/tissue_element.h"

namespace thenar {

/// Shape, mesh and tissues of a pad.
struct PadModel {
  PadShape shape;
  PadCells cells;               // cells of the coarsest mesh
  std::vector<Tissue> tissues;  // the pulp, then layers of skin from the inside out
  HexElement element = HexElement::kMeanDilatation;  // kind of elements; quadratic ones are not
                                                     // refined
};

struct PadPressOptions {
  PressOptions step;
  double force_error = 0.02;      // estimated force error up to which a mesh is fine enough [1]
  int max_elements = 20000;       // elements of a mesh up to which it is refined
  double max_penetration = 1e-6;  // depth of the object in faces between their nodes [m]
  int max_failed_pieces = 60;     // failed pieces after which a halved step fails; 1: no halving
  double refined_share = 0.3;  // share of the error energy whose elements are refined at once [1]
};

/// Result of a step of a press.
struct [[nodiscard]] PadPressResult {
  PressOutcome solved;       // outcome of the last solution
  Wrench push;               // wrench of the object on the pad, about the pad's origin
  double area = 0;           // deformed area of the patch [m^2]
  double stick = 0;          // share of the normal force on sticking nodes [1]
  double force_error = 0;    // estimated relative error of the force [1]
  double penetration = 0;    // depth of the deepest point of a face in the object [m]
  std::size_t elements = 0;  // elements of the mesh
  int iterations = 0;        // iterations since the pad was built
  int cuts = 0;              // failed pieces of the step, each halved
};

}  // namespace thenar
