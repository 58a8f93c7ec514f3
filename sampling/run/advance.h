#pragma once

/// Advances several samplers together and evaluates their proposals in one batch.

#include <functional>
#include <memory>
#include <vector>

#include "sampling/methods/sampler.h"

namespace thenar {

/// Called for every step that a sampler completes, with the sampler's index.
using StepObserver = std::function<void(std::size_t sampler)>;

/// Advances every sampler to `steps` steps. Each sampler goes on as soon as it has its densities
/// and never waits for a longer trajectory of another; no draw depends on the composition of a
/// batch.
/// @param steps  of each sampler since its start [1]
/// @param stop   polled between batches; true: return early, with samplers possibly within a step
void advance(const std::vector<Sampler*>& samplers, const Target& target, long steps,
             const StepObserver& observer = {}, const std::function<bool()>& stop = {});

}  // namespace thenar
