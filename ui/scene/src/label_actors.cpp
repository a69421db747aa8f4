// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/label_actors.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <algorithm>

#include "glisson/patient/label_map.h"

namespace glisson::scene {
namespace {

constexpr double kLiverOpacity = 0.35;

vtkSmartPointer<vtkPolyData> poly_data(const BlockSurface& surface) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(surface.vertices.rows());
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(surface.vertices.rows());
  std::copy_n(surface.vertices.data(), surface.vertices.size(),
              static_cast<float*>(points->GetVoidPointer(0)));
  std::copy_n(surface.normals.data(), surface.normals.size(), normals->GetPointer(0));
  vtkNew<vtkCellArray> cells;
  for (Eigen::Index t = 0; t < surface.triangles.rows(); ++t) {
    const vtkIdType ids[3] = {surface.triangles(t, 0), surface.triangles(t, 1), surface.triangles(t, 2)};
    cells->InsertNextCell(3, ids);
  }
  auto shape = vtkSmartPointer<vtkPolyData>::New();
  shape->SetPoints(points);
  shape->SetPolys(cells);
  shape->GetPointData()->SetNormals(normals);
  return shape;
}

}  // namespace

struct LabelActors::Impl {
  struct Block {
    std::shared_ptr<const BlockSurface> surface;
    vtkNew<vtkActor> actor;
  };
  vtkRenderer& renderer;
  std::map<LabelSurfaces::Key, std::unique_ptr<Block>> blocks;
  std::vector<Label> hidden;
  bool visible = true;

  explicit Impl(vtkRenderer& to) : renderer(to) {}

  void dress(Label label, vtkActor& actor) const {
    auto colour = structure_colour(label);
    vtkProperty& look = *actor.GetProperty();
    look.SetColor(colour.data());
    look.SetSpecular(0.25);
    look.SetSpecularPower(30.0);
    const bool skin = label == structure::kParenchyma;
    look.SetOpacity(skin ? kLiverOpacity : 1.0);
    // One layer of a translucent skin needs no sorting, which software drawing could not afford.
    look.SetBackfaceCulling(skin ? 1 : 0);
    actor.SetVisibility(shows(label) ? 1 : 0);
  }
  bool shows(Label label) const {
    return visible && std::find(hidden.begin(), hidden.end(), label) == hidden.end();
  }
  void apply() {
    for (auto& [key, block] : blocks) block->actor->SetVisibility(shows(key.first) ? 1 : 0);
  }
};

LabelActors::LabelActors(vtkRenderer& renderer) : impl_(std::make_unique<Impl>(renderer)) {}

LabelActors::~LabelActors() { show({}); }

void LabelActors::show(const LabelSurfaces& surfaces) {
  for (auto block = impl_->blocks.begin(); block != impl_->blocks.end();) {
    const auto now = surfaces.blocks().find(block->first);
    if (now != surfaces.blocks().end() && now->second == block->second->surface) {
      ++block;
      continue;
    }
    impl_->renderer.RemoveActor(block->second->actor);
    block = impl_->blocks.erase(block);
  }
  for (const auto& [key, surface] : surfaces.blocks()) {
    std::unique_ptr<Impl::Block>& block = impl_->blocks[key];
    if (block) continue;
    block = std::make_unique<Impl::Block>();
    block->surface = surface;
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(poly_data(*surface));
    block->actor->SetMapper(mapper);
    impl_->dress(key.first, *block->actor);
    impl_->renderer.AddActor(block->actor);
  }
}

void LabelActors::set_hidden(const std::vector<Label>& labels) {
  impl_->hidden = labels;
  impl_->apply();
}

void LabelActors::set_visible(bool visible) {
  impl_->visible = visible;
  impl_->apply();
}

int LabelActors::actor_count() const { return static_cast<int>(impl_->blocks.size()); }

std::vector<vtkActor*> LabelActors::actors() const {
  std::vector<vtkActor*> all;
  for (const auto& [key, block] : impl_->blocks) all.push_back(block->actor);
  return all;
}

}  // namespace glisson::scene
