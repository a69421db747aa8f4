// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <QColor>
#include <vector>

namespace glisson::scene {

/// Actors that come into a renderer and leave it together.
class ActorGroup {
 public:
  /// @param renderer is kept.
  explicit ActorGroup(vtkRenderer& renderer) : renderer_(&renderer) {}
  ~ActorGroup() { clear(); }
  ActorGroup(const ActorGroup&) = delete;
  ActorGroup& operator=(const ActorGroup&) = delete;

  /// @return how it looks, to be changed.
  vtkProperty& add(vtkPolyData* data, const QColor& colour) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
    renderer_->AddActor(actor);
    actors_.push_back(actor);
    return *actor->GetProperty();
  }
  void clear() {
    for (const auto& actor : actors_) renderer_->RemoveActor(actor);
    actors_.clear();
  }
  int size() const { return static_cast<int>(actors_.size()); }

 private:
  vtkSmartPointer<vtkRenderer> renderer_;
  std::vector<vtkSmartPointer<vtkActor>> actors_;
};

}  // namespace glisson::scene
