#include "apps/options.h"

#include <algorithm>
#include <cmath>

#include "report/table.h"
#include "base/error.h"

namespace thenar {

double parse_number(const std::string& text, const std::string& what) {
  std::size_t read = 0;
  double value = 0;
  try {
    value = std::stod(text, &read);
  } catch (const std::exception&) {
    read = 0;  // not a number at all, or one too large
  }
  require(read > 0 && read == text.size() && std::isfinite(value), "wanted {}, got '{}'", what,
          text);
  return value;
}

std::map<std::string, double> parse_named_numbers(const std::vector<std::string>& texts,
                                                  const std::string& what) {
  std::map<std::string, double> named;
  for (const std::string& text : texts) {
    const std::size_t sign = text.find('=');
    require(sign != std::string::npos && sign > 0, "wanted {}, got '{}'", what, text);
    const std::string name = text.substr(0, sign);
    const double value = parse_number(text.substr(sign + 1), what + " for '" + name + "'");
    require(named.emplace(name, value).second, "'{}' is given twice", name);
  }
  return named;
}

Eigen::VectorXd in_order(const std::map<std::string, double>& named,
                         const std::vector<std::string>& names, const std::string& kind) {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(names.size()));
  for (const auto& [name, value] : named) {
    const auto found = std::find(names.begin(), names.end(), name);
    require(found != names.end(), "no {} '{}'; there are {}", kind, name, listed(names));
    values[found - names.begin()] = value;
  }
  return values;
}

}  // namespace thenar
