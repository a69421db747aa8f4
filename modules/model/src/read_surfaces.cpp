// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>

#include "anatomy.h"
#include "glisson/core/error.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/topology.h"
#include "glisson/model/build.h"

namespace glisson::model {
namespace fs = std::filesystem;
namespace {

constexpr double kLeastLesion = 15e-9;  // m3: below, a piece of a tumour file is a crumb
constexpr std::array<const char*, 5> kExtensions = {".vtk", ".vtp", ".stl", ".obj", ".ply"};  // by preference

enum class Role { liver, vessel, lesions, other };
struct Meaning {
  Role role = Role::other;
  Label structure = 0;
};

std::optional<Meaning> meaning_of(std::string stem) {
  std::transform(stem.begin(), stem.end(), stem.begin(), [](unsigned char c) {
    return c == '-' || c == ' ' ? '_' : static_cast<char>(std::tolower(c));
  });
  static const std::map<std::string, Meaning> kMeanings = {
      {"liver", {Role::liver, structure::kParenchyma}},
      {"portal_vein", {Role::vessel, structure::kPortalVein}},
      {"portal_veins", {Role::vessel, structure::kPortalVein}},
      {"hepatic_veins", {Role::vessel, structure::kHepaticVeins}},
      {"hepatic_vein", {Role::vessel, structure::kHepaticVeins}},
      {"arteries", {Role::vessel, structure::kArtery}},
      {"artery", {Role::vessel, structure::kArtery}},
      {"hepatic_artery", {Role::vessel, structure::kArtery}},
      {"vena_cava", {Role::vessel, structure::kVenaCava}},
      {"inferior_vena_cava", {Role::vessel, structure::kVenaCava}},
      {"gallbladder", {Role::vessel, structure::kGallbladder}},
      {"liver_tumours", {Role::lesions, 0}},
      {"liver_tumors", {Role::lesions, 0}},
      {"tumours", {Role::lesions, 0}},
      {"tumors", {Role::lesions, 0}},
      {"lesions", {Role::lesions, 0}},
      {"liver_cysts", {Role::lesions, 0}},
      {"cysts", {Role::lesions, 0}}};
  const auto found = kMeanings.find(stem);
  if (found == kMeanings.end()) return {};
  return found->second;
}

std::string extension_of(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

/// One file a structure: where a folder has several formats of it, the first of kExtensions.
std::map<std::string, fs::path> files_in(const fs::path& folder, std::vector<std::string>& notes) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() &&
        std::find(kExtensions.begin(), kExtensions.end(), extension_of(entry.path())) != kExtensions.end())
      files.push_back(entry.path());
  const auto rank = [](const fs::path& path) {
    return std::find(kExtensions.begin(), kExtensions.end(), extension_of(path)) - kExtensions.begin();
  };
  std::sort(files.begin(), files.end(), [&](const fs::path& a, const fs::path& b) {
    return std::pair(a.stem(), rank(a)) < std::pair(b.stem(), rank(b));
  });
  std::map<std::string, fs::path> chosen;
  for (const fs::path& file : files)
    if (!meaning_of(file.stem().string()) || !chosen.emplace(file.stem().string(), file).second)
      notes.push_back("surfaces.ignored " + file.filename().string());
  return chosen;
}

void add_lesions(const TriangleMesh& file, SurfaceSet& set) {
  int crumbs = 0;
  for (const TriangleMesh& piece : split_components(merge_vertices(file, 0.0))) {
    if (std::abs(volume(piece)) < kLeastLesion || !is_closed(piece)) {
      ++crumbs;
      continue;
    }
    int number = structure::kFirstLesion;
    for (const NamedSurface& other : set.others)
      if (is_lesion(other.structure)) ++number;
    if (number > structure::kLastLesion)
      throw InputError("surfaces", "lesions", "there are more than 240", "Keep those that matter");
    const auto label = static_cast<Label>(number);
    set.others.push_back({label, structure_name(label), piece});
  }
  if (crumbs > 0) set.notes.push_back("lesion.crumbs_dropped " + std::to_string(crumbs));
}

}  // namespace

SurfaceSet read_surfaces(const fs::path& path, LengthUnit unit) {
  if (!fs::exists(path)) throw FileError(path.string() + ": does not exist. Check the path.");
  SurfaceSet set;
  if (!fs::is_directory(path)) {
    set.liver = merge_vertices(read_triangle_mesh(path, unit), 0.0);
    check_liver_size(set.liver.vertices, unit, path.string());
    return set;
  }
  const std::map<std::string, fs::path> files = files_in(path, set.notes);
  std::vector<fs::path> lesion_files;
  for (const auto& [stem, file] : files) {
    const Meaning meaning = *meaning_of(stem);
    if (meaning.role == Role::lesions) {
      lesion_files.push_back(file);
      continue;
    }
    TriangleMesh mesh = merge_vertices(read_triangle_mesh(file, unit), 0.0);
    if (meaning.role == Role::liver) {
      check_liver_size(mesh.vertices, unit, file.string());
      set.liver = std::move(mesh);
    } else {
      set.others.push_back({meaning.structure, structure_name(meaning.structure), std::move(mesh)});
    }
  }
  if (set.liver.triangle_count() == 0)
    throw InputError(path.string(), "liver", "there is no surface of that name",
                     "Name the liver's surface liver.vtk, .vtp, .stl, .obj or .ply");
  // Tumours before cysts: their numbers do not change when cysts are added.
  std::stable_sort(lesion_files.begin(), lesion_files.end(), [](const fs::path& a, const fs::path& b) {
    const auto cyst = [](const fs::path& p) { return p.stem().string().find("cyst") != std::string::npos; };
    return cyst(a) < cyst(b);
  });
  for (const fs::path& file : lesion_files) add_lesions(read_triangle_mesh(file, unit), set);
  return set;
}

}  // namespace glisson::model
