// SPDX-License-Identifier: GPL-3.0-or-later
#include "slicer_segments.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <numeric>
#include <set>
#include <sstream>

#include "glisson/core/error.h"

namespace glisson {
namespace {

std::string value_of(const Texts& texts, const std::string& key) {
  const auto found = texts.find(key);
  return found == texts.end() ? std::string() : found->second;
}

std::vector<double> numbers_of(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  std::vector<double> numbers;
  for (double number = 0.0; stream >> number;) numbers.push_back(number);
  return numbers;
}

long whole_number(const std::string& name, const Texts& texts, const std::string& key, long low, long high,
                  long otherwise) {
  const std::string text = value_of(texts, key);
  if (text.empty()) return otherwise;
  const std::vector<double> numbers = numbers_of(text);
  if (numbers.size() != 1 || numbers[0] != std::floor(numbers[0]) ||
      !(numbers[0] >= static_cast<double>(low) && numbers[0] <= static_cast<double>(high)))
    throw InputError(
        name, key,
        "is \"" + text + "\", not a whole number from " + std::to_string(low) + " to " + std::to_string(high),
        "Save the segmentation from Slicer again");
  return static_cast<long>(numbers[0]);
}

/// The entry of Slicer's tag list "key:value|key:value|".
std::string tag_of(const std::string& tags, const std::string& key) {
  std::istringstream stream(tags);
  for (std::string tag; std::getline(stream, tag, '|');) {
    const std::size_t colon = tag.find(':');
    if (colon == std::string::npos) continue;
    const std::string found = tag.substr(0, colon);
    if (found == key || found == "Segmentation." + key || found == "Segmentation_" + key)
      return tag.substr(colon + 1);
  }
  return "";
}

std::string number_text(double value) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(6);
  stream << value;
  return stream.str();
}

}  // namespace

std::vector<SlicerSegment> slicer_segments(const std::string& name, const Texts& texts, int layers) {
  std::vector<SlicerSegment> segments;
  for (int n = 0; texts.contains("Segment" + std::to_string(n) + "_ID"); ++n) {
    const std::string prefix = "Segment" + std::to_string(n) + "_";
    SlicerSegment segment;
    segment.name = value_of(texts, prefix + "Name");
    segment.terminology = tag_of(value_of(texts, prefix + "Tags"), "TerminologyEntry");
    segment.status = tag_of(value_of(texts, prefix + "Tags"), "Status");
    segment.value = static_cast<Label>(whole_number(name, texts, prefix + "LabelValue", 1, 65535, n + 1));
    segment.layer = static_cast<int>(whole_number(name, texts, prefix + "Layer", 0, layers - 1, 0));
    const std::vector<double> colour = numbers_of(value_of(texts, prefix + "Color"));
    if (colour.size() == 3)
      for (std::size_t c = 0; c < 3; ++c) segment.colour[c] = std::clamp(colour[c], 0.0, 1.0);
    segments.push_back(segment);
  }
  return segments;
}

std::vector<SlicerSegment> with_unnamed(std::vector<SlicerSegment> segments, int layers,
                                        const std::vector<Label>& voxels) {
  const auto count = static_cast<std::size_t>(layers);
  std::vector<std::vector<bool>> known(count, std::vector<bool>(65536, false));
  for (std::vector<bool>& values : known) values[0] = true;  // the background
  for (const SlicerSegment& segment : segments)
    known[static_cast<std::size_t>(segment.layer)][segment.value] = true;
  std::set<std::pair<int, Label>> unnamed;
  for (std::size_t n = 0; n < voxels.size(); ++n)
    if (!known[n % count][voxels[n]]) {
      known[n % count][voxels[n]] = true;
      unnamed.emplace(static_cast<int>(n % count), voxels[n]);
    }
  for (const auto& [layer, value] : unnamed) {
    SlicerSegment segment;
    segment.value = value;
    segment.layer = layer;
    segments.push_back(segment);
  }
  return segments;
}

LabelFile flattened(const VolumeGrid& grid, int layers, const std::vector<Label>& voxels,
                    const std::vector<SlicerSegment>& segments) {
  const auto count = static_cast<std::size_t>(grid.voxel_count());
  require(voxels.size() == count * static_cast<std::size_t>(layers),
          "a segmentation has one value a voxel and layer");
  std::set<Label> values;
  for (const SlicerSegment& segment : segments) values.insert(segment.value);
  const bool distinct = values.size() == segments.size();

  std::vector<Label> code(segments.size());
  for (std::size_t s = 0; s < segments.size(); ++s)
    code[s] = distinct ? segments[s].value : static_cast<Label>(s + 1);
  // segment_at[layer][value]: its number + 1.
  std::vector<std::map<Label, std::size_t>> segment_at(static_cast<std::size_t>(layers));
  for (std::size_t s = 0; s < segments.size(); ++s)
    segment_at[static_cast<std::size_t>(segments[s].layer)][segments[s].value] = s;
  std::vector<long> volume(segments.size(), 0);
  const auto at = [&](std::size_t voxel, std::size_t layer) {
    return voxels[voxel * static_cast<std::size_t>(layers) + layer];
  };
  const auto segment_of = [&](std::size_t voxel, std::size_t layer) -> std::ptrdiff_t {
    const Label value = at(voxel, layer);
    if (value == 0) return -1;
    const auto found = segment_at[layer].find(value);
    return found == segment_at[layer].end() ? -1 : static_cast<std::ptrdiff_t>(found->second);
  };
  for (std::size_t voxel = 0; voxel < count; ++voxel)
    for (std::size_t layer = 0; layer < segment_at.size(); ++layer)
      if (const auto s = segment_of(voxel, layer); s >= 0) ++volume[static_cast<std::size_t>(s)];

  std::vector<Label> dense(count, 0);
  for (std::size_t voxel = 0; voxel < count; ++voxel) {
    std::ptrdiff_t best = -1;
    for (std::size_t layer = 0; layer < segment_at.size(); ++layer) {
      const std::ptrdiff_t s = segment_of(voxel, layer);
      if (s >= 0 &&
          (best < 0 || volume[static_cast<std::size_t>(s)] < volume[static_cast<std::size_t>(best)]))
        best = s;
    }
    if (best >= 0) dense[voxel] = code[static_cast<std::size_t>(best)];
  }
  LabelFile file;
  file.voxels = LabelVolume(grid, dense);
  for (std::size_t s = 0; s < segments.size(); ++s)
    file.infos.push_back(
        {code[s], segments[s].name, segments[s].terminology, segments[s].colour, segments[s].status});
  return file;
}

std::vector<std::pair<std::string, std::string>> slicer_keys(const VolumeGrid& grid,
                                                             const std::vector<LabelInfo>& infos) {
  std::vector<std::pair<std::string, std::string>> keys;
  const std::string extent = "0 " + std::to_string(grid.size.x() - 1) + " 0 " +
                             std::to_string(grid.size.y() - 1) + " 0 " + std::to_string(grid.size.z() - 1);
  for (std::size_t n = 0; n < infos.size(); ++n) {
    const LabelInfo& info = infos[n];
    const std::string prefix = "Segment" + std::to_string(n) + "_";
    const std::string name = info.name.empty() ? "label_" + std::to_string(info.code) : info.name;
    std::string tags = "Segmentation.Status:" + (info.status.empty() ? "inprogress" : info.status) + "|";
    if (!info.terminology.empty()) tags += "TerminologyEntry:" + info.terminology + "|";
    keys.emplace_back(prefix + "Color", number_text(info.colour[0]) + " " + number_text(info.colour[1]) +
                                            " " + number_text(info.colour[2]));
    keys.emplace_back(prefix + "ColorAutoGenerated", "0");
    keys.emplace_back(prefix + "Extent", extent);
    keys.emplace_back(prefix + "ID", "Segment_" + std::to_string(info.code));
    keys.emplace_back(prefix + "LabelValue", std::to_string(info.code));
    keys.emplace_back(prefix + "Layer", "0");
    keys.emplace_back(prefix + "Name", name);
    keys.emplace_back(prefix + "NameAutoGenerated", "0");
    keys.emplace_back(prefix + "Tags", tags);
  }
  keys.emplace_back("Segmentation_ContainedRepresentationNames", "Binary labelmap|");
  keys.emplace_back("Segmentation_ConversionParameters", "");
  keys.emplace_back("Segmentation_MasterRepresentation", "Binary labelmap");
  keys.emplace_back("Segmentation_ReferenceImageExtentOffset", "0 0 0");
  return keys;
}

}  // namespace glisson
