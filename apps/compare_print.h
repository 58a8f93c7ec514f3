#pragma once

/// A comparison of hands as tables for the terminal.

#include "grasp/compare/comparison.h"

namespace thenar {

/// Prints what hands made of the objects, why nothing closed where nothing did, what hands can do
/// by themselves, and warnings. Loads by the same rule as on the page.
void print_comparison(const Comparison& comparison);

}  // namespace thenar
