#include <fstream>
#include <sstream>

#include <netcdf.h>
#include <netcdf_mem.h>

#include "base/error.h"
#include "data/io/inference_file.h"

namespace thenar {
namespace {

constexpr const char* kProgram = "program";  // attribute of the file: it is one of ours

void check(int status, const std::string& what) {
  require(status == NC_NOERR, "netCDF could not {}: {}", what, nc_strerror(status));
}

/// An open file in memory.
class Reading {
 public:
  explicit Reading(std::string bytes) : bytes_(std::move(bytes)) {
    check(nc_open_mem("inference", NC_NOWRITE, bytes_.size(), bytes_.data(), &file_), "open it");
  }
  ~Reading() { (void)nc_close(file_); }
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;
  [[nodiscard]] int file() const { return file_; }

 private:
  std::string bytes_;
  int file_ = 0;
};

/// Text of an attribute; "" if there is none.
std::string get_text(int group, int variable, const std::string& name) {
  nc_type type = NC_CHAR;
  std::size_t length = 0;
  if (nc_inq_att(group, variable, name.c_str(), &type, &length) != NC_NOERR) return {};
  if (type == NC_CHAR) {
    std::string text(length, '\0');
    check(nc_get_att_text(group, variable, name.c_str(), text.data()), "read attribute " + name);
    return text;
  }
  require(type == NC_STRING && length == 1, "attribute '{}' is no text", name);
  char* chars = nullptr;
  check(nc_get_att_string(group, variable, name.c_str(), &chars), "read attribute " + name);
  const std::string text = chars;
  (void)nc_free_string(1, &chars);
  return text;
}

std::string name_of_dimension(int group, int dimension) {
  char name[NC_MAX_NAME + 1];
  check(nc_inq_dimname(group, dimension, name), "read a dimension");
  return name;
}

std::vector<std::string> get_labels(int group, int variable, std::size_t length) {
  std::vector<char*> chars(length, nullptr);
  if (length > 0) check(nc_get_var_string(group, variable, chars.data()), "read labels");
  const std::vector<std::string> labels(chars.begin(), chars.end());
  if (length > 0) (void)nc_free_string(length, chars.data());
  return labels;
}

void get_variable(int group, int variable, InferenceGroup& out) {
  char name[NC_MAX_NAME + 1];
  nc_type type = NC_DOUBLE;
  int rank = 0;
  check(nc_inq_var(group, variable, name, &type, &rank, nullptr, nullptr), "read a variable");
  std::vector<int> over(static_cast<std::size_t>(rank));
  check(nc_inq_vardimid(group, variable, over.data()), "read a variable");
  if (out.lengths.count(name) == 1) {
    if (type == NC_STRING)
      out.coordinates[name] = get_labels(group, variable, out.lengths.at(name));
    return;
  }
  InferenceArray array;
  std::size_t size = 1;
  for (const int dimension : over) {
    array.dimensions.push_back(name_of_dimension(group, dimension));
    size *= out.lengths.at(array.dimensions.back());
  }
  array.unit = get_text(group, variable, "units");
  array.description = get_text(group, variable, "long_name");
  array.boolean = type == NC_BYTE;
  array.integer = type == NC_INT64;
  array.values.resize(size);
  if (size > 0)
    check(nc_get_var_double(group, variable, array.values.data()), std::string("read ") + name);
  out.arrays[name] = std::move(array);
}

InferenceGroup get_group(int group) {
  InferenceGroup out;
  int count = 0;
  check(nc_inq_dimids(group, &count, nullptr, 0), "list dimensions");
  std::vector<int> dimensions(static_cast<std::size_t>(count));
  check(nc_inq_dimids(group, &count, dimensions.data(), 0), "list dimensions");
  for (const int dimension : dimensions) {
    std::size_t length = 0;
    check(nc_inq_dimlen(group, dimension, &length), "read a dimension");
    out.lengths[name_of_dimension(group, dimension)] = length;
  }
  check(nc_inq_nvars(group, &count), "list variables");
  for (int variable = 0; variable < count; ++variable) get_variable(group, variable, out);
  return out;
}

std::map<std::string, std::string> get_attributes(int file) {
  int count = 0;
  check(nc_inq_natts(file, &count), "list attributes");
  std::map<std::string, std::string> attributes;
  for (int i = 0; i < count; ++i) {
    char name[NC_MAX_NAME + 1];
    check(nc_inq_attname(file, NC_GLOBAL, i, name), "list attributes");
    attributes[name] = get_text(file, NC_GLOBAL, name);
  }
  return attributes;
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  if (!file || bytes.str().compare(0, 4, "\x89HDF") != 0)
    throw DataError(path, 1, "wanted an inference file (netCDF-4), got none or another format");
  return bytes.str();
}

}  // namespace

InferenceFile read_inference(const std::string& path) try {
  const Reading reading(bytes_of(path));
  InferenceFile out;
  out.attributes = get_attributes(reading.file());
  if (out.attributes[kProgram] != "thenar")
    throw DataError(path, 1, "wanted an inference file of thenar, got another netCDF file");
  out.attributes.erase(kProgram);
  int count = 0;
  check(nc_inq_grps(reading.file(), &count, nullptr), "list groups");
  std::vector<int> groups(static_cast<std::size_t>(count));
  check(nc_inq_grps(reading.file(), &count, groups.data()), "list groups");
  for (const int group : groups) {
    char name[NC_MAX_NAME + 1];
    check(nc_inq_grpname(group, name), "list groups");
    out.groups[name] = get_group(group);
  }
  return out;
} catch (const InputError& error) {
  throw DataError(path, 1, error.what());
}

}  // namespace thenar
