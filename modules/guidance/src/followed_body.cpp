// SPDX-License-Identifier: GPL-3.0-or-later
#include "followed_body.h"

#include <string>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/fem/inverted.h"
#include "glisson/registration/register.h"

namespace glisson::guidance {
namespace {

fem::IntegratorOptions integration(const TrackerOptions& options) {
  fem::IntegratorOptions result;
  result.time_step = options.time_step;
  result.fixed_nodes = options.fixed_nodes;
  return result;
}

PatientModel mechanics_of(const PatientModel& model) {
  PatientModel mechanics;
  mechanics.mesh = model.mesh;
  mechanics.vessels = model.vessels;
  return mechanics;
}

}  // namespace

FollowedBody::FollowedBody(const PatientModel& model, const Points& start_in_camera,
                           const TrackerOptions& options)
    : materials_(options.materials),
      integration_(integration(options)),
      mechanics_(mechanics_of(model)),
      composite_(std::make_shared<fem::CompositeModel>(model.mesh, model.vessels, materials_)),
      integrator_(composite_, integration_),
      surface_(model),
      springs_(model, start_in_camera, options.boundary_young_modulus, options.boundary_length,
               options.boundary_tether) {
  place(start_in_camera);
}

std::shared_ptr<const fem::CompositeModel> FollowedBody::resting_in(const Points& shape, const char* what,
                                                                    const char* remedy) const {
  try {
    const PatientModel rest = registration::moved_to(mechanics_, shape);
    return std::make_shared<fem::CompositeModel>(rest.mesh, rest.vessels, materials_);
  } catch (const InputError& failure) {
    throw InputError(what, "mesh", std::string("cannot be followed: ") + failure.what(), remedy);
  }
}

void FollowedBody::rest_here() {
  const Points here = positions();
  composite_ = resting_in(here);
  integrator_ = fem::Integrator(composite_, integration_);
  integrator_.set_state(here);
}

int FollowedBody::inverted() const { return fem::inverted_tetrahedra(*composite_, positions()); }

void FollowedBody::move(const RigidMotion& motion) {
  const Points moved = (positions() * motion.rotation.transpose()).rowwise() + motion.translation.transpose();
  place(moved);
  springs_.move(motion);
}

void FollowedBody::place(const Points& positions) {
  integrator_.set_state(positions);
  surface_.move(positions);
}

void FollowedBody::take(std::shared_ptr<const fem::CompositeModel> resting, const Points& motion) {
  const Points there = positions() + motion, speed = velocities();
  composite_ = std::move(resting);
  integrator_ = fem::Integrator(composite_, integration_);
  integrator_.set_state(there, speed);
  surface_.move(there);
  springs_.shift(motion);
}

void FollowedBody::restore(const Points& positions, const Points& velocities,
                           const BoundarySprings& springs) {
  springs_ = springs;
  integrator_.set_state(positions, velocities);
  surface_.move(positions);
}

}  // namespace glisson::guidance
