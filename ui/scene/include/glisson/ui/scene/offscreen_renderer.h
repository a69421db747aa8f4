// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/patient/picture.h"

class vtkRenderer;

namespace glisson::scene {

/// Draws VTK scenes into memory without any display, through an EGL surfaceless context (a GPU's, or Mesa's
/// software one). Works in a process that has no DISPLAY and in one that shows windows. The context is
/// current only inside render(): an object may be used from any thread, but from one at a time, and not from
/// a thread on which a window's OpenGL context is current.
class OffscreenRenderer {
 public:
  /// @param width, height pixels, at least 1.
  /// @throws Error when this machine offers no EGL (the message names the packages).
  OffscreenRenderer(int width, int height);
  ~OffscreenRenderer();
  OffscreenRenderer(const OffscreenRenderer&) = delete;
  OffscreenRenderer& operator=(const OffscreenRenderer&) = delete;

  void resize(int width, int height);
  /// Draws what the renderer holds now. Passing the same renderer again keeps what was uploaded for it.
  Picture render(vtkRenderer& renderer);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::scene
