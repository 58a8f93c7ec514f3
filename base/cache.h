#pragma once

/// Cache of results that take seconds, in a folder, from one run to the next.

#include <cstdint>
#include <optional>
#include <string>

namespace thenar {

struct CacheOptions {
  std::string folder;                    // empty: no cache; made with mode 700
  std::uintmax_t max_bytes = 500000000;  // limit on the size of all entries; the least recently
                                         // used are removed first [bytes]
  bool own = false;  // folder of thenar alone: an existing one is set to mode 700, too
};

/// Sets the folder that find_cached() and store_cached() of this process use from now on. Without
/// this call nothing is cached.
void use_cache(const CacheOptions& options);

/// Returns the user's settings: the folder THENAR_CACHE, or no cache if that is "off" or empty; by
/// default $XDG_CACHE_HOME/thenar or ~/.cache/thenar. THENAR_CACHE_MB is the limit in megabytes.
[[nodiscard]] CacheOptions cache_options_of_user();

/// Returns the stored result for an input, if there is one and its checksum is right. Entries of
/// other builds of the program are not found.
/// @param kind   kind of result with the version of its algorithm: "skin mesh 1"
/// @param input  everything that the result depends on
[[nodiscard]] std::optional<std::string> find_cached(const std::string& kind,
                                                     const std::string& input);

/// Stores a result. Other processes see either the complete result or nothing. If the folder cannot
/// be made, is full or is read-only, nothing is stored and no error is raised. Files that are not
/// cache entries are never touched.
void store_cached(const std::string& kind, const std::string& input, const std::string& result);

}  // namespace thenar
