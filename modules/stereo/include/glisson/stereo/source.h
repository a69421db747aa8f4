// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "glisson/geometry/camera.h"
#include "glisson/patient/picture.h"

namespace glisson::stereo {

/// How the two views come.
enum class Layout {
  side_by_side,     ///< left half, right half
  top_bottom,       ///< upper half, lower half
  row_interleaved,  ///< even rows, odd rows
  separate          ///< two files, patterns or devices
};

/// What of each view is kept, pixels. A width or height of 0: everything right of x, below y.
struct Crop {
  int x = 0, y = 0, width = 0, height = 0;
  bool any() const { return x != 0 || y != 0 || width != 0 || height != 0; }
};

/// Where stereo frames come from: see StereoVideo in picture_io.h, the reader of them all.
struct SourceOptions {
  /// A video file; a folder of picture pairs, or one side's pictures (see picture_pairs.h); a live device
  /// ("device:0", or what OpenCV opens by name: "device:/dev/video2", "device:" and a GStreamer pipeline); a
  /// server of OpenIGTLink and its devices of the two views ("igtl:192.168.1.20:18944/Left,Right").
  std::string left;
  std::string right;  ///< the other side's; empty unless the layout is separate
  Layout layout = Layout::side_by_side;
  bool right_first = false;  ///< the right view is the left (upper, even) one
  bool deinterlace = false;  ///< each view's first field only, the rows between from their neighbours
  Crop crop;                 ///< of each view, after it was taken apart
  double pictures_per_second = 30.0;  ///< of folders, which have no times
  double largest_skew = 0.0;          ///< seconds between the views of a pair; 0: half a frame's time

  /// @throws InputError naming the field.
  void validate() const;
};

/// Whether a source's name is that of a live device ("device:0"), not of a file.
bool is_device(std::string_view source);
/// The device in such a name ("0"), and the name for a device. @pre is_device(source).
std::string device_of(std::string_view source);
std::string device_source(std::string_view device);
/// Whether a source's name is that of a server of OpenIGTLink ("igtl:HOST:PORT/LEFT,RIGHT"), and the name for
/// what follows the colon.
bool is_igtl(std::string_view source);
std::string igtl_source(std::string_view pictures);
/// Either: no file, and without an end.
bool is_live(std::string_view source);
/// Whether a file's name stands for several pictures ("left_*.png").
bool is_pattern(std::string_view source);

/// JSON {"left": "scope.mkv", "layout": "top_bottom", "deinterlace": true, "crop": [0, 4, 0, 532], ...};
/// paths in it are relative to its folder. Wherever a stereo video can be named, such a file can.
/// @throws FileError; InputError naming the field.
SourceOptions read_source(const std::filesystem::path& path);
/// Atomic. Paths are written as they are; whoever writes them has chosen them (remember_sources()).
void write_source(const std::filesystem::path& path, const SourceOptions& options);

/// How pictures were cut out of a source's views.
struct Cut {
  int whole_width = 0, whole_height = 0;  ///< of a view, pixels
  Crop crop;
};
/// Whether pictures of this size are what a cut leaves. @param width, height pixels; 0: not known, they may
/// be.
bool leaves(const Cut& cut, int width, int height);
/// How a video's views are cut; opens it. Empty: `video` is no source's file (JSON), it cuts nothing, or
/// gives pictures of another size.
/// @param width, height of the pictures in question, pixels; 0: not known.
/// @throws as read_source() and StereoVideo.
std::optional<Cut> cut_of(const std::filesystem::path& video, int width, int height);

/// The calibration of the cropped pictures. @throws InputError a crop that leaves nothing, or no principal
/// point.
StereoRig cropped(const StereoRig& rig, const Crop& crop);

/// What the laparoscope shows: a disk before black; an ellipse where the pixels are not square.
struct ScopeCircle {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< pixels
  double radius = 0.0;                               ///< along the rows, pixels
  double aspect = 1.0;                               ///< of its radius along the columns to that
};
/// Finds the edge of the laparoscope's picture, by a robust circle, or an ellipse along the axes, through
/// where rays from the middle leave the light. Light is what exceeds the noise of the darkest corners.
/// @return empty: the picture is filled; what is dark is no disk's outside; or the light fades without a rim.
std::optional<ScopeCircle> find_scope_circle(const Picture& picture);
/// One channel: 255 inside the circle less `margin_px` (its edge is blurred), 0 outside.
Picture circle_mask(const ScopeCircle& circle, int width, int height, double margin_px = 4.0);

}  // namespace glisson::stereo
