// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/model_source.h"

#include "glisson/engine/case_io.h"
#include "glisson/geometry/mesh_io.h"

namespace glisson::engine {

ModelSource model_source(const std::filesystem::path& path) {
  if (is_case(path)) return ModelSource::a_case;
  if (std::filesystem::is_directory(path)) return ModelSource::surfaces;
  return is_tetrahedral(path) ? ModelSource::tetrahedra : ModelSource::surfaces;
}

}  // namespace glisson::engine
