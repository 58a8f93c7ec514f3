#include "data/io/inference_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <numeric>

#include <netcdf.h>
#include <netcdf_mem.h>

#include "base/error.h"
#include "base/provenance.h"
#include "base/write_file.h"
#include "data/io/checked_file.h"

namespace thenar {
namespace {

void check(int status, const std::string& what) {
  require(status == NC_NOERR, "netCDF could not {}: {}", what, nc_strerror(status));
}

/// Plain text where that is possible, as most programs expect it. A long one would not fit the
/// header of an HDF5 object, and an empty one would have no value.
void put_text(int group, int variable, const std::string& name, const std::string& text) {
  constexpr std::size_t kLongest = 4096;  // [bytes]
  const bool ascii = std::all_of(text.begin(), text.end(), [](char c) { return c > 0; });
  const char* chars = text.c_str();
  const int status = ascii && !text.empty() && text.size() <= kLongest
                         ? nc_put_att_text(group, variable, name.c_str(), text.size(), chars)
                         : nc_put_att_string(group, variable, name.c_str(), 1, &chars);
  check(status, "write attribute " + name);
}

int put_variable(int group, const std::string& name, nc_type type, const std::vector<int>& over) {
  int variable = 0;
  check(
      nc_def_var(group, name.c_str(), type, static_cast<int>(over.size()), over.data(), &variable),
      "add variable " + name);
  if (type != NC_STRING)  // which cannot go without
    check(nc_def_var_fill(group, variable, NC_NOFILL, nullptr), "add variable " + name);
  return variable;
}

/// A dimension, and the variable of the same name that labels it.
int put_dimension(int group, const std::string& name, std::size_t length,
                  const std::vector<std::string>* labels) {
  int dimension = 0;
  // A length of 0 makes a dimension that could grow, with nothing in it yet.
  check(nc_def_dim(group, name.c_str(), length, &dimension), "add dimension " + name);
  const int variable = put_variable(group, name, labels ? NC_STRING : NC_INT64, {dimension});
  if (length == 0) return dimension;
  const std::size_t start = 0;
  if (!labels) {
    std::vector<long long> index(length);
    std::iota(index.begin(), index.end(), 0LL);
    check(nc_put_vara_longlong(group, variable, &start, &length, index.data()), "count " + name);
    return dimension;
  }
  std::vector<const char*> chars;
  for (const std::string& label : *labels) chars.push_back(label.c_str());
  check(nc_put_vara_string(group, variable, &start, &length, chars.data()), "label " + name);
  return dimension;
}

void put_values(int group, int variable, const InferenceArray& array, const std::string& name,
                const std::vector<std::size_t>& lengths) {
  if (array.values.empty()) return;
  const std::vector<std::size_t> starts(lengths.size(), 0);
  int status = 0;
  if (array.boolean) {
    const std::vector<signed char> flags(array.values.begin(), array.values.end());
    status = nc_put_vara_schar(group, variable, starts.data(), lengths.data(), flags.data());
  } else if (array.integer) {
    const std::vector<long long> whole(array.values.begin(), array.values.end());
    status = nc_put_vara_longlong(group, variable, starts.data(), lengths.data(), whole.data());
  } else {
    status =
        nc_put_vara_double(group, variable, starts.data(), lengths.data(), array.values.data());
  }
  check(status, "write " + name);
}

/// Everything that netCDF or a reader would trip over.
void check_array(const std::string& name, const InferenceArray& array,
                 const InferenceGroup& group) {
  require(group.lengths.count(name) == 0, "array '{}' is named like a dimension", name);
  require(!(array.integer && array.boolean), "array '{}' is of integers and of bools", name);
  std::size_t size = 1;
  for (const std::string& dimension : array.dimensions) {
    const auto found = group.lengths.find(dimension);
    require(found != group.lengths.end(), "array '{}': dimension '{}' has no length", name,
            dimension);
    size *= found->second;
  }
  require(array.values.size() == size, "array '{}' has {} values, its dimensions {}", name,
          array.values.size(), size);
  for (const double value : array.values) {
    require(!array.boolean || value == 0 || value == 1, "array '{}' of bools has a value {}", name,
            value);
    constexpr double kLargest = 9007199254740992;  // 2^53: every integer up to it is a double
    require(!array.integer || (value == std::floor(value) && std::abs(value) <= kLargest),
            "array '{}' of integers has a value {}", name, value);
  }
}

void put_array(int group, const std::string& name, const InferenceArray& array,
               const InferenceGroup& described, const std::map<std::string, int>& dimensions) {
  check_array(name, array, described);
  std::vector<int> over;
  std::vector<std::size_t> lengths;
  for (const std::string& dimension : array.dimensions) {
    over.push_back(dimensions.at(dimension));
    lengths.push_back(described.lengths.at(dimension));
  }
  const nc_type type = array.boolean ? NC_BYTE : array.integer ? NC_INT64 : NC_DOUBLE;
  const int variable = put_variable(group, name, type, over);
  put_text(group, variable, "units", array.unit);
  if (!array.description.empty()) put_text(group, variable, "long_name", array.description);
  if (array.boolean) put_text(group, variable, "dtype", "bool");  // as xarray says it
  put_values(group, variable, array, name, lengths);
}

void put_group(int file, const std::string& name, const InferenceGroup& described,
               const std::map<std::string, std::string>& attributes) {
  int group = 0;
  check(nc_def_grp(file, name.c_str(), &group), "add group " + name);
  for (const auto& [key, text] : attributes) put_text(group, NC_GLOBAL, key, text);
  std::map<std::string, int> dimensions;
  for (const auto& [dimension, length] : described.lengths) {
    const auto found = described.coordinates.find(dimension);
    const auto* labels = found == described.coordinates.end() ? nullptr : &found->second;
    require(!labels || labels->size() == length, "dimension '{}' has {} names, its length is {}",
            dimension, labels ? labels->size() : 0, length);
    dimensions[dimension] = put_dimension(group, dimension, length, labels);
  }
  for (const auto& [dimension, labels] : described.coordinates)
    require(dimensions.count(dimension) == 1, "dimension '{}' has names, but no length", dimension);
  for (const auto& [key, array] : described.arrays)
    put_array(group, key, array, described, dimensions);
}

std::string now() {
  const std::time_t time = std::time(nullptr);
  std::tm utc{};
  (void)gmtime_r(&time, &utc);
  char text[32];
  const std::size_t size = std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S+00:00", &utc);
  return {text, size};
}

/// What ArviZ notes in every group.
std::map<std::string, std::string> group_attributes(const InferenceFile& file) {
  std::map<std::string, std::string> attributes{
      {"created_at", now()},
      {"creation_library", "thenar"},
      {"inference_library", "thenar"},
      {"inference_library_version", versions().at("thenar")}};
  for (auto& [name, text] : attributes) {
    const auto found = file.attributes.find(name);
    if (found != file.attributes.end()) text = found->second;
  }
  return attributes;
}

}  // namespace

// The file is made in memory: HDF5 cannot recover from a full disk.
void write_inference(const InferenceFile& file, const std::string& path) {
  require(file.attributes.count(kProgram) == 0, "attribute '{}' is ours", kProgram);
  require_writable(path);
  int id = 0;
  check(nc_create_mem("inference", NC_NETCDF4, 0, &id), "make a file in memory");
  NC_memio image{};
  try {
    put_text(id, NC_GLOBAL, kProgram, kCheckedProgram);
    for (const auto& [name, text] : file.attributes) put_text(id, NC_GLOBAL, name, text);
    const auto attributes = group_attributes(file);
    for (const auto& [name, group] : file.groups) put_group(id, name, group, attributes);
  } catch (...) {
    (void)nc_abort(id);
    throw;
  }
  check(nc_close_memio(id, &image), "complete a file");
  std::string bytes(static_cast<const char*>(image.memory), image.size);
  std::free(image.memory);  // NOLINT: netCDF gave it away
  write_file(path, with_checksum(std::move(bytes)));
}

}  // namespace thenar
