// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/import_mesh.h"

#include "glisson/engine/parts/model.h"
#include "glisson/geometry/liver_size.h"
#include "glisson/geometry/mesh_io.h"
#include "model_figures.h"

namespace glisson::engine {

CommandTraits ImportMesh::traits() const {
  return {.code = "import_mesh", .writes = {part::model}, .notice = Notice::files};
}

Cancellable<Applied> ImportMesh::apply(const CaseState& state, const RunContext& context) const {
  context.progress(0.0, "mesh.read");
  TetMesh mesh = read_tet_mesh(path, unit);
  check_liver_size(mesh.vertices, unit, path.string(), volume(mesh));
  return with_model(state, model::build_from_mesh(std::move(mesh)));
}

}  // namespace glisson::engine
