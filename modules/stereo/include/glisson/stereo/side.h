// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glisson::stereo {

/// Which of the laparoscope's two pictures.
enum class Side { left, right };

}  // namespace glisson::stereo
