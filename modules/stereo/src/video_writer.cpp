// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "../codecs/opencv_codecs.h"
#include "glisson/core/claim.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/output_file.h"
#include "glisson/stereo/paced_writer.h"
#include "glisson/stereo/picture_io.h"
#include "picture_cv.h"
#include "streams.h"

namespace glisson::stereo {
namespace fs = std::filesystem;

struct VideoWriter::Impl {
  fs::path path;
  std::optional<OutputFile> file;  ///< on its way; without close() nothing remains of it
  int width = 0, height = 0, written = 0;
  cv::Size coded;                         ///< even, which the codec demands
  std::unique_ptr<cv::VideoWriter> film;  ///< null: closed

  /// Frames that can be read back; all where no reader can be had, for then nothing speaks against them.
  int readable() const {
    int frames = 0;
    try {
      FileStream stream(file->path());
      if (stream.width != coded.width || stream.height != coded.height) return 0;
      while (stream.grab()) ++frames;
    } catch (const InputError&) {
      // Broken off: what was read until then plays.
    } catch (const FileError&) {
      return written;
    }
    return frames;
  }

  /// What the codec takes: three channels, and the last column or row once more where the size is odd.
  cv::Mat codable(const Picture& picture) const {
    cv::Mat image = view(picture);
    if (image.channels() == 1) cv::cvtColor(image, image, cv::COLOR_GRAY2BGR);
    if (image.size() != coded)
      cv::copyMakeBorder(image, image, 0, coded.height - height, 0, coded.width - width,
                         cv::BORDER_REPLICATE);
    return image;
  }
};

VideoWriter::VideoWriter(const fs::path& path, int width, int height, double frames_per_second)
    : impl_(std::make_unique<Impl>()) {
  require(width > 0 && height > 0, "a video has a size");
  require(std::isfinite(frames_per_second) && frames_per_second > 0.0, "a video has a frame rate");
  if (path.extension() != ".mkv")
    throw InputError(path.string(), "", "is not a name for a recording",
                     "Use .mkv: a recording that is cut off can still be read there");
  impl_->path = path;
  impl_->file.emplace(path);
  sweep_leftovers(fs::absolute(impl_->file->path()).parent_path());  // a recording that was cut off is kept
  impl_->width = width;
  impl_->height = height;
  impl_->coded = cv::Size(width + width % 2, height + height % 2);
  impl_->film =
      codecs().film(impl_->file->path().string(), {'m', 'p', '4', 'v'}, frames_per_second, impl_->coded);
  if (!impl_->film)
    throw FileError(path.string() + ": cannot be opened for recording. Check permissions and space.");
}

VideoWriter::~VideoWriter() = default;

void VideoWriter::write(const Picture& picture) {
  require(impl_->film != nullptr, "a video that was closed takes no more pictures");
  require(picture.width == impl_->width && picture.height == impl_->height,
          "a picture has the size of its video");
  require_room(impl_->path, impl_->written, free_space);  // OpenCV says nothing of a full disk
  impl_->film->write(impl_->codable(picture));
  ++impl_->written;
}

void VideoWriter::close() {
  require(impl_->film != nullptr, "a video is closed once");
  impl_->film->release();
  impl_->film.reset();
  flush_to_disk(impl_->file->path());
  const int frames = impl_->readable();
  if (frames == 0)
    throw FileError(impl_->path.string() +
                    ": not one frame was recorded. Free some space on the disk and record again.");
  impl_->file->commit();
  if (frames != impl_->written)
    throw PartlyRecorded(impl_->path.string() + ": " + std::to_string(frames) + " of " +
                             std::to_string(impl_->written) +
                             " frames can be read back. Free some space on the disk and record again.",
                         frames);
}

}  // namespace glisson::stereo
