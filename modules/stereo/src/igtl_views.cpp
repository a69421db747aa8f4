// SPDX-License-Identifier: GPL-3.0-or-later
#include "igtl_views.h"

#include <opencv2/imgproc.hpp>
#include <utility>

#include "glisson/stereo/source.h"
#include "picture_cv.h"
#include "size_text.h"

namespace glisson::stereo {
namespace {

/// As every other source gives it: blue, green, red.
cv::Mat coloured(const Picture& picture) {
  cv::Mat result;
  if (picture.channels == 1)
    cv::cvtColor(view(picture), result, cv::COLOR_GRAY2BGR);
  else
    result = view(picture).clone();
  return result;
}

}  // namespace

IgtlViews::IgtlViews(std::string source, const openigtlink::ReceiverOptions& options,
                     const RunContext& context)
    : source_(std::move(source)), context_(context.quiet()), receiver_(options) {
  rate = 30.0;  // as other live sources that do not say theirs
}

std::unique_ptr<IgtlViews> IgtlViews::open(const std::string& source, double largest_skew,
                                           const RunContext& context) {
  openigtlink::ReceiverOptions options =
      openigtlink::parse_pictures(std::string_view(source).substr(igtl_source("").size()));
  if (largest_skew > 0.0) options.largest_skew = largest_skew;
  std::unique_ptr<IgtlViews> views(new IgtlViews(source, options, context));
  views->first_ = views->receiver_.next_pair(context);
  if (!views->first_) {
    if (context.cancelled()) return nullptr;
    throw InputError(source, "", "has closed before a picture came", "Start the server again");
  }
  views->width = views->first_->left.width;
  views->height = views->first_->left.height;
  return views;
}

bool IgtlViews::read(cv::Mat& left, cv::Mat& right) {
  const auto pair = first_ ? std::exchange(first_, std::nullopt) : receiver_.next_pair(context_);
  if (!pair) return false;
  if (pair->left.width != width || pair->left.height != height)
    throw InputError(source_, "",
                     "is " + size_text(pair->left.width, pair->left.height) + ", the pictures before " +
                         size_text(width, height),
                     "Give pictures of one size");
  skipped = receiver_.passed_over();
  left = coloured(pair->left);
  right = coloured(pair->right);
  seconds_ = pair->seconds;
  return true;
}

}  // namespace glisson::stereo
