// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "anatomy.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/json_file.h"
#include "glisson/core/note_value.h"
#include "glisson/geometry/liver_size.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/topology.h"
#include "glisson/model/build.h"

namespace glisson::model {
namespace fs = std::filesystem;
namespace {

constexpr double kLeastLesion = 15e-9;  // m3: below, a piece of a tumour file is a crumb
// Of a structure's size over the liver's: beyond, it is in another unit.
constexpr double kMostOverLiver = 4.0, kLeastOverLiver = 0.005;
constexpr double kBesideLiver = 0.05;  // metres: farther from the liver's box it is in another frame
constexpr double kMidline = 0.001;     // metres: what lies in the liver's middle tells no side
constexpr std::array<const char*, 5> kExtensions = {".vtk", ".vtp", ".stl", ".obj", ".ply"};  // by preference

enum class Role { liver, vessel, lesions, other };
struct Meaning {
  Role role = Role::other;
  Label structure = 0;  ///< of lesions: 0 where the name tells no number
};

/// A file's stem or a key as it is compared: "Portal Vein" is portal_vein.
std::string plain(std::string name) {
  name = lower_case(std::move(name));
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '-' || c == ' '; }, '_');
  return name;
}

std::optional<Meaning> meaning_of(const std::string& name) {
  const std::string stem = plain(name);
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
  // As they are written one by one.
  const auto named = structure_named(stem);
  if (named && is_lesion(*named)) return Meaning{Role::lesions, *named};
  const auto found = kMeanings.find(stem);
  if (found == kMeanings.end()) return {};
  return found->second;
}

/// One file a name: where a folder has several formats of it, the first of kExtensions. @throws InputError
/// two of one name and format: a vessel's beams would be there twice.
std::map<std::string, fs::path> files_in(const fs::path& folder, std::vector<std::string>& notes) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() &&
        std::find(kExtensions.begin(), kExtensions.end(), lower_extension(entry.path())) != kExtensions.end())
      files.push_back(entry.path());
  const auto order = [](const fs::path& path) {
    const auto rank = std::find(kExtensions.begin(), kExtensions.end(), lower_extension(path));
    return std::tuple(plain(path.stem().string()), rank - kExtensions.begin(), path.filename());
  };
  std::sort(files.begin(), files.end(),
            [&](const fs::path& a, const fs::path& b) { return order(a) < order(b); });
  std::map<std::string, fs::path> chosen;
  for (const fs::path& file : files) {
    const std::string stem = plain(file.stem().string()), name = file.filename().string();
    if (!meaning_of(stem)) {
      notes.push_back("surfaces.ignored " + note_value(name));
    } else if (const auto [taken, is_first] = chosen.emplace(stem, file); !is_first) {
      const std::string other = taken->second.filename().string();
      if (lower_extension(file) == lower_extension(taken->second))
        throw InputError(folder.string(), stem, "is named twice: " + other + " and " + name,
                         "Keep one of them");
      notes.push_back("surfaces.of_one_name " + note_value(name) + " " + note_value(other));
    }
  }
  return chosen;
}

/// The first lesion that no file names and no surface has.
Label free_lesion(const SurfaceSet& set, const std::set<Label>& named) {
  const std::vector<Label> free = free_labels(structure::kFirstLesion, [&](Label label) {
    const bool is_there = std::ranges::any_of(
        set.others, [label](const NamedSurface& other) { return other.structure == label; });
    return is_there || named.contains(label);
  });
  if (!free.empty()) return free.front();
  throw InputError("surfaces", "lesions", "there are more than 240", "Keep those that matter");
}

/// The largest piece is the lesion that the file is named after; all others get numbers that are free.
/// @param wanted of the largest piece; 0: the file tells none.
/// @return whether nothing was left out because it is open.
bool add_lesions(const TriangleMesh& file, Label wanted, const std::set<Label>& named, SurfaceSet& set) {
  int crumbs = 0;
  bool is_whole = true;
  for (const TriangleMesh& piece : split_components(merge_vertices(file, 0.0))) {
    const bool is_open = !is_closed(piece);
    if (std::abs(volume(piece)) < kLeastLesion || is_open) {
      ++crumbs;
      is_whole &= !is_open;
      continue;
    }
    const Label label = wanted != 0 ? std::exchange(wanted, Label{0}) : free_lesion(set, named);
    set.others.push_back({label, structure_name(label), piece});
  }
  if (crumbs > 0) set.notes.push_back("lesion.crumbs_dropped " + std::to_string(crumbs));
  return is_whole;
}

/// One file and what it holds.
struct Source {
  std::string name;  ///< as folder or list call it; files of one name are pieces of one structure
  fs::path file;
  Meaning meaning;
  LengthUnit unit;
};

[[noreturn]] void refuse(const fs::path& file, const std::string& field, const std::string& problem,
                         const std::string& remedy) {
  throw InputError(file.string(), field, problem, remedy);
}

/// The sum of all pieces, whichever way each is turned.
double enclosed(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const TriangleMesh& piece : split_components(mesh)) sum += std::abs(volume(piece));
  return sum;
}

/// None where the largest piece is open.
std::optional<double> closed_volume(const TriangleMesh& mesh) {
  const std::vector<TriangleMesh> pieces = split_components(mesh);
  if (pieces.empty() || !is_closed(pieces.front())) return {};
  return std::abs(volume(pieces.front()));
}

double diagonal(const TriangleMesh& mesh) {
  return (mesh.vertices.colwise().maxCoeff() - mesh.vertices.colwise().minCoeff()).norm();
}

/// Slicer writes into the file's first lines which way its axes run.
void require_lps(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::array<char, 512> head{};
  stream.read(head.data(), head.size());
  if (std::string_view(head.data(), head.size()).find("SPACE=RAS") != std::string_view::npos)
    refuse(file, "SPACE", "is RAS: x and y run the other way than in LPS",
           "Export all surfaces of one patient in one frame (LPS)");
}

TriangleMesh read_structure(const Source& source) {
  require_lps(source.file);
  TriangleMesh mesh = merge_vertices(read_triangle_mesh(source.file, source.unit), 0.0);
  if (mesh.triangle_count() == 0)
    refuse(source.file, "triangles", "there are none", "Export the surface anew");
  return mesh;
}

void require_closed(const fs::path& file, const TriangleMesh& liver) {
  const std::vector<TriangleMesh> pieces = split_components(liver);
  if (pieces.empty() || !is_closed(pieces.front()))
    refuse(file, "liver", "the surface is open: it has holes, or edges with more than two triangles",
           "Close it (fill its holes) in the program that made it");
}

/// A structure in a unit of its own, or one that was taken for the liver, shows in its size.
void require_plausible(const Source& source, const TriangleMesh& mesh, const TriangleMesh& liver,
                       const fs::path& liver_file) {
  const std::string what = source.meaning.role == Role::lesions ? std::string("lesions")
                                                                : structure_name(source.meaning.structure);
  const double ratio = diagonal(mesh) / diagonal(liver);
  if (ratio > kMostOverLiver || ratio < kLeastOverLiver)
    refuse(
        source.file, what,
        "is " + shown(1e3 * diagonal(mesh)) + " mm large, the liver " + shown(1e3 * diagonal(liver)) + " mm",
        "Give this file's own unit in the list of surfaces, or export it in the liver's");
  if (enclosed(mesh) > enclosed(liver))
    refuse(source.file, what,
           "holds more volume (" + shown(1e6 * enclosed(mesh)) + " ml) than the liver in " +
               liver_file.filename().string() + " (" + shown(1e6 * enclosed(liver)) + " ml)",
           "The two are probably swapped: name each file by what it shows");
  const auto low = [](const TriangleMesh& m) { return m.vertices.colwise().minCoeff().array().eval(); };
  const auto high = [](const TriangleMesh& m) { return m.vertices.colwise().maxCoeff().array().eval(); };
  if ((low(mesh) > high(liver) + kBesideLiver).any() || (high(mesh) < low(liver) - kBesideLiver).any())
    refuse(source.file, what, "lies elsewhere than the liver in " + liver_file.filename().string(),
           "Export all surfaces of one patient in one frame (LPS)");
}

/// As of labels: the vena cava runs near the midline, the bulk of the liver to the patient's right of it.
bool looks_mirrored(const SurfaceSet& set) {
  return std::ranges::any_of(set.others, [&set](const NamedSurface& other) {
    if (other.structure != structure::kVenaCava) return false;
    const auto x = other.mesh.vertices.col(0);  // the vessel may be open, so that it has no centroid
    return 0.5 * (x.minCoeff() + x.maxCoeff()) < centroid(set.liver).x() - kMidline;
  });
}

/// A vessel or an organ beside the liver; further pieces of one name are added to the first.
/// @throws InputError two names for one structure: it would stand in the model twice.
void add_other(const Source& source, TriangleMesh mesh, std::map<Label, Source>& first,
               const fs::path& origin, SurfaceSet& set) {
  const Label structure = source.meaning.structure;
  const auto [known, is_new] = first.emplace(structure, source);
  if (is_new) {
    set.others.push_back({structure, structure_name(structure), std::move(mesh)});
    return;
  }
  if (known->second.name != source.name)
    refuse(origin, structure_name(structure),
           "is named twice: " + known->second.file.filename().string() + " and " +
               source.file.filename().string(),
           "Keep one of them");
  TriangleMesh& all = std::ranges::find(set.others, structure, &NamedSurface::structure)->mesh;
  const int vertices = all.vertex_count(), triangles = all.triangle_count();
  all.vertices.conservativeResize(vertices + mesh.vertex_count(), 3);
  all.vertices.bottomRows(mesh.vertex_count()) = mesh.vertices;
  all.triangles.conservativeResize(triangles + mesh.triangle_count(), 3);
  all.triangles.bottomRows(mesh.triangle_count()) = (mesh.triangles.array() + vertices).matrix();
}

/// Lesions that files are named after. @throws InputError two of one.
std::set<Label> named_lesions(const std::vector<Source>& sources, const fs::path& origin) {
  std::set<Label> named;
  for (const Source& source : sources) {
    const Label lesion = source.meaning.role == Role::lesions ? source.meaning.structure : Label{0};
    if (lesion != 0 && !named.insert(lesion).second)
      refuse(origin, structure_name(lesion), "is named twice", "Keep one of them");
  }
  return named;
}

/// @throws InputError no liver, two livers, and what is wrong with a file.
SurfaceSet read_sources(std::vector<Source> sources, const fs::path& origin, std::vector<std::string> notes) {
  SurfaceSet set;
  set.notes = std::move(notes);
  fs::path liver_file;
  for (const Source& source : sources) {
    if (source.meaning.role != Role::liver) continue;
    if (!liver_file.empty())
      refuse(origin, "liver",
             "is named twice: " + liver_file.filename().string() + " and " + source.file.filename().string(),
             "Keep one of them");
    liver_file = source.file;
    set.liver = read_structure(source);
    check_liver_size(set.liver.vertices, source.unit, source.file.string(), closed_volume(set.liver));
    require_closed(source.file, set.liver);
  }
  if (liver_file.empty())
    refuse(origin, "liver", "there is no surface of that name",
           "Name the liver's surface liver.vtk, .vtp, .stl, .obj or .ply");
  // Tumours before cysts: their numbers do not change when cysts are added.
  std::stable_sort(sources.begin(), sources.end(), [](const Source& a, const Source& b) {
    const auto cyst = [](const Source& s) {
      return s.meaning.role == Role::lesions && s.file.stem().string().find("cyst") != std::string::npos;
    };
    return cyst(a) < cyst(b);
  });
  const std::set<Label> named = named_lesions(sources, origin);
  std::map<Label, Source> first;
  for (const Source& source : sources) {
    if (source.meaning.role == Role::liver) continue;
    TriangleMesh mesh = read_structure(source);
    require_plausible(source, mesh, set.liver, liver_file);
    if (source.meaning.role == Role::lesions) {
      const std::size_t before = set.others.size();
      const bool is_whole = add_lesions(mesh, source.meaning.structure, named, set);
      // One that is named, closed and too small does not hinder all others.
      const bool is_told = source.meaning.structure != 0 && is_whole;
      if (set.others.size() == before && !is_told)
        refuse(source.file, "lesions", "holds no closed surface of 15 mm3 or more",
               "Close the surfaces (fill their holes) in the program that made them");
    } else {
      add_other(source, std::move(mesh), first, origin, set);
    }
  }
  return set;
}

std::vector<Source> sources_in_list(const fs::path& path, LengthUnit unit) {
  const nlohmann::json document = read_json(path);
  const char* remedy =
      R"(Write {"unit": "mm", "structures": {"liver": "liver.stl", "portal_vein": {"file": "pv.ply", "unit": "m"}}})";
  const auto unit_of = [&](const nlohmann::json& entry, LengthUnit otherwise, const std::string& field) {
    if (!entry.contains("unit")) return otherwise;
    for (const LengthUnit known : kLengthUnits)
      if (entry["unit"] == unit_code(known)) return known;
    refuse(path, field, "is none of mm, cm, m", remedy);
  };
  if (!document.is_object() || !document.contains("structures") || !document["structures"].is_object())
    refuse(path, "structures", "there are none", remedy);
  const LengthUnit all = unit_of(document, unit, "unit");
  std::vector<Source> sources;
  for (const auto& item : document["structures"].items()) {
    const std::string& name = item.key();
    const nlohmann::json& entry = item.value();
    const std::optional<Meaning> meaning = meaning_of(name);
    if (!meaning) refuse(path, name, "is no structure that is known", remedy);
    const auto add = [&](const nlohmann::json& one) {
      const bool has_file =
          one.is_string() || (one.is_object() && one.contains("file") && one["file"].is_string());
      if (!has_file) refuse(path, name, "names no file", remedy);
      const fs::path file = (one.is_string() ? one : one["file"]).get<std::string>();
      sources.push_back({name, path.parent_path() / file, *meaning,
                         one.is_object() ? unit_of(one, all, name + ".unit") : all});
    };
    if (entry.is_array())
      for (const nlohmann::json& one : entry) add(one);
    else
      add(entry);
  }
  return sources;
}

SurfaceSet read_any(const fs::path& path, LengthUnit unit) {
  if (!fs::exists(path)) throw FileError(path.string() + ": does not exist. Check the path.");
  if (fs::is_directory(path)) {
    std::vector<std::string> notes;
    std::vector<Source> sources;
    for (const auto& [stem, file] : files_in(path, notes))
      sources.push_back({stem, file, *meaning_of(stem), unit});
    return read_sources(std::move(sources), path, std::move(notes));
  }
  if (lower_extension(path) == ".json") return read_sources(sources_in_list(path, unit), path, {});
  return read_sources({{"liver", path, {Role::liver, structure::kParenchyma}, unit}}, path, {});
}

}  // namespace

SurfaceSet read_surfaces(const fs::path& path, LengthUnit unit, LeftLiver left_liver) {
  SurfaceSet set = read_any(path, unit);
  if (!looks_mirrored(set)) return set;
  if (left_liver == LeftLiver::refused)
    refuse(path, "orientation",
           "the liver lies to the left of the vena cava: mirrored, in RAS, or the liver's right part was "
           "removed",
           "Export all surfaces of one patient in one frame (LPS); after a right hepatectomy import them "
           "with 'glisson model --left-liver'");
  if (left_liver == LeftLiver::taken) set.notes.emplace_back("liver.perhaps_mirrored");
  return set;
}

}  // namespace glisson::model
