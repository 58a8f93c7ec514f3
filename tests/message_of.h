#pragma once

#include <string>

#include "base/error.h"

namespace thenar {

/// What a call throws, in its own words. @tparam Wanted  the kind that it ought to be
template <typename Wanted = InputError, typename Call>
std::string message_of(const Call& call) {
  try {
    call();
  } catch (const Wanted& error) {
    return error.what();
  }
  return "nothing was thrown";
}

}  // namespace thenar
