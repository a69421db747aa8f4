// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace glisson::stereo {

/// Of the codecs that laparoscopes' recordings come in ("mpeg4", "h264", "mjpeg", "ffv1"), those of
/// which this machine writes a few frames and reads as many back, in the confined reader. What it reads but
/// cannot write is not among them. Writes a small file to the work folder. @throws FileError there is no
/// space.
std::vector<std::string> video_codecs();

}  // namespace glisson::stereo
