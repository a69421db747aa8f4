// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "glisson/openigtlink/sender.h"

namespace glisson::openigtlink {

using Bytes = std::shared_ptr<const std::string>;

/// What is true now, as messages. Numbers rise with each change.
class Bulletin {
 public:
  /// @param surfaces_per_second by the frames' times.
  explicit Bulletin(double surfaces_per_second) : rate_(surfaces_per_second) {}

  /// @param model null: nothing is followed.
  /// @param epoch seconds since 1970 of the frames' time 0.
  void compose(const SentModel* model, const OverlayFrame& frame, double epoch);

  const Bytes& level() const { return level_; }
  const Bytes& surfaces() const { return surfaces_; }
  std::uint64_t level_number() const { return level_number_; }
  std::uint64_t surfaces_number() const { return surfaces_number_; }

 private:
  /// Whether surfaces are due: others are shown than before, or it is their time.
  bool are_due(const std::set<std::string>& shown, double seconds) const;
  std::string surface_messages(const SentModel* model, const OverlayFrame& frame,
                               const std::set<std::string>& shown, double stamp);

  double rate_;
  Bytes level_, surfaces_;
  std::uint64_t level_number_ = 0, surfaces_number_ = 0;
  std::set<std::string> named_;          ///< every surface ever sent
  std::set<std::string> shown_;          ///< those sent last
  std::optional<double> shown_at_;       ///< seconds of that frame
  const SentModel* shown_of_ = nullptr;  ///< compared, never followed
  Points told_;                          ///< nodes of the last frame, whose surfaces may not have been due
  std::optional<double> told_at_;        ///< seconds of that frame: the same with other nodes is a correction
};

}  // namespace glisson::openigtlink
