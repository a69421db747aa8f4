// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string_view>
#include <system_error>

#include "glisson/core/error.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/picture_pairs.h"
#include "glisson/stereo/picture_reader.h"
#include "glisson/stereo/source.h"
#include "igtl_views.h"
#include "picture_cv.h"
#include "size_text.h"
#include "streams.h"
#include "views.h"

namespace glisson::stereo {
namespace fs = std::filesystem;
namespace {

/// Frames by which a whole video may be shorter than its stated length, which some containers compute from a
/// rounded duration.
constexpr int kRoundedFrames = 1;
/// Seconds without a pair after which two sources are taken for different operations or moments.
constexpr double kLongestSearch = 2.0;

std::unique_ptr<PictureStream> open_stream(const std::string& source) {
  if (!is_device(source)) return std::make_unique<FileStream>(source);
  const std::string device = device_of(source);
  if (device.empty())
    throw InputError(source, "", "is no device", "Write device: and its number, as device:0");
  return std::make_unique<DeviceStream>(device);
}

bool holds_pictures(const std::string& source) {
  if (is_live(source)) return false;
  std::error_code failure;
  return fs::is_directory(source, failure) || source.find('*') != std::string::npos ||
         source.find('?') != std::string::npos;
}

/// Both views in each picture.
class OneStream : public Views {
 public:
  OneStream(std::unique_ptr<PictureStream> stream, Layout layout)
      : stream_(std::move(stream)), layout_(layout) {
    width = stream_->width;
    height = stream_->height;
    frames = stream_->frames;
    rate = stream_->rate;
    const bool across = layout == Layout::side_by_side;
    if ((across ? width : height) % 2 != 0)
      throw InputError(
          stream_->name, "",
          "is " + std::to_string(across ? width : height) +
              (across ? " pixels wide, so it has no two halves" : " pixels high, so it has no two halves"),
          "Both views are of one size; give two files otherwise");
    if (across) width /= 2;
    if (layout == Layout::top_bottom) height /= 2;
  }

  bool read(cv::Mat& left, cv::Mat& right) override {
    cv::Mat whole;
    if (!stream_->grab() || !stream_->retrieve(whole)) {
      if (read_ + kRoundedFrames < frames) broken_off(stream_->name, read_, frames);
      return false;
    }
    ++read_;
    if (layout_ == Layout::side_by_side) {
      left = whole.colRange(0, width);
      right = whole.colRange(width, 2 * width);
    } else if (layout_ == Layout::top_bottom) {
      left = whole.rowRange(0, height);
      right = whole.rowRange(height, 2 * height);
    } else {
      left = one_field(whole, 0);
      right = one_field(whole, 1);
    }
    return true;
  }
  void rewind() override {
    stream_->rewind();
    read_ = 0;
  }
  std::optional<double> came() const override {
    return stream_->live ? std::optional(stream_->seconds) : std::nullopt;
  }

 private:
  std::unique_ptr<PictureStream> stream_;
  Layout layout_;
  int read_ = 0;
};

/// A view each, matched by their times.
class TwoStreams : public Views {
 public:
  TwoStreams(std::unique_ptr<PictureStream> left, std::unique_ptr<PictureStream> right, double largest_skew)
      : left_(std::move(left)), right_(std::move(right)), largest_skew_(largest_skew) {
    if (left_->width != right_->width || left_->height != right_->height)
      throw InputError(right_->name, "",
                       "is " + size_text(right_->width, right_->height) + ", the left video " +
                           size_text(left_->width, left_->height),
                       "Both views of a stereo video have one size");
    if (std::abs(left_->rate - right_->rate) > 1e-3 * left_->rate)
      throw InputError(right_->name, "", "has another frame rate than the left video",
                       "Record both views at one rate");
    width = left_->width;
    height = left_->height;
    frames = left_->frames;
    rate = left_->rate;
    if (largest_skew_ <= 0.0) largest_skew_ = 0.5 / rate;
  }

  bool read(cv::Mat& left, cv::Mat& right) override {
    bool has_left = take(*left_, taken_left_), has_right = take(*right_, taken_right_);
    const double begin = std::min(left_->seconds, right_->seconds);
    while (has_left && has_right) {
      const Meeting met = meeting(left_->seconds, right_->seconds, largest_skew_);
      if (met == Meeting::pair) return retrieve(left, right);
      ++skipped;
      if (met == Meeting::pass_left)
        has_left = take(*left_, taken_left_);
      else
        has_right = take(*right_, taken_right_);
      if (std::max(left_->seconds, right_->seconds) - begin > kLongestSearch) refuse_skew();
    }
    // Only a file that breaks off is reported. One of two cameras that was unplugged, or one of two recorders
    // that was stopped a moment before the other, is simply the end.
    if (has_left != has_right && skipped == 0 && !left_->live && !right_->live) {
      const PictureStream& broken = has_left ? *right_ : *left_;
      const int taken = has_left ? taken_right_ : taken_left_,
                longest = std::max(left_->frames, right_->frames);
      if (taken + kRoundedFrames < longest) broken_off(broken.name, taken, longest);
    }
    for (const auto& [stream, taken] : {std::pair(left_.get(), taken_left_), {right_.get(), taken_right_}})
      if (!has_left && !has_right && taken + kRoundedFrames < stream->frames)
        broken_off(stream->name, taken, stream->frames);
    return false;
  }
  void rewind() override {
    left_->rewind();
    right_->rewind();
    taken_left_ = taken_right_ = 0;
    skipped = 0;
  }
  std::optional<double> came() const override {
    return left_->live ? std::optional(left_->seconds) : std::nullopt;
  }

 private:
  static bool take(PictureStream& stream, int& taken) {
    if (!stream.grab()) return false;
    ++taken;
    return true;
  }
  bool retrieve(cv::Mat& left, cv::Mat& right) {
    const bool has_left = left_->retrieve(left), has_right = right_->retrieve(right);
    if ((!has_left && left_->live) || (!has_right && right_->live)) return false;
    if (!has_left) broken_off(left_->name, taken_left_ - 1, left_->frames);
    if (!has_right) broken_off(right_->name, taken_right_ - 1, right_->frames);
    return true;
  }
  [[noreturn]] void refuse_skew() const {
    throw InputError(left_->name + " and " + right_->name, "time",
                     "have no frames within " + std::to_string(std::lround(1e3 * largest_skew_)) +
                         " ms of each other (" + std::to_string(left_->seconds) + " s and " +
                         std::to_string(right_->seconds) + " s)",
                     "Record both views at once, from one trigger");
  }

  std::unique_ptr<PictureStream> left_, right_;
  double largest_skew_;
  int taken_left_ = 0, taken_right_ = 0;
};

/// Pairs of picture files.
class PictureFolder : public Views {
 public:
  PictureFolder(const PicturePairs& files, double per_second) : pairs_(files.pairs) {
    skipped = static_cast<int>(files.alone.size());
    frames = static_cast<int>(pairs_.size());
    rate = per_second;
    const Picture first = reader_.read(pairs_[0].left);
    width = first.width;
    height = first.height;
  }
  bool read(cv::Mat& left, cv::Mat& right) override {
    if (next_ == pairs_.size()) return false;
    const PicturePair& pair = pairs_[next_++];
    for (const auto& [path, image] : {std::pair(&pair.left, &left), {&pair.right, &right}}) {
      const Picture picture = reader_.read(*path);
      if (picture.width != width || picture.height != height)
        throw InputError(path->string(), "",
                         "is " + size_text(picture.width, picture.height) + ", the pictures before " +
                             size_text(width, height),
                         "Give pictures of one size");
      *image = view(picture).clone();
    }
    return true;
  }
  void rewind() override { next_ = 0; }

 private:
  std::vector<PicturePair> pairs_;
  PictureReader reader_;
  std::size_t next_ = 0;
};

/// Null: cancelled.
std::unique_ptr<Views> open_views(const SourceOptions& options, const RunContext& context) {
  options.validate();
  if (is_igtl(options.left)) return IgtlViews::open(options.left, options.largest_skew, context);
  const bool separate = !options.right.empty();
  if (holds_pictures(options.left))
    return std::make_unique<PictureFolder>(
        separate ? picture_pairs(options.left, options.right) : picture_pairs(options.left),
        options.pictures_per_second);
  if (separate)
    return std::make_unique<TwoStreams>(open_stream(options.left), open_stream(options.right),
                                        options.largest_skew);
  return std::make_unique<OneStream>(open_stream(options.left), options.layout);
}

SourceOptions options_of(const fs::path& left, const fs::path& right) {
  if (right.empty() && left.extension() == ".json") return read_source(left);
  SourceOptions options;
  options.left = left.string();
  options.right = right.string();
  if (!right.empty()) options.layout = Layout::separate;
  return options;
}

}  // namespace

struct StereoVideo::Impl {
  SourceOptions options;
  std::unique_ptr<Views> views;
  cv::Rect part;  ///< of each view that is given out
  int next = 0;
  std::optional<double> first;  ///< when a live source's first frame came

  Impl(const SourceOptions& given, std::unique_ptr<Views> opened) : options(given), views(std::move(opened)) {
    const Crop& crop = options.crop;
    part = {crop.x, crop.y, crop.width > 0 ? crop.width : views->width - crop.x,
            crop.height > 0 ? crop.height : views->height - crop.y};
    if (part.width < 16 || part.height < 16 || part.x + part.width > views->width ||
        part.y + part.height > views->height)
      throw InputError(options.left, "crop",
                       "leaves " + size_text(part.width, part.height) + " from (" + std::to_string(part.x) +
                           ", " + std::to_string(part.y) + ") of views of " +
                           size_text(views->width, views->height),
                       "Crop within the picture");
  }

  Picture finished(const cv::Mat& image) const {
    return to_picture((options.deinterlace ? one_field(image, 0) : image)(part));
  }
};

StereoVideo::StereoVideo(const SourceOptions& options)
    : impl_(std::make_unique<Impl>(options, open_views(options, RunContext()))) {}
StereoVideo::StereoVideo(const fs::path& left, const fs::path& right)
    : StereoVideo(options_of(left, right)) {}
StereoVideo::StereoVideo(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
StereoVideo::~StereoVideo() = default;

Cancellable<std::unique_ptr<StereoVideo>> StereoVideo::open(const fs::path& left, const fs::path& right,
                                                            const RunContext& context) {
  const SourceOptions options = options_of(left, right);
  std::unique_ptr<Views> views = open_views(options, context);
  if (!views) return {};
  return std::unique_ptr<StereoVideo>(new StereoVideo(std::make_unique<Impl>(options, std::move(views))));
}

int StereoVideo::width() const { return impl_->part.width; }
int StereoVideo::height() const { return impl_->part.height; }
int StereoVideo::whole_width() const { return impl_->views->width; }
int StereoVideo::whole_height() const { return impl_->views->height; }
double StereoVideo::frames_per_second() const { return impl_->views->rate; }
int StereoVideo::frame_count() const { return impl_->views->frames; }
int StereoVideo::skipped() const { return impl_->views->skipped; }

bool StereoVideo::read(StereoFrame& frame) {
  cv::Mat left, right;
  if (!impl_->views->read(left, right)) return false;
  if (impl_->options.right_first) std::swap(left, right);
  frame.left = impl_->finished(left);
  frame.right = impl_->finished(right);
  frame.index = impl_->next++;
  // What is live comes when it comes: frames that were dropped show in the times.
  const std::optional<double> came = impl_->views->came();
  if (came && !impl_->first) impl_->first = came;
  frame.seconds = came ? *came - *impl_->first : frame.index / impl_->views->rate;
  return true;
}

void StereoVideo::rewind() {
  impl_->views->rewind();
  impl_->next = 0;
  impl_->first.reset();
}

}  // namespace glisson::stereo
