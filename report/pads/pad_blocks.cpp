#include "report/pads/pad_blocks.h"

namespace thenar {

Json pad_banner(const std::string& refusal, const std::vector<std::string>& warnings,
                const std::string& failed_title, const std::string& title) {
  std::vector<std::string> reasons = warnings;
  if (!refusal.empty()) reasons.insert(reasons.begin(), refusal);
  const bool ok = refusal.empty();
  return {{"type", "banner"},
          {"ok", ok},
          {"caution", ok && !reasons.empty()},
          {"title", ok ? title : failed_title},
          {"reasons", reasons}};
}

}  // namespace thenar
