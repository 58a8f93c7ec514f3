#include "tendons/net/build_tendons.h"

#include "base/error.h"
#include "tendons/linear_tendons.h"
#include "tendons/net/net_tendons.h"

namespace thenar {

std::unique_ptr<DigitTendons> build_digit_tendons(const Subject& subject, const std::string& digit,
                                                  const TendonOptions& options,
                                                  const NetDescription* description,
                                                  const NetBuildOptions& net) {
  if (options.hood != Hood::kFloatingNet) {
    require(description == nullptr, "net '{}' is given, but the hood asked for is not a net",
            description == nullptr ? "" : description->name);
    return build_linear_tendons(subject, digit, options);
  }
  require(description != nullptr, "a hood that floats needs the description of a net");
  return build_net_tendons(subject, digit, options, *description, net);
}

std::unique_ptr<DigitTendons> build_net_tendons(const Subject& subject, const std::string& digit,
                                                const TendonOptions& options,
                                                const NetDescription& description,
                                                const NetBuildOptions& net) {
  TendonOptions separate = options;
  separate.hood = Hood::kSeparate;
  std::unique_ptr<DigitTendons> linear = build_linear_tendons(subject, digit, separate);
  BuiltNet built = build_net(subject, linear->digit(), description, net);
  return std::make_unique<NetTendons>(std::move(linear), std::move(built));
}

TipStatics tip_statics(const TendonDigit& digit, const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                       const TendonTorque& pull) {
  TipStatics statics = tip_statics(digit, q);
  statics.R = pull.R;
  statics.tau_0 += pull.tau - pull.R.transpose() * t;
  return statics;
}

TendonTip tip_force(const DigitTendons& tendons, const Eigen::VectorXd& q,
                    const Eigen::VectorXd& t) {
  const TendonTorque pull = tendons.evaluate(q, t);
  return {tip_force(tip_statics(tendons.digit(), q, t, pull), t), pull.warning};
}

}  // namespace thenar
