// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "glisson/segmentation/segment.h"

namespace glisson::ui {

/// Why growth cannot begin, for people.
QString hindrance_text(segmentation::Hindrance hindrance);

/// What growth can find anew, as people ask for it; all else stays as a hand left it.
struct Find {
  QString text;
  segmentation::Structures structures;
};
std::vector<Find> finds();

}  // namespace glisson::ui
