// SPDX-License-Identifier: GPL-3.0-or-later
// fuzz_volumes COUNT: damages good volumes COUNT times a format, has them read by the program that reads
// volumes, and prints a table: what was refused, in how many of these that program broke down, what was read
// with the same voxels and place, and what was read as something else. Fails where the file could have told
// that its voxels are others: they are still others when its own are put back.
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <random>
#include <vector>

#include "damage.h"
#include "dicom_bytes.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/volume/dicom_segmentation.h"
#include "glisson/volume/io.h"
#include "phantom.h"

namespace {

using namespace glisson;
namespace fs = std::filesystem;

enum class Outcome { refused, reader_ended, same, other_voxels, other_place };

struct Tally {
  std::map<Outcome, int> count;
  int untold = 0;  ///< of the other voxels: the file could have told
  double longest = 0.0;
};

/// Bytes [begin, end) of a file.
struct Range {
  std::size_t begin, end;
};

/// A line of a header of text: a number's type and its byte order are told by nothing else.
Range line_of(const std::string& bytes, const std::string& key) {
  const std::size_t begin = bytes.find(key);
  return begin == std::string::npos ? Range{0, 0} : Range{begin, bytes.find('\n', begin)};
}

/// Where a changed byte cannot be told from what was measured: the voxels themselves where no check sum
/// stands over them, their number type, byte order and scale.
std::vector<Range> untellable(const std::string& name, const std::string& bytes) {
  if (name == "a.nii") return {{70, 74}, {112, 120}, {352, bytes.size()}};
  if (name == "a.nrrd") return {line_of(bytes, "type:"), line_of(bytes, "endian:")};
  if (name == "a.mha") return {line_of(bytes, "ElementType"), line_of(bytes, "BinaryDataByteOrderMSB")};
  if (name == "a.vti") return {{bytes.find("type=\"Int"), bytes.find("</DataArray>")}};
  if (name == "a.dcm") return {{bytes.size() - 30, bytes.size()}};  // a bit a voxel, of two segments
  if (name == "dicom") return {{bytes.size() - 60, bytes.size()}};
  return {};
}

/// The damaged file with good voxels again, where the two can be laid beside each other: what is then still
/// read as other voxels, the file could have told. Bytes that came or went could be told, but for text, whose
/// length nothing fixes.
std::string with_good_voxels(const std::string& name, const std::string& good, std::string bad) {
  const std::vector<Range> ranges = untellable(name, good);
  if (good.size() == bad.size()) {
    for (const Range& range : ranges)
      std::copy_n(good.begin() + range.begin, range.end - range.begin, bad.begin() + range.begin);
    return bad;
  }
  if (name != "a.vti") return bad;
  std::size_t begin = 0, behind = 0;
  const std::size_t shorter = std::min(good.size(), bad.size());
  while (begin < shorter && good[begin] == bad[begin]) ++begin;
  while (behind < shorter - begin && good[good.size() - 1 - behind] == bad[bad.size() - 1 - behind]) ++behind;
  const bool is_within = begin >= ranges.front().begin && good.size() - behind <= ranges.front().end;
  return is_within ? good : bad;
}

/// What a volume holds: of an image Hounsfield units, else labels.
struct Content {
  VolumeGrid grid;
  std::vector<int> voxels;
};
Content content_of(const fs::path& path) {
  const auto of = [](const VolumeGrid& grid, const auto& voxels) {
    return Content{grid, std::vector<int>(voxels.begin(), voxels.end())};
  };
  if (path.extension() == ".dcm") {
    const LabelVolume labels = read_dicom_labels(path, RunContext()).value().file.voxels;
    return of(labels.grid(), labels.dense());
  }
  if (path.string().ends_with(".seg.nrrd")) {
    const LabelVolume labels = read_labels(path).voxels;
    return of(labels.grid(), labels.dense());
  }
  const Image image = read_image(path, RunContext()).value();
  return of(image.grid, *image.voxels);
}

LabelVolume some_labels() {
  const Image image = test::stored_world(11);
  std::vector<Label> dense(image.voxels->size());
  for (std::size_t n = 0; n < dense.size(); ++n)
    dense[n] = n % 7 == 0 ? Label{2} : n % 3 == 0 ? Label{1} : Label{0};
  return {image.grid, dense};
}

Outcome read(const fs::path& path, const Content& good) {
  try {
    const Content content = content_of(path);
    if (!content.grid.same_as(good.grid)) return Outcome::other_place;
    return content.voxels == good.voxels ? Outcome::same : Outcome::other_voxels;
  } catch (const Error& error) {
    const bool ended = std::string(error.what()).find("broke down") != std::string::npos;
    return ended ? Outcome::reader_ended : Outcome::refused;
  }
}

void write(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

std::string vti() {
  std::string values;
  for (int n = 0; n < 60; ++n) values += std::to_string(n * 17 % 900 - 500) + " ";
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
         "<ImageData WholeExtent=\"0 4 0 3 0 2\" Origin=\"1 2 3\" Spacing=\"1 1 2\">\n<Piece Extent=\"0 4 0 "
         "3 0 2\">\n"
         "<PointData Scalars=\"s\"><DataArray type=\"Int16\" Name=\"s\" format=\"ascii\">" +
         values + "</DataArray></PointData>\n</Piece>\n</ImageData>\n</VTKFile>\n";
}

/// A copy that was taken although the file could have told.
void keep(const std::string& name, int copy, const std::string& bytes) {
  fs::create_directories("fuzz_found");
  const fs::path path = fs::path("fuzz_found") / (std::to_string(copy) + "-" + name);
  write(path, bytes);
  std::fprintf(stderr, "%s: other voxels, and it could be told\n", path.c_str());
}

Tally run(const std::string& name, int count) {
  const TemporaryFolder folder;
  const bool series = name == "dicom";
  const fs::path path = series ? folder.path() / "series" : folder.path() / name;
  fs::path victim = path;
  if (series) {
    fs::create_directory(path);
    for (int k = 0; k < 4; ++k) write(path / std::to_string(k), test::dicom_of(k, test::HandSlice()));
    victim = path / "2";
  } else if (name == "a.vti") {
    write(path, vti());
  } else if (name == "a.seg.nrrd") {
    write_labels(path, some_labels(), {});
  } else if (name == "a.dcm") {
    write_dicom_labels(path, some_labels(), {}, {});
  } else {
    write_image(path, test::stored_world(11));
  }
  const Content good = content_of(path);
  const std::string bytes = read_file(victim);
  std::mt19937 random(41);
  Tally tally;
  for (int n = 0; n < count; ++n) {
    const std::string bad = fuzz::damaged(bytes, random);
    write(victim, bad);
    const auto begin = std::chrono::steady_clock::now();
    const Outcome outcome = read(path, good);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    tally.longest = std::max(tally.longest, took.count());
    ++tally.count[outcome];
    if (outcome != Outcome::other_voxels) continue;
    write(victim, with_good_voxels(name, bytes, bad));
    if (read(path, good) == Outcome::same) continue;
    ++tally.untold;
    keep(name, n, bad);
  }
  return tally;
}

}  // namespace

int main(int count, char** words) {
  if (count < 2) {
    std::fprintf(stderr, "fuzz_volumes COUNT [FORMAT...]\n");
    return 2;
  }
  std::vector<std::string> formats(words + 2, words + count);
  if (formats.empty())
    formats = {"a.nrrd", "a.nii", "a.nii.gz", "a.mha", "a.vti", "dicom", "a.seg.nrrd", "a.dcm"};
  std::printf(
      "| format | damaged | refused | of these, reader ended | same image | other voxels | of these, could "
      "be "
      "told | other place | longest |\n"
      "|---|---|---|---|---|---|---|---|---|\n");
  int untold = 0;
  for (const std::string& name : formats) {
    const Tally tally = run(name, std::atoi(words[1]));
    const auto of = [&tally](Outcome outcome) {
      return tally.count.contains(outcome) ? tally.count.at(outcome) : 0;
    };
    const int ended = of(Outcome::reader_ended);
    std::printf("| %s | %s | %d | %d | %d | %d | %d | %d | %.1f s |\n", name.c_str(), words[1],
                of(Outcome::refused) + ended, ended, of(Outcome::same), of(Outcome::other_voxels),
                tally.untold, of(Outcome::other_place), tally.longest);
    std::fflush(stdout);
    untold += tally.untold;
  }
  struct rusage readers = {};
  ::getrusage(RUSAGE_CHILDREN, &readers);  // waited for, all of them
  std::printf("\nMost memory that any reader took: %.0f MB\n",
              static_cast<double>(readers.ru_maxrss) / 1024.0);
  return untold == 0 ? 0 : 1;
}
