#include "live/strand_paths.h"

#include <cmath>
#include <utility>

namespace thenar {
namespace {

/// Returns the nodes up to the first one on the base.
TendonPath<double> moving_part(const TendonPath<double>& path) {
  TendonPath<double> part;
  for (const PathNode<double>& node : path) {
    part.push_back(node);
    if (node.link < 0) break;
  }
  return part;
}

/// Reduces a path to kMaxStrandPoints nodes: both ends, and nodes at equal index steps between.
TendonPath<double> thinned(const TendonPath<double>& path) {
  if (path.size() <= kMaxStrandPoints) return path;
  TendonPath<double> thin;
  for (int i = 0; i < kMaxStrandPoints; ++i)
    thin.push_back(
        path[std::lround(i * static_cast<double>(path.size() - 1) / (kMaxStrandPoints - 1))]);
  return thin;
}

}  // namespace

std::string digit_name(const TendonDigit& digit) {
  return digit.skeleton.tips.empty() ? "" : digit.skeleton.tips[0].digit;
}

std::vector<StrandPath> strand_paths(const TendonDigit& digit) {
  std::vector<StrandPath> paths;
  for (std::size_t s = 0; s < digit.model.paths.size(); ++s) {
    StrandPath path{static_cast<int>(s), digit.names.strands[s],
                    thinned(moving_part(digit.model.paths[s]))};
    if (path.nodes.size() > 1) paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace thenar
