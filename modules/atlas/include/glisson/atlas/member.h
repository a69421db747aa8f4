// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "glisson/atlas/shape_model.h"
#include "glisson/atlas/structure.h"
#include "glisson/patient/patient_model.h"

namespace glisson::atlas {

/// A liver as it is given: its surface and what is known on it. CT frame, metres.
struct Member {
  std::string name;
  TriangleMesh liver;
  /// Lines in order, single points, and what touches (vena_cava, gallbladder_bed) as points of the contact in
  /// any order. What is absent is unknown.
  std::map<Structure, PointsIn<CtFrame>> structures;
};

/// What a patient's model shows: the liver's fine surface; where the vena cava, the gallbladder and the
/// portal vein touch it; and of `placed`, which a person placed or accepted, notch and margin. A margin that
/// was only detected is no truth of its whole course and stays out.
/// @throws InputError the model has no liver surface.
Member member_of(const std::string& name, const PatientModel& model, const Landmarks& placed);

/// Whether a structure is an area: known by all its points of contact.
bool is_area(Structure structure);

/// The vertices of a liver that touch another surface (within `reach`, metres).
Points contact(const TriangleMesh& liver, const TriangleMesh& other, double reach = 0.003);

/// A liver as one closed piece.
struct PreparedLiver {
  TriangleMesh mesh;                ///< the largest piece
  std::vector<std::string> doubts;  ///< "atlas.open_surface", "atlas.several_pieces 3"
  /// Share of the surface that it lacks: other pieces, and holes, each as large as a disc with a rim as long
  /// as all of theirs.
  double lacking = 0.0;
};
/// Leaves out what does not hang together with the largest piece; says what is doubtful.
/// @throws InputError nothing there, or of no plausible size.
PreparedLiver prepare(const TriangleMesh& liver, const std::string& name);

/// The ordered points of a structure, the same number on every liver (point_count()); areas give their
/// middle line. Empty: too little is known.
/// @param raw as in Member. @param upright turns the liver's frame into the atlas' (axes to the patient's
/// left, back and head). @param notch anchors the margin; without it there is no margin.
Points ordered_points(Structure structure, const Points& raw, const Eigen::Matrix3d& upright,
                      const Points& notch);

/// Points at even distances along a line, ends included. @pre two rows, count >= 2
Points resampled(const Points& line, int count);

/// A place on a template's surface, wherever its vertices lie.
struct Place {
  int triangle = -1;
  Eigen::Vector3d barycentric = Eigen::Vector3d::Zero();
  double height = 0.0;  ///< along the triangle's normal, in units of the template's size
};
using Places = std::vector<Place>;
/// Where points lie on a surface. @param size of the surface, metres
Places places_of(const TriangleMesh& surface, const Points& points, double size);
/// The same places on other vertices.
Points points_at(const Places& places, const TriangleMesh& surface, double size);

}  // namespace glisson::atlas
