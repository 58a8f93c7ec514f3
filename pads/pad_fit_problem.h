#pragma once

/// Fit problems of pads from data files, and pads with the estimates of a fit.

#include "data/io/pad/pad.h"
#include "data/io/pad/pad_data.h"
#include "pads/pad_fit.h"

namespace thenar {

/// Builds the fit problem of a data file.
///
/// A plane is a block that reaches beyond the pad; a cylinder lies across the finger. Objects move
/// along -(sin(angle), 0, cos(angle)), as in touch_pad(). The loads of a press are all loads of its
/// data, in rising order. If no press takes time, tissues do not relax.
/// @throws DataError at the file's line if the pad lacks a layer, an exponent or a term that the
/// file names, if one constant is named twice or starts where no pad can be, or a share is to be
/// fitted and no press takes time; InputError of build_pad().
[[nodiscard]] PadFitProblem pad_fit_problem(const PadData& data, const PadSpec& pad);

/// Returns the pad with the estimates and the cells of a fit.
///
/// A constant that the data determine is no longer marked as assumed, and its tissue also cites the
/// sources of the data; an undetermined constant is marked as assumed. Definitions of the files'
/// own citation keys are merged.
[[nodiscard]] PadSpec fitted_pad(const PadSpec& pad, const PadData& data,
                                 const PadFitProblem& problem, const PadFitResult& result);

/// Returns the comment at the head of the fitted pad's file: each estimate with its factor at one
/// sd, constants that the data do not determine, and the misfit. Lines end with '\n'.
[[nodiscard]] std::string fit_comment(const PadData& data, const PadFitProblem& problem,
                                      const PadFitResult& result);

}  // namespace thenar
