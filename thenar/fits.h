#pragma once

/// Fits of a digit to measured forces, predictions, posteriors.

#include "api/fit.h"
#include "api/posterior.h"
#include "api/predict.h"
