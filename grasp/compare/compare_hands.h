#pragma once

/// Comparison of hands on objects, and their abilities without an object.

#include "grasp/compare/comparison.h"

namespace thenar {

/// Compares one hand on one object. Approach n draws from generators seeded with (seed, object's
/// name, n) alone: the same for every hand, in any order, on any number of threads. If it is
/// stopped, `approaches` is 0.
/// @param scale  of the object [1]
/// @throws InputError as grasp(), or if the object's mass is unknown.
[[nodiscard]] HandOnObject compare_on(const ComparedHand& hand, const BodySpec& object,
                                      double scale, const CompareOptions& options,
                                      const Progress& progress = {});

/// Computes all of HandAbilities but `types`. Samples postures uniformly within limits from a
/// generator with options.seed. A stopped computation leaves nothing of use.
[[nodiscard]] HandAbilities hand_abilities(const ComparedHand& hand, const CompareOptions& options,
                                           const Progress& progress = {});

/// Compares every hand on every object. Stops when asked to, after one approach or load at most,
/// and drops the unfinished cell.
/// @param done  cells of an earlier run with the same options: not computed again
/// @throws InputError if there is no hand or object, a name twice, or as compare_on().
[[nodiscard]] Comparison compare(const std::vector<ComparedHand>& hands,
                                 const std::vector<BodySpec>& objects,
                                 const CompareOptions& options, const Progress& progress = {},
                                 const std::vector<HandOnObject>& done = {});

}  // namespace thenar
