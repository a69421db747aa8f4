// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "glisson/ui/scene/label_surfaces.h"

class vtkActor;
class vtkRenderer;

namespace glisson::scene {

/// Label surfaces as VTK actors in a renderer: the liver translucent, all else solid. Only blocks that differ
/// are replaced. Not thread-safe.
class LabelActors {
 public:
  /// @param renderer outlives this object.
  explicit LabelActors(vtkRenderer& renderer);
  ~LabelActors();
  LabelActors(const LabelActors&) = delete;
  LabelActors& operator=(const LabelActors&) = delete;

  void show(const LabelSurfaces& surfaces);
  void set_hidden(const std::vector<Label>& labels);
  /// Takes all away, or puts them back.
  void set_visible(bool visible);
  int actor_count() const;
  std::vector<vtkActor*> actors() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::scene
