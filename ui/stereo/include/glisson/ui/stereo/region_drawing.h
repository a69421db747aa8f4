// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "glisson/stereo/regions.h"

namespace glisson::ui {

/// Labelling a stereo pair by mouse and keyboard, without widgets: what a click would do, and what it does.
/// With a tool, clicks draw and never move other corners (regions touch each other). Without one, they
/// select, drag corners and put new ones on an outline.
class RegionDrawing {
 public:
  using Regions = std::vector<stereo::Region>;
  /// What the next line will be.
  struct Tool {
    Feature feature = Feature::surface;
    bool closed = true;          ///< false: a curve
    double half_width_px = 6.0;  ///< of a curve
    bool operator==(const Tool&) const = default;
  };
  /// A pointer on one of the pictures.
  struct Place {
    stereo::Side side = stereo::Side::left;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();  ///< inside the picture
    double reach = 8.0;  ///< pixels of the picture within which something is taken
  };
  /// What a click at a place would do.
  enum class Click { nothing, begin, add, close, end_curve, wrong_picture, drag, insert, select };
  /// A corner of a finished region.
  struct Corner {
    std::size_t region = 0, corner = 0;
    bool operator==(const Corner&) const = default;
  };

  /// Drops an unfinished line.
  void set_tool(const std::optional<Tool>& tool);
  const std::optional<Tool>& tool() const { return tool_; }
  /// What the case holds. Other regions than those here (of another frame or case) begin a new history.
  void set_regions(const Regions& regions);
  /// What stands on another frame: even the same regions begin a new history.
  void begin_anew(const Regions& regions);
  const Regions& regions() const { return regions_; }
  /// The line that is being drawn; null: none.
  const stereo::Region* unfinished() const { return unfinished_ ? &*unfinished_ : nullptr; }
  const std::optional<std::size_t>& selected() const { return selected_; }
  void select(const std::optional<std::size_t>& region);
  const std::optional<Corner>& dragged() const { return dragged_; }

  Click click_at(const Place& place) const;
  // The following say whether the finished regions have changed.
  bool press(const Place& place);
  bool double_click(const Place& place);
  /// Moves a dragged corner; the regions count as changed at release().
  void move(const Place& place);
  bool release();
  /// Ends the unfinished line, where it has corners enough.
  bool finish();
  /// The unfinished line's last corner. @return whether there was one.
  bool take_back();
  /// Esc: the unfinished line, a drag, else the tool. @return whether there was anything.
  bool drop();
  bool remove_selected();
  bool remove_at(const Place& place);
  bool clear();
  /// One change back (of an unfinished line: one corner) or forth.
  bool undo();
  bool redo();
  bool can_undo() const { return unfinished_ || !past_.empty(); }
  bool can_redo() const { return !unfinished_ && !future_.empty(); }

 private:
  std::optional<Corner> corner_at(const Place& place) const;
  std::optional<std::size_t> region_at(const Place& place) const;
  /// A corner that may be put on the selected region's outline.
  std::optional<stereo::OutlinePlace> outline_at(const Place& place) const;
  bool change(Regions regions);

  std::optional<Tool> tool_;
  Regions regions_;
  std::optional<stereo::Region> unfinished_;
  bool press_finished_ = false;  ///< the last press has ended a line
  std::optional<std::size_t> selected_;
  std::optional<Corner> dragged_;
  Regions before_drag_;
  std::vector<Regions> past_, future_;
};

/// Whether two lists of regions are the same to the last bit.
bool same_regions(const RegionDrawing::Regions& a, const RegionDrawing::Regions& b);
/// How many of `regions` stand as they are in `former`.
int count_unchanged(const RegionDrawing::Regions& regions, const RegionDrawing::Regions& former);

}  // namespace glisson::ui
