#pragma once

/// The inner loops of a posterior, compiled for several processors and chosen from at run time.
/// All give the same bits: no sum is reordered, and none is fused (-ffp-contract=off).

#include "posterior/lane_rows.h"

namespace thenar::internal {

/// A map in cells of equal width, of which each is a polynomial of degree 5.
struct CellMap {
  const double* coefficients;  // six of each cell, constant term first
  double start, per_unit;      // where the first cell begins; cells per unit
  double last;                 // where the last one ends
};

/// y = scale z(x), by_x = scale dz/dx at eight points; beyond the cells, those of their ends.
void map_lanes(const CellMap& map, const double* x, double scale, double* y, double* by_x);

/// y = scale x.
void scale_lanes(const double* x, double scale, double* y, double* by_x);

/// sum -= x^2 / 2 at eight points.
void subtract_half_square(const double* x, double* sum);

/// A von Mises-Fisher prior of two tilts against normal ones, see TiltDensity.
struct TiltLanes {
  double mean[2], sd, concentration;
};
/// Adds to `sum` the part of its logarithm without -3/2 log w, multiplies `product` by w = 1 +
/// |t|^2 and gives the derivatives by y, the tilts' displacements.
void tilt_lanes(const TiltLanes& prior, const double* y0, const double* y1, double* sum,
                double* product, double* by_y0, double* by_y1);

/// Returns sum (measured - predicted)^2 precision, and gives weight = (measured - predicted)
/// precision scale.
double weigh_residuals(int count, const double* measured, const double* predicted,
                       const double* precision, double scale, double* weight);

}  // namespace thenar::internal
