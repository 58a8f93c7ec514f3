#include "report/answers/motion_account.h"

#include <fmt/format.h>

#include "base/units.h"
#include "report/words.h"

namespace thenar {
namespace {

/// Returns the energy losses of a run, in words.
std::string losses_words(const FlowBalance& balance) {
  return fmt::format("friction {} mJ, impacts {} mJ, dampers and soft parts {} mJ",
                     shown(1e3 * balance.friction), shown(1e3 * balance.impacts),
                     shown(1e3 * balance.yielding));
}

std::string limits_words(const std::vector<PassedLimit>& limits) {
  if (limits.empty()) return "none";
  return each_in_words(limits, [](const PassedLimit& limit) {
    return fmt::format("{} by {}", limit.joint, beyond_words(limit));
  });
}

}  // namespace

std::vector<Fields> limit_fields(const std::vector<PassedLimit>& limits) {
  return fields_of_each(limits, [](const PassedLimit& limit) {
    return Fields{{"joint", limit.joint},
                  {"beyond", limit.slides ? units::kMetre : units::kRadian, limit.excess}};
  });
}

Table account_table(const SceneResult& scene) {
  Table table{{"measure", "value"}};
  const auto add = [&](const std::string& name, const std::string& value) {
    table.add({name, value});
  };
  if (scene.measures.worst) {
    add("energy error", energy_error_words(*scene.measures.worst));
    add("dissipated by", losses_words(*scene.measures.balance));
  } else {
    add("energy error", "not known: contacts are springs, and losses are what the balance leaves");
  }
  add("deepest overlap", fmt::format("{:.2g} mm", scene.run.cost.max_penetration / kMm));
  add("joint limits passed", limits_words(limits_passed(scene)));
  if (const double restitution = restitution_ignored(scene); restitution > 0)
    add("restitution ignored",
        fmt::format("up to {:.3g}: nothing bounces in steps of fixed length", restitution));
  return table;
}

}  // namespace thenar
