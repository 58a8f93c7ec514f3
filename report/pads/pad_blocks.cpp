#include "report/pads/pad_blocks.h"

#include "report/blocks.h"

namespace thenar {

Json pad_banner(const std::string& refusal, const std::vector<std::string>& warnings,
                const std::string& failed_title, const std::string& title) {
  std::vector<std::string> reasons = warnings;
  if (!refusal.empty()) reasons.insert(reasons.begin(), refusal);
  const bool ok = refusal.empty();
  return with(banner_block(ok ? title : failed_title, reasons, ok),
              {{"caution", ok && !reasons.empty()}});
}

}  // namespace thenar
