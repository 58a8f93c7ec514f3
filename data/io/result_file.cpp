#include "data/io/result_file.h"

#include <numeric>

#include <hdf5.h>
#include <hdf5_hl.h>

#include "base/error.h"
#include "base/file_io.h"
#include "base/lists.h"
#include "data/io/checked_file.h"
#include "data/io/file_guard.h"
#include "data/io/hdf5_guard.h"
#include "data/io/result_layout.h"

namespace thenar {
namespace {

Hdf5Object string_type() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return {type, H5Tclose, "make a string type"};
}

Hdf5Object link_options() {
  const hid_t list = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_create_intermediate_group(list, 1);
  return {list, H5Pclose, "make link options"};
}

/// Datasets without the time at which they were made: the same result is the same bytes.
Hdf5Object dataset_options() {
  const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_obj_track_times(list, false);
  return {list, H5Pclose, "make dataset options"};
}

void write_attribute(hid_t object, const char* name, const std::string& text) {
  const Hdf5Object type = string_type();
  const Hdf5Object space(H5Screate(H5S_SCALAR), H5Sclose, "make a scalar space");
  const Hdf5Object attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose, std::string("add attribute ") + name);
  const char* chars = text.c_str();
  require(H5Awrite(attribute, type, &chars) >= 0, "HDF5 could not write attribute {}", name);
}

/// Reads variable-length texts of attributes and arrays, and frees HDF5's copies. Many texts may
/// point to the same bytes of a file, but together they may not be longer than the file.
class TextReader {
 public:
  explicit TextReader(std::size_t most) : left_(most) {}

  /// @param read  stores a pointer to a new text in its argument; false: it failed
  template <typename Read>
  std::string one(const std::string& what, const Read& read) {
    char* chars = nullptr;
    require(read(static_cast<void*>(&chars)), "HDF5 could not read {}", what);
    std::string text = chars == nullptr ? "" : chars;
    (void)H5free_memory(chars);
    require(text.size() <= left_, "the texts are longer than the file, up to {}", what);
    left_ -= text.size();
    return text;
  }

 private:
  std::size_t left_;  // [bytes]
};

/// Returns whether a type is a text of variable length, which is one pointer for each entry.
bool is_text(hid_t type) {
  return H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) > 0;
}

std::string read_attribute(hid_t object, const char* name, TextReader& texts) {
  if (H5Aexists(object, name) <= 0) return {};
  const std::string what = fmt::format("attribute '{}'", name);
  const Hdf5Object attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose, "open " + what);
  const Hdf5Object space(H5Aget_space(attribute), H5Sclose, "read the shape of " + what);
  const Hdf5Object stored(H5Aget_type(attribute), H5Tclose, "read the type of " + what);
  // One text; anything else could take more memory than the file has.
  require(is_text(stored) && H5Sget_simple_extent_npoints(space) == 1,
          "wanted {} as one text of variable length, got something else", what);
  const Hdf5Object type = string_type();
  return texts.one(what, [&](void* to) { return H5Aread(attribute, type, to) >= 0; });
}

/// Group of a key with a trailing slash; "" for the root.
std::string group_of(const std::string& key) {
  const auto slash = key.rfind('/');
  return slash == std::string::npos ? "" : key.substr(0, slash + 1);
}

/// Attaches a dimension scale for one labelled length in one group, written once.
void attach_scale(hid_t file, hid_t dataset, const std::string& group, const std::string& label,
                  unsigned axis, hsize_t length) {
  const std::string name = group + label;
  if (H5LTpath_valid(file, name.c_str(), true) <= 0) {
    // The first array with this label writes the scale 0, 1, ..
    std::vector<double> index(length);
    std::iota(index.begin(), index.end(), 0.0);
    const Hdf5Object space(H5Screate_simple(1, &length, nullptr), H5Sclose, "make a space");
    const Hdf5Object links = link_options();
    const Hdf5Object scale(H5Dcreate2(file, name.c_str(), H5T_NATIVE_DOUBLE, space, links,
                                      dataset_options(), H5P_DEFAULT),
                           H5Dclose, "add dimension " + name);
    require(H5Dwrite(scale, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, index.data()) >= 0 &&
                H5DSset_scale(scale, label.c_str()) >= 0,
            "HDF5 could not write dimension {}", name);
  }
  const Hdf5Object scale(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, "open " + name);
  require(H5DSattach_scale(dataset, scale, axis) >= 0, "HDF5 could not label dimension {}", name);
}

void write_array(hid_t file, const std::string& key, const ResultArray& array) {
  // Shape; groups on the way are made.
  const std::vector<hsize_t> shape(array.shape.begin(), array.shape.end());
  const Hdf5Object space(
      shape.empty() ? H5Screate(H5S_SCALAR)
                    : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
      H5Sclose, "make a space");
  const Hdf5Object links = link_options();
  const Hdf5Object dataset(H5Dcreate2(file, key.c_str(), H5T_NATIVE_DOUBLE, space, links,
                                      dataset_options(), H5P_DEFAULT),
                           H5Dclose, "add " + key);
  // Values, unit and labels.
  require(
      H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.values.data()) >= 0,
      "HDF5 could not write {}", key);
  write_attribute(dataset, "units", array.unit);
  for (std::size_t k = 0; k < array.labels.size(); ++k)
    attach_scale(file, dataset, group_of(key), array.labels[k], static_cast<unsigned>(k), shape[k]);
}

void write_texts(hid_t file, const std::string& key, const std::vector<std::string>& texts) {
  // HDF5 wants pointers to the texts.
  const std::vector<const char*> chars =
      transformed(texts, [](const std::string& text) { return text.c_str(); });
  const hsize_t length = texts.size();
  const Hdf5Object type = string_type();
  const Hdf5Object space(H5Screate_simple(1, &length, nullptr), H5Sclose, "make a space");
  const Hdf5Object links = link_options();
  const Hdf5Object dataset(
      H5Dcreate2(file, key.c_str(), type, space, links, dataset_options(), H5P_DEFAULT), H5Dclose,
      "add " + key);
  require(length == 0 || H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, chars.data()) >= 0,
          "HDF5 could not write {}", key);
}

/// Reads a list of texts one by one, so that their total length is limited by the file.
std::vector<std::string> read_texts(hid_t dataset, hid_t space, const std::string& key,
                                    TextReader& reader) {
  const auto count = static_cast<hsize_t>(H5Sget_simple_extent_npoints(space));
  const Hdf5Object memory = string_type();
  const Hdf5Object one(H5Screate(H5S_SCALAR), H5Sclose, "make a scalar space");
  std::vector<std::string> texts;
  for (hsize_t i = 0; i < count; ++i) {
    const hsize_t length = 1;
    if (H5Sget_simple_extent_ndims(space) == 1)
      require(H5Sselect_hyperslab(space, H5S_SELECT_SET, &i, nullptr, &length, nullptr) >= 0,
              "HDF5 could not find an entry of {}", key);
    texts.push_back(reader.one(
        key, [&](void* to) { return H5Dread(dataset, memory, one, space, H5P_DEFAULT, to) >= 0; }));
  }
  return texts;
}

/// Reads numbers or a list of texts. @throws InputError for anything else.
void read_dataset(hid_t file, const std::string& key, TextReader& texts, ResultFile& out) {
  // Dimension scales are labels, not results.
  const Hdf5Object dataset(H5Dopen2(file, key.c_str(), H5P_DEFAULT), H5Dclose, "open " + key);
  if (H5DSis_scale(dataset) > 0) return;
  const Hdf5Object space(H5Dget_space(dataset), H5Sclose, "read the shape of " + key);
  const Hdf5Object type(H5Dget_type(dataset), H5Tclose, "read the type of " + key);
  const int rank = H5Sget_simple_extent_ndims(space);
  require(rank >= 0 && rank <= 3, "'{}' has {} dimensions, wanted at most 3", key, rank);
  // Texts, or numbers of 64 bits.
  if (is_text(type)) {
    require(rank <= 1, "the texts '{}' have {} dimensions, wanted a list", key, rank);
    out.texts[key] = read_texts(dataset, space, key, texts);
    return;
  }
  require(H5Tget_class(type) == H5T_FLOAT && H5Tget_size(type) == sizeof(double),
          "wanted '{}' as numbers of 64 bits or as texts, got something else", key);
  require(H5Sget_simple_extent_type(space) != H5S_NULL, "'{}' holds nothing", key);
  // The guard compared the shape with the file's size; what was never written has no size there.
  std::vector<hsize_t> shape(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  const auto size = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
  require(size == 0 || H5Dget_storage_size(dataset) > 0, "'{}' was never written", key);
  ResultArray array{std::vector<double>(size),
                    {shape.begin(), shape.end()},
                    read_attribute(dataset, "units", texts),
                    {}};
  require(
      H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.values.data()) >= 0,
      "HDF5 could not read {}", key);
  out.arrays[key] = std::move(array);
}

/// A file in memory. HDF5 cannot recover from a full disk: it crashes at exit.
Hdf5Object memory_file(const std::string& path) {
  constexpr std::size_t kMemoryIncrement = 1 << 16;  // Size of pieces of allocated memory [bytes]
  const Hdf5Object options(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make file options");
  require(H5Pset_fapl_core(options, kMemoryIncrement, false) >= 0,
          "HDF5 could not keep a file in memory");
  return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, options), H5Fclose,
          "make '" + path + "'"};
}

/// The bytes of the file as they would stand on disk.
std::string image(hid_t file) {
  require(H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0, "HDF5 could not complete a file");
  const auto size = H5Fget_file_image(file, nullptr, 0);
  require(size > 0, "HDF5 could not tell the size of a file");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  require(H5Fget_file_image(file, bytes.data(), bytes.size()) == size,
          "HDF5 could not copy a file of {} bytes", size);
  return bytes;
}

/// The library neither copies nor frees the bytes of a file in memory.
constexpr unsigned kImageIsOurs = H5LT_FILE_IMAGE_DONT_COPY | H5LT_FILE_IMAGE_DONT_RELEASE;

/// Stops the library from printing its own stack of errors.

/// @param bytes  of a file; HDF5 asks for mutable bytes, and does not change them
ResultFile read_image(std::string& bytes, Checksum checksum, const std::string& path) {
  const std::vector<std::string> keys = guard_hdf5(bytes, path);
  // Only our own files are read.
  return at_line(path, 1, [&] {
    const Hdf5Object h5(H5LTopen_file_image(bytes.data(), bytes.size(), kImageIsOurs), H5Fclose,
                        "open it");
    TextReader texts(bytes.size());
    require_ours(read_attribute(h5, "program", texts), checksum, path,
                 "a result file of thenar, got another HDF5 file");
    ResultFile out;
    for (const std::string& key : keys) read_dataset(h5, key, texts, out);
    return out;
  });
}

}  // namespace

void ResultFile::add(const std::string& key, const Eigen::Ref<const Eigen::MatrixXd>& matrix,
                     const std::string& unit, const std::vector<std::string>& labels) {
  require(labels.size() == 2 || (labels.size() == 1 && matrix.cols() == 1),
          "array '{}' has {} labels for a {} x {} matrix", key, labels.size(), matrix.rows(),
          matrix.cols());
  ResultArray array{{}, {static_cast<std::size_t>(matrix.rows())}, unit, labels};
  // Row by row, as files have it.
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

Eigen::MatrixXd finite_matrix(const ResultFile& file, const std::string& path,
                              const std::string& key, Eigen::Index rows, Eigen::Index columns) {
  if (file.arrays.count(key) == 0) throw DataError(path, 1, fmt::format("it has no '{}'", key));
  const Eigen::MatrixXd values = file.matrix(key);
  if (values.rows() != rows || values.cols() != columns)
    throw DataError(path, 1,
                    fmt::format("'{}': wanted {} x {} numbers, got {} x {}", key, rows, columns,
                                values.rows(), values.cols()));
  if (!values.allFinite())
    throw DataError(path, 1, fmt::format("'{}' has numbers that are not finite", key));
  return values;
}

std::string ResultFile::text_or_none(const std::string& key) const {
  const auto found = texts.find(key);
  return found == texts.end() || found->second.empty() ? "" : found->second.front();
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
  const auto lock = lock_hdf5();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // otherwise the library prints its errors
  require_writable(path);
  // Into memory first, then to disk in one go.
  const Hdf5Object h5 = memory_file(path);
  write_attribute(h5, "program", kCheckedProgram);
  for (const auto& [key, array] : file.arrays) write_array(h5, key, array);
  for (const auto& [key, texts] : file.texts) write_texts(h5, key, texts);
  write_file(path, with_checksum(image(h5)));
}

ResultFile read_result(const std::string& path) {
  const auto lock = lock_hdf5();
  if (!has_hdf5_start(path))
    throw DataError(path, 1, "wanted an HDF5 result file that thenar wrote");
  std::string bytes = read_guarded(path, GuardedKind::kResult);
  // Verify the checksum, try in a copy of the process, then read.
  const Checksum checksum = take_checksum(bytes, path);
  try_in_fork(path, seconds_to_read(bytes.size()),
              [&] { (void)read_image(bytes, checksum, path); });
  ResultFile file = read_image(bytes, checksum, path);
  check_layout(file, path);
  return file;
}

}  // namespace thenar
