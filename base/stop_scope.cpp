#include "base/stop_scope.h"

#include "base/progress_parts.h"

namespace thenar {
namespace {

thread_local const StopScope::Request* t_stop_requested = nullptr;

}  // namespace

StopScope::StopScope(const Request* stop_requested) : before_(t_stop_requested) {
  t_stop_requested = stop_requested;
}

StopScope::~StopScope() { t_stop_requested = before_; }

const StopScope::Request* StopScope::current() { return t_stop_requested; }

void end_if_stopped() {
  if (t_stop_requested != nullptr && *t_stop_requested && (*t_stop_requested)())
    throw Stopped("it was stopped");
}

}  // namespace thenar
