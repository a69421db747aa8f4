// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/fem/composite_model.h"

#include <cmath>
#include <sstream>
#include <string>
#include <utility>

#include "composite_impl.h"
#include "glisson/core/error.h"

namespace glisson::fem {
namespace {

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

void check_material(const Material& material, const std::string& name) {
  if (!std::isfinite(material.young_modulus) || material.young_modulus < 1.0 || material.young_modulus > 1e12)
    throw InputError(name, "young_modulus", "is " + number(material.young_modulus) + " Pa, out of range",
                     "Give Young's modulus in pascals, between 1 and 1e12 (3.5 kPa is 3500)");
  if (!(material.poisson_ratio >= 0.0 && material.poisson_ratio < 0.5))
    throw InputError(name, "poisson_ratio", "is " + number(material.poisson_ratio) + ", out of range",
                     "Give a Poisson ratio from 0 to below 0.5");
}

void check_range(double value, double low, double high, const std::string& field, const std::string& unit) {
  if (!(value >= low && value <= high))
    throw InputError("composite options", field, "is " + number(value) + " " + unit + ", out of range",
                     "Give a value between " + number(low) + " and " + number(high) + " " + unit);
}

std::vector<Tetrahedron> build_tetrahedra(const TetMesh& mesh, const CompositeOptions& options) {
  std::vector<Tetrahedron> elements;
  elements.reserve(static_cast<std::size_t>(mesh.tetrahedron_count()));
  for (int t = 0; t < mesh.tetrahedron_count(); ++t) {
    std::array<int, 4> nodes;
    Eigen::Matrix<double, 3, 4> rest;
    for (int k = 0; k < 4; ++k) {
      nodes[k] = mesh.tetrahedra(t, k);
      rest.col(k) = mesh.vertex(nodes[k]);
    }
    elements.emplace_back(
        nodes, rest,
        mesh.labels.empty() ? options.parenchyma : options.of(mesh.labels[static_cast<std::size_t>(t)]));
  }
  return elements;
}

std::vector<Membrane> build_membranes(const BoundarySurface& surface, const CompositeOptions& options) {
  std::vector<Membrane> elements;
  elements.reserve(static_cast<std::size_t>(surface.mesh.triangle_count()));
  for (int t = 0; t < surface.mesh.triangle_count(); ++t) {
    std::array<int, 3> nodes;
    Eigen::Matrix3d rest;
    for (int k = 0; k < 3; ++k) {
      const int vertex = surface.mesh.triangles(t, k);
      nodes[k] = surface.node_of_vertex[static_cast<std::size_t>(vertex)];
      rest.col(k) = surface.mesh.vertex(vertex);
    }
    elements.emplace_back(nodes, rest, options.capsule, options.capsule_thickness);
  }
  return elements;
}

void check_all_nodes_used(const CompositeModel::Impl& impl) {
  for (Eigen::Index i = 0; i < impl.lumped_mass.size(); ++i)
    if (impl.lumped_mass[i] == 0.0)
      throw InputError("mesh", "vertex " + std::to_string(i), "belongs to no tetrahedron",
                       "Drop unused vertices from the mesh");
}

}  // namespace

void CompositeOptions::validate() const {
  check_material(parenchyma, "parenchyma");
  check_material(vessel_wall, "vessel_wall");
  check_material(capsule, "capsule");
  for (const auto& [label, material] : by_label)
    check_material(material, "by_label[" + std::to_string(label) + "]");
  check_range(capsule_thickness, 1e-7, 1e-2, "capsule_thickness", "m");
  check_range(wall_fraction, 1e-3, 1.0, "wall_fraction", "of the radius");
  check_range(density, 1.0, 1e5, "density", "kg/m3");
  check_range(rayleigh_mass, 0.0, 1e4, "rayleigh_mass", "1/s");
  check_range(rayleigh_stiffness, 0.0, 1e4, "rayleigh_stiffness", "s");
}

const Material& CompositeOptions::of(int label) const {
  const auto found = std::in_range<Label>(label) ? by_label.find(static_cast<Label>(label)) : by_label.end();
  return found == by_label.end() ? parenchyma : found->second;
}

CompositeModel::CompositeModel(const TetMesh& mesh, const std::vector<VesselTree>& vessels,
                               const CompositeOptions& options)
    : impl_(std::make_unique<Impl>()) {
  options.validate();
  if (mesh.tetrahedron_count() == 0)
    throw InputError("mesh", "tetrahedra", "holds none", "Give a tetrahedral mesh of the liver");
  if (!mesh.labels.empty() && static_cast<int>(mesh.labels.size()) != mesh.tetrahedron_count())
    throw InputError("mesh", "labels",
                     "has " + std::to_string(mesh.labels.size()) + " values for " +
                         std::to_string(mesh.tetrahedron_count()) + " tetrahedra",
                     "Give one label a tetrahedron, or none");
  check_tetrahedra(mesh, "mesh");
  Impl& m = *impl_;
  m.mesh = mesh;
  m.options = options;
  m.surface = boundary_surface(mesh);
  m.tetrahedra = build_tetrahedra(mesh, options);
  if (options.with_capsule) m.membranes = build_membranes(m.surface, options);
  if (options.with_vessels) m.vessels = bind_vessels(mesh, vessels, options);
  m.lumped_mass = Eigen::VectorXd::Zero(mesh.vertex_count());
  for (const Tetrahedron& element : m.tetrahedra)
    for (const int node : element.nodes) m.lumped_mass[node] += 0.25 * options.density * element.volume;
  check_all_nodes_used(m);
}

CompositeModel::~CompositeModel() = default;

int CompositeModel::node_count() const { return impl_->mesh.vertex_count(); }
int CompositeModel::beam_count() const { return static_cast<int>(impl_->vessels.beams.size()); }
const TetMesh& CompositeModel::mesh() const { return impl_->mesh; }
const BoundarySurface& CompositeModel::surface() const { return impl_->surface; }
const CompositeOptions& CompositeModel::options() const { return impl_->options; }
const Eigen::VectorXd& CompositeModel::lumped_mass() const { return impl_->lumped_mass; }

Points CompositeModel::mass_times(const Points& per_node) const {
  require(per_node.rows() == node_count(), "a product with the mass takes one row a node of the model");
  if (impl_->options.mass == MassMatrix::lumped) return impl_->lumped_mass.asDiagonal() * per_node;
  Points product = Points::Zero(per_node.rows(), 3);
  for (const Tetrahedron& e : impl_->tetrahedra) {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (const int node : e.nodes) sum += per_node.row(node);
    const double share = impl_->options.density * e.volume / 20.0;
    for (const int node : e.nodes) product.row(node) += share * (sum + per_node.row(node));
  }
  return product;
}

double CompositeModel::energy(const Points& x) const {
  require(x.rows() == node_count(), "positions hold one row a node of the model");
  const Impl& m = *impl_;
  double sum = 0.0;
  for (const Tetrahedron& e : m.tetrahedra)
    sum += e.volume * energy_density(e, m.options.law, e.deformation_gradient(x));
  for (const Membrane& e : m.membranes) sum += e.volume * energy_density(e, e.deformation_gradient(x));
  std::vector<BeamNodeState> states;
  states.reserve(m.vessels.nodes.size());
  for (const BoundNode& node : m.vessels.nodes)
    states.push_back(
        bound_state(node, m.tetrahedra[static_cast<std::size_t>(node.tetrahedron)], x, false).state);
  for (const VesselBeam& beam : m.vessels.beams)
    sum += beam.element.energy(states[static_cast<std::size_t>(beam.a)],
                               states[static_cast<std::size_t>(beam.b)]);
  return sum;
}

Points CompositeModel::internal_force(const Points& x) const {
  require(x.rows() == node_count(), "positions hold one row a node of the model");
  const Impl& m = *impl_;
  Points force = Points::Zero(x.rows(), 3);
  for (const Tetrahedron& e : m.tetrahedra) {
    const Eigen::Matrix<double, 3, 4> f =
        e.volume * stress(e, m.options.law, e.deformation_gradient(x)) * e.gradients;
    for (int k = 0; k < 4; ++k) force.row(e.nodes[k]) -= f.col(k).transpose();
  }
  for (const Membrane& e : m.membranes) {
    const Eigen::Matrix3d f = e.volume * stress(e, e.deformation_gradient(x)) * e.gradients;
    for (int k = 0; k < 3; ++k) force.row(e.nodes[k]) -= f.col(k).transpose();
  }
  const std::vector<BoundState> states = bound_states(m.vessels, m.tetrahedra, x);
  for (const VesselBeam& beam : m.vessels.beams) {
    const BoundState &a = states[static_cast<std::size_t>(beam.a)],
                     &b = states[static_cast<std::size_t>(beam.b)];
    const BeamElement::Gradient gradient = beam.element.gradient(a.state, b.state);
    add_bound_force(m.vessels.nodes[static_cast<std::size_t>(beam.a)], m.tetrahedra, a, gradient.head<6>(),
                    force);
    add_bound_force(m.vessels.nodes[static_cast<std::size_t>(beam.b)], m.tetrahedra, b, gradient.tail<6>(),
                    force);
  }
  return force;
}

Eigen::VectorXd CompositeModel::von_mises(const Points& x) const {
  require(x.rows() == node_count(), "positions hold one row a node of the model");
  Eigen::VectorXd result(mesh().tetrahedron_count());
  for (Eigen::Index t = 0; t < result.size(); ++t) {
    const Tetrahedron& e = impl_->tetrahedra[static_cast<std::size_t>(t)];
    result[t] = fem::von_mises(e, impl_->options.law, e.deformation_gradient(x));
  }
  return result;
}

}  // namespace glisson::fem
