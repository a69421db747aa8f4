// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// How far a source of pictures reaches, and whether a person has chosen it. What a person names is opened: a
/// file, a camera, a stream of a network. It is remembered. What a case or a description of a source (.json)
/// names may have come from anywhere: what leads beyond this computer is opened only where a person of this
/// computer has entered the same address, and of a case so is any file or camera that lies elsewhere.

namespace glisson::stereo {

struct SourceOptions;

/// Whether a source is a file, or a camera of this computer ("device:0", "device:/dev/video2"). Streams of a
/// network, servers of OpenIGTLink and pipelines of GStreamer, which can do anything, are not.
bool stays_here(std::string_view source);

/// Keeps that a person has entered these sources, in `known_sources` below state_folder(): one a line, files
/// by their canonical absolute path, the latest last; the latest 1,000 stay. Nobody else may read the list.
/// Nothing where there is no such folder or it cannot be written: work is not refused for it. Of two programs
/// that write at once one may be lost.
/// @param sources as SourceOptions names them; empty ones are none.
void remember_sources(const std::vector<std::string>& sources);

/// Whether a person has entered this source before, however its path was written.
bool is_entered(const std::string& source);

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
