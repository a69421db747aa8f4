// SPDX-License-Identifier: GPL-3.0-or-later
#include "archive.h"
#include "claim.h"
#include "entries.h"
#include "scratch.h"

namespace glisson::fuzz {
namespace {

template <class ClaimOf>
void header(const char* name, std::string_view bytes, ClaimOf claim_of) {
  read_file_of(name, bytes, [&](const std::filesystem::path& path) {
    const reader::Request request{path, path.string(), path.parent_path(), [](double) {}, ""};
    const reader::Claim claim = claim_of(request);
    must((claim.size.array() >= 1).all() && claim.components >= 1, "a size below one");
    const VolumeGrid grid =
        reader::checked_grid(request, claim.size, claim.spacing_mm, claim.origin_mm, claim.direction);
    must(grid.spacing_mm.minCoeff() > 0.0 && grid.origin_mm.allFinite(), "a grid that is nowhere");
  });
}

void unpack(const char* name, std::string_view bytes) {
  read_file_of(name, bytes, [](const std::filesystem::path& path) {
    const TemporaryFolder folder;
    const reader::Request request{path, path.string(), folder.path(), [](double) {}, ""};
    std::filesystem::create_directory(folder.path() / "archive");
    try {
      reader::unpack_archive(request, folder.path() / "archive");
    } catch (const InputError&) {
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
      must(entry.path().filename() == "archive", "unpacked beside its folder");
  });
}

}  // namespace

void nifti_header(std::string_view bytes) { header("a.nii", bytes, reader::claim_of_nifti); }
void nrrd_header(std::string_view bytes) { header("a.nrrd", bytes, reader::claim_of_nrrd); }
void meta_header(std::string_view bytes) { header("a.mha", bytes, reader::claim_of_meta); }
void archive(std::string_view bytes) { unpack("a.tar", bytes); }
void zip_archive(std::string_view bytes) { unpack("a.zip", bytes); }

}  // namespace glisson::fuzz
