#include "apps/tendon_report.h"

#include <fmt/format.h>

#include "report/page.h"
#include "report/provenance.h"

namespace thenar {

void write_tendon_report(const TendonQuestion& question, const TendonCase& at,
                         const TendonSweep& sweep, const std::string& path) {
  Json provenance = provenance_json({at.sources.front()}, at.bones().fidelity);
  provenance["tensions"] = fmt::format("{}", fmt::join(question.tension, " "));
  if (at.net != nullptr) provenance["net"] = at.net->net().net.name;
  write_report({{"title", fmt::format("Tendons of the {} of {}", at.digit, at.subject)},
                {"subtitle", fmt::format("under {} N", fmt::join(question.tension, ", "))},
                {"provenance", provenance},
                {"sections", tendon_page(sweep)}},
               path);
}

}  // namespace thenar
