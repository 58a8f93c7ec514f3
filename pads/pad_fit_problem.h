#pragma once

/// Fits of pads from files, and pads with what a fit found.

#include "data/io/pad/pad.h"
#include "data/io/pad/pad_data.h"
#include "pads/pad_fit.h"

namespace thenar {

/// The problem that a data file states of a pad.
///
/// A plane is a block that reaches beyond the pad, a cylinder lies across the finger; objects come
/// along -(sin(angle), 0, cos(angle)), as in touch_pad(). The loads of a press are all that its
/// data name, in rising order. Where no press takes time, tissues do not relax.
/// @throws DataError at the file's line if the pad lacks a layer, an exponent or a term that the
/// file names, if one constant is named twice or starts where no pad can be, or a share is to be
/// fitted and no press takes time; InputError of build_pad().
[[nodiscard]] PadFitProblem pad_fit_problem(const PadData& data, const PadSpec& pad);

/// The pad with the estimates of a fit, and with its cells.
///
/// A constant that the data determine is assumed no longer, and its tissue cites the sources of the
/// data beside its own; one that they leave open is assumed from now on. What keys mean that are
/// the files' own is taken from both.
[[nodiscard]] PadSpec fitted_pad(const PadSpec& pad, const PadData& data,
                                 const PadFitProblem& problem, const PadFitResult& result);

/// Returns the comment at the head of the fitted pad's file: each estimate with its factor at one
/// sd, constants that the data do not determine, and the misfit. Lines end with '\n'.
[[nodiscard]] std::string fit_comment(const PadData& data, const PadFitProblem& problem,
                                      const PadFitResult& result);

}  // namespace thenar
