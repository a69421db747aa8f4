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

/// Of the codecs without which recordings of most laparoscopes cannot be used ("mpeg4", "h264"), those that
/// are not among `there`.
std::vector<std::string> lacking_codecs(const std::vector<std::string>& there);

/// Records a few frames as the program records, to the work folder. @throws FileError they cannot be read
/// back.
void try_recording();

}  // namespace glisson::stereo
