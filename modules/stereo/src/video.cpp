// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string_view>
#include <system_error>

#include "glisson/core/error.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/picture_reader.h"
#include "glisson/stereo/reach.h"
#include "glisson/stereo/source.h"
#include "igtl_views.h"
#include "picture_cv.h"
#include "picture_pairs.h"
#include "size_text.h"
#include "stream_views.h"
#include "streams.h"
#include "views.h"

namespace glisson::stereo {
namespace fs = std::filesystem;
namespace {

std::unique_ptr<PictureStream> open_stream(const std::string& source, const RunContext& context) {
  if (!is_device(source)) return std::make_unique<FileStream>(source);
  const std::string device = device_of(source);
  if (device.empty())
    throw InputError(source, "", "is no device", "Write device: and its number, as device:0");
  return std::make_unique<DeviceStream>(device, context);
}

bool holds_pictures(const std::string& source) {
  if (is_live(source)) return false;
  std::error_code failure;
  return fs::is_directory(source, failure) || is_pattern(source);
}

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
  auto left = open_stream(options.left, context);
  auto right = separate ? open_stream(options.right, context) : nullptr;
  if (context.cancelled()) return nullptr;
  if (separate) return views_of(std::move(left), std::move(right), options.largest_skew);
  return views_of(std::move(left), options.layout);
}

/// What is opened by these paths is remembered, what a description names, too.
SourceOptions options_of(const fs::path& left, const fs::path& right) {
  if (right.empty() && left.extension() == ".json") {
    const SourceOptions described = read_entered_source(left);
    remember_sources({left.string(), described.left, described.right});
    return described;
  }
  SourceOptions options;
  options.left = left.string();
  options.right = right.string();
  remember_sources({options.left, options.right});
  if (!right.empty()) options.layout = Layout::separate;
  return options;
}

}  // namespace

struct StereoVideo::Impl {
  SourceOptions options;
  std::unique_ptr<Views> views;
  cv::Rect part;  ///< of each view that is given out
  int next = 0;
  std::optional<double> first;  ///< when a live source's first frame came, or what a file says of its own
  bool by_stamps = false;       ///< the file's times are not those of its rate

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

  /// Of the frame that was read last. What is live comes when it comes: frames that were dropped show in the
  /// times. So they do in files, which recorders make with gaps, or at a rate that changes; but files round
  /// their times, so the count tells them as long as both agree.
  double seconds_of(int index) {
    constexpr double kLongest = 1e6;  // seconds; what says more is no time
    const double counted = index / views->rate;
    const std::optional<double> came = views->came(), stamped = views->stamped();
    if (!came && !stamped) return counted;
    if (!first) first = came ? came : stamped;
    if (came) return *came - *first;
    const double told = *stamped - *first;
    if (!(told >= 0.0 && told < kLongest)) return counted;
    by_stamps = by_stamps || std::abs(told - counted) > 0.5 / views->rate + 1e-3;
    return by_stamps ? told : counted;
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
std::optional<Cut> StereoVideo::cut() const {
  if (!impl_->options.crop.any()) return {};
  return Cut{whole_width(), whole_height(), impl_->options.crop};
}
double StereoVideo::frames_per_second() const { return impl_->views->rate; }
bool StereoVideo::is_live() const {
  return stereo::is_live(impl_->options.left) || stereo::is_live(impl_->options.right);
}
int StereoVideo::frame_count() const { return impl_->views->frames; }
int StereoVideo::skipped() const { return impl_->views->skipped; }

bool StereoVideo::read(StereoFrame& frame) {
  cv::Mat left, right;
  if (!impl_->views->read(left, right)) return false;
  if (impl_->options.right_first) std::swap(left, right);
  frame.left = impl_->finished(left);
  frame.right = impl_->finished(right);
  frame.index = impl_->next++;
  frame.seconds = impl_->seconds_of(frame.index);
  return true;
}

void StereoVideo::rewind() {
  impl_->views->rewind();
  impl_->next = 0;
  impl_->first.reset();
  impl_->by_stamps = false;
}

}  // namespace glisson::stereo
