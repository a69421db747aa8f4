// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "glisson/core/run_context.h"
#include "glisson/openigtlink/receiver.h"
#include "views.h"

namespace glisson::stereo {

/// Both views from a server of OpenIGTLink, the newest pair always. Live: it has no length and ends when the
/// server closes.
class IgtlViews : public Views {
 public:
  /// @param source "igtl:HOST:PORT/LEFT,RIGHT". @param largest_skew seconds; 0: the receiver's own.
  /// Null: cancelled. @throws InputError the server does not answer, or sends no such pictures.
  static std::unique_ptr<IgtlViews> open(const std::string& source, double largest_skew,
                                         const RunContext& context);

  bool read(cv::Mat& left, cv::Mat& right) override;
  void rewind() override {}  // what is live has no beginning
  std::optional<double> came() const override { return seconds_; }

 private:
  IgtlViews(std::string source, const openigtlink::ReceiverOptions& options, const RunContext& context);

  std::string source_;
  RunContext context_;
  openigtlink::Receiver receiver_;
  std::optional<openigtlink::ReceivedPair> first_;  ///< told the size; given out first
  double seconds_ = 0.0;
};

}  // namespace glisson::stereo
