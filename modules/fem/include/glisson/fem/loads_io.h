// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glisson/fem/composite_model.h"
#include "glisson/fem/integrator.h"

/// @file
/// Load files: what `glisson simulate --load` reads. One JSON object; every key is optional, but one of
/// gravity, pressure, forces, springs and moved must be there. Lengths in files are millimetres, in the
/// mesh's frame (LPS); everything here is metres.
///
///     {
///       "gravity":  {"from": "supine", "to": "left_flank"},
///       "pressure": {"pascal": 1600, "region": {"normal": [0, -1, 0], "angle_deg": 60}},
///       "forces":   [{"point_mm": [10, -42, 130], "newton": [0, -0.5, 0]}],
///       "springs":  [{"node": 17, "newton_per_metre": 50, "target_mm": [12, -40, 131]},
///                    {"region": {"centre_mm": [0, 30, 90], "radius_mm": 20},
///                     "structure": {"pascal": 20e6, "area_mm2": 0.2, "length_mm": 30}}],
///       "fixed":    {"nodes": [0, 5], "region": {"centre_mm": [0, 30, 90], "radius_mm": 15}},
///       "moved":    [{"region": {"centre_mm": [80, 0, 60], "radius_mm": 10}, "by_mm": [0, -10, 0]}],
///       "ramp_s":   0.5
///     }
///
/// - gravity: "change" (m/s2, three numbers: new less old), or "from" and "to", each a vector in m/s2 or a
///   posture: supine, prone, left_flank, right_flank (the side that is down), standing, none. "from" is
///   supine when left out: the CT is an equilibrium in that posture, so only the difference loads the model.
/// - pressure: pascals along the inward normal, following the surface; on "triangles" (indices of the
///   boundary surface) or a "region", else everywhere.
/// - forces: newtons at a "node" or at the mesh's point closest to "point_mm"; the direction does not turn.
/// - springs: at a "node", a "point_mm" or all surface nodes of a "region" (which share the stiffness by
///   area), towards "target_mm" (a node or point) or where they are at rest. Stiffness "newton_per_metre" or
///   a "structure" that pulls along its length, k = E A / L.
/// - fixed: "nodes" and all nodes of a "region".
/// - moved: "nodes" and all nodes of a "region" that are held like fixed ones, but displaced "by_mm".
/// - region: a ball ("centre_mm", "radius_mm"), a box ("low_mm", "high_mm"), for pressure also a direction
///   ("normal", "angle_deg" up to 180: triangles whose outward normal is so near). Given together, all hold.
/// - ramp_s: the load grows linearly over this time (0: at once). Springs' targets and moved nodes go from
///   the rest position to their place meanwhile. Static solves ignore it.
/// - comment: anything, for people.

namespace glisson::fem {

/// A part of the mesh. Unset parts do not restrict.
struct LoadRegion {
  std::optional<Eigen::Vector3d> centre;     ///< m, with radius
  double radius = 0.0;                       ///< m
  std::optional<Eigen::Vector3d> low, high;  ///< m
  std::optional<Eigen::Vector3d> normal;     ///< unit
  double angle = 0.0;                        ///< radians
};

/// Where something is attached: exactly one is set.
struct LoadPlace {
  std::optional<int> node;
  std::optional<Eigen::Vector3d> point;  ///< m; bound to the closest tetrahedron
  std::optional<LoadRegion> region;
};

/// A spring from a place of the model to a place in space, which does not move with the model. Its rest
/// length is zero: it pulls with stiffness times distance.
struct LoadSpring {
  LoadPlace place;
  double stiffness = 0.0;                 ///< N/m, in all; a region's nodes share it by area
  std::optional<Eigen::Vector3d> target;  ///< m; unset: the rest position
};
/// A force whose direction stays fixed in the mesh's frame. A region's nodes share it by area.
struct LoadForce {
  LoadPlace place;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< N, in all
};

/// Nodes that are held at their rest position plus `by`. A region means all its nodes, inner ones too.
struct LoadMove {
  std::vector<int> nodes;
  std::optional<LoadRegion> region;
  Eigen::Vector3d by = Eigen::Vector3d::Zero();  ///< m
};

/// A load file's content, not yet tied to a mesh.
struct LoadCase {
  Eigen::Vector3d gravity_change = Eigen::Vector3d::Zero();  ///< m/s2
  double pressure = 0.0;                                     ///< Pa
  std::vector<int> pressure_triangles;
  std::optional<LoadRegion> pressure_region;
  std::vector<LoadForce> forces;
  std::vector<LoadSpring> springs;
  std::vector<int> fixed_nodes;
  std::optional<LoadRegion> fixed_region;
  std::vector<LoadMove> moved;
  double ramp = 0.0;  ///< s
};

/// Gravity in a named posture, m/s2, in LPS. @throws InputError for an unknown name.
Eigen::Vector3d gravity_in_posture(const std::string& posture);

/// @throws FileError when the file is missing; InputError naming the key, for anything that is malformed,
/// unknown (a misspelt key is not ignored) or not finite.
LoadCase read_load_case(const std::filesystem::path& path);
/// The same of a file's text. @param name stands in messages.
LoadCase parse_load_case(const std::string& json, const std::string& name);

/// A load case tied to one model.
class AppliedLoad {
 public:
  /// @throws InputError for nodes or triangles that the mesh does not have, and regions that are empty.
  AppliedLoad(const LoadCase& load, const CompositeModel& model);

  /// Fixed and moved ones.
  const std::vector<int>& fixed_nodes() const { return fixed_nodes_; }
  /// Where a static solve starts: at rest, but for the moved nodes.
  Points start(const CompositeModel& model) const;
  /// The loads at node positions x and a time; springs pull from where x has their points.
  Loads at(const Points& x, double time) const;
  /// The whole load, as a static solve wants it.
  Loads at(const Points& x) const;
  /// Whether a static solve has something to hold on to.
  bool holds() const;

 private:
  struct Anchor {
    std::array<int, 4> nodes{-1, -1, -1, -1};
    std::array<double, 4> weights{};
    double stiffness = 0.0;
    Eigen::Vector3d rest = Eigen::Vector3d::Zero(), target = Eigen::Vector3d::Zero();  ///< of a spring
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
  };
  Loads scaled(const Points& x, double fraction) const;
  std::vector<std::pair<Anchor, double>> places(const LoadPlace& place, const CompositeModel& model,
                                                const std::string& field) const;
  void hold(const LoadCase& load, const CompositeModel& model);

  Loads base_;
  std::vector<Anchor> anchors_;
  std::vector<int> fixed_nodes_;
  struct Moved {
    int node;
    Eigen::Vector3d rest, by;
  };
  std::vector<Moved> moved_;
  double ramp_ = 0.0;
};

}  // namespace glisson::fem
