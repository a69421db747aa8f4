// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace glisson::engine {

/// What a file or folder is where a model is wanted.
enum class ModelSource {
  a_case,      ///< OpenCase
  tetrahedra,  ///< ImportMesh
  surfaces     ///< ImportSurfaces: a closed surface, or a folder of surfaces
};

/// Looks into formats that hold either (.vtk, .vtu, .msh). Nothing is checked beyond that: who reads it says
/// what is wrong with it.
/// @throws FileError missing; InputError a file that cannot be read or is of no known mesh format.
ModelSource model_source(const std::filesystem::path& path);

}  // namespace glisson::engine
