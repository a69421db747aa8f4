// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/reach.h"

#include <algorithm>
#include <string>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/stereo/source.h"

namespace glisson::stereo {
namespace {

bool is_number(std::string_view text) {
  return !text.empty() && text.size() <= 3 && text.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

bool stays_here(std::string_view source) {
  // Of this computer, too: a case must not make the program connect.
  if (is_igtl(source)) return false;
  if (!is_device(source)) return source.find("://") == std::string_view::npos;
  const std::string device = device_of(source);
  constexpr std::string_view kNode = "/dev/video";
  return is_number(device) || (device.starts_with(kNode) && is_number(device.substr(kNode.size())));
}

void require_known_scheme(std::string_view source) {
  const std::string device = is_device(source) ? device_of(source) : std::string(source);
  const std::size_t end = device.find("://");
  if (end == std::string::npos || device.find('!') != std::string::npos) return;  // a pipeline has its own
  const std::string scheme = lower_case(device.substr(0, end));
  for (const char* known : {"rtsp", "rtsps", "rtp", "srt", "udp", "http", "https"})
    if (scheme == known) return;
  throw InputError(std::string(source), "", "is an address of a kind that is not opened",
                   "Use rtsp, rtsps, rtp, srt, udp, http or https");
}

bool begins_as_video(std::string_view begin) {
  using namespace std::string_view_literals;
  for (const std::string_view mark :
       {"\x1A\x45\xDF\xA3"sv, "\x30\x26\xB2\x75"sv, "OggS"sv, "FLV\x01"sv, "DKIF"sv, "\x06\x0E\x2B\x34"sv,
        "\x00\x00\x01\xBA"sv, "\x00\x00\x01\xB3"sv, "\x00\x00\x00\x01"sv, "\x00\x00\x01\x67"sv,
        "YUV4MPEG2 "sv})
    if (begin.starts_with(mark)) return true;
  if (begin.starts_with("RIFF")) return begin.substr(8, 4) == "AVI ";
  for (const char* box : {"ftyp", "moov", "mdat", "free", "skip", "wide"})  // MP4 and QuickTime
    if (begin.size() >= 8 && begin.substr(4, 4) == box) return true;
  return !begin.empty() &&
         (begin[0] == '\x47' || (begin.size() > 4 && begin[4] == '\x47'));  // transport stream
}

}  // namespace glisson::stereo
