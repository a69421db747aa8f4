// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "glisson/core/frames.h"
#include "glisson/patient/label_map.h"
#include "glisson/segmentation/segment.h"

namespace glisson::segmentation {

/// How labels were found in part anew.
struct PartlyAnew {
  /// Whether a structure is as it was; background: whether any is.
  std::function<bool(Label)> is_kept;
  /// Whether what was told then is a report on all labels, as segment() gives it.
  bool is_whole = false;
  /// Whether a former note, though of a structure that is kept, was looked into again; empty: none was.
  std::function<bool(const std::string& note)> is_answered = {};
};

/// Whether each report on all labels tells of it anew; of a part of them it says nothing.
bool is_told_of_the_whole(const std::string& note);

/// " @x,y,z", LPS mm: the end of a note on a place. @param p_in_ct metres.
std::string place_text(const Eigen::Vector3d& p_in_ct);
/// What place_text() was put behind a note. Empty: nothing, or no place near a patient.
std::optional<Point<CtFrame>> place_told(const std::string& note);
/// Notes that are kept beside seeds that may change. Those that name a click by its number ("seed.liver_apart
/// 4") get its place behind it (see place_text()); those that have one, or whose click is not among the
/// seeds, stay as they are.
std::vector<std::string> with_places(std::vector<std::string> notes, const Seeds& seeds);
/// The same notes by the numbers that the clicks have in these seeds, without their places; what is told of a
/// click that is not among them is left out.
std::vector<std::string> with_numbers(const std::vector<std::string>& notes, const Seeds& seeds);
/// Whether the labels show that a note with a place holds no more: the click that was without effect has one,
/// what may be liver is, the liver is as large as one is.
bool is_settled(const std::string& note, const LabelMap& labels);

/// What is told of such labels: what was told then, behind those notes of the former labels that hold still.
/// @param former of the former labels. What a whole report tells each time (volumes, borders, sides, the
///   image) is taken from that.
std::vector<std::string> with_kept_notes(const std::vector<std::string>& former, const PartlyAnew& anew,
                                         std::vector<std::string> told);

/// Whether a search in a region has looked again into what a former note tells: of the region's border, of a
/// click that lies in it, of what is told once more with another value.
/// @param region in the frame of the seeds. @param told by that search.
bool is_answered(const std::string& note, const Eigen::AlignedBox3d& region, const Seeds& seeds,
                 const std::vector<std::string>& told);

}  // namespace glisson::segmentation
