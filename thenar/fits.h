#pragma once

/// Fits of a digit to measured forces, predictions, posteriors.
/// Example: examples/07_fit.cpp, 10_posterior.cpp, 14_fit_and_posterior.cpp.

#include "api/fit.h"
#include "api/posterior.h"
#include "api/predict.h"
