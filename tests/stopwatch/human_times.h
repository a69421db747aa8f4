// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glisson::stopwatch {

/// What a person needs for each act, in seconds. The first five are those of the keystroke-level model for a
/// person who is not practised (Card, Moran and Newell, The Psychology of Human-Computer Interaction, 1983);
/// reading is Brysbaert's mean for silent reading of English (J. Memory and Language 109, 2019). The others
/// have no source: they are stated here, long rather than short, and are the same for every CT.
struct HumanTimes {
  static constexpr double kDecide = 1.35;           ///< M, before each act
  static constexpr double kPoint = 1.10;            ///< P, with the mouse
  static constexpr double kClick = 0.20;            ///< B B, button down and up
  static constexpr double kHome = 0.40;             ///< H, the hand between mouse and keyboard
  static constexpr double kKey = 0.28;              ///< K, a typist of 40 words a minute
  static constexpr double kWord = 60.0 / 238.0;     ///< read
  static constexpr double kFindFolder = 20.0;       ///< to find the CT's folder in a dialogue
  static constexpr double kFindSlice = 3.0;         ///< to scroll to a slice and to recognise it
  static constexpr double kSlice = 0.5;             ///< to look at a slice for faults
  static constexpr double kLookAtCorrection = 5.0;  ///< whether a correction is right
  static constexpr double kLookAtSeries = 5.0;      ///< at the picture and the text of a series in the list
  static constexpr double kScrollControls = 2.0;    ///< to find a control that is out of sight
};

}  // namespace glisson::stopwatch
