#include "base/name_hint.h"

#include "base/nearest_name.h"

namespace thenar {

std::string hint_before_list(const std::string& wanted, const std::vector<std::string>& names) {
  const std::string meant = did_you_mean(wanted, names);
  return meant.empty() ? ";" : meant;
}

}  // namespace thenar
