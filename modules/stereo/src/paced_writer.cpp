// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/paced_writer.h"

#include <sys/statvfs.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace glisson::stereo {
namespace {

constexpr double kLongestGap = 2.0;  ///< seconds without a picture that a film keeps
constexpr double kSameMoment = 0.6;  ///< of a frame's time: what comes sooner shows the same moment

}  // namespace

double free_space(const std::filesystem::path& folder) {
  struct statvfs found = {};
  if (::statvfs(folder.c_str(), &found) != 0) return std::numeric_limits<double>::infinity();
  return static_cast<double>(found.f_bavail) * static_cast<double>(found.f_frsize);
}

void require_room(const std::filesystem::path& video, int written, const FreeSpace& space) {
  if (space(std::filesystem::absolute(video).parent_path()) >= kLeastFree) return;
  throw FileError(video.string() + ": the disk is full after " + std::to_string(written) +
                  " frames. Free some space on the disk and record again.");
}

FilmPace::Place FilmPace::next(double seconds) {
  if (written_ == 0) begun_ = seconds;
  const long ideal = std::lround((seconds - begun_) * rate_);
  const bool is_same_moment = written_ > 0 && seconds - last_ < kSameMoment / rate_;
  if (ideal + 1 < written_ || (ideal < written_ && is_same_moment)) return {true, 0, 0};
  const long wanted = std::max<long>(ideal, written_);
  last_ = seconds;
  Place place;
  if (wanted - written_ <= std::lround(kLongestGap * rate_))
    place.repeats = static_cast<int>(wanted - written_);
  else
    begun_ += static_cast<double>(wanted - written_) / rate_;
  place.number = written_ + place.repeats;
  written_ = place.number + 1;
  return place;
}

PacedWriter::PacedWriter(const std::filesystem::path& path, int width, int height, double frames_per_second,
                         FreeSpace space)
    : path_(path), space_(std::move(space)), writer_(path, width, height, frames_per_second) {}

void PacedWriter::add(const Picture& picture, const FilmPace::Place& place) {
  if (place.taken) return;
  for (int k = 0; k < place.repeats; ++k) write(last_);
  write(picture);
  last_ = picture;
}

void PacedWriter::write(const Picture& picture) {
  require_room(path_, written_, space_);
  writer_.write(picture);
  ++written_;
}

void PacedWriter::close() {
  closed_ = true;
  try {
    writer_.close();
    kept_ = written_;
  } catch (const PartlyRecorded& partly) {
    kept_ = partly.frames();
    throw;
  }
}

int PacedWriter::keep() {
  if (closed_) return kept_;
  try {
    close();
  } catch (const FileError&) {
    // What is kept is known; what went wrong first is said already.
  }
  return kept_;
}

}  // namespace glisson::stereo
