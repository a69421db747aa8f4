// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "raw_volume.h"

namespace glisson::reader {

/// Unpacks the files of an archive (.tar, .tar.gz, .tgz, .zip) into `folder`, which exists. Links, devices
/// and whatever would lie outside are left out; nothing but plain files is made, readable by their owner
/// alone.
/// @throws InputError damaged; more than 100,000 files; more than a hundred times its own size (and 256 MB);
///   more than fits beside 1 GB that stays free.
void unpack_archive(const Request& request, const std::filesystem::path& folder);
/// The same of a zip archive: stored and deflated files, zip64. What it claims is measured before
/// the first file is made. @throws InputError as unpack_archive; encrypted, packed otherwise.
void unpack_zip(const Request& request, const std::filesystem::path& folder);

}  // namespace glisson::reader
