// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "cli.h"

#include "glisson/fem/composite_model.h"
#include "glisson/fem/tissue.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/patient/registration.h"
#include "glisson/registration/register_model.h"

/// @file
/// "M" of the command line: a case, a tetrahedral mesh, or a closed surface.

namespace glisson::app {

/// What was given as a model, and how results go back to it.
struct ModelArgument {
  std::filesystem::path path;
  LengthUnit unit = LengthUnit::millimetre;
  /// Set when a surface was given: results are that surface, deformed.
  std::optional<TriangleMesh> surface;
};

/// Declares --model, --unit, --vertices and --landmarks.
void declare_model(Arguments& arguments);
/// Brings the model into the session. @throws Error.
ModelArgument load_model(const Arguments& arguments, Session& session);

/// Writes the model at `nodes` (camera frame) as what was given: the tetrahedral mesh in its node order, or
/// the surface deformed; in its unit, with `cloud_from_model` and what else is said of it as field data.
void write_deformed(const std::filesystem::path& path, const ModelArgument& argument, const Session& session,
                    const Registration& registration, const NamedArrays& said = {});

/// Declares --stiffness.
void declare_stiffness(Arguments& arguments);
/// What --stiffness says; empty: nothing. @throws InputError.
std::optional<fem::Tissue> given_stiffness(const Arguments& arguments);
/// Declares what the mechanics is made of: --materials, --homogeneous, --young, --poisson, --stiffness.
void declare_materials(Arguments& arguments);
fem::CompositeOptions materials(const Arguments& arguments);
/// The same where one of them was given; empty: the model decides. @throws UsageError where --stiffness says
/// something of the parenchyma, too.
std::optional<fem::CompositeOptions> given_materials(const Arguments& arguments);
/// How the shape is found, as --method names it. @throws UsageError.
registration::Method given_method(const Arguments& arguments);
/// Brings what --stiffness says into the session. @throws Error.
void say_stiffness(const Arguments& arguments, Session& session);
/// Node numbers of --fixed, or none.
std::vector<int> fixed_nodes(const Arguments& arguments, const Session& session);

}  // namespace glisson::app
