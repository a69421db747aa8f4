// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/core/units.h"
#include "glisson/patient/label_map.h"
#include "glisson/patient/patient_model.h"

namespace glisson::model {

/// What the mesh of a model should be like.
struct MeshOptions {
  int target_vertices = 550;  ///< the paper's size; met within 10 %
  /// Mean edge length (mm) away from lesions and vessels, met within 15 %; then target_vertices does not
  /// count. 0: as target_vertices ask for.
  double edge_mm = 0.0;
  double lesion_refinement = 1.0;  ///< edge length in lesions over that elsewhere, at most
  double vessel_refinement = 1.0;  ///< edge length in vessels and within 4 mm of them over that elsewhere
  /// @throws InputError naming the option.
  void validate() const;
};

/// How closely a mesh follows the organ that it was built of.
struct OrganFit {
  double volume_error = 0.0;  ///< (mesh - labels) / labels
  /// From the vertices of the mesh's surface to the fine surface: the paper's "mean Hausdorff distance".
  double vertices_to_fine_mean_mm = 0.0;
  double mesh_to_fine_mean_mm = 0.0, fine_to_mesh_mean_mm = 0.0, fine_to_mesh_max_mm = 0.0;
};

/// What a person reads before approving a mesh.
struct MeshQuality {
  int vertices = 0, tetrahedra = 0;
  double min_dihedral_deg = 0.0, max_dihedral_deg = 0.0;
  /// None: not known, the mesh came without the organ's labels or surfaces.
  std::optional<OrganFit> organ_fit;
};

/// What building a model says of itself.
struct ModelReport {
  MeshQuality quality;
  std::vector<std::string> notes;  ///< components dropped, vessel nodes outside, ...: codes with values
};
/// What a person changes in the vessel trees (see tree_edits.h).
struct TreeEdit {
  enum class Kind {
    set_root,  ///< the tree enters at the node nearest to `at`; its beams lead away from there
    prune,     ///< the branch nearest to `at` goes, from its fork on, with all that hangs on it (pruning_at)
    join       ///< the node nearest to `to`, of another tree, hangs on the node nearest to `at` by new beams
  };
  Kind kind = Kind::prune;
  Eigen::Vector3d at = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();  ///< CT frame, metres
  bool operator==(const TreeEdit&) const = default;
};

/// A model, how it was built, and what a person has changed in its trees since.
struct BuiltModel {
  PatientModel model;
  ModelReport report;
  /// What was changed in the trees since, and the trees before that; both empty when nothing was.
  std::vector<TreeEdit> tree_edits;
  std::vector<VesselTree> trees_as_built;
};

/// What a model is built of, and how finely.
struct ModelOptions {
  MeshOptions mesh;
  bool vessels = true;
  /// Beams in all trees together, about: spacing is chosen to meet it; where bends and forks ask for more
  /// than 1.15 times as many, the thinnest and of those the shortest side branches are pruned (and reported).
  /// Roots and what is 2 mm thick in radius or more stay, however many beams they take.
  int target_beams = 120;
  bool arteries = false;  ///< trees of arteries too
  /// Where trees enter, one point a tree if given (CT, metres); otherwise the thickest end near the hilum or
  /// the cava.
  PointsIn<CtFrame> portal_root, hepatic_root;
  /// @throws InputError naming the option.
  void validate() const;
};

/// Label map to model: CGAL tetrahedra with lesions as sub-domains, Lloyd, ODT, perturb, exude; fine surfaces
/// by marching cubes; Dijkstra skeletons, Bezier fits, 6-DoF nodes; anterior margin by ridge detection. The
/// same input and seed give the same bits. @param image of the labels, on their grid: its padding cuts a
/// liver as its sides do; null: it is not known. @throws InputError no liver, several large components.
Cancellable<BuiltModel> build_from_labels(const LabelMap& labels, const ModelOptions& options,
                                          const RunContext& context, const Image* image = nullptr);

/// Closed surfaces of one patient, CT frame, metres: `liver` required.
struct SurfaceSet {
  TriangleMesh liver;
  std::vector<NamedSurface> others;  ///< vessels, lesions, vena cava
  std::vector<std::string> notes;    ///< what was left out of the folder: codes with values
};
/// Reads surfaces (.vtk .vtp .stl .obj .ply): a folder of files named by structure (liver,
/// portal_vein, hepatic_veins, arteries, liver_tumours, liver_cysts, lesions, gallbladder, vena_cava); one
/// file, the liver's; or a list in JSON, {"unit": "mm", "structures": {"liver": "a.stl", "portal_vein":
/// {"file": "b.ply", "unit": "m"}, "lesions": ["c.stl", "d.stl"]}}, files relative to it. Each connected
/// component of a lesion file is a lesion of its own. Vessels may be open: their holes are closed for the
/// trees, and it is noted. @param unit where a list says none.
/// @throws FileError, InputError naming the file and the remedy: no liver or two, open surface, implausible
/// size (another unit), a structure larger than the liver (swapped), or away from it (another frame), a liver
/// left of the vena cava that is not to be taken so (LeftLiver::taken: it is noted).
SurfaceSet read_surfaces(const std::filesystem::path& path, LengthUnit unit,
                         LeftLiver left_liver = LeftLiver::refused);
Cancellable<BuiltModel> build_from_surfaces(const SurfaceSet& surfaces, const ModelOptions& options,
                                            const RunContext& context);

/// A mesh that somebody else made, as it is: node order and all; its surface is the organ's, without vessels
/// or lesions, its margin where the ridge is.
BuiltModel build_from_mesh(TetMesh mesh);

/// A closed surface, meshed (one sub-domain). Used by `register` on a bare surface and by the theatre.
Cancellable<TetMesh> mesh_surface(const TriangleMesh& surface, const MeshOptions& options,
                                  const RunContext& context);

/// The anterior margin as an ordered polyline (paper 2.2.1; thresholds from the mesh's own statistics). The
/// same under rigid motion. Empty when there is no ridge.
/// @param inferior_anterior the direction in which the margin is to be looked for; zero: any (the longest
/// ridge).
/// @param cut where the image ends inside the organ, frame of the surface; empty: nowhere. Its rim is sharp
/// and no margin: vertices as near to it as sharpness reaches (kSharpnessRadius) are left out, from the
/// thresholds too. Of a margin that it parts the longer part is found.
Points detect_anterior_margin(const TriangleMesh& surface, const Eigen::Vector3d& inferior_anterior,
                              const TriangleMesh& cut = {});

}  // namespace glisson::model
