#include "pads/build_pad.h"

#include "base/error.h"
#include "geometry/solid.h"

namespace thenar {
namespace {

Tissue build_tissue(const PadTissueSpec& spec, const std::string& name) {
  Tissue tissue;
  tissue.name = name;
  tissue.law = tissue_law_named(spec.law);
  tissue.shear_modulus = spec.shear_modulus;
  tissue.exponent = spec.exponent;
  tissue.poisson_ratio = spec.poisson_ratio;
  // Copy the relaxation, a time for each share.
  require(spec.relaxation_share.size() == spec.relaxation_time.size(),
          "{} has {} shares of relaxation and {} times", name, spec.relaxation_share.size(),
          spec.relaxation_time.size());
  for (std::size_t i = 0; i < spec.relaxation_share.size(); ++i)
    tissue.relaxation.push_back({spec.relaxation_share[i], spec.relaxation_time[i]});
  check_tissue(tissue);
  return tissue;
}

}  // namespace

TissueLaw tissue_law_named(const std::string& name) {
  return value_in(kTissueLawNames, name, "law of tissue");
}

HexElement pad_element_named(const std::string& name) {
  return value_in(kHexElementNames, name, "element");
}

PadModel build_pad(const PadSpec& spec) {
  // Copy shape, skin and cells.
  PadModel model;
  model.shape.length = spec.length;
  model.shape.width = spec.width;
  model.shape.height = spec.height;
  model.shape.bone_length = spec.bone_length;
  model.shape.bone_width = spec.bone_width;
  model.shape.bone_height = spec.bone_height;
  if (spec.skin) model.shape.skin = build_solid({*spec.skin}).shape;
  model.cells = {spec.across, spec.around, spec.through};
  model.element = pad_element_named(spec.element);
  // Add the pulp, then the layers from the inside out, which files count from the outside.
  model.tissues.push_back(build_tissue(spec.pulp, "pulp"));
  for (std::size_t i = spec.layers.size(); i-- > 0;)
    model.tissues.push_back(build_tissue(spec.layers[i], fmt::format("layer {}", i + 1)));
  for (const PadTissueSpec& layer : spec.layers) model.shape.layers.push_back({layer.thickness});
  (void)PadChart(model.shape);  // checks that the parts fit
  return model;
}

}  // namespace thenar
