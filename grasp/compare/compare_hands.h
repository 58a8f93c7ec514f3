#pragma once

/// Comparison of hands on objects, and of their abilities without an object.

#include "grasp/compare/comparison.h"

namespace thenar {

/// Compares one hand on one object. Approach n draws from generators seeded with (seed, object's
/// name, n) only, so that it is the same for every hand, in any order, on any number of threads. If
/// the computation is stopped, `approaches` is 0.
/// @param scale  scale of the object [1]
/// @throws InputError as grasp(), or if the object's mass is unknown.
[[nodiscard]] HandOnObject compare_on(const ComparedHand& hand, const BodySpec& object,
                                      double scale, const CompareOptions& options,
                                      const Progress& progress = {});

/// Computes all members of HandAbilities but `types`, from postures sampled uniformly within the
/// limits by a generator with options.seed. The result of a stopped computation is not usable.
[[nodiscard]] HandAbilities hand_abilities(const ComparedHand& hand, const CompareOptions& options,
                                           const Progress& progress = {});

/// Compares every hand on every object. On a stop it ends after at most one approach or load, and
/// drops the unfinished cell.
/// @param done  cells of an earlier run with the same options, which are not computed again
/// @throws InputError if there is no hand or object, a duplicate name, or as compare_on().
[[nodiscard]] Comparison compare(const std::vector<ComparedHand>& hands,
                                 const std::vector<BodySpec>& objects,
                                 const CompareOptions& options, const Progress& progress = {},
                                 const std::vector<HandOnObject>& done = {});

}  // namespace thenar
