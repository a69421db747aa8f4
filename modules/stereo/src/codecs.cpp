// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/codecs.h"

#include <algorithm>
#include <array>
#include <opencv2/core.hpp>

#include "../codecs/opencv_codecs.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/stereo/picture_io.h"
#include "streams.h"

namespace glisson::stereo {
namespace {

struct Codec {
  const char* name;
  std::array<char, 4> tag;
};
constexpr std::array kCodecs{Codec{"mpeg4", {'m', 'p', '4', 'v'}}, Codec{"h264", {'H', '2', '6', '4'}},
                             Codec{"mjpeg", {'M', 'J', 'P', 'G'}}, Codec{"ffv1", {'F', 'F', 'V', '1'}}};

bool comes_back(const Codec& codec, const std::filesystem::path& path) {
  constexpr int kFrames = 5;
  const cv::Mat grey(240, 320, CV_8UC3, cv::Scalar(128, 128, 128));
  try {
    const auto writer = codecs().film(path.string(), codec.tag, 25.0, grey.size());
    if (!writer) return false;
    for (int frame = 0; frame < kFrames; ++frame) writer->write(grey);
    writer->release();
    return FileStream(path).count_frames() == kFrames;
  } catch (const cv::Exception&) {
    return false;
  } catch (const InputError&) {
    return false;  // written, but not read
  }
}

}  // namespace

std::vector<std::string> video_codecs() {
  const TemporaryFolder folder;
  std::vector<std::string> found;
  for (const Codec& codec : kCodecs)
    if (comes_back(codec, folder.path() / (std::string(codec.name) + ".mkv"))) found.emplace_back(codec.name);
  return found;
}

std::vector<std::string> lacking_codecs(const std::vector<std::string>& there) {
  std::vector<std::string> lacking;
  for (const char* needed : {"mpeg4", "h264"})
    if (std::find(there.begin(), there.end(), needed) == there.end()) lacking.emplace_back(needed);
  return lacking;
}

void try_recording() {
  const TemporaryFolder folder;
  const Picture grey{320, 240, 3,
                     std::make_shared<std::vector<std::uint8_t>>(320UL * 240 * 3, std::uint8_t{128})};
  VideoWriter writer(folder.path() / "tried.mkv", grey.width, grey.height, 25.0);
  for (int frame = 0; frame < 5; ++frame) writer.write(grey);
  writer.close();  // counts the frames that can be read back
}

}  // namespace glisson::stereo
