#pragma once

/// Work that several ranks do side by side, and whose failure they share.

#include <exception>
#include <string>

#include "base/error.h"
#include "sampling/gather_bytes.h"

namespace thenar {

/// Calls work() on this rank; once all ranks have, throws on every one if it threw on any: each its
/// own error, or that of the first rank that has one. So nobody waits for a rank that has given up.
/// Every rank must call it alike, and `work` must meet no gathers.
template <typename Work>
void agreed_work(const Ranks& ranks, Work work) {
  std::exception_ptr mine;
  std::string told;  // "!" and the error; empty: none
  try {
    work();
  } catch (const std::exception& error) {
    mine = std::current_exception();
    told = std::string("!") + error.what();
  }
  const auto all = internal::gather_bytes(ranks, told);
  if (mine) std::rethrow_exception(mine);
  for (const std::string& other : all)
    if (!other.empty()) throw Error(other.substr(1));
}

}  // namespace thenar
