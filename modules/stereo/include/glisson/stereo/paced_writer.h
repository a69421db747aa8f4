// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "glisson/core/error.h"
#include "glisson/patient/picture.h"
#include "glisson/stereo/picture_io.h"

namespace glisson::stereo {

/// Bytes that are free to write where a file stands.
using FreeSpace = std::function<double(const std::filesystem::path& folder)>;
/// What the system says; infinity where it says nothing.
double free_space(const std::filesystem::path& folder);
/// So much of the disk is left free, bytes: with less a video could not be brought to its end.
inline constexpr double kLeastFree = 16e6;
/// Asked before each frame of a video. @throws FileError the disk is full.
void require_room(const std::filesystem::path& video, int written, const FreeSpace& space);

/// What VideoWriter::close() throws when less can be read back than was written: what can be stays.
class PartlyRecorded : public FileError {
 public:
  PartlyRecorded(const std::string& message, int frames) : FileError(message), frames_(frames) {}
  int frames() const { return frames_; }

 private:
  int frames_;
};

/// Where the pictures of a film stand that runs as fast as what was filmed, however many of them there are: a
/// picture stands for its own moment of the source, and where none came the one before stays. One that came a
/// little early, as cameras' pictures do, takes the next place: it is left out only where the source runs
/// faster than the film. A gap of more than two seconds is no pause of the film but a jump in the source: it
/// is left out.
class FilmPace {
 public:
  explicit FilmPace(double frames_per_second) : rate_(frames_per_second) {}
  struct Place {
    bool taken = false;  ///< this moment is written already: the picture is left out
    int repeats = 0;     ///< how often the picture before is to be written first
    int number = 0;      ///< of the picture in the film, from 0
  };
  /// The next picture's. @param seconds its time in the source. Its frame is counted as written.
  Place next(double seconds);
  int frames() const { return written_; }

 private:
  double rate_, begun_ = 0.0;  ///< the source's time of the film's first frame
  double last_ = 0.0;          ///< the source's time of the last picture
  int written_ = 0;
};

/// A video that is written at that pace. A disk that is full is an error of the first frame that has no room;
/// close() keeps what is there.
class PacedWriter {
 public:
  /// @param space asked before each frame; for tests.
  PacedWriter(const std::filesystem::path& path, int width, int height, double frames_per_second,
              FreeSpace space = free_space);
  /// @throws FileError
  void add(const Picture& picture, const FilmPace::Place& place);
  /// Once. @throws FileError; PartlyRecorded.
  void close();
  /// The same for what an error has cut short, also one of close(). @return frames that are kept.
  int keep();

 private:
  void write(const Picture& picture);

  std::filesystem::path path_;
  FreeSpace space_;
  VideoWriter writer_;
  Picture last_;
  int written_ = 0, kept_ = 0;
  bool closed_ = false;
};

}  // namespace glisson::stereo
