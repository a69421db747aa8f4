// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/sent_model.h"

#include "glisson/patient/label_map.h"

namespace glisson::scene {

std::shared_ptr<const openigtlink::SentModel> sent_model(const DrawableModel& drawable) {
  auto sent = std::make_shared<openigtlink::SentModel>();
  sent->model = drawable.model;
  for (const DrawableSurface& surface : drawable.surfaces) {
    // Vena cava and gallbladder lie outside the liver: they are not drawn over the picture either.
    const bool is_neighbour =
        surface.structure == structure::kVenaCava || surface.structure == structure::kGallbladder;
    if (is_neighbour || surface.binding.tetrahedron.empty()) continue;
    sent->surfaces.push_back({surface.structure, surface.inside.triangles, surface.binding});
  }
  return sent;
}

}  // namespace glisson::scene
