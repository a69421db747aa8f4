// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/grey_window.h"

#include <QCoreApplication>
#include <algorithm>
#include <limits>

#include "glisson/core/error.h"

namespace glisson::ui {

namespace {

/// Context of these words for translators.
class GreyWindows {
  Q_DECLARE_TR_FUNCTIONS(GreyWindows)
 public:
  static QString name(WindowPreset preset) {
    switch (preset) {
      case WindowPreset::abdomen:
        return tr("Abdomen");
      case WindowPreset::liver:
        return tr("Liver");
      case WindowPreset::vessels:
        return tr("Vessels");
      case WindowPreset::lung:
        return tr("Lung");
      case WindowPreset::bone:
        return tr("Bone");
      case WindowPreset::own:
        return tr("Own");
      case WindowPreset::whole:
        return tr("Whole range");
    }
    return {};
  }
};

}  // namespace

bool is_hounsfield(WindowPreset preset) {
  return preset != WindowPreset::own && preset != WindowPreset::whole;
}

GreyWindow hounsfield_window(WindowPreset preset) {
  switch (preset) {
    case WindowPreset::abdomen:
      return {80.0, 400.0};
    case WindowPreset::liver:
      return {100.0, 180.0};
    case WindowPreset::vessels:
      return {150.0, 350.0};
    case WindowPreset::lung:
      return {-600.0, 1500.0};
    case WindowPreset::bone:
      return {400.0, 1800.0};
    case WindowPreset::own:
    case WindowPreset::whole:
      break;
  }
  throw PreconditionError("a window of Hounsfield units is one of those that have a name");
}

GreyWindow whole_range(const Image& image) {
  require(!image.empty(), "a range is that of an image that has voxels");
  constexpr int kLowest = std::numeric_limits<std::int16_t>::min();
  constexpr double kLeftOut = 1e-3;  // of all voxels, at either end
  std::vector<long> counts(std::size_t{1} << 16U, 0);
  for (const std::int16_t value : *image.voxels) ++counts[static_cast<std::size_t>(value - kLowest)];
  const long left_out = static_cast<long>(kLeftOut * static_cast<double>(image.voxels->size()));
  const auto end = [left_out](auto from, auto to) {
    long passed = 0;
    auto at = std::find_if(from, to, [&](long count) { return (passed += count) > left_out; });
    return std::distance(from, at);
  };
  const double low = kLowest + static_cast<double>(end(counts.begin(), counts.end()));
  const double high =
      std::numeric_limits<std::int16_t>::max() - static_cast<double>(end(counts.rbegin(), counts.rend()));
  return {0.5 * (low + high), std::max(1.0, high - low)};
}

QString preset_text(WindowPreset preset) { return GreyWindows::name(preset); }

}  // namespace glisson::ui
