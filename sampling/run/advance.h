#pragma once

/// Joint advance of several samplers, with batch evaluation of their proposals.

#include <functional>
#include <memory>
#include <vector>

#include "sampling/methods/sampler.h"

namespace thenar {

/// Callback for every step that a sampler completes, with the sampler's index.
using StepObserver = std::function<void(std::size_t sampler)>;

/// Advances every sampler to `steps` steps. Each sampler continues as soon as its densities are
/// available and never waits for a longer trajectory of another; no draw depends on the composition
/// of a batch.
/// @param steps  number of steps of each sampler since its start [1]
/// @param stop   polled between batches; true: return early, possibly within a step of a sampler
void advance(const std::vector<Sampler*>& samplers, const Target& target, long steps,
             const StepObserver& observer = {}, const std::function<bool()>& stop = {});

}  // namespace thenar
