#pragma once

/// Comparison of hands on objects, and of their abilities without an object.

#include "grasp/compare/comparison.h"

namespace thenar {

/// Computes all members of HandAbilities but `types`, from postures sampled uniformly within the
/// limits by a generator with options.seed. The result of a stopped computation is not usable.
[[nodiscard]] HandAbilities hand_abilities(const ComparedHand& hand, const CompareOptions& options,
                                           const Progress& progress = {});

/// Compares every hand on every object. Approach n on an object draws from generators seeded with
/// (seed, object's name, n) only, so that it is the same for every hand, in any order, on any
/// number of threads. On a stop it ends after at most one approach or load, and drops the
/// unfinished cell.
/// @param done  cells of an earlier run with the same options, which are not computed again
/// @throws InputError if there is no hand or object, a duplicate name, or an object of unknown
/// mass, or as grasp().
[[nodiscard]] Comparison compare(const std::vector<ComparedHand>& hands,
                                 const std::vector<BodySpec>& objects,
                                 const CompareOptions& options, const Progress& progress = {},
                                 const std::vector<HandOnObject>& done = {});

}  // namespace thenar
