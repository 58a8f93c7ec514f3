#pragma once

/// Results that cost seconds, cached in a folder from one run to the next.

#include <cstdint>
#include <optional>
#include <string>

namespace thenar {

struct CacheOptions {
  std::string folder;                    // empty: nothing is kept; made with mode 700
  std::uintmax_t max_bytes = 500000000;  // limit on the size of all entries; the least recently
                                         // used are removed first [bytes]
  bool own = false;  // folder of thenar alone: an existing one is set to mode 700, too
};

/// Sets the folder that kept() and keep() of this process use from now on. A program asks for it;
/// the library by itself caches nothing.
void use_cache(const CacheOptions& options);

/// Returns the user's settings: the folder THENAR_CACHE, no cache if that is "off" or empty;
/// otherwise $XDG_CACHE_HOME/thenar or ~/.cache/thenar. THENAR_CACHE_MB is the limit in megabytes.
[[nodiscard]] CacheOptions cache_options_of_user();

/// Finds the result for an input, if it is there and whole: its checksum is computed again.
/// Entries of another build of the program are not found.
/// @param kind   of result, with a number that changes when what makes it does: "skin mesh 1"
/// @param input  all that the result depends on
[[nodiscard]] std::optional<std::string> kept(const std::string& kind, const std::string& input);

/// Stores a result. Another process sees all of it or nothing. If the folder cannot be made, is
/// full or is read-only, nothing is stored and no error is raised. Files that are no entries are
/// never touched.
void keep(const std::string& kind, const std::string& input, const std::string& result);

}  // namespace thenar
