// SPDX-License-Identifier: GPL-3.0-or-later
#include "stream_views.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "picture_cv.h"
#include "size_text.h"

namespace glisson::stereo {
namespace {

/// Frames by which a whole video may be shorter than its stated length, which some containers compute from a
/// rounded duration.
constexpr int kRoundedFrames = 1;
/// Seconds without a pair after which two sources are taken for different operations or moments.
constexpr double kLongestSearch = 2.0;

/// A camera may change its size at any time, and what is cut out of its pictures would be something else.
/// @throws InputError it has.
void require_size(const PictureStream& stream, const cv::Mat& image) {
  if (image.cols == stream.width && image.rows == stream.height) return;
  throw InputError(stream.name, "",
                   "is " + size_text(image.cols, image.rows) + ", the pictures before " +
                       size_text(stream.width, stream.height),
                   "Give pictures of one size");
}

/// How far a file has been read by its own times. Recorders drop frames: then there are fewer than its length
/// and rate give, and it ends all the same.
class Reached {
 public:
  void take(const PictureStream& stream) {
    if (taken_ > 0) longest_ = std::max(longest_, stream.seconds - last_);
    if (taken_++ == 0) first_ = stream.seconds;
    last_ = stream.seconds;
  }
  int taken() const { return taken_; }
  /// To within the longest step so far.
  bool is_end_of(int frames, double rate) const {
    return taken_ + kRoundedFrames >= frames ||
           (taken_ > 0 && last_ - first_ + longest_ + (kRoundedFrames + 0.5) / rate >= frames / rate);
  }

 private:
  int taken_ = 0;
  double first_ = 0.0, last_ = 0.0, longest_ = 0.0;
};

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
    if (!stream_->grab() || !stream_->retrieve(whole_)) {
      if (!reached_.is_end_of(frames, rate)) broken_off(stream_->name, reached_.taken(), frames);
      return false;
    }
    require_size(*stream_, whole_);
    reached_.take(*stream_);
    if (layout_ == Layout::side_by_side) {
      left = whole_.colRange(0, width);
      right = whole_.colRange(width, 2 * width);
    } else if (layout_ == Layout::top_bottom) {
      left = whole_.rowRange(0, height);
      right = whole_.rowRange(height, 2 * height);
    } else {
      left = one_field(whole_, 0);
      right = one_field(whole_, 1);
    }
    return true;
  }
  void rewind() override {
    stream_->rewind();
    reached_ = {};
  }
  std::optional<double> came() const override {
    return stream_->live ? std::optional(stream_->seconds) : std::nullopt;
  }
  std::optional<double> stamped() const override {
    return stream_->live ? std::nullopt : std::optional(stream_->seconds);
  }

 private:
  std::unique_ptr<PictureStream> stream_;
  Layout layout_;
  Reached reached_;
  cv::Mat whole_;  ///< of the last pair; its memory serves the next
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
    bool has_left = take(*left_, in_left_), has_right = take(*right_, in_right_);
    const double begin = std::min(left_->seconds, right_->seconds);
    while (has_left && has_right) {
      const Meeting met = meeting(left_->seconds, right_->seconds, largest_skew_);
      if (met == Meeting::pair) return retrieve(left, right);
      ++skipped;
      if (met == Meeting::pass_left)
        has_left = take(*left_, in_left_);
      else
        has_right = take(*right_, in_right_);
      if (std::max(left_->seconds, right_->seconds) - begin > kLongestSearch) refuse_skew();
    }
    // Only a file that breaks off is reported. One of two cameras that was unplugged, or one of two recorders
    // that was stopped a moment before the other, is simply the end.
    if (has_left != has_right && !left_->live && !right_->live) {
      const PictureStream& broken = has_left ? *right_ : *left_;
      const Reached& reached = has_left ? in_right_ : in_left_;
      // Where frames had no partners the two need not be of one length.
      const int frames_due = skipped == 0 ? std::max(left_->frames, right_->frames) : broken.frames;
      if (!reached.is_end_of(frames_due, rate)) broken_off(broken.name, reached.taken(), frames_due);
    }
    for (const auto& [stream, reached] : {std::pair(left_.get(), &in_left_), {right_.get(), &in_right_}})
      if (!has_left && !has_right && !reached->is_end_of(stream->frames, rate))
        broken_off(stream->name, reached->taken(), stream->frames);
    return false;
  }
  void rewind() override {
    left_->rewind();
    right_->rewind();
    in_left_ = in_right_ = {};
    skipped = 0;
  }
  std::optional<double> came() const override {
    return left_->live ? std::optional(left_->seconds) : std::nullopt;
  }
  std::optional<double> stamped() const override {
    return left_->live ? std::nullopt : std::optional(left_->seconds);
  }

 private:
  static bool take(PictureStream& stream, Reached& reached) {
    if (!stream.grab()) return false;
    reached.take(stream);
    return true;
  }
  bool retrieve(cv::Mat& left, cv::Mat& right) {
    const bool has_left = left_->retrieve(left), has_right = right_->retrieve(right);
    if ((!has_left && left_->live) || (!has_right && right_->live)) return false;
    if (!has_left) broken_off(left_->name, in_left_.taken() - 1, left_->frames);
    if (!has_right) broken_off(right_->name, in_right_.taken() - 1, right_->frames);
    require_size(*left_, left);
    require_size(*right_, right);
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
  Reached in_left_, in_right_;
};

}  // namespace

std::unique_ptr<Views> views_of(std::unique_ptr<PictureStream> whole, Layout layout) {
  return std::make_unique<OneStream>(std::move(whole), layout);
}

std::unique_ptr<Views> views_of(std::unique_ptr<PictureStream> left, std::unique_ptr<PictureStream> right,
                                double largest_skew) {
  return std::make_unique<TwoStreams>(std::move(left), std::move(right), largest_skew);
}

}  // namespace glisson::stereo
