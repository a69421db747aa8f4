// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>
#include <string>

#include "glisson/core/aside.h"
#include "glisson/core/run_context.h"

namespace glisson::stereo {

/// Pictures one after another, with their times.
class PictureStream {
 public:
  virtual ~PictureStream() = default;
  /// Takes the next picture. @return false at the end. Times ascend.
  virtual bool grab() = 0;
  /// The picture that was taken. @return false: it is damaged.
  virtual bool retrieve(cv::Mat& image) = 0;
  virtual void rewind() = 0;

  std::string name;
  int width = 0, height = 0;
  int frames = 0;        ///< as the container says; 0: it does not
  double rate = 0.0;     ///< per second
  double seconds = 0.0;  ///< of what was grabbed last
  bool live = false;     ///< `seconds` is the time at which it came
};

class ForeignVideo;

/// A video file.
class FileStream : public PictureStream {
 public:
  /// @throws FileError, InputError.
  explicit FileStream(const std::filesystem::path& path);
  ~FileStream() override;
  bool grab() override;
  bool retrieve(cv::Mat& image) override;
  void rewind() override;
  int count_frames();  ///< by reading them

 private:
  void open();

  std::filesystem::path path_;
  std::unique_ptr<ForeignVideo> video_;
  int taken_ = 0;
};

/// A camera, through whatever OpenCV has for it. Live: it has no length, cannot be wound back, ends when it
/// is unplugged, and its times are those at which pictures came, by one clock for all devices.
class DeviceStream : public PictureStream {
 public:
  /// @param device a camera's number, or what OpenCV opens by name: a node as /dev/video2, a pipeline of
  ///   GStreamer. @param context when it is cancelled, nothing is waited for any more, neither here nor by
  ///   grab(), which then has nothing: a dead camera keeps its driver for ten seconds and more.
  /// @throws InputError it cannot be opened.
  explicit DeviceStream(const std::string& device, const RunContext& context = RunContext());
  bool grab() override;
  bool retrieve(cv::Mat& image) override;
  void rewind() override {}  // what is live has no beginning

 private:
  /// Of a call that was let go as much as of this.
  struct Camera;
  std::shared_ptr<Camera> camera_;
  Aside aside_;
  RunContext context_;
};

/// Whether two times belong to one pair, and if not, which of them is to be passed over.
enum class Meeting { pair, pass_left, pass_right };
inline Meeting meeting(double left, double right, double largest_skew) {
  if (left - right > largest_skew) return Meeting::pass_right;
  if (right - left > largest_skew) return Meeting::pass_left;
  return Meeting::pair;
}

}  // namespace glisson::stereo
