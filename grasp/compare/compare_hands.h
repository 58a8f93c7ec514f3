#pragma once

/// The comparison itself.

#include "grasp/compare/comparison.h"

namespace thenar {

/// One hand on one object. Approach n draws from generators seeded with (seed, object's name, n)
/// alone: the same for every hand, in any order, on any number of threads.
/// Stopped, it is no cell: `approaches` is 0.
/// @throws InputError as grasp(), or if the object's mass is unknown.
[[nodiscard]] HandOnObject compare_on(const ComparedHand& hand, const BodySpec& object,
                                      double scale, const CompareOptions& options,
                                      const Progress& progress = {});

/// Every hand on every object. Stops when asked to, after one approach or load at most; the cell at
/// work is dropped.
/// @param done  cells of an earlier run of the same options: not worked out again
/// @throws InputError if there is no hand or object, a name twice, or as compare_on().
[[nodiscard]] Comparison compare(const std::vector<ComparedHand>& hands,
                                 const std::vector<BodySpec>& objects,
                                 const CompareOptions& options, const Progress& progress = {},
                                 const std::vector<HandOnObject>& done = {});

}  // namespace thenar
