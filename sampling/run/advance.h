#pragma once

/// Samplers driven side by side, their questions gathered into lanes.

#include <functional>
#include <memory>
#include <vector>

#include "sampling/methods/sampler.h"

namespace thenar {

/// Called for every step that one of the samplers completes.
using StepObserver = std::function<void(std::size_t sampler)>;

/// Brings every sampler to `steps` steps. Each goes on as soon as its own densities are there, so
/// that none waits for a longer trajectory of another; no draw depends on who shares a batch.
/// @param stop  asked between batches; true: return early, samplers maybe within a step
void advance(const std::vector<Sampler*>& samplers, const Target& target, long steps,
             const StepObserver& observer = {}, const std::function<bool()>& stop = {});

}  // namespace thenar
