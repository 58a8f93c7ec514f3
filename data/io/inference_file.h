#pragma once

/// ArviZ InferenceData on netCDF-4: groups of labelled arrays. The only fence of netCDF.

#include <map>
#include <string>
#include <vector>

namespace thenar {

/// A labelled array of one group, row-major.
struct InferenceArray {
  std::vector<double> values;           // row-major (product of the lengths of its dimensions)
  std::vector<std::string> dimensions;  // names: {"chain", "draw", "parameter"}
  std::string unit;                     // "mm", "N", "1": the attribute `units`
  std::string description;              // the attribute `long_name`; may be empty
  bool integer = false;                 // stored as 64-bit integers
  bool boolean = false;                 // stored as ArviZ stores bool
};

/// Arrays of one group, and names along its dimensions; those without names are counted 0, 1, 2,
/// ...
struct InferenceGroup {
  std::map<std::string, std::size_t> lengths;                   // length of every dimension
  std::map<std::string, std::vector<std::string>> coordinates;  // dimension -> names
  std::map<std::string, InferenceArray> arrays;
};

/// Content of a file: groups posterior, sample_stats, log_likelihood, posterior_predictive, prior,
/// observed_data, ...
struct InferenceFile {
  std::map<std::string, InferenceGroup> groups;
  std::map<std::string, std::string> attributes;  // file attributes: provenance, inputs
};

/// Writes a file beside `path`, with a checksum, and renames it. `az.from_netcdf(path)` opens it.
/// Every group also gets the attributes of ArviZ: created_at (that of the file, or now),
/// creation_library, inference_library and its version.
/// @throws InputError if shapes disagree, an array of integers or bools holds other values, an
/// attribute is named "program" (which marks the file as ours), or the file cannot be written.
void write_inference(const InferenceFile& file, const std::string& path);

/// Reads a file. @throws DataError if it is missing, not ours, damaged, or promises more than it
/// has.
[[nodiscard]] InferenceFile read_inference(const std::string& path);

}  // namespace thenar
