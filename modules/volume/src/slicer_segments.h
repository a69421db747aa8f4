// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "glisson/volume/io.h"

namespace glisson {

using Texts = std::map<std::string, std::string>;

/// One segment of a Slicer segmentation (.seg.nrrd keys Segment<N>_...).
struct SlicerSegment {
  std::string name, terminology, status;
  std::array<double, 3> colour = {0.5, 0.5, 0.5};
  Label value = 0;
  int layer = 0;
};

/// @throws InputError naming `name` when a number in the keys is none, or a layer is not in 0..layers-1.
std::vector<SlicerSegment> slicer_segments(const std::string& name, const Texts& texts, int layers);

/// The segments, and behind them one without a name for each value of a layer that no segment names: where a
/// key was lost, or one among them is missing. Its voxels would be nobody's, and go without a word.
/// @param voxels as many values a voxel as there are layers, next to each other.
std::vector<SlicerSegment> with_unnamed(std::vector<SlicerSegment> segments, int layers,
                                        const std::vector<Label>& voxels);

/// One label per voxel out of several layers. Codes are the segments' own label values where these are all
/// different, else 1, 2, ... in the file's order. Where segments overlap, the smaller wins: a tumour painted
/// into a liver stays a tumour whichever layer it is on.
LabelFile flattened(const VolumeGrid& grid, int layers, const std::vector<Label>& voxels,
                    const std::vector<SlicerSegment>& segments);

/// The keys that make Slicer show `labels` as segments, in the order in which Slicer writes them.
std::vector<std::pair<std::string, std::string>> slicer_keys(const VolumeGrid& grid,
                                                             const std::vector<LabelInfo>& infos);

}  // namespace glisson
