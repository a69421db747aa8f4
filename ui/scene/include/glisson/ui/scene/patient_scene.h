// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "glisson/geometry/closest_point_tree.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/picture.h"
#include "glisson/ui/scene/drawable_model.h"
#include "glisson/ui/scene/slice_picture.h"

class vtkActor;
class vtkRenderer;

namespace glisson::scene {

/// A point that the operator placed, drawn as a small ball.
struct Marker {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();  ///< metres, the scene's frame
  Label structure = 0;                          ///< gives the colour
  double radius = 2.5e-3;                       ///< metres
  bool operator==(const Marker&) const = default;
};

/// From where the patient is looked at.
enum class ViewFrom { anterior, posterior, right, left, superior, inferior, camera };
/// What a view is to hold at first. `liver`: its surface, whatever hangs on it, as the vena cava does; all
/// where there is no model.
enum class InView { everything, liver };

/// Which side of the patient lies towards each edge of the view: "R", or "RA" for an oblique view.
struct ViewLetters {
  std::string left, right, top, bottom;
  bool operator==(const ViewLetters&) const = default;
};

/// The patient in three dimensions: surfaces, mesh, vessels, landmarks, cloud, slices and markers as VTK
/// actors in one renderer. The scene's frame is the CT's, or the camera's once set_nodes() was given nodes
/// there. Holds what was given to it until it is replaced. Not thread-safe.
class PatientScene {
 public:
  PatientScene();
  ~PatientScene();
  PatientScene(const PatientScene&) = delete;
  PatientScene& operator=(const PatientScene&) = delete;

  vtkRenderer& renderer() const;
  /// Of the structures and of the slices: what one points at (seen_point()).
  std::vector<vtkActor*> surface_actors() const;

  /// Replaces the model (null: none), at rest.
  void set_model(std::shared_ptr<const DrawableModel> model);
  /// The same, made drawable here: takes its time.
  void set_model(const PatientModel& model);
  /// Puts the model's nodes somewhere (empty: at rest). @pre one row a node.
  void set_nodes(const Points& nodes);
  /// The same for a load on the organ in its place (CT frame): neighbours, and vessels that run on outside
  /// the mesh, follow near where they are attached and stay where they are further away.
  void set_loaded_nodes(const Points& nodes);
  int node_count() const;  ///< of the model; 0: there is none
  /// Replaces the model's own landmarks; CT frame, follow the nodes.
  void set_landmarks(const Landmarks& landmarks);
  /// In the scene's frame as it is. An empty cloud removes it.
  void set_cloud(const LabelledCloud& cloud);
  void set_markers(const std::vector<Marker>& markers);
  /// A line with a ball at either end: what pulls at the organ. Empty: none.
  struct Pull {
    Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();
  };
  void set_pull(const std::optional<Pull>& pull);
  /// A slice as a textured plane; one a plane. An empty picture removes it.
  void set_slice(const SliceGeometry& geometry, const Picture& picture);

  void set_visible(Label structure, bool visible);
  bool is_visible(Label structure) const;  ///< unless it was told not to be
  void set_opacity(Label structure, double opacity);
  void set_mesh_visible(bool visible);
  void set_slices_visible(bool visible);
  /// The model's vessel trees as lines along their beams, a ball at each entrance; at rest.
  void set_skeleton_visible(bool visible);
  /// A surface that is to be seen through everything translucent, in a warning colour; empty: none. Scene's
  /// frame, metres.
  void set_highlight(const TriangleMesh& surface);

  /// `camera` looks along +z with y down (the laparoscope's own view).
  void look_from(ViewFrom from, InView what = InView::everything);
  /// The view has another size: the same is in it again, unless somebody has moved the viewer since
  /// look_from().
  void keep_in_view();
  /// @pre the scene is in the CT's frame.
  ViewLetters view_letters() const;
  /// The first point of the liver's surface under a place in the view, at the nodes where they are now.
  /// @param x, y in [0, 1] from the view's top left corner. @param aspect width over height.
  std::optional<Eigen::Vector3d> surface_point(double x, double y, double aspect) const;
  /// The same with the triangle of PatientModel::surface that was hit.
  std::optional<ClosestPoint> surface_hit(double x, double y, double aspect) const;
  /// The point under a place in the view that lies as deep in it as p does: on the plane through p that faces
  /// the viewer.
  Eigen::Vector3d point_beside(const Eigen::Vector3d& p, double x, double y, double aspect) const;
  /// Where a point appears, in the same coordinates. Empty behind the viewer.
  std::optional<Eigen::Vector2d> view_point(const Eigen::Vector3d& p, double aspect) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::scene
