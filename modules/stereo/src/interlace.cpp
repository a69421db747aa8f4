// SPDX-License-Identifier: GPL-3.0-or-later
#include "interlace.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace glisson::stereo {
namespace {

/// The rows of one parity, of as many as both have. @param first 0: even, 1: odd.
cv::Mat field_of(const cv::Mat& image, int first) {
  cv::Mat rows = image;
  return {image.rows / 2, image.cols, image.type(), rows.ptr(first), 2 * image.step[0]};
}

/// Mean difference of rows from the middle of those of the other parity that enclose them.
/// @param rows of one field, all that are enclosed. @param others the whole other field.
double apart(const cv::Mat& rows, const cv::Mat& others, const cv::Mat& where) {
  cv::Mat middle, difference;
  cv::addWeighted(others.rowRange(0, others.rows - 1), 0.5, others.rowRange(1, others.rows), 0.5, 0.0,
                  middle);
  cv::absdiff(rows, middle, difference);
  return cv::mean(difference, where)[0];
}

/// The level that a share of all pixels exceeds, about.
int level_of_most(const cv::Mat& change, double share) {
  std::array<int, 256> counts{};
  for (int y = 0; y < change.rows; ++y)
    for (int x = 0; x < change.cols; ++x) ++counts[change.at<std::uint8_t>(y, x)];
  int level = 255;
  for (double left = share * static_cast<double>(change.total()); level > 0 && left > 0.0; --level)
    left -= counts[static_cast<std::size_t>(level)];
  return level;
}

/// How far fields are apart; grey levels.
struct Distances {
  double own = 0.0, even_later = 0.0, odd_later = 0.0;

  /// @param first, last of the rows of this parity that others enclose.
  void add(const cv::Mat& now, const cv::Mat& before, int parity, int first, int last) {
    const auto rows = [&](const cv::Mat& image) { return field_of(image, parity).rowRange(first, last); };
    const auto others = [&](const cv::Mat& image) { return field_of(image, 1 - parity); };
    cv::Mat change;
    cv::absdiff(rows(now), rows(before), change);
    const int level = level_of_most(change, kMostChanged);
    if (level < kLeastChange) return;
    const cv::Mat where = change > level;
    own += 0.5 * (apart(rows(now), others(now), where) + apart(rows(before), others(before), where));
    (parity == 0 ? even_later : odd_later) += apart(rows(now), others(before), where);
    (parity == 0 ? odd_later : even_later) += apart(rows(before), others(now), where);
  }

 private:
  // Where most changes, noise and coding count least. Grey levels: less is no motion.
  static constexpr double kMostChanged = 0.02;
  static constexpr int kLeastChange = 3;
};

}  // namespace

bool Interlace::push(const cv::Mat& grey) {
  // Of 1/2 and 3/2; less, because what is rough anyway adds to both. Coding makes a progressive film's differ
  // by a fifth (MJPG), and leaves as little as half of a picture's own comb: then more is asked.
  constexpr double kFarther = 1.15, kOwn = 0.75, kCodedFarther = 1.3, kCodedOwn = 0.4;
  constexpr int kSure = 6;
  const cv::Mat before = before_;
  before_ = grey;
  if (evidence_ >= kSure || before.size() != grey.size() || grey.rows < 4) return evidence_ >= kSure;
  // Rows of both parities are looked at: of two pictures one may be the noisier, as coding makes it.
  Distances found;
  const int rows = grey.rows / 2;
  found.add(grey, before, 0, 1, rows);
  found.add(grey, before, 1, 0, rows - 1);
  if (found.own == 0.0) return false;
  const double near = std::min(found.even_later, found.odd_later),
               far = std::max(found.even_later, found.odd_later);
  const int parity = found.even_later < found.odd_later ? 1 : -1;
  const double own = found.own / near, farther = far / near;
  if ((farther >= kFarther && own >= kOwn) || (farther >= kCodedFarther && own >= kCodedOwn)) {
    evidence_ = parity == parity_ ? evidence_ + 1 : 1;
    parity_ = parity;
  } else if (kFarther * own < 1.0) {
    evidence_ = std::max(0, evidence_ - 1);  // it moves, and both are as far; else it moves too little
  }
  return evidence_ >= kSure;
}

}  // namespace glisson::stereo
