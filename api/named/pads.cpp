#include "api/named/pads.h"

#include <fmt/format.h>

#include "api/named/files.h"
#include "base/error.h"
#include "base/nearest_name.h"

namespace thenar {
namespace {

/// Gives a tissue another law.
void change_law(const PadRequest& request, PadTissueSpec& tissue) {
  if (!request.law.empty()) {
    (void)index_of_name(request.law, tissue_law_names(), "law of tissue", "law");
    tissue.law = request.law;
  }
  require_field("exponent", !request.exponent || has_exponent(tissue.law),
                "the law '{}' has no exponent", tissue.law);
  if (request.exponent) tissue.exponent = *request.exponent;
  require_field("law", !has_exponent(tissue.law) || tissue.exponent != 0,
                "the law '{}' needs an exponent, and the pad's file gives none", tissue.law);
}

}  // namespace

NamedPad open_pad(const PadRequest& request) {
  NamedPad pad;
  pad.path = requested_file("pad", "pad", request.pad, "pads", request.data);
  pad.spec = read_pad(pad.path);
  // Change what the request states otherwise than the file.
  change_law(request, pad.spec.pulp);
  for (PadTissueSpec& layer : pad.spec.layers) change_law(request, layer);
  if (!request.element.empty()) pad.spec.element = request.element;
  pad.model = build_pad(pad.spec);
  return pad;
}

std::string assumption_of(const PadSpec& spec) {
  const std::vector<std::string> words = assumed_words(spec);
  if (words.empty()) return "";
  return fmt::format("pad '{}' is assumed, not measured, in {}: {}", spec.name,
                     words.size() == 1 ? "one number" : fmt::format("{} numbers", words.size()),
                     listed(words));
}

}  // namespace thenar
