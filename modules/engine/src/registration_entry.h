// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>

#include "glisson/engine/part.h"
#include "glisson/model/build.h"
#include "glisson/patient/registration.h"

/// @file
/// A registration in a case's folder: a mesh, and the rest in case.json.

namespace glisson::engine {

/// Writes the mesh and gives the entry. @throws FileError.
nlohmann::json write_registration_entry(const CaseFolder& folder, const char* file,
                                        const model::BuiltModel& built, const Registration& registration);
/// @param built null: an error. @throws FileError, InputError naming file and field.
std::shared_ptr<const Registration> read_registration_entry(const CaseFolder& folder, const char* file,
                                                            const nlohmann::json& entry,
                                                            const model::BuiltModel* built);

/// Whether one that was read back holds all that was written.
bool same_registration(const Registration& written, const Registration& read);

}  // namespace glisson::engine
