// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/registration_actors.h"

#include <vtkConeSource.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "actor_group.h"
#include "glisson/core/chi_square.h"
#include "glisson/core/error.h"
#include "glisson/ui/scene/colours.h"
#include "glisson/ui/scene/proposal_actors.h"
#include "glisson/ui/scene/surface_shapes.h"

namespace glisson::scene {
namespace {

constexpr double kLiverOpacity = 0.7, kRegionOpacity = 0.45;
constexpr double kLongestArrow = 35e-3;            // metres: of the strongest force
constexpr double kPlace = 6e-3;                    // metres: radius of the ball where a look helps most
constexpr double kShaft = 1.2e-3, kHead = 3.2e-3;  // radii, metres

const DrawableSurface* liver_of(const DrawableModel& model) {
  for (const DrawableSurface& surface : model.surfaces)
    if (surface.structure == structure::kParenchyma) return &surface;
  return nullptr;
}

TriangleMesh placed(const DrawableSurface& surface, const PatientModel& model, const Points& nodes) {
  return {surface.binding.apply(model.mesh, nodes), surface.mesh.triangles};
}

/// The head of an arrow.
vtkSmartPointer<vtkPolyData> head(const Eigen::Vector3d& base, const Eigen::Vector3d& tip, double radius) {
  const Eigen::Vector3d along = tip - base, middle = 0.5 * (base + tip);
  vtkNew<vtkConeSource> cone;
  cone->SetCenter(middle.x(), middle.y(), middle.z());
  cone->SetDirection(along.x(), along.y(), along.z());
  cone->SetHeight(along.norm());
  cone->SetRadius(radius);
  cone->SetResolution(16);
  cone->Update();
  return cone->GetOutput();
}

}  // namespace

QColor error_colour(double error) {
  static constexpr std::array<std::array<double, 3>, 5> kStops = {
      {{0, 34, 78}, {65, 77, 107}, {124, 123, 120}, {188, 175, 111}, {254, 232, 56}}};
  const double at = (kStops.size() - 1) * std::clamp(error / kMostErrorShown, 0.0, 1.0);
  const auto low = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const double share = at - static_cast<double>(low);
  const auto mix = [&](std::size_t c) {
    return static_cast<int>(std::lround((1.0 - share) * kStops[low][c] + share * kStops[low + 1][c]));
  };
  return {mix(0), mix(1), mix(2)};
}

ErrorRange look_range(const LesionLooks& looks) {
  return {looks.seen.size() > 0 ? looks.seen.minCoeff() : looks.now, looks.now};
}

struct RegistrationActors::Impl {
  ActorGroup actors;

  explicit Impl(vtkRenderer& to) : actors(to) {}

  /// @param errors of the nodes, metres; of another size: not known.
  void add_liver(const DrawableSurface& liver, const PatientModel& model, const Points& nodes,
                 const Eigen::VectorXd& errors, const ErrorRange& range) {
    const auto data = make_poly_data(placed(liver, model, nodes));
    add_normals(*data);
    if (errors.size() == nodes.rows()) {
      // What carries the vertices' places carries their numbers as well.
      Points numbers = Points::Zero(errors.size(), 3);
      numbers.col(0) = errors;
      const Points of_vertices = liver.binding.apply(model.mesh, numbers);
      vtkNew<vtkUnsignedCharArray> colours;
      colours->SetNumberOfComponents(3);
      for (Eigen::Index i = 0; i < of_vertices.rows(); ++i) {
        const double share = (of_vertices(i, 0) - range.low) / std::max(1e-6, range.high - range.low);
        const QColor colour = error_colour(kMostErrorShown * share);
        for (const int part : {colour.red(), colour.green(), colour.blue()})
          colours->InsertNextValue(static_cast<unsigned char>(part));
      }
      data->GetPointData()->SetScalars(colours);
    }
    vtkProperty& look = actors.add(data, QColor(120, 126, 132));
    look.SetOpacity(kLiverOpacity);
    look.SetBackfaceCulling(1);
    look.SetAmbient(0.35);  // the colour is read, not the light
  }

  void add_region(const LesionVerdict& lesion) {
    if (lesion.covariance.isZero(0.0)) return;
    const auto data = make_poly_data(ellipsoid(lesion.centre, lesion.covariance, kEllipsoid95));
    add_normals(*data);
    vtkProperty& look = actors.add(data, colour_of(lesion.lesion));
    look.SetOpacity(kRegionOpacity);
    look.SetBackfaceCulling(1);
  }

  /// An arrow that ends where the force acts.
  void add_force(const FoundForce& force, const Points& nodes, double strongest) {
    const Eigen::Vector3d tip = nodes.row(force.node).transpose();
    const double length = kLongestArrow * force.force.norm() / strongest;
    if (length < 2.0 * kHead) return;
    const Eigen::Vector3d along = force.force.normalized(), neck = tip - 3.0 * kHead * along;
    Points shaft(2, 3);
    shaft << (tip - length * along).transpose(), neck.transpose();
    const QColor colour(255, 122, 61);
    if (length > 3.0 * kHead) actors.add(make_poly_data(polyline_tube(shaft, kShaft)), colour).LightingOff();
    actors.add(head(neck, tip, kHead), colour).LightingOff();
  }

  void add_best_place(const Eigen::VectorXd& errors, const Points& nodes) {
    Eigen::Index best = 0;
    if (!(errors.minCoeff(&best) < errors.maxCoeff())) return;
    const Eigen::Matrix3d square = kPlace * kPlace * Eigen::Matrix3d::Identity();
    const auto data = make_poly_data(ellipsoid(nodes.row(best).transpose(), square, 1.0));
    add_normals(*data);
    actors.add(data, QColor(255, 255, 255)).LightingOff();
  }

  void add_rival(const DrawableSurface& liver, const PatientModel& model, const Points& nodes) {
    vtkProperty& look = actors.add(make_poly_data(placed(liver, model, nodes)), QColor(87, 181, 232));
    look.SetRepresentationToWireframe();
    look.SetOpacity(0.35);
    look.LightingOff();
  }
};

RegistrationActors::RegistrationActors(vtkRenderer& renderer) : impl_(std::make_unique<Impl>(renderer)) {}

RegistrationActors::~RegistrationActors() = default;

void RegistrationActors::clear() { impl_->actors.clear(); }

void RegistrationActors::show(const DrawableModel& model, const Registration& registration,
                              const std::vector<LesionVerdict>& lesions, const Chosen& chosen) {
  const PatientModel& patient = *model.model;
  require(registration.nodes_in_camera.rows() == patient.mesh.vertex_count(),
          "a registration's nodes are those of its model");
  impl_->actors.clear();
  const DrawableSurface* liver = liver_of(model);
  if (liver != nullptr && liver->binding.weights.rows() > 0) {
    const auto look = static_cast<std::size_t>(chosen.look), rival = static_cast<std::size_t>(chosen.rival);
    const bool looks = chosen.holds && chosen.look >= 0 && look < registration.looks.size();
    impl_->add_liver(*liver, patient, registration.nodes_in_camera,
                     !chosen.holds ? Eigen::VectorXd()
                     : looks       ? registration.looks[look].seen
                                   : registration.expected,
                     looks ? look_range(registration.looks[look]) : ErrorRange());
    if (looks) impl_->add_best_place(registration.looks[look].seen, registration.nodes_in_camera);
    if (chosen.rival >= 0 && rival < registration.rivals.size())
      impl_->add_rival(*liver, patient, registration.rivals[rival].nodes_in_camera);
  }
  if (chosen.holds)
    for (const LesionVerdict& lesion : lesions) impl_->add_region(lesion);
  double strongest = 0.0;
  for (const FoundForce& force : registration.forces) strongest = std::max(strongest, force.force.norm());
  for (const FoundForce& force : registration.forces)
    impl_->add_force(force, registration.nodes_in_camera, strongest);
}

}  // namespace glisson::scene
