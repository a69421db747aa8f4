// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "glisson/core/run_context.h"
#include "glisson/patient/picture.h"
#include "glisson/stereo/source.h"

namespace glisson::stereo {

/// One picture, as PictureReader::read() reads it. @throws FileError, InputError.
Picture read_picture(const std::filesystem::path& path);
/// PNG, JPEG or BMP by extension; atomic.
void write_picture(const std::filesystem::path& path, const Picture& picture);

/// The reader of every source of stereo frames: videos (side by side, top and bottom, interleaved rows, two
/// files), folders of picture pairs, live devices, servers of OpenIGTLink. The views of separate sources are
/// matched by time: what has no partner within the largest skew is passed over (skipped()).
class StereoVideo {
 public:
  /// @throws FileError; InputError what cannot be read, sources that do not belong together (size, rate).
  explicit StereoVideo(const SourceOptions& options);
  /// @param left a video, a folder of picture pairs, "device:0", "igtl:HOST:PORT/LEFT,RIGHT", or a
  ///   description of a source (.json, see read_source()).
  /// @param right empty: `left` holds both views (a video: side by side).
  explicit StereoVideo(const std::filesystem::path& left, const std::filesystem::path& right = {});
  ~StereoVideo();
  /// As the constructors. A server of a network, or a dead camera, may keep one waiting: opening and reading
  /// end when the context is cancelled (within 50 ms); empty then, as read() is at its end.
  static Cancellable<std::unique_ptr<StereoVideo>> open(const std::filesystem::path& left,
                                                        const std::filesystem::path& right,
                                                        const RunContext& context);
  int width() const;  ///< of one view, as it is given out
  int height() const;
  int whole_width() const;  ///< of one view before it is cropped
  int whole_height() const;
  /// How its views are cut; empty: they are not.
  std::optional<Cut> cut() const;
  double frames_per_second() const;
  /// Frames come when they come, from a device or a server, and without an end.
  bool is_live() const;
  /// As the container says; may be more than can be read; 0: it does not say.
  int frame_count() const;
  /// The next frame. @return false at the end. @throws InputError when the video breaks off before
  /// frame_count(); when the views' times never meet.
  bool read(StereoFrame& frame);
  /// Back to the first frame, whose index and time are 0 again; skipped() is not. A live source goes on where
  /// it is, with index and time from 0.
  void rewind();
  int skipped() const;  ///< frames of either view that had no partner, so far

 private:
  struct Impl;
  explicit StereoVideo(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Writes a video (mp4v in .mkv: a killed file keeps nearly all frames). close() flushes, reads back the
/// number of frames and renames; without close() nothing remains.
/// Its codec takes even widths and heights only: the last column or row of an odd one is written twice.
/// @pre pictures of one size, one channel or three. @throws InputError another extension than .mkv,
/// FileError.
class VideoWriter {
 public:
  VideoWriter(const std::filesystem::path& path, int width, int height, double frames_per_second);
  ~VideoWriter();
  /// @throws FileError too little room is left on the disk.
  void write(const Picture& picture);
  /// Puts the file in place, also if less can be read back than was written. @pre not closed yet.
  /// @throws PartlyRecorded less can be read back; FileError nothing can, or the file cannot be put in place.
  void close();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::stereo
