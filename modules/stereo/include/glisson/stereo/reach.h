// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// @file
/// How far a source of pictures reaches: what a case names is opened without anybody's asking, so that it
/// must stay on this computer. What a person names may be a stream of a network. A description of a source
/// (.json) may have come from anywhere: what it names beyond this computer is opened only where a person of
/// this computer has entered the same address.

namespace glisson::stereo {

struct SourceOptions;

/// Whether a source is a file, or a camera of this computer ("device:0", "device:/dev/video2"). Streams of a
/// network, servers of OpenIGTLink and pipelines of GStreamer, which can do anything, are not.
bool stays_here(std::string_view source);

/// Keeps that a person has entered a source that does not stay here, in `known_sources` below state_folder();
/// nothing where there is no such folder or it cannot be written.
void remember_source(const std::string& source);

/// As read_source(). @throws InputError, too, where it names a source that does not stay here and that nobody
/// here has entered.
SourceOptions read_entered_source(const std::filesystem::path& path);

/// @throws InputError an address ("SCHEME://...") of another kind than rtsp, rtsps, rtp, srt, udp, http,
/// https.
void require_known_scheme(std::string_view source);

/// Whether a file begins as a container of video does: Matroska, MP4, AVI, MPEG, ASF, Ogg, MXF, FLV, IVF, or
/// a bare H.264 or H.265 stream. Play lists and scripts, which name other files and addresses, do not.
/// @param begin its first 16 bytes or more.
bool begins_as_video(std::string_view begin);

}  // namespace glisson::stereo
