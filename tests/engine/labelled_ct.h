// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/core/files.h"
#include "glisson/editing/tools/margin.h"
#include "glisson/editing/tools/paint.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/engine.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/volume/io.h"

/// @file
/// A small CT in an engine, and a hand that paints on it.

namespace glisson::test {

inline VolumeGrid small_grid() {
  VolumeGrid grid;
  grid.size = {40, 36, 34};
  grid.spacing_mm = {2.0, 2.0, 2.5};
  return grid;
}

/// A CT that has one value everywhere.
inline void write_ct(const std::filesystem::path& path, std::int16_t value) {
  Image image;
  image.grid = small_grid();
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(
      static_cast<std::size_t>(image.grid.voxel_count()), value);
  write_image(path, image);
}

/// A case with an image, written as files: engines read it as a person's would be.
class CtFolder {
 public:
  CtFolder() { write_ct(path() / "ct.nrrd", 60); }
  std::filesystem::path path() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

inline std::unique_ptr<engine::Engine> engine_of(engine::Runner runner, const CtFolder& files,
                                                 engine::Apply apply = engine::apply) {
  engine::Engine::Options options;
  options.runner = runner;
  options.apply = std::move(apply);
  options.wake = [] {};
  auto made = std::make_unique<engine::Engine>(std::move(options));
  if (made->wait(made->post(engine::ImportImage{files.path() / "ct.nrrd"})).status != engine::Status::done)
    return nullptr;
  return made;
}

inline editing::Edit ball(const Eigen::Vector3d& centre_mm, double radius_mm,
                          Label label = structure::kParenchyma) {
  editing::Paint paint;
  paint.label = label;
  paint.brush = editing::Paint::Brush::ball;
  paint.radius = 1e-3 * radius_mm;
  paint.path = 1e-3 * centre_mm.transpose();
  return {paint, {}};
}

inline editing::Edit grown(double by_mm, Label label = structure::kParenchyma) {
  return {editing::Margin{label, 1e-3 * by_mm}, {}};
}

inline long voxels(const engine::Engine& engine, Label label) {
  const auto& figures = engine.snapshot()->state[part::statistics]->figures();
  return figures.contains(label) ? figures.at(label).voxels : 0;
}

inline engine::Outcome done(engine::Engine& engine, engine::Command command) {
  return engine.wait(engine.post(std::move(command)));
}

}  // namespace glisson::test
