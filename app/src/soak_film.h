// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cli.h"
#include "glisson/patient/picture.h"
#include "glisson/patient/registration.h"

namespace glisson::app {

/// A case's film forwards and backwards, so that nothing in it jumps; numbers and times go on.
class SoakFilm {
 public:
  /// @throws InputError the case has no video of two frames or more.
  explicit SoakFilm(const engine::CaseState& state);
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
  explicit SoakLosses(const SoakFilm& film) : film_(film) {}
  void add(int n, const OverlayFrame& overlay);
  void tell(Figures& figures) const;
  /// A table for the page; empty when every frame was valid.
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

}  // namespace glisson::app
