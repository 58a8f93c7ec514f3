#include "tendons/net/net_plan.h"

#include "tendons/net/check_net.h"

namespace thenar::internal {
namespace {

/// Numbers of the free nodes, in file order; -1 for others.
std::vector<int> number_free(const Net& net) {
  std::vector<int> number;
  int next = 0;
  for (const NetNode& node : net.nodes) number.push_back(node.free ? next++ : -1);
  return number;
}

BlockPattern pattern_of(const Net& net) {
  const std::vector<int> number = number_free(net);
  std::vector<std::pair<int, int>> edges;
  int free = 0;
  for (int i : number) free += i >= 0;
  for (const NetBand& band : net.bands)
    if (number[band.a] >= 0 && number[band.b] >= 0)
      edges.emplace_back(number[band.a], number[band.b]);
  return {free, edges};
}

const Net& checked(const Net& net) {
  check_net(net);
  return net;
}

}  // namespace

NetPlan::NetPlan(const Net& given) : net(checked(given)), pattern(pattern_of(net)) {
  row = number_free(net);
  node.resize(pattern.size());
  for (int i = 0; i < static_cast<int>(row.size()); ++i)
    if (row[i] >= 0) {
      row[i] = pattern.place(row[i]);
      node[row[i]] = i;
    }
  clasps.resize(node.size());
  for (const NetBand& band : net.bands) {
    BandPlan plan{row[band.a], row[band.b], -1, row[band.a] < row[band.b]};
    if (plan.ka >= 0 && plan.kb >= 0)
      plan.slot = plan.flip ? pattern.slot(plan.kb, plan.ka) : pattern.slot(plan.ka, plan.kb);
    if (band.over >= 0)
      for (int k : {plan.ka, plan.kb})
        if (k >= 0) clasps[k].push_back(static_cast<int>(bands.size()));
    bands.push_back(plan);
  }
}

}  // namespace thenar::internal
