#pragma once

/// When something that moves first touches something else.

#include <functional>
#include <vector>

#include "grasp/contact/separation.h"

namespace thenar {

/// One pair of solids on its way, s: the motion's own measure (time, angle, travel).
struct Approach {
  std::function<Separation(double s, double cutoff)> separation;  // at s, as in separation.h
  double speed = 0;  // that no point of one exceeds, seen from the other [m per unit of s]
};

/// How contact is looked for.
enum class ContactSearch {
  kAdvance,  // conservative advancement: goes as far as the gap certainly allows, misses nothing
  kBisect    // steps, then bisection: thinner overlaps than a step may be missed
};

struct TimeOfContactOptions {
  ContactSearch search = ContactSearch::kAdvance;
  double gap = 1e-4;             // what is left between the two when they touch [m]
  double step = 1e-3;            // of kBisect: way of the fastest point [m]
  int most_questions = 100'000;  // separations, of all pairs together
};

/// Where the motion ends.
struct [[nodiscard]] TimeOfContact {
  bool touches;   // or there was no contact up to the end
  double s;       // of the contact, or the end of what is free for certain
  int pair;       // that touches; -1: none
  Separation at;  // of that pair there; negative only if the motion began in an overlap
  int questions;  // separations asked for
  bool gave_up;   // after most_questions; s is free for certain
};

/// Follows pairs from s = 0 to `end` until one has a gap of options.gap or less.
///
/// Conservative advancement: from s on, a gap g cannot close before  s + (g - error) / speed,  so
/// the pair with the earliest such s is asked next, until its gap is small. A pair whose two lie in
/// each other at 0 touches there. A pair that cannot be told from touching, its error being as
/// large as its gap, touches.
/// @throws InputError if a speed is negative or not finite, or end, gap or step is not positive.
/// Source: [MirtichCanny1995].
TimeOfContact time_of_contact(const std::vector<Approach>& pairs, double end,
                              const TimeOfContactOptions& options = {});

/// No point of A is farther from a line than this; times a rate of turning it bounds a speed [m].
/// @param point, direction  of the line, in A's frame [m] (3); unit (3)
[[nodiscard]] double reach_from(const TouchBody& a, const Eigen::Vector3d& point,
                                const Eigen::Vector3d& direction);

}  // namespace thenar
