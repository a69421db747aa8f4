// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/patient_scene.h"

#include <Eigen/Geometry>

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <map>

#include "glisson/core/error.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/patient/label_map.h"
#include "glisson/ui/scene/colours.h"
#include "glisson/ui/scene/surface_shapes.h"

namespace glisson::scene {
namespace {

struct Shape {
  const DrawableSurface* surface = nullptr;  ///< the drawable model's; null: no structure of it
  vtkSmartPointer<vtkPolyData> data;
  vtkNew<vtkActor> actor;
};

std::unique_ptr<Shape> make_shape(const vtkSmartPointer<vtkPolyData>& data) {
  auto shape = std::make_unique<Shape>();
  shape->data = data;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shape->data);
  shape->actor->SetMapper(mapper);
  return shape;
}

void give_colour(vtkActor& actor, Label structure) {
  auto colour = structure_colour(structure);
  actor.GetProperty()->SetColor(colour.data());
  actor.GetProperty()->SetSpecular(0.25);
  actor.GetProperty()->SetSpecularPower(30.0);
}

void give_colour(vtkActor& actor, Feature feature) {
  const QColor colour = colour_of(feature);
  actor.GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
}

constexpr double kSkeletonRadius = 0.7e-3;  ///< metres
constexpr double kFillView = 1.25;  ///< zoom after VTK has fitted the scene's sphere: a liver is flatter

/// Towards which side of the patient a direction points: one letter, or two where it lies between sides.
std::string side_letters(const Eigen::Vector3d& direction) {
  constexpr double kLeast = 0.38;  // sine of 22.5 degrees
  constexpr std::array<std::array<char, 2>, 3> kLetters = {{{'R', 'L'}, {'A', 'P'}, {'I', 'S'}}};
  std::array<int, 3> axes = {0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(),
                   [&](int a, int b) { return std::abs(direction[a]) > std::abs(direction[b]); });
  std::string letters;
  for (const int axis : axes)
    if (std::abs(direction[axis]) > kLeast && letters.size() < 2)
      letters += kLetters[static_cast<std::size_t>(axis)][direction[axis] > 0.0 ? 1 : 0];
  return letters;
}

}  // namespace

struct PatientScene::Impl {
  vtkNew<vtkRenderer> renderer;
  std::shared_ptr<const DrawableModel> drawable;
  std::shared_ptr<const PatientModel> model;  ///< drawable's
  Points nodes;
  std::map<Label, std::unique_ptr<Shape>> structures;
  std::unique_ptr<Shape> mesh, margin, notch, cava, cloud, pull, highlight, roots;
  std::vector<std::unique_ptr<Shape>> skeletons;  ///< one a tree
  Landmarks landmarks;
  Binding margin_binding, notch_binding, cava_binding;
  std::vector<std::unique_ptr<Shape>> markers;
  struct Slice {
    std::unique_ptr<Shape> shape;
    vtkNew<vtkTexture> texture;
  };
  std::array<std::unique_ptr<Slice>, 3> slices;
  std::map<Label, bool> visible;
  std::map<Label, double> opacity{{structure::kParenchyma, 0.35}};
  bool mesh_visible = false, slices_visible = true, skeleton_visible = false;
  ClosestPointTree skin;
  std::optional<std::pair<ViewFrom, InView>> looked;  ///< by look_from(), last, which set the viewer so:
  Eigen::Vector3d set_at = Eigen::Vector3d::Zero(), set_up = Eigen::Vector3d::Zero();

  void remove(std::unique_ptr<Shape>& shape) {
    if (shape) renderer->RemoveActor(shape->actor);
    shape.reset();
  }
  void add(Shape& shape) { renderer->AddActor(shape.actor); }

  void apply_look(Label structure) {
    const auto found = structures.find(structure);
    if (found == structures.end()) return;
    vtkActor& actor = *found->second->actor;
    const auto shown = visible.find(structure);
    actor.SetVisibility(shown == visible.end() || shown->second ? 1 : 0);
    const auto strength = opacity.find(structure);
    const double alpha = strength == opacity.end() ? 1.0 : strength->second;
    actor.GetProperty()->SetOpacity(alpha);
    // One layer of a translucent skin needs no sorting, which software drawing could not afford.
    actor.GetProperty()->SetBackfaceCulling(alpha < 1.0 ? 1 : 0);
  }

  void add_surface(const DrawableSurface& surface) {
    auto shape = make_shape(make_poly_data(surface.mesh));
    add_normals(*shape->data);
    shape->surface = &surface;
    give_colour(*shape->actor, surface.structure);
    add(*shape);
    structures[surface.structure] = std::move(shape);
    apply_look(surface.structure);
  }

  void draw_skeleton() {
    for (auto& shape : skeletons) remove(shape);
    skeletons.clear();
    remove(roots);
    if (!skeleton_visible || !model || model->vessels.empty()) return;
    Points entrances(0, 3);
    for (const VesselTree& tree : model->vessels) {
      VesselTree thin = tree;
      thin.radii.assign(tree.radii.size(), kSkeletonRadius);
      auto shape = make_shape(make_poly_data(tube_mesh(thin, 6)));
      // Lighter than the vessel around it, whose colour it keeps.
      const auto colour = structure_colour(tree.structure);
      shape->actor->GetProperty()->SetColor(0.5 + 0.5 * colour[0], 0.5 + 0.5 * colour[1],
                                            0.5 + 0.5 * colour[2]);
      shape->actor->GetProperty()->LightingOff();
      add(*shape);
      skeletons.push_back(std::move(shape));
      if (tree.root < 0) continue;
      entrances.conservativeResize(entrances.rows() + 1, 3);
      entrances.bottomRows(1) = tree.nodes.row(tree.root);
    }
    roots = make_shape(balls(entrances, 3e-3));
    roots->actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
    add(*roots);
  }

  void draw_landmarks() {
    for (auto* shape : {&margin, &notch, &cava}) remove(*shape);
    const auto place = [&](const Points& points, const Binding& binding) -> Points {
      return nodes.rows() == 0 || binding.weights.rows() == 0 ? points : binding.apply(model->mesh, nodes);
    };
    if (landmarks.anterior_margin.rows() > 1) {
      margin =
          make_shape(make_poly_data(polyline_tube(place(landmarks.anterior_margin, margin_binding), 1.2e-3)));
      give_colour(*margin->actor, Feature::anterior_margin);
      add(*margin);
    }
    if (landmarks.umbilical_notch.rows() > 0) {
      notch = make_shape(balls(place(landmarks.umbilical_notch, notch_binding), 4e-3));
      give_colour(*notch->actor, Feature::umbilical_notch);
      add(*notch);
    }
    if (landmarks.vena_cava.rows() > 0) {
      cava = make_shape(balls(place(landmarks.vena_cava, cava_binding), 2.5e-3));
      give_colour(*cava->actor, structure::kVenaCava);
      add(*cava);
    }
  }

  /// @param loaded what lies outside follows as set_loaded_nodes() says.
  void put(const Points& moved, bool loaded);

  vtkSmartPointer<vtkMatrix4x4> clip_from_world(double aspect) const {
    auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
    matrix->DeepCopy(renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0));
    return matrix;
  }

  /// @param depth of normalised device coordinates, [-1, 1].
  Eigen::Vector3d unproject(double x, double y, double depth, double aspect) const {
    const auto inverse = clip_from_world(aspect);
    inverse->Invert();
    const double clip[4] = {2.0 * x - 1.0, 1.0 - 2.0 * y, depth, 1.0};
    double world[4];
    inverse->MultiplyPoint(clip, world);
    return Eigen::Vector3d(world[0], world[1], world[2]) / world[3];
  }
};

PatientScene::PatientScene() : impl_(std::make_unique<Impl>()) {
  impl_->renderer->SetBackground(0.086, 0.102, 0.118);
  impl_->renderer->SetBackgroundAlpha(1.0);  // VTK's default lets the widget behind shine through
}
PatientScene::~PatientScene() = default;

vtkRenderer& PatientScene::renderer() const { return *impl_->renderer; }

std::vector<vtkActor*> PatientScene::surface_actors() const {
  std::vector<vtkActor*> actors;
  for (const auto& [label, shape] : impl_->structures) actors.push_back(shape->actor);
  for (const auto& slice : impl_->slices)
    if (slice) actors.push_back(slice->shape->actor);
  return actors;
}

void PatientScene::set_model(const PatientModel& model) {
  set_model(make_drawable(std::make_shared<const PatientModel>(model)));
}

void PatientScene::set_model(std::shared_ptr<const DrawableModel> drawable) {
  for (auto& [label, shape] : impl_->structures) impl_->renderer->RemoveActor(shape->actor);
  impl_->structures.clear();
  impl_->remove(impl_->mesh);
  impl_->nodes.resize(0, 3);
  impl_->drawable = std::move(drawable);
  impl_->model = impl_->drawable ? impl_->drawable->model : nullptr;
  impl_->skin = {};
  impl_->draw_skeleton();
  if (!impl_->model) {
    set_landmarks({});
    return;
  }
  for (const DrawableSurface& surface : impl_->drawable->surfaces) impl_->add_surface(surface);
  if (impl_->model->surface.mesh.triangle_count() > 0) {
    impl_->mesh = make_shape(make_poly_data(impl_->model->surface.mesh));
    vtkProperty& look = *impl_->mesh->actor->GetProperty();
    look.SetRepresentationToWireframe();
    look.SetColor(0.85, 0.88, 0.9);
    look.LightingOff();
    impl_->add(*impl_->mesh);
    set_mesh_visible(impl_->mesh_visible);
    impl_->skin = ClosestPointTree(impl_->model->surface.mesh);
  }
  set_landmarks(impl_->model->landmarks);
}

void PatientScene::set_nodes(const Points& nodes) { impl_->put(nodes, false); }
void PatientScene::set_loaded_nodes(const Points& nodes) { impl_->put(nodes, true); }

int PatientScene::node_count() const { return impl_->model ? impl_->model->mesh.vertex_count() : 0; }

void PatientScene::set_pull(const std::optional<Pull>& pull) {
  impl_->remove(impl_->pull);
  if (!pull) return;
  Points ends(2, 3);
  ends << pull->from.transpose(), pull->to.transpose();
  vtkNew<vtkAppendPolyData> all;
  all->AddInputData(balls(ends, 2.5e-3));
  if ((pull->to - pull->from).norm() > 1e-4) all->AddInputData(make_poly_data(polyline_tube(ends, 0.8e-3)));
  all->Update();
  impl_->pull = make_shape(all->GetOutput());
  impl_->pull->actor->GetProperty()->SetColor(1.0, 0.85, 0.2);
  impl_->pull->actor->GetProperty()->LightingOff();
  impl_->add(*impl_->pull);
}

void PatientScene::set_skeleton_visible(bool visible) {
  if (impl_->skeleton_visible == visible) return;
  impl_->skeleton_visible = visible;
  impl_->draw_skeleton();
}

void PatientScene::set_highlight(const TriangleMesh& surface) {
  impl_->remove(impl_->highlight);
  if (surface.triangle_count() == 0) return;
  impl_->highlight = make_shape(make_poly_data(surface));
  vtkProperty& look = *impl_->highlight->actor->GetProperty();
  look.SetColor(1.0, 0.35, 0.1);
  look.LightingOff();
  look.SetEdgeVisibility(1);
  look.SetEdgeColor(0.3, 0.05, 0.0);
  impl_->add(*impl_->highlight);
}

void PatientScene::Impl::put(const Points& moved, bool loaded) {
  if (!model) return;
  require(moved.rows() == 0 || moved.rows() == model->mesh.vertex_count(),
          "a scene's nodes are those of its model");
  nodes = moved;
  const Points& at = nodes.rows() > 0 ? nodes : model->mesh.vertices;
  for (auto& [label, shape] : structures)
    if (shape->surface->binding.weights.rows() > 0)
      move_vertices(*shape->data, loaded ? loaded_vertices(*model, *shape->surface, at)
                                         : shape->surface->binding.apply(model->mesh, at));
  if (mesh) {
    Points surface(model->surface.mesh.vertices.rows(), 3);
    for (std::size_t i = 0; i < model->surface.node_of_vertex.size(); ++i)
      surface.row(static_cast<Eigen::Index>(i)) = at.row(model->surface.node_of_vertex[i]);
    move_vertices(*mesh->data, surface);
    skin.refit(surface);
  }
  draw_landmarks();
}

void PatientScene::set_landmarks(const Landmarks& landmarks) {
  impl_->landmarks = landmarks;
  impl_->margin_binding = impl_->notch_binding = impl_->cava_binding = {};
  if (impl_->model && impl_->model->mesh.tetrahedron_count() > 0) {
    const TetMesh& mesh = impl_->model->mesh;
    impl_->margin_binding = bind_points(mesh, landmarks.anterior_margin, false);
    impl_->notch_binding = bind_points(mesh, landmarks.umbilical_notch, false);
    impl_->cava_binding = bind_points(mesh, landmarks.vena_cava, false);
  }
  impl_->draw_landmarks();
}

void PatientScene::set_cloud(const LabelledCloud& cloud) {
  impl_->remove(impl_->cloud);
  if (cloud.size() == 0) return;
  TriangleMesh points;
  points.vertices = cloud.points;
  impl_->cloud = make_shape(make_poly_data(points));
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (int i = 0; i < cloud.size(); ++i) {
    const vtkIdType id = i;
    vertices->InsertNextCell(1, &id);
    const QColor colour = colour_of(cloud.feature(i));
    for (const int part : {colour.red(), colour.green(), colour.blue()})
      colours->InsertNextValue(static_cast<unsigned char>(part));
  }
  impl_->cloud->data->SetVerts(vertices);
  impl_->cloud->data->GetPointData()->SetScalars(colours);
  impl_->cloud->actor->GetProperty()->SetPointSize(4.0F);
  impl_->cloud->actor->GetProperty()->LightingOff();
  impl_->add(*impl_->cloud);
}

void PatientScene::set_markers(const std::vector<Marker>& markers) {
  for (auto& shape : impl_->markers) impl_->renderer->RemoveActor(shape->actor);
  impl_->markers.clear();
  for (const Marker& marker : markers) {
    Points one(1, 3);
    one.row(0) = marker.p.transpose();
    impl_->markers.push_back(make_shape(balls(one, marker.radius)));
    give_colour(*impl_->markers.back()->actor, marker.structure);
    impl_->add(*impl_->markers.back());
  }
}

void PatientScene::set_slice(const SliceGeometry& geometry, const Picture& picture) {
  auto& slice = impl_->slices[static_cast<std::size_t>(geometry.plane)];
  if (picture.empty()) {
    if (slice) impl_->remove(slice->shape);
    slice.reset();
    return;
  }
  require(picture.width == geometry.width && picture.height == geometry.height && picture.channels == 3,
          "a slice's picture has the slice's size");
  if (!slice) {
    slice = std::make_unique<Impl::Slice>();
    TriangleMesh quad;
    quad.vertices.resize(4, 3);
    quad.vertices.setZero();
    quad.triangles.resize(2, 3);
    quad.triangles << 0, 1, 2, 0, 2, 3;
    slice->shape = make_shape(make_poly_data(quad));
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetNumberOfComponents(2);
    for (const auto& [s, t] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
      coordinates->InsertNextTuple2(s, t);
    slice->shape->data->GetPointData()->SetTCoords(coordinates);
    slice->texture->InterpolateOn();
    slice->shape->actor->SetTexture(slice->texture);
    slice->shape->actor->GetProperty()->LightingOff();
    impl_->add(*slice->shape);
    slice->shape->actor->SetVisibility(impl_->slices_visible ? 1 : 0);
  }
  // Texture row 0 is the picture's top row: it lies at the slice's origin.
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture.width, picture.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* out = static_cast<std::uint8_t*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < picture.bytes->size(); i += 3)
    for (std::size_t c = 0; c < 3; ++c) out[i + c] = (*picture.bytes)[i + 2 - c];
  slice->texture->SetInputData(image);
  Points corners(4, 3);
  const double w = picture.width - 0.5, h = picture.height - 0.5;
  corners.row(0) = geometry.p_in_ct({-0.5, -0.5}).xyz.transpose();
  corners.row(1) = geometry.p_in_ct({w, -0.5}).xyz.transpose();
  corners.row(2) = geometry.p_in_ct({w, h}).xyz.transpose();
  corners.row(3) = geometry.p_in_ct({-0.5, h}).xyz.transpose();
  move_vertices(*slice->shape->data, corners);
}

void PatientScene::set_visible(Label structure, bool visible) {
  impl_->visible[structure] = visible;
  impl_->apply_look(structure);
}

bool PatientScene::is_visible(Label structure) const {
  const auto told = impl_->visible.find(structure);
  return told == impl_->visible.end() || told->second;
}

void PatientScene::set_opacity(Label structure, double opacity) {
  impl_->opacity[structure] = std::clamp(opacity, 0.0, 1.0);
  impl_->apply_look(structure);
}

void PatientScene::set_mesh_visible(bool visible) {
  impl_->mesh_visible = visible;
  if (impl_->mesh) impl_->mesh->actor->SetVisibility(visible ? 1 : 0);
}

void PatientScene::set_slices_visible(bool visible) {
  impl_->slices_visible = visible;
  for (auto& slice : impl_->slices)
    if (slice) slice->shape->actor->SetVisibility(visible ? 1 : 0);
}

void PatientScene::look_from(ViewFrom from, InView what) {
  struct Look {
    Eigen::Vector3d direction, up;  // LPS: from the viewer to the patient
  };
  static const std::map<ViewFrom, Look> looks = {
      {ViewFrom::anterior, {{0, 1, 0}, {0, 0, 1}}},   {ViewFrom::posterior, {{0, -1, 0}, {0, 0, 1}}},
      {ViewFrom::right, {{1, 0, 0}, {0, 0, 1}}},      {ViewFrom::left, {{-1, 0, 0}, {0, 0, 1}}},
      {ViewFrom::superior, {{0, 0, -1}, {0, -1, 0}}}, {ViewFrom::inferior, {{0, 0, 1}, {0, -1, 0}}},
      {ViewFrom::camera, {{0, 0, 1}, {0, -1, 0}}}};
  const Look& look = looks.at(from);
  vtkCamera& view = *impl_->renderer->GetActiveCamera();
  view.SetUseExplicitProjectionTransformMatrix(false);
  view.SetFocalPoint(0, 0, 0);
  view.SetPosition((-look.direction).eval().data());
  view.SetViewUp(look.up.data());
  if (what == InView::liver && impl_->mesh)
    impl_->renderer->ResetCamera(impl_->mesh->data->GetBounds());
  else
    impl_->renderer->ResetCamera();
  view.Dolly(kFillView);
  impl_->renderer->ResetCameraClippingRange();
  impl_->looked = {from, what};
  impl_->set_at = Eigen::Map<const Eigen::Vector3d>(view.GetPosition());
  impl_->set_up = Eigen::Map<const Eigen::Vector3d>(view.GetViewUp());
}

void PatientScene::keep_in_view() {
  vtkCamera& view = *impl_->renderer->GetActiveCamera();
  const Eigen::Map<const Eigen::Vector3d> at(view.GetPosition()), up(view.GetViewUp());
  if (impl_->looked && at == impl_->set_at && up == impl_->set_up)
    look_from(impl_->looked->first, impl_->looked->second);
}

ViewLetters PatientScene::view_letters() const {
  vtkCamera& view = *impl_->renderer->GetActiveCamera();
  const Eigen::Map<const Eigen::Vector3d> direction(view.GetDirectionOfProjection());
  const Eigen::Vector3d along = direction.normalized();
  const Eigen::Vector3d up_hint = Eigen::Map<const Eigen::Vector3d>(view.GetViewUp());
  const Eigen::Vector3d right = along.cross(up_hint).normalized(), up = right.cross(along);
  return {side_letters(-right), side_letters(right), side_letters(up), side_letters(-up)};
}

std::optional<Eigen::Vector3d> PatientScene::surface_point(double x, double y, double aspect) const {
  const auto hit = surface_hit(x, y, aspect);
  if (!hit) return std::nullopt;
  return hit->point;
}

std::optional<ClosestPoint> PatientScene::surface_hit(double x, double y, double aspect) const {
  if (impl_->skin.empty()) return std::nullopt;
  const Eigen::Vector3d near = impl_->unproject(x, y, -1.0, aspect),
                        far = impl_->unproject(x, y, 1.0, aspect);
  const ClosestPoint hit = impl_->skin.first_hit(near, far - near, 0.0, 1.0);
  if (hit.triangle < 0) return std::nullopt;
  return hit;
}

Eigen::Vector3d PatientScene::point_beside(const Eigen::Vector3d& p, double x, double y,
                                           double aspect) const {
  const double world[4] = {p.x(), p.y(), p.z(), 1.0};
  double clip[4];
  impl_->clip_from_world(aspect)->MultiplyPoint(world, clip);
  return impl_->unproject(x, y, clip[2] / clip[3], aspect);
}

std::optional<Eigen::Vector2d> PatientScene::view_point(const Eigen::Vector3d& p, double aspect) const {
  const double world[4] = {p.x(), p.y(), p.z(), 1.0};
  double clip[4];
  impl_->clip_from_world(aspect)->MultiplyPoint(world, clip);
  if (clip[3] <= 0.0) return std::nullopt;
  return Eigen::Vector2d(0.5 * (clip[0] / clip[3] + 1.0), 0.5 * (1.0 - clip[1] / clip[3]));
}

}  // namespace glisson::scene
