// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "cli.h"
#include "glisson/experiments/track_evaluation.h"
#include "glisson/model/build.h"
#include "model_argument.h"

namespace glisson::app {

/// What 'glisson track' writes: one mesh a frame, with what is known of it; frames.jsonl, a line a frame; and
/// what the track comes to.
class TrackRecord {
 public:
  /// @param digits of the numbers in the meshes' names.
  TrackRecord(Session& session, const ModelArgument& argument, const Arguments& arguments,
              std::filesystem::path folder, int digits);

  void add(int number, const OverlayFrame& overlay);
  /// Writes frames.jsonl and adds the figures to the session. @param whole false: it was cut short.
  void finish(bool whole);
  int frames() const { return evaluation_.times().frames(); }

 private:
  void write_mesh(const std::string& name, const OverlayFrame& overlay, const NamedArrays& marks) const;
  void compare(int number, const OverlayFrame& overlay);

  Session& session_;
  const ModelArgument& argument_;
  const Arguments& arguments_;
  std::filesystem::path folder_;
  int digits_;
  std::shared_ptr<const model::BuiltModel> model_;
  experiments::TrackEvaluation evaluation_;
  std::string lines_;  ///< of frames.jsonl
};

}  // namespace glisson::app
