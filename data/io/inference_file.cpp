#include "data/io/inference_file.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <numeric>

#include <fmt/ranges.h>
#include <netcdf.h>
#include <netcdf_mem.h>

#include "base/error.h"
#include "base/file_io.h"
#include "base/lists.h"
#include "base/provenance.h"
#include "data/io/checked_file.h"
#include "data/io/file_guard.h"
#include "data/io/hdf5_guard.h"
#include "data/io/result_layout.h"

namespace thenar {
namespace {

void check(int status, const std::string& what) {
  require(status == NC_NOERR, "netCDF could not {}: {}", what, nc_strerror(status));
}

/// Writes an attribute as plain text where possible, as most programs expect. A long text would not
/// fit the header of an HDF5 object, and an empty one would have no value.
void put_text(int group, int variable, const std::string& name, const std::string& text) {
  constexpr std::size_t kMaxText = 4096;  // [bytes]
  const bool ascii = std::all_of(text.begin(), text.end(), [](char c) { return c > 0; });
  const char* chars = text.c_str();
  const int status = ascii && !text.empty() && text.size() <= kMaxText
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

/// Adds a dimension, and the variable of the same name that labels it.
int put_dimension(int group, const std::string& name, std::size_t length,
                  const std::vector<std::string>* labels) {
  int dimension = 0;
  // A length of 0 makes a dimension that can grow, still empty.
  check(nc_def_dim(group, name.c_str(), length, &dimension), "add dimension " + name);
  const int variable = put_variable(group, name, labels ? NC_STRING : NC_INT64, {dimension});
  if (length == 0) return dimension;
  const std::size_t start = 0;
  // Without labels the entries are counted.
  if (!labels) {
    std::vector<long long> index(length);
    std::iota(index.begin(), index.end(), 0LL);
    check(nc_put_vara_longlong(group, variable, &start, &length, index.data()), "count " + name);
    return dimension;
  }
  // Labels as a variable of texts.
  std::vector<const char*> chars =
      transformed(*labels, [](const std::string& label) { return label.c_str(); });
  check(nc_put_vara_string(group, variable, &start, &length, chars.data()), "label " + name);
  return dimension;
}

void put_values(int group, int variable, const InferenceArray& array, const std::string& name,
                const std::vector<std::size_t>& lengths) {
  if (array.values.empty()) return;
  const std::vector<std::size_t> starts(lengths.size(), 0);
  int status = 0;
  // Stored as the type that the array declares.
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

/// Refuses arrays that netCDF or a reader would fail on.
void check_array(const std::string& name, const InferenceArray& array,
                 const InferenceGroup& group) {
  require(group.lengths.count(name) == 0, "array '{}' is named like a dimension", name);
  require(!(array.integer && array.boolean), "array '{}' is of integers and of bools", name);
  // The shape must follow from the dimensions.
  std::size_t size = 1;
  for (const std::string& dimension : array.dimensions) {
    const auto found = group.lengths.find(dimension);
    require(found != group.lengths.end(), "array '{}': dimension '{}' has no length", name,
            dimension);
    size *= found->second;
  }
  require(array.values.size() == size, "array '{}' has {} values, its dimensions {}", name,
          array.values.size(), size);
  // Values must fit their type.
  for (const double value : array.values) {
    require(!array.boolean || value == 0 || value == 1, "array '{}' of bools has a value {}", name,
            value);
    // 2^53: every integer of at most this size is a double [1]
    constexpr double kMaxExactInteger = 9007199254740992;
    require(!array.integer || (value == std::floor(value) && std::abs(value) <= kMaxExactInteger),
            "array '{}' of integers has a value {}", name, value);
  }
}

void put_array(int group, const std::string& name, const InferenceArray& array,
               const InferenceGroup& described, const std::map<std::string, int>& dimensions) {
  check_array(name, array, described);
  // Identifiers and lengths of the dimensions.
  const std::vector<int> over =
      transformed(array.dimensions, [&](const std::string& each) { return dimensions.at(each); });
  // Type, unit and description of the variable, then its values.
  const nc_type type = array.boolean ? NC_BYTE : array.integer ? NC_INT64 : NC_DOUBLE;
  const int variable = put_variable(group, name, type, over);
  put_text(group, variable, "units", array.unit);
  if (!array.description.empty()) put_text(group, variable, "long_name", array.description);
  if (array.boolean) put_text(group, variable, "dtype", "bool");  // as xarray marks it
  put_values(group, variable, array, name, shape_in(described, array));
}

void put_group(int file, const std::string& name, const InferenceGroup& described,
               const std::map<std::string, std::string>& attributes) {
  int group = 0;
  check(nc_def_grp(file, name.c_str(), &group), "add group " + name);
  for (const auto& [key, text] : attributes) put_text(group, NC_GLOBAL, key, text);
  // Dimensions first, with their labels.
  std::map<std::string, int> dimensions;
  for (const auto& [dimension, length] : described.lengths) {
    const auto found = described.coordinates.find(dimension);
    const auto* labels = found == described.coordinates.end() ? nullptr : &found->second;
    require(labels == nullptr || labels->size() == length,
            "dimension '{}' has {} names, its length is {}", dimension, labels ? labels->size() : 0,
            length);
    dimensions[dimension] = put_dimension(group, dimension, length, labels);
  }
  for (const auto& [dimension, labels] : described.coordinates)
    require(dimensions.count(dimension) == 1, "dimension '{}' has names, but no length", dimension);
  // Then arrays over these.
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

/// Attributes that ArviZ writes into every group.
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

// Writes into memory first, because HDF5 cannot recover from a full disk.
void write_inference(const InferenceFile& file, const std::string& path) {
  const auto lock = lock_hdf5();
  require(file.attributes.count(kProgram) == 0, "attribute '{}' is ours", kProgram);
  require_writable(path);
  int id = 0;
  // A file in memory, closed or aborted whatever happens.
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
  // Take its bytes, and add the checksum.
  check(nc_close_memio(id, &image), "complete a file");
  std::string bytes(static_cast<const char*>(image.memory), image.size);
  std::free(image.memory);  // NOLINT: netCDF gave it away
  write_file(path, with_checksum(std::move(bytes)));
}

namespace {

/// An open file in memory, with the number of its bytes that are left for texts.
class Reading {
 public:
  explicit Reading(std::string& bytes) : bytes_(bytes), left_(bytes.size()) {
    check(nc_open_mem("inference", NC_NOWRITE, bytes_.size(), bytes_.data(), &file_), "open it");
  }
  ~Reading() { (void)nc_close(file_); }
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;
  [[nodiscard]] int file() const { return file_; }
  [[nodiscard]] std::size_t size() const { return bytes_.size(); }  // [bytes]

  /// Counts bytes that are about to be taken: together they cannot exceed the file.
  void take(std::size_t bytes, const std::string& what) {
    require(bytes <= left_, "{} promises more bytes than are left of the file's {}", what,
            bytes_.size());
    left_ -= bytes;
  }

  /// Reads one text and frees netCDF's copy. @param get  netCDF's call that provides it
  template <typename Get>
  std::string text(const std::string& what, const Get& get) {
    char* chars = nullptr;
    check(get(&chars), "read " + what);
    std::string found = chars == nullptr ? "" : chars;
    (void)nc_free_string(1, &chars);
    take(found.size(), what);
    return found;
  }

 private:
  std::string& bytes_;
  std::size_t left_;  // of the file, for texts [bytes]
  int file_ = 0;
};

/// Text of an attribute; "" if there is none.
std::string get_text(Reading& reading, int group, int variable, const std::string& name) {
  nc_type type = NC_CHAR;
  std::size_t length = 0;
  if (nc_inq_att(group, variable, name.c_str(), &type, &length) != NC_NOERR) return {};
  const std::string what = fmt::format("attribute '{}'", name);
  // Short texts are characters, long ones a string.
  if (type == NC_CHAR) {
    reading.take(length, what);
    std::string text(length, '\0');
    check(nc_get_att_text(group, variable, name.c_str(), text.data()), "read " + what);
    return text;
  }
  require(type == NC_STRING && length == 1, "{} is not a text", what);
  return reading.text(
      what, [&](char** to) { return nc_get_att_string(group, variable, name.c_str(), to); });
}

std::string name_of_dimension(int group, int dimension) {
  char name[NC_MAX_NAME + 1];
  check(nc_inq_dimname(group, dimension, name), "read a dimension");
  return name;
}

/// Shape and type of a variable.
struct VariableShape {
  std::string name;
  nc_type type = NC_DOUBLE;
  std::vector<std::string> dimensions;
};

VariableShape get_shape(int group, int variable) {
  char name[NC_MAX_NAME + 1];
  VariableShape shape;
  int rank = 0;
  check(nc_inq_var(group, variable, name, &shape.type, &rank, nullptr, nullptr), "read a variable");
  shape.name = name;
  std::vector<int> over(static_cast<std::size_t>(rank));
  check(nc_inq_vardimid(group, variable, over.data()), "read a variable");
  for (const int dimension : over) shape.dimensions.push_back(name_of_dimension(group, dimension));
  return shape;
}

/// Labels along a dimension: a variable with its name must lie along it.
std::vector<std::string> get_labels(Reading& reading, int group, int variable,
                                    const VariableShape& shape, std::size_t length) {
  require(shape.dimensions.size() == 1 && shape.dimensions[0] == shape.name,
          "the coordinate '{}' lies along '{}', not along its own dimension", shape.name,
          fmt::join(shape.dimensions, "', '"));
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < length; ++i)
    labels.push_back(reading.text("the names of " + shape.name, [&](char** to) {
      return nc_get_var1_string(group, variable, &i, to);
    }));
  return labels;
}

/// Number of values; the file must have at least as many bytes.
std::size_t size_of(const VariableShape& shape, const InferenceGroup& group, std::size_t most) {
  std::size_t size = 1;
  for (const std::string& dimension : shape.dimensions) {
    const auto found = group.lengths.find(dimension);
    require(found != group.lengths.end(),
            "'{}' lies along '{}', which is not a dimension of its group", shape.name, dimension);
    if (found->second == 0) return 0;
    require(size <= most / found->second, "'{}' promises more values than the file has bytes, {}",
            shape.name, most);
    size *= found->second;
  }
  return size;
}

void get_variable(Reading& reading, int group, int variable, InferenceGroup& out) {
  const VariableShape shape = get_shape(group, variable);
  // A variable named like a dimension labels it.
  if (const auto found = out.lengths.find(shape.name); found != out.lengths.end()) {
    if (shape.type == NC_STRING)
      out.coordinates[shape.name] = get_labels(reading, group, variable, shape, found->second);
    return;
  }
  require(shape.type == NC_DOUBLE || shape.type == NC_INT64 || shape.type == NC_BYTE,
          "wanted '{}' as numbers of 64 bits or as bytes, got something else", shape.name);
  // Any other variable is an array.
  InferenceArray array;
  array.dimensions = shape.dimensions;
  array.unit = get_text(reading, group, variable, "units");
  array.description = get_text(reading, group, variable, "long_name");
  array.boolean = shape.type == NC_BYTE;
  array.integer = shape.type == NC_INT64;
  array.values.resize(size_of(shape, out, reading.size()));
  if (!array.values.empty())
    check(nc_get_var_double(group, variable, array.values.data()), "read " + shape.name);
  out.arrays[shape.name] = std::move(array);
}

InferenceGroup get_group(Reading& reading, int group) {
  InferenceGroup out;
  int count = 0;
  // Dimensions with their lengths.
  check(nc_inq_dimids(group, &count, nullptr, 0), "list dimensions");
  std::vector<int> dimensions(static_cast<std::size_t>(count));
  check(nc_inq_dimids(group, &count, dimensions.data(), 0), "list dimensions");
  for (const int dimension : dimensions) {
    std::size_t length = 0;
    check(nc_inq_dimlen(group, dimension, &length), "read a dimension");
    out.lengths[name_of_dimension(group, dimension)] = length;
  }
  // Variables over these.
  check(nc_inq_nvars(group, &count), "list variables");
  for (int variable = 0; variable < count; ++variable) get_variable(reading, group, variable, out);
  return out;
}

std::map<std::string, std::string> get_attributes(Reading& reading) {
  const int file = reading.file();
  int count = 0;
  check(nc_inq_natts(file, &count), "list attributes");
  std::map<std::string, std::string> attributes;
  for (int i = 0; i < count; ++i) {
    char name[NC_MAX_NAME + 1];
    check(nc_inq_attname(file, NC_GLOBAL, i, name), "list attributes");
    attributes[name] = get_text(reading, file, NC_GLOBAL, name);
  }
  return attributes;
}

InferenceFile read_open(Reading& reading, Checksum checksum, const std::string& path) {
  InferenceFile out;
  out.attributes = get_attributes(reading);
  // Only our own files are read.
  require_ours(out.attributes[kProgram], checksum, path,
               "an inference file of thenar, got another netCDF file");
  out.attributes.erase(kProgram);
  // Groups of the file.
  int count = 0;
  check(nc_inq_grps(reading.file(), &count, nullptr), "list groups");
  std::vector<int> groups(static_cast<std::size_t>(count));
  check(nc_inq_grps(reading.file(), &count, groups.data()), "list groups");
  for (const int group : groups) {
    char name[NC_MAX_NAME + 1];
    check(nc_inq_grpname(group, name), "list groups");
    out.groups[name] = get_group(reading, group);
  }
  return out;
}

/// @param bytes  of a file; the libraries ask for mutable bytes, and do not change them
InferenceFile read_inference_image(std::string& bytes, Checksum checksum, const std::string& path) {
  (void)guard_hdf5(bytes, path);  // netCDF-4 is HDF5
  return at_line(path, 1, [&] {
    Reading reading(bytes);
    return read_open(reading, checksum, path);
  });
}

}  // namespace

InferenceFile read_inference(const std::string& path) {
  const auto lock = lock_hdf5();
  if (!has_hdf5_start(path)) throw DataError(path, 1, "wanted a posterior file (netCDF-4)");
  std::string bytes = read_guarded(path, GuardedKind::kInference);
  // Verify the checksum, try in a copy of the process, then read.
  const Checksum checksum = take_checksum(bytes, path);
  try_in_fork(path, seconds_to_read(bytes.size()),
              [&] { (void)read_inference_image(bytes, checksum, path); });
  InferenceFile file = read_inference_image(bytes, checksum, path);
  check_layout(file, path);
  return file;
}

}  // namespace thenar
