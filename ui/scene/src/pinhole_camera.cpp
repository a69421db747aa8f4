// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/pinhole_camera.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include "glisson/core/error.h"

namespace glisson::scene {

void set_pinhole_camera(vtkRenderer& renderer, const Camera& camera, double near, double far) {
  require(camera.width > 0 && camera.height > 0, "a camera has a picture size");
  require(near > 0.0 && near < far, "the near plane lies in front of the far one");
  const double w = camera.width, h = camera.height;
  // Pixel centres are at whole numbers, the picture's left edge is at -0.5. VTK's view has y up and looks
  // along -z.
  vtkNew<vtkMatrix4x4> projection;
  projection->Zero();
  projection->SetElement(0, 0, 2.0 * camera.matrix(0, 0) / w);
  projection->SetElement(0, 1, -2.0 * camera.matrix(0, 1) / w);
  projection->SetElement(0, 2, 1.0 - 2.0 * (camera.matrix(0, 2) + 0.5) / w);
  projection->SetElement(1, 1, 2.0 * camera.matrix(1, 1) / h);
  projection->SetElement(1, 2, 2.0 * (camera.matrix(1, 2) + 0.5) / h - 1.0);
  projection->SetElement(2, 2, -(far + near) / (far - near));
  projection->SetElement(2, 3, -2.0 * far * near / (far - near));
  projection->SetElement(3, 2, -1.0);

  vtkCamera* view = renderer.GetActiveCamera();
  view->SetPosition(0.0, 0.0, 0.0);
  view->SetFocalPoint(0.0, 0.0, 1.0);
  view->SetViewUp(0.0, -1.0, 0.0);
  view->SetClippingRange(near, far);
  view->SetExplicitProjectionTransformMatrix(projection);
  view->SetUseExplicitProjectionTransformMatrix(true);
}

}  // namespace glisson::scene
