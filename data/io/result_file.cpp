#include "data/io/result_file.h"

#include <algorithm>
#include <numeric>
#include <set>

#include <hdf5.h>
#include <hdf5_hl.h>

#include "base/error.h"
#include "base/write_file.h"

namespace thenar {
namespace {

/// An HDF5 handle that closes itself and refuses to be an error.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close, const std::string& what) : id_(id), close_(close) {
    require(id >= 0, "HDF5 could not {}", what);
  }
  ~Handle() { close_(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }  // NOLINT: handles are passed to C all the time

 private:
  hid_t id_;
  Close close_;
};

Handle string_type() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return {type, H5Tclose, "make a string type"};
}

Handle link_options() {
  const hid_t list = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_create_intermediate_group(list, 1);
  return {list, H5Pclose, "make link options"};
}

void write_attribute(hid_t object, const char* name, const std::string& text) {
  const Handle type = string_type();
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "make a scalar space");
  const Handle attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         std::string("add attribute ") + name);
  const char* chars = text.c_str();
  require(H5Awrite(attribute, type, &chars) >= 0, "HDF5 could not write attribute {}", name);
}

std::string read_attribute(hid_t object, const char* name) {
  if (H5Aexists(object, name) <= 0) return {};
  const Handle type = string_type();
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose, "open an attribute");
  char* chars = nullptr;
  if (H5Aread(attribute, type, &chars) < 0 || chars == nullptr) return {};
  std::string text = chars;
  H5free_memory(chars);
  return text;
}

/// Group part of a key, "" for the root.
std::string group_of(const std::string& key) {
  const auto slash = key.rfind('/');
  return slash == std::string::npos ? "" : key.substr(0, slash + 1);
}

/// A dimension scale for one labelled length in one group, written once.
void attach_scale(hid_t file, hid_t dataset, const std::string& group, const std::string& label,
                  unsigned axis, hsize_t length) {
  const std::string name = group + label;
  if (H5LTpath_valid(file, name.c_str(), 1) <= 0) {
    std::vector<double> index(length);
    std::iota(index.begin(), index.end(), 0.0);
    const Handle space(H5Screate_simple(1, &length, nullptr), H5Sclose, "make a space");
    const Handle links = link_options();
    const Handle scale(
        H5Dcreate2(file, name.c_str(), H5T_NATIVE_DOUBLE, space, links, H5P_DEFAULT, H5P_DEFAULT),
        H5Dclose, "add dimension " + name);
    require(
        H5Dwrite(scale, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, index.data()) >= 0 &&
            H5DSset_scale(scale, label.c_str()) >= 0,
        "HDF5 could not write dimension {}", name);
  }
  const Handle scale(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, "open " + name);
  require(H5DSattach_scale(dataset, scale, axis) >= 0, "HDF5 could not label dimension {}", name);
}

void write_array(hid_t file, const std::string& key, const ResultArray& array) {
  const std::vector<hsize_t> shape(array.shape.begin(), array.shape.end());
  const Handle space(shape.empty()
                         ? H5Screate(H5S_SCALAR)
                         : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                     H5Sclose, "make a space");
  const Handle links = link_options();
  const Handle dataset(
      H5Dcreate2(file, key.c_str(), H5T_NATIVE_DOUBLE, space, links, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose, "add " + key);
  require(
      H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.values.data()) >= 0,
      "HDF5 could not write {}", key);
  write_attribute(dataset, "units", array.unit);
  for (std::size_t k = 0; k < array.labels.size(); ++k)
    attach_scale(file, dataset, group_of(key), array.labels[k], static_cast<unsigned>(k), shape[k]);
}

void write_texts(hid_t file, const std::string& key, const std::vector<std::string>& texts) {
  std::vector<const char*> chars(texts.size());
  std::transform(texts.begin(), texts.end(), chars.begin(),
                 [](const std::string& text) { return text.c_str(); });
  const hsize_t length = texts.size();
  const Handle type = string_type();
  const Handle space(H5Screate_simple(1, &length, nullptr), H5Sclose, "make a space");
  const Handle links = link_options();
  const Handle dataset(H5Dcreate2(file, key.c_str(), type, space, links, H5P_DEFAULT, H5P_DEFAULT),
                       H5Dclose, "add " + key);
  require(length == 0 || H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, chars.data()) >= 0,
          "HDF5 could not write {}", key);
}

void read_dataset(hid_t file, const std::string& key, ResultFile& out) {
  const Handle dataset(H5Dopen2(file, key.c_str(), H5P_DEFAULT), H5Dclose, "open " + key);
  if (H5DSis_scale(dataset) > 0) return;
  const Handle space(H5Dget_space(dataset), H5Sclose, "read the shape of " + key);
  const Handle type(H5Dget_type(dataset), H5Tclose, "read the type of " + key);
  std::vector<hsize_t> shape(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  const auto size = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));

  if (H5Tget_class(type) == H5T_STRING) {
    const Handle memory = string_type();
    std::vector<char*> chars(size, nullptr);
    require(
        size == 0 || H5Dread(dataset, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, chars.data()) >= 0,
        "HDF5 could not read {}", key);
    std::vector<std::string> texts(chars.begin(), chars.end());
    if (size > 0) H5Dvlen_reclaim(memory, space, H5P_DEFAULT, chars.data());
    out.texts[key] = std::move(texts);
    return;
  }
  ResultArray array{std::vector<double>(size),
                    {shape.begin(), shape.end()},
                    read_attribute(dataset, "units"),
                    {}};
  require(
      H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.values.data()) >= 0,
      "HDF5 could not read {}", key);
  out.arrays[key] = std::move(array);
}

/// Called for every object of the file; errors wait in the list, since this runs inside C.
herr_t visit(hid_t /*root*/, const char* name, const H5O_info_t* info, void* data) {
  if (info->type == H5O_TYPE_DATASET)
    static_cast<std::vector<std::string>*>(data)->emplace_back(name);
  return 0;
}

/// A file that lives in memory only. HDF5 cannot recover from a full disk: it crashes at exit.
Handle memory_file(const std::string& path) {
  constexpr std::size_t kIncrement = 1 << 16;  // memory is taken in such pieces [bytes]
  const Handle options(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make file options");
  require(H5Pset_fapl_core(options, kIncrement, 0) >= 0, "HDF5 could not keep a file in memory");
  return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, options), H5Fclose,
          "make '" + path + "'"};
}

/// The bytes that the file would have on disk.
std::string image(hid_t file) {
  require(H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0, "HDF5 could not complete a file");
  const auto size = H5Fget_file_image(file, nullptr, 0);
  require(size > 0, "HDF5 could not tell the size of a file");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  require(H5Fget_file_image(file, bytes.data(), bytes.size()) == size,
          "HDF5 could not copy a file of {} bytes", size);
  return bytes;
}

/// The library prints its own stack of errors unless told not to.
void be_quiet() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

}  // namespace

void ResultFile::add(const std::string& key, const Eigen::Ref<const Eigen::MatrixXd>& matrix,
                     const std::string& unit, const std::vector<std::string>& labels) {
  require(labels.size() == 2 || (labels.size() == 1 && matrix.cols() == 1),
          "array '{}' has {} labels for a {} x {} matrix", key, labels.size(), matrix.rows(),
          matrix.cols());
  ResultArray array{{}, {static_cast<std::size_t>(matrix.rows())}, unit, labels};
  if (labels.size() == 2) array.shape.push_back(static_cast<std::size_t>(matrix.cols()));
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) array.values.push_back(matrix(i, j));
  arrays[key] = std::move(array);
}

void ResultFile::add(const std::string& key, double value, const std::string& unit) {
  arrays[key] = {{value}, {}, unit, {}};
}

void ResultFile::add(const std::string& key, const std::string& text) { texts[key] = {text}; }

void ResultFile::add(const std::string& key, std::vector<std::string> list) {
  texts[key] = std::move(list);
}

Eigen::MatrixXd ResultFile::matrix(const std::string& key) const {
  const auto found = arrays.find(key);
  require(found != arrays.end(), "result file has no array '{}'", key);
  const ResultArray& array = found->second;
  require(array.shape.size() <= 2, "array '{}' has {} dimensions, wanted at most 2", key,
          array.shape.size());
  const auto rows = static_cast<Eigen::Index>(array.shape.empty() ? 1 : array.shape[0]);
  const auto columns = static_cast<Eigen::Index>(array.shape.size() == 2 ? array.shape[1] : 1);
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const RowMajor>(array.values.data(), rows, columns);
}

double ResultFile::number(const std::string& key) const {
  const Eigen::MatrixXd value = matrix(key);
  require(value.size() == 1, "result '{}' is not a single number", key);
  return value(0, 0);
}

const std::vector<std::string>& ResultFile::list(const std::string& key) const {
  const auto found = texts.find(key);
  require(found != texts.end(), "result file has no text '{}'", key);
  return found->second;
}

const std::string& ResultFile::text(const std::string& key) const {
  require(list(key).size() == 1, "result '{}' is not a single text", key);
  return list(key).front();
}

void write_result(const ResultFile& file, const std::string& path) {
  be_quiet();
  require_writable(path);
  const Handle h5 = memory_file(path);
  write_attribute(h5, "program", "thenar");
  for (const auto& [key, array] : file.arrays) write_array(h5, key, array);
  for (const auto& [key, texts] : file.texts) write_texts(h5, key, texts);
  write_file(path, image(h5));
}

ResultFile read_result(const std::string& path) {
  be_quiet();
  if (H5Fis_hdf5(path.c_str()) <= 0)
    throw DataError(path, 1, "wanted a result file (HDF5) of thenar, got none or another format");
  const Handle h5(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
                  "open '" + path + "'");
  if (read_attribute(h5, "program") != "thenar")
    throw DataError(path, 1, "wanted a result file of thenar, got another HDF5 file");
  std::vector<std::string> keys;
  require(H5Ovisit2(h5, H5_INDEX_NAME, H5_ITER_NATIVE, visit, &keys, H5O_INFO_BASIC) >= 0,
          "HDF5 could not list '{}'", path);
  ResultFile out;
  for (const std::string& key : keys) read_dataset(h5, key, out);
  return out;
}

}  // namespace thenar
