#include <netcdf.h>
#include <netcdf_mem.h>

#include "base/error.h"
#include "data/io/checked_file.h"
#include "data/io/file_guard.h"
#include "data/io/hdf5_guard.h"
#include "data/io/inference_file.h"
#include "data/io/trial_run.h"

namespace thenar {
namespace {

void check_read(int status, const std::string& what) {
  require(status == NC_NOERR, "netCDF could not {}: {}", what, nc_strerror(status));
}

/// An open file in memory.
class Reading {
 public:
  explicit Reading(std::string& bytes) : bytes_(bytes), left_(bytes.size()) {
    check_read(nc_open_mem("inference", NC_NOWRITE, bytes_.size(), bytes_.data(), &file_),
               "open it");
  }
  ~Reading() { (void)nc_close(file_); }
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;
  [[nodiscard]] int file() const { return file_; }
  [[nodiscard]] std::size_t size() const { return bytes_.size(); }  // [bytes]

  /// Holds what is about to be taken against the file: nothing in it stands there twice.
  void take(std::size_t bytes, const std::string& what) {
    require(bytes <= left_, "{} promises more bytes than are left of the file's {}", what,
            bytes_.size());
    left_ -= bytes;
  }

  /// One text, whose memory netCDF gives away. @param get  netCDF's call that puts it there
  template <typename Get>
  std::string text(const std::string& what, const Get& get) {
    char* chars = nullptr;
    check_read(get(&chars), "read " + what);
    const std::string found = chars == nullptr ? "" : chars;
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
  if (type == NC_CHAR) {
    reading.take(length, what);
    std::string text(length, '\0');
    check_read(nc_get_att_text(group, variable, name.c_str(), text.data()), "read " + what);
    return text;
  }
  require(type == NC_STRING && length == 1, "{} is no text", what);
  return reading.text(
      what, [&](char** to) { return nc_get_att_string(group, variable, name.c_str(), to); });
}

std::string name_of_dimension(int group, int dimension) {
  char name[NC_MAX_NAME + 1];
  check_read(nc_inq_dimname(group, dimension, name), "read a dimension");
  return name;
}

/// The shape and the type of a variable.
struct VariableShape {
  std::string name;
  nc_type type = NC_DOUBLE;
  std::vector<std::string> dimensions;
};

VariableShape get_shape(int group, int variable) {
  char name[NC_MAX_NAME + 1];
  VariableShape shape;
  int rank = 0;
  check_read(nc_inq_var(group, variable, name, &shape.type, &rank, nullptr, nullptr),
             "read a variable");
  shape.name = name;
  std::vector<int> over(static_cast<std::size_t>(rank));
  check_read(nc_inq_vardimid(group, variable, over.data()), "read a variable");
  for (const int dimension : over) shape.dimensions.push_back(name_of_dimension(group, dimension));
  return shape;
}

/// Names along a dimension: a variable that is named like it need not lie along it.
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

/// Number of values, which the file must have in bytes at least.
std::size_t size_of(const VariableShape& shape, const InferenceGroup& group, std::size_t most) {
  std::size_t size = 1;
  for (const std::string& dimension : shape.dimensions) {
    const auto found = group.lengths.find(dimension);
    require(found != group.lengths.end(),
            "'{}' lies along '{}', which is no dimension of its group", shape.name, dimension);
    if (found->second == 0) return 0;
    require(size <= most / found->second, "'{}' promises more values than the file has bytes, {}",
            shape.name, most);
    size *= found->second;
  }
  return size;
}

void get_variable(Reading& reading, int group, int variable, InferenceGroup& out) {
  const VariableShape shape = get_shape(group, variable);
  if (const auto found = out.lengths.find(shape.name); found != out.lengths.end()) {
    if (shape.type == NC_STRING)
      out.coordinates[shape.name] = get_labels(reading, group, variable, shape, found->second);
    return;
  }
  require(shape.type == NC_DOUBLE || shape.type == NC_INT64 || shape.type == NC_BYTE,
          "wanted '{}' as numbers of 64 bits or as bytes, got something else", shape.name);
  InferenceArray array;
  array.dimensions = shape.dimensions;
  array.unit = get_text(reading, group, variable, "units");
  array.description = get_text(reading, group, variable, "long_name");
  array.boolean = shape.type == NC_BYTE;
  array.integer = shape.type == NC_INT64;
  array.values.resize(size_of(shape, out, reading.size()));
  if (!array.values.empty())
    check_read(nc_get_var_double(group, variable, array.values.data()), "read " + shape.name);
  out.arrays[shape.name] = std::move(array);
}

InferenceGroup get_group(Reading& reading, int group) {
  InferenceGroup out;
  int count = 0;
  check_read(nc_inq_dimids(group, &count, nullptr, 0), "list dimensions");
  std::vector<int> dimensions(static_cast<std::size_t>(count));
  check_read(nc_inq_dimids(group, &count, dimensions.data(), 0), "list dimensions");
  for (const int dimension : dimensions) {
    std::size_t length = 0;
    check_read(nc_inq_dimlen(group, dimension, &length), "read a dimension");
    out.lengths[name_of_dimension(group, dimension)] = length;
  }
  check_read(nc_inq_nvars(group, &count), "list variables");
  for (int variable = 0; variable < count; ++variable) get_variable(reading, group, variable, out);
  return out;
}

std::map<std::string, std::string> get_attributes(Reading& reading) {
  const int file = reading.file();
  int count = 0;
  check_read(nc_inq_natts(file, &count), "list attributes");
  std::map<std::string, std::string> attributes;
  for (int i = 0; i < count; ++i) {
    char name[NC_MAX_NAME + 1];
    check_read(nc_inq_attname(file, NC_GLOBAL, i, name), "list attributes");
    attributes[name] = get_text(reading, file, NC_GLOBAL, name);
  }
  return attributes;
}

InferenceFile read_open(Reading& reading, Checksum checksum, const std::string& path) {
  InferenceFile out;
  out.attributes = get_attributes(reading);
  require_ours(out.attributes[kProgram], checksum, path,
               "an inference file of thenar, got another netCDF file");
  out.attributes.erase(kProgram);
  int count = 0;
  check_read(nc_inq_grps(reading.file(), &count, nullptr), "list groups");
  std::vector<int> groups(static_cast<std::size_t>(count));
  check_read(nc_inq_grps(reading.file(), &count, groups.data()), "list groups");
  for (const int group : groups) {
    char name[NC_MAX_NAME + 1];
    check_read(nc_inq_grpname(group, name), "list groups");
    out.groups[name] = get_group(reading, group);
  }
  return out;
}

/// @param bytes  of a file; the libraries want to be able to change them, and do not
InferenceFile read_inference_image(std::string& bytes, Checksum checksum, const std::string& path) {
  (void)guard_hdf5(bytes, path);  // netCDF-4 is HDF5
  try {
    Reading reading(bytes);
    return read_open(reading, checksum, path);
  } catch (const InputError& error) {
    throw DataError(path, 1, error.what());
  }
}

}  // namespace

InferenceFile read_inference(const std::string& path) {
  if (!has_hdf5_start(path))
    throw DataError(path, 1, "wanted an inference file (netCDF-4), got none or another format");
  std::string bytes = read_guarded(path, GuardedKind::kInference);
  const Checksum checksum = take_checksum(bytes, path);
  try_first(path, seconds_to_read(bytes.size()),
            [&] { (void)read_inference_image(bytes, checksum, path); });
  return read_inference_image(bytes, checksum, path);
}

}  // namespace thenar
