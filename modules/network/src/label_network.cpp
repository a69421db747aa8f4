// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/network/label_network.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>

#include "glisson/core/error.h"
#include "glisson/network/runner.h"
#include "glisson/volume/morphology.h"
#include "glisson/volume/plausibility.h"
#include "oriented.h"
#include "painter.h"
#include "sheet.h"
#include "tiles.h"

namespace glisson::network {
namespace {

/// Of a tile's scores, and of all that are held at once; a sheet may claim anything.
constexpr long kMostValues = 100000000, kMostHeld = 500000000;

/// The size of a tile, with one slice where the network takes slices: as the sheet has it, else the file.
Three tile_of(const LabelSheet& sheet, const std::vector<int>& input, const std::filesystem::path& network) {
  const auto refuse = [&](const std::string& problem, const std::string& remedy) {
    throw InputError(sheet_of(network).string(), "tile", problem, remedy);
  };
  std::vector<int> tile = sheet.tile;
  if (!input.empty()) {
    if (input.size() != 4 && input.size() != 5)
      throw InputError(
          network.string(), "input", "is " + shape_text(input) + ", neither slices nor a block",
          "Export a network whose input is [1, 1, rows, columns] or [1, 1, slices, rows, columns]");
    if (input[0] > 1 || (input[1] > 0 && input[1] != 1))
      throw InputError(network.string(), "input", "is " + shape_text(input) + ", not one CT at a time",
                       "Export a network whose input has a batch and a channel of 1");
    const std::vector<int> own(input.begin() + 2, input.end());
    if (tile.empty()) tile = own;
    for (std::size_t n = 0; n < own.size(); ++n)
      if (tile.size() != own.size() || (own[n] > 0 && own[n] != tile[n]))
        refuse("is " + shape_text(tile) + " where the network's input is " + shape_text(input),
               "Write the size of the network's input");
  }
  if (tile.empty() || std::any_of(tile.begin(), tile.end(), [](int side) { return side < 1; }))
    refuse("is missing where the network leaves its input's size open",
           "Write [rows, columns] or [slices, rows, columns]");
  if (std::accumulate(tile.begin(), tile.end(), static_cast<double>(sheet.channels.size()),
                      std::multiplies<>()) > kMostValues)
    refuse("is more than " + std::to_string(kMostValues / 1000000) + " million voxels and channels",
           "Use smaller tiles");
  return tile.size() == 2 ? Three{1, tile[0], tile[1]} : Three{tile[0], tile[1], tile[2]};
}

/// The network on tile after tile of a CT.
class Labelling {
 public:
  Labelling(const Image& image, const LabelSheet& sheet, NetworkRunner& runner, const Three& tile)
      : image_(image),
        sheet_(sheet),
        runner_(runner),
        tile_(tile),
        oriented_(image.grid, sheet.axes, sheet.spacing_mm) {
    for (std::size_t n = 0; n < 3; ++n) {
      const bool by_slice = n == 0 && tile[0] == 1;
      starts_[n] = tile_starts(oriented_.size()[n], tile[n], by_slice ? 0.0 : sheet.overlap);
    }
    const int channels = static_cast<int>(sheet.channels.size());
    input_shape_ = {1, 1};
    output_shape_ = {1, channels};
    for (const int side : tile_)
      for (auto* shape : {&input_shape_, &output_shape_}) shape->push_back(side);
  }
  /// Slices have four dimensions. A block of one slice has five.
  void take_slices() {
    for (auto* shape : {&input_shape_, &output_shape_}) shape->erase(shape->begin() + 2);
  }
  long tiles() const { return static_cast<long>(starts_[0].size() * starts_[1].size() * starts_[2].size()); }

  /// Scores that are held at once.
  double held() const {
    const Three& size = oriented_.size();
    return static_cast<double>(sheet_.channels.size()) * std::min(tile_[0], size[0]) * size[1] * size[2];
  }

  /// Lesions are all one label.
  Cancellable<std::vector<Label>> labels(const RunContext& context) {
    TileBlend blend(oriented_.size(), tile_, starts_, static_cast<int>(sheet_.channels.size()));
    Painter painter(oriented_, sheet_);
    int taken = 0;
    const auto take_until = [&](int slice) {
      for (; taken < slice; ++taken) painter.add(blend.take(taken));
    };
    long done = 0;
    for (const int slice : starts_[0]) {
      take_until(slice);
      for (const int row : starts_[1])
        for (const int column : starts_[2]) {
          context.progress(static_cast<double>(done++) / static_cast<double>(tiles()), "network.tiles");
          const auto scores = scores_of({slice, row, column}, context);
          if (!scores) return {};
          blend.add({slice, row, column}, scores->values);
        }
    }
    take_until(oriented_.size()[0]);
    return painter.take();
  }

 private:
  Cancellable<Tensor> scores_of(const Three& start, const RunContext& context) {
    Tensor input{input_shape_, sampled(image_, oriented_, start, tile_)};
    const double low = sheet_.window_low_hu, high = sheet_.window_high_hu;
    const double zero = sheet_.mean_hu.value_or(low), one = sheet_.sd_hu.value_or(high - low);
    for (float& value : input.values)
      value = static_cast<float>((std::clamp(static_cast<double>(value), low, high) - zero) / one);
    return runner_.run(input, output_shape_, context);
  }

  const Image& image_;
  const LabelSheet& sheet_;
  NetworkRunner& runner_;
  Three tile_;
  Oriented oriented_;
  std::array<std::vector<int>, 3> starts_;
  std::vector<int> input_shape_, output_shape_;
};

/// What was found and what stays, voxel by voxel.
class Merging {
 public:
  Merging(const LabelSheet& sheet, const std::vector<Label>& locked)
      : sheet_(sheet), locked_(locked.begin(), locked.end()) {}
  bool is_locked(Label label) const { return locked_.contains(label); }
  Label of(Label former, Label found) const {
    const bool stays = former != structure::kBackground && !sheet_.finds(former);
    if (stays || is_locked(former)) return former;
    return found != LabelSheet::kLesions && is_locked(found) ? former : found;
  }

 private:
  const LabelSheet& sheet_;
  std::set<Label> locked_;
};

/// Each piece of what was found as lesion becomes a lesion of its own, the largest first; what is too small
/// is parenchyma, or as it was where that is locked. @param fresh which voxels those are
void number_lesions(std::vector<Label>& labels, const std::vector<std::uint8_t>& fresh,
                    const std::vector<Label>& former, const VolumeGrid& grid, const LabelSheet& sheet,
                    const Merging& merging, std::vector<std::string>& notes) {
  const VoxelBox box = bounding_box(grid.size, grid.spacing_mm, fresh, 0.0);
  if (box.empty()) return;
  const Mask mask = crop(grid.size, grid.spacing_mm, fresh, box);
  std::vector<long> sizes;
  const std::vector<int> pieces = connected_components(mask, sizes);
  std::vector<Label> names(sizes.size() + 1, structure::kParenchyma);
  const std::vector<Label> free =
      free_labels(structure::kFirstLesion, [&merging](Label label) { return merging.is_locked(label); });
  auto next = free.begin();
  long small = 0;
  for (std::size_t piece = 0; piece < sizes.size(); ++piece) {
    const double ml = 1e-3 * grid.voxel_volume_mm3() * static_cast<double>(sizes[piece]);
    if (ml >= sheet.least_lesion_ml && next != free.end())
      names[piece + 1] = *next++;
    else
      ++small;
  }
  if (small > 0) notes.push_back("network.small_lesions " + std::to_string(small));
  for (int k = 0; k < mask.size.z(); ++k)
    for (int j = 0; j < mask.size.y(); ++j)
      for (int i = 0; i < mask.size.x(); ++i)
        if (const int piece = pieces[mask.offset(i, j, k)]; piece > 0) {
          const auto at = static_cast<std::size_t>(grid.offset(box.low + Eigen::Vector3i(i, j, k)));
          labels[at] = merging.of(former[at], names[static_cast<std::size_t>(piece)]);
        }
}

LabelMap map_of(const VolumeGrid& grid, const std::vector<Label>& labels, const LabelMap* kept) {
  LabelMap map;
  map.voxels = LabelVolume(grid, labels);
  const std::vector<long> counts = map.voxels.histogram();
  for (std::size_t code = 1; code < counts.size(); ++code) {
    if (counts[code] == 0) continue;
    const auto label = static_cast<Label>(code);
    LabelInfo info = structure_info(label);
    if (kept != nullptr)
      for (const LabelInfo& former : kept->infos)
        if (former.code == label) info = former;
    map.infos.push_back(info);
  }
  return map;
}

void check(const Image& image, const LabelMap* kept) {
  if (image.modality != Modality::ct)
    throw InputError("image", "modality", "is not CT, and the network's window is of Hounsfield units",
                     "Open a CT");
  if (kept != nullptr) require_same_grid(kept->voxels.grid(), image.grid, "the case's labels and its image");
}

}  // namespace

Cancellable<NetworkLabels> label_by_network(const Image& image, const std::filesystem::path& network,
                                            const LabelSheet& sheet, const LabelOptions& options,
                                            const RunContext& context, const LabelMap* kept) {
  check(image, kept);
  context.progress(0.0, "network.read");
  const auto runner = NetworkRunner::open(network, context);
  if (!runner) return {};
  Labelling labelling(image, sheet, *runner, tile_of(sheet, runner->input_shape(), network));
  const std::size_t rank =
      runner->input_shape().empty() ? sheet.tile.size() + 2 : runner->input_shape().size();
  if (rank == 4) labelling.take_slices();
  if (labelling.held() > kMostHeld)
    throw InputError(sheet_of(network).string(), "spacing_mm", "needs more memory than there is",
                     "Use a coarser spacing, or tiles of fewer slices");
  auto labels = labelling.labels(context);
  if (!labels) return {};
  const Merging merging(sheet, options.locked);
  std::vector<std::uint8_t> lesions(labels->size());
  const std::vector<Label> former =
      kept == nullptr ? std::vector<Label>(labels->size()) : kept->voxels.dense();
  for (std::size_t n = 0; n < labels->size(); ++n) {
    const Label found = (*labels)[n];
    const bool was_free =
        former[n] == structure::kBackground || (sheet.finds(former[n]) && !merging.is_locked(former[n]));
    lesions[n] = found == LabelSheet::kLesions && was_free ? 1 : 0;
    (*labels)[n] = merging.of(former[n], found);
  }
  NetworkLabels made;
  made.tiles = labelling.tiles();
  made.notes = scale_doubts(image);
  number_lesions(*labels, lesions, former, image.grid, sheet, merging, made.notes);
  made.labels = map_of(image.grid, *labels, kept);
  return made;
}

}  // namespace glisson::network
