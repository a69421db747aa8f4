// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QSize>

#include "glisson/patient/picture.h"

namespace glisson::scene {

/// The picture for Qt, without a copy: the image keeps the picture's bytes alive and must not be painted on.
QImage view_as_image(const Picture& picture);
/// A copy that may be painted on, always colour (QImage::Format_RGB32).
QImage copy_to_image(const Picture& picture);
/// The picture as a screen takes it, smoothly brought to a size in the screen's pixels
/// (QImage::Format_RGB32): a window then has nothing left to do but to copy it. Any thread.
QImage screen_image(const Picture& picture, const QSize& size);
/// Any image as a picture with three channels.
Picture to_picture(const QImage& image);

}  // namespace glisson::scene
