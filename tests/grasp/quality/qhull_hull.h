#pragma once

/// Convex hulls in six dimensions by qhull, to compare with.

#include <cstdio>
#include <limits>
#include <vector>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include "grasp/contact/wrench_set.h"

namespace thenar {

struct QhullHull {
  bool ok;         // qhull took the points
  double nearest;  // least signed distance of the origin from a facet's plane,
                   // positive inside
  double volume;   // 0 unless asked for
};

/// @param command  "qhull ..." options; @param points  one after the other
inline QhullHull qhull_hull(const std::vector<WrenchCoordinates>& points, const char* command,
                            bool with_volume) {
  std::vector<double> numbers;
  for (const WrenchCoordinates& p : points) numbers.insert(numbers.end(), p.data(), p.data() + 6);
  std::vector<char> options(command, command + std::char_traits<char>::length(command) + 1);
  std::FILE* nowhere = std::fopen("/dev/null", "w");
  qhT qh;
  qh_zero(&qh, nowhere);
  QhullHull out{qh_new_qhull(&qh, 6, static_cast<int>(points.size()), numbers.data(), 0,
                             options.data(), nowhere, nowhere) == 0,
                std::numeric_limits<double>::infinity(), 0};
  if (out.ok) {
    for (const facetT* facet = qh.facet_list; facet != nullptr && facet->next != nullptr;
         facet = facet->next)
      out.nearest = std::min(out.nearest, -facet->offset);
    if (with_volume) {
      qh_getarea(&qh, qh.facet_list);
      out.volume = qh.totvol;
    }
  }
  qh_freeqhull(&qh, 0);  // all but short memory
  int blocks = 0, bytes = 0;
  qh_memfreeshort(&qh, &blocks, &bytes);
  std::fclose(nowhere);
  return out;
}

/// Points of a polytope: its caps (kL1), or all sums of one or none of each
/// contact's (kLinf).
inline std::vector<WrenchCoordinates> vertices_of(const WrenchSet& polytope, ForceNorm limit) {
  std::vector<WrenchCoordinates> all{WrenchCoordinates::Zero()};
  if (limit == ForceNorm::kL1) {
    all.clear();
    for (const WrenchCap& cap : polytope.caps) all.push_back(cap.c.vector());
    return all;
  }
  for (std::size_t i = 0; i < polytope.caps.size();) {
    const std::vector<WrenchCoordinates> before = all;
    const int contact = polytope.caps[i].contact;
    for (; i < polytope.caps.size() && polytope.caps[i].contact == contact; ++i)
      for (const WrenchCoordinates& p : before) all.emplace_back(p + polytope.caps[i].c.vector());
  }
  return all;
}

}  // namespace thenar
