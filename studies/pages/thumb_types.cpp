#include "studies/pages/thumb_types.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/units.h"
#include "report/blocks.h"
#include "report/provenance.h"
#include "studies/pages/thumb_types_answer.h"

namespace thenar {
namespace {

const char* const kTypesIntroduction =
    "Joint axes of thumbs differ between people. Axes are drawn from normal distributions about a "
    "mean thumb and turned into Denavit-Hartenberg parameters, as [SantosValeroCuevas2006] did "
    "with the reported anatomy. Each draw is of one of four types: by the order of the MCP axes "
    "along the metacarpal, and by the side of the thumb to which a common normal of two successive "
    "axes points. The abstract does not say which normal that is; the one used here is named in "
    "the table, and the shares of all others are below it. Sds that are marked as assumed were not "
    "measured: the shares of the types are no better than these.";

Json distribution_table(const DigitVariability& variability) {
  // Keep what was assumed beside what was published.
  Json rows = Json::array();
  for (const AxisVariability& axis : variability.axes) {
    rows.push_back({axis.joint, 1e3 * axis.along, 1e3 * axis.along_sd, 1e3 * axis.across_sd,
                    degrees(axis.tilt_sd), fmt::format("{}", fmt::join(axis.assumed, ", ")),
                    axis.source});
  }
  return table_block("What was drawn from: shifts from the mean thumb and tilts about it",
                     {"axis", "along [mm]:1", "sd along [mm]:1", "sd across [mm]:1",
                      "sd of tilts [deg]:1", "assumed", "source"},
                     std::move(rows));
}

Json normals_table(const ThumbTypes& types) {
  Json rows = Json::array();
  for (const NormalShares& normal : types.normals)
    rows.push_back({normal.first + " to " + normal.second, 100 * normal.toward[0],
                    100 * normal.toward[1], 100 * normal.toward[2]});
  return table_block(
      "Draws in which the common normal of successive axes points distally, dorsally "
      "and radially",
      {"axes", "distal [%]:1", "dorsal [%]:1", "radial [%]:1"}, std::move(rows));
}

}  // namespace

Json page_of(const ThumbTypesResult& result) {
  const ThumbTypes& types = result.types;
  Json blocks = Json::array();
  if (types.draws > 0)
    blocks = Json::array(
        {table_block("Types and their shares, with 95 % intervals of Wilson", share_table(result)),
         text_block(order_words(result)),
         table_block("Denavit-Hartenberg parameters of each type, mean and sd; normals point from "
                     "an axis to the next one, so that a is not negative",
                     table_of(result)),
         normals_table(types)});
  blocks.push_back(distribution_table(types.variability));
  Json provenance = provenance_json({types.inputs.variability, types.inputs.subject}, {});
  provenance["seed"] = fmt::format("{}", result.seed);
  return {{"title", "thenar: types of thumbs"},
          {"subtitle", "What the spread of joint axes between people makes"},
          {"provenance", provenance},
          {"sections", Json::array({section("thumb-types", "Types of thumbs", kTypesIntroduction,
                                            std::move(blocks))})}};
}

}  // namespace thenar
