// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "glisson/core/json_file.h"
#include "glisson/engine/case_state.h"
#include "glisson/patient/picture.h"
#include "glisson/patient/registration.h"

namespace glisson::experiments {

/// A case's film forwards and backwards, so that nothing in it jumps; numbers and times go on.
class SoakFilm {
 public:
  /// @throws InputError the case has no video of two frames or more.
  explicit SoakFilm(const engine::CaseState& state);
  /// @pre two frames or more.
  explicit SoakFilm(std::vector<StereoFrame> frames) : frames_(std::move(frames)) {}
  StereoFrame at(int n) const;
  int last() const { return static_cast<int>(frames_.size()) - 1; }
  /// Number of the frame's picture in the film, from 0 to last().
  int picture(int n) const;

 private:
  std::vector<StereoFrame> frames_;
};

/// Why frames were not drawn in full, and where in the film.
class SoakLosses {
 public:
  /// @param film outlives this.
  explicit SoakLosses(const SoakFilm& film) : film_(film) {}
  /// @param n number of the frame, from 0.
  void add(int n, const OverlayFrame& overlay);
  /// `soak_frames_...`: of each level and reason how many, in how many spells.
  Figures figures() const;
  /// A table of Markdown; empty when every frame was valid.
  std::string table() const;

 private:
  struct Loss {
    Level level = Level::valid;
    int frames = 0, spells = 0, longest = 0;
    int at_turns = 0;             ///< spells that began within three frames of where the film turns round
    std::map<int, int> pictures;  ///< how often each picture of the film was lost
  };
  const SoakFilm& film_;
  std::map<std::string, Loss> losses_;
  std::string last_;
  int spell_ = 0, frames_ = 0;
};

}  // namespace glisson::experiments
