#include "data/io/hdf5_guard.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <new>
#include <string_view>
#include <type_traits>
#include <utility>

#include <hdf5.h>
#include <hdf5_hl.h>

#include "base/error.h"
#include "base/file_io.h"

namespace thenar {
namespace {

constexpr int kMaxGroupDepth = 8;     // Deepest nesting of groups; ours need 4
constexpr int kMaxDimensions = 8;     // Most dimensions of an array; ours need 3
constexpr int kMaxAttributes = 1000;  // Most attributes of one object; each is searched among all
constexpr std::size_t kMaxObjects = 100'000;  // Most groups, datasets and attributes together

static_assert(std::is_same_v<hid_t, std::int64_t> && std::is_same_v<herr_t, int>);

using Names = std::vector<std::string>;

/// Lists every hard link of a group; soft and external links lead elsewhere and are ignored.
herr_t list_link(hid_t /*group*/, const char* name, const H5L_info_t* info, void* data) {
  auto& names = *static_cast<Names*>(data);
  if (info->type == H5L_TYPE_HARD) names.emplace_back(name);
  return names.size() > kMaxObjects ? -1 : 0;
}

/// Walk over all objects, with the number of the file's bytes that are left for them.
class Hdf5Walk {
 public:
  Hdf5Walk(hid_t file, std::size_t bytes) : file_(file), size_(bytes), left_(bytes) {}

  Names datasets() {
    Names found;
    // Depth-first over the groups, on a stack of our own.
    std::vector<std::pair<std::string, int>> groups{{"/", 0}};  // with their depth
    while (!groups.empty()) {
      const auto [group, depth] = groups.back();
      groups.pop_back();
      require(depth <= kMaxGroupDepth, "groups nest deeper than {}", kMaxGroupDepth);
      for (const std::string& name : links_of(group)) {
        const std::string key = group == "/" ? name : fmt::format("{}/{}", group, name);
        const Hdf5Object object(H5Oopen(file_, key.c_str(), H5P_DEFAULT), H5Oclose, "open " + key);
        const H5I_type_t type = H5Iget_type(object);
        // Groups are visited later; datasets are checked here.
        if (type == H5I_GROUP) groups.emplace_back(key, depth + 1);
        if (type == H5I_DATASET) {
          check_dataset(object, key);
          found.push_back(key);
        }
        check_attributes(object, key);
      }
    }
    const Hdf5Object root(H5Gopen2(file_, "/", H5P_DEFAULT), H5Gclose, "open the root");
    check_attributes(root, "/");
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  Names links_of(const std::string& key) {
    const Hdf5Object group(H5Gopen2(file_, key.c_str(), H5P_DEFAULT), H5Gclose, "open " + key);
    Names names;
    require(H5Literate(group, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, list_link, &names) >= 0,
            "HDF5 could not list '{}'", key);
    take_objects(names.size());
    return names;
  }

  void check_dataset(hid_t dataset, const std::string& key) {
    const Hdf5Object space(H5Dget_space(dataset), H5Sclose, "read the shape of " + key);
    const Hdf5Object type(H5Dget_type(dataset), H5Tclose, "read the type of " + key);
    const Hdf5Object made(H5Dget_create_plist(dataset), H5Pclose, "read the layout of " + key);
    const std::size_t entry = std::max<std::size_t>(1, H5Tget_size(type));
    take(space, entry, key);
    // Values must lie in this file.
    const H5D_layout_t layout = H5Pget_layout(made);
    require(layout == H5D_CONTIGUOUS || layout == H5D_COMPACT || layout == H5D_CHUNKED,
            "'{}' does not lie in the file", key);
    require(H5Pget_external_count(made) <= 0, "'{}' does not lie in the file", key);
    if (layout == H5D_CHUNKED) check_chunk(made, entry, key);
  }

  /// A chunk is unpacked as a whole, whatever part of it is read.
  void check_chunk(hid_t made, std::size_t entry, const std::string& key) const {
    hsize_t lengths[H5S_MAX_RANK];
    const int rank = H5Pget_chunk(made, H5S_MAX_RANK, lengths);
    require(rank >= 0, "HDF5 could not tell the pieces of '{}'", key);
    // Size of the pieces in which netCDF stores arrays that can grow [bytes]
    constexpr std::size_t kNetcdfPieceBytes = 4u << 20;
    (void)product(lengths, rank, entry, std::max(size_, kNetcdfPieceBytes),
                  "a piece of '" + key + "'");
  }

  void check_attributes(hid_t object, const std::string& key) {
    const int count = H5Aget_num_attrs(object);
    require(count >= 0 && count <= kMaxAttributes, "'{}' has {} attributes, wanted at most {}", key,
            count, kMaxAttributes);
    take_objects(static_cast<std::size_t>(count));
    // Attributes may promise as much as arrays.
    for (int i = 0; i < count; ++i) {
      const std::string what = fmt::format("attribute {} of '{}'", i + 1, key);
      const Hdf5Object attribute(H5Aopen_by_idx(object, ".", H5_INDEX_NAME, H5_ITER_NATIVE,
                                                static_cast<hsize_t>(i), H5P_DEFAULT, H5P_DEFAULT),
                                 H5Aclose, "open " + what);
      const Hdf5Object space(H5Aget_space(attribute), H5Sclose, "read the shape of " + what);
      const Hdf5Object type(H5Aget_type(attribute), H5Tclose, "read the type of " + what);
      take(space, std::max<std::size_t>(1, H5Tget_size(type)), what);
    }
  }

  void take_objects(std::size_t count) {
    objects_ += count;
    require(objects_ <= kMaxObjects, "wanted at most {} groups, arrays and attributes, got more",
            kMaxObjects);
  }

  /// Subtracts the bytes that an array or attribute promises from what is left of the file.
  void take(hid_t space, std::size_t entry, const std::string& what) {
    hsize_t lengths[H5S_MAX_RANK];
    const int rank = H5Sget_simple_extent_ndims(space);
    require(rank >= 0 && rank <= kMaxDimensions, "'{}' has {} dimensions, wanted at most {}", what,
            rank, kMaxDimensions);
    if (H5Sget_simple_extent_type(space) == H5S_NULL) return;
    require(H5Sget_simple_extent_dims(space, lengths, nullptr) == rank,
            "HDF5 could not tell the shape of '{}'", what);
    left_ -= product(lengths, rank, entry, left_, "'" + what + "'");
  }

  /// entry * lengths[0] * ..., at most `most`; safe if the product would overflow.
  std::size_t product(const hsize_t* lengths, int rank, std::size_t entry, std::size_t most,
                      const std::string& what) const {
    if (std::find(lengths, lengths + rank, 0) != lengths + rank) return 0;
    std::size_t all = entry;
    for (int i = 0; i < rank; ++i) {
      require(lengths[i] <= most / all, "{} promises more bytes than are left of the file's {}",
              what, size_);
      all *= static_cast<std::size_t>(lengths[i]);
    }
    require(all <= most, "{} promises more bytes than are left of the file's {}", what, size_);
    return all;
  }

  hid_t file_;
  std::size_t size_, left_;  // of the file [bytes]
  std::size_t objects_ = 0;
};

}  // namespace

Hdf5Object::Hdf5Object(std::int64_t id, Close close, const std::string& what)
    : id_(id), close_(close) {
  require(id >= 0, "HDF5 could not {}", what);
}

std::unique_lock<std::recursive_mutex> lock_hdf5() {
  static std::recursive_mutex one_at_a_time;
  return std::unique_lock<std::recursive_mutex>(one_at_a_time);
}

std::vector<std::string> guard_hdf5(std::string& bytes, const std::string& path) try {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // otherwise the library prints its errors
  // The library neither copies nor frees the bytes, nor changes them, as it opens them to read.
  constexpr unsigned kImageFlags = H5LT_FILE_IMAGE_DONT_COPY | H5LT_FILE_IMAGE_DONT_RELEASE;
  const Hdf5Object file(H5LTopen_file_image(bytes.data(), bytes.size(), kImageFlags), H5Fclose,
                        "open the file");
  return Hdf5Walk(file, bytes.size()).datasets();
} catch (const InputError& error) {
  throw DataError(path, 1, error.what());
}

namespace {

// Most memory beyond that of this process [bytes]
constexpr rlim_t kMaxExtraMemory = 1000 * 1000 * 1000;

/// Address space of this process [bytes].
rlim_t memory_in_use() {
  constexpr std::size_t kMaxStatmBytes = 1000;  // Most bytes of the file [bytes]
  const std::string pages = read_file("/proc/self/statm", kMaxStatmBytes);
  return std::stoull(pages) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

void lower_limit(int resource, rlim_t value) {
  rlimit limit{};
  if (getrlimit(static_cast<__rlimit_resource>(resource), &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_cur, value);
  (void)setrlimit(static_cast<__rlimit_resource>(resource), &limit);
}

constexpr std::size_t kMaxMessage = 4000;  // Most bytes that a pipe takes at once [bytes]
// Exit statuses of the copy: the file is refused, or memory does not suffice
constexpr int kRefusedStatus = 1, kMemoryStatus = 2;

/// Work of the copy. Nothing of it is seen outside except its exit status and a message.
[[noreturn]] void run_limited(rlim_t memory, int seconds, const std::function<void()>& work,
                              int message) {
  // The copy dies with its parent, by default handlers, without a core file, in limited time.
  (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGXCPU, SIGINT, SIGTERM})
    (void)std::signal(signal, SIG_DFL);
  lower_limit(RLIMIT_CORE, 0);
  lower_limit(RLIMIT_CPU, static_cast<rlim_t>(seconds));
#ifndef __SANITIZE_ADDRESS__  // whose shadow takes more than all memory
  lower_limit(RLIMIT_AS, memory + kMaxExtraMemory);
#else
  (void)memory;
#endif
  // The exit status tells what went wrong.
  int end = 0;
  try {
    work();
  } catch (const std::bad_alloc&) {
    end = kMemoryStatus;
  } catch (const std::exception& error) {
    const std::string_view words = std::string_view(error.what()).substr(0, kMaxMessage);
    end = write(message, words.data(), words.size()) >= 0 ? kRefusedStatus : kMemoryStatus;
  }
  _exit(end);
}

/// The message of a copy that has ended.
std::string message_in(int pipe) {
  std::string words(kMaxMessage, ' ');
  const ssize_t size = read(pipe, words.data(), words.size());
  words.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  return words;
}

/// Reason why a copy did not return 0, in words. @param message  of the copy
std::string reason(int status, const std::string& message, const std::string& path) {
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
    return "it is damaged: reading it does not end";
  if (WIFSIGNALED(status))
    return fmt::format("it is damaged: reading it crashes ({})", strsignal(WTERMSIG(status)));
  if (WEXITSTATUS(status) == kMemoryStatus)
    return fmt::format("reading it takes more than {} MB of memory", kMaxExtraMemory / 1'000'000);
  if (WEXITSTATUS(status) != kRefusedStatus || message.empty())
    return "it is damaged: reading it fails";
  // The path is added again by the error.
  const std::string place = path + ":1: ";
  return message.compare(0, place.size(), place) == 0 ? message.substr(place.size()) : message;
}

}  // namespace

void try_in_fork(const std::string& path, int seconds, const std::function<void()>& work) {
  // A pipe that neither blocks nor survives an exec.
  const rlim_t memory = memory_in_use();
  std::array<int, 2> ends{-1, -1};
  require(pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) == 0, "no pipe to read '{}' through: {}", path,
          std::strerror(errno));
  // Copy the process; the copy never returns from its work.
  const pid_t copy = fork();
  if (copy == 0) run_limited(memory, seconds, work, ends[1]);
  const int no_copy = copy < 0 ? errno : 0;
  // Wait for the copy, and read its message.
  int status = 0, no_news = 0;
  while (copy > 0 && no_news == 0 && waitpid(copy, &status, 0) < 0)
    if (errno != EINTR) no_news = errno;
  const std::string message = message_in(ends[0]);
  for (const int end : ends) (void)close(end);
  // Report what failed here, then what failed there.
  require(no_copy == 0, "no process to read '{}' in: {}", path, std::strerror(no_copy));
  require(no_news == 0, "no news of the process that reads '{}': {}", path, std::strerror(no_news));
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGINT || signal == SIGTERM) (void)raise(signal);  // was meant for us, too
  throw DataError(path, 1, reason(status, message, path));
}

}  // namespace thenar
