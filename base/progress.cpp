#include "base/progress.h"

namespace thenar {

void Progress::operator()(double fraction, const std::string& what) const {
  if (report) report(fraction, what);
}

bool Progress::stop() const { return stop_requested && stop_requested(); }

}  // namespace thenar
