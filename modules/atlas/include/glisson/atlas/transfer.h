// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "glisson/atlas/atlas.h"
#include "glisson/atlas/correspond.h"
#include "glisson/patient/patient_model.h"

namespace glisson::atlas {

/// Where a proposal comes from.
enum class Source {
  statistics,  ///< the atlas alone
  image,       ///< this patient's own image
  both,        ///< the atlas, moved by what the image shows
  person       ///< somebody placed it
};
/// "statistics", "image", "both", "person".
const char* source_code(Source source);

/// What a person made of a proposal.
enum class Decision { proposed, accepted, moved, not_visible };
/// "proposed", "accepted", "moved", "not_visible".
const char* decision_code(Decision decision);

/// A structure where it should lie on the patient's liver. CT frame, metres.
struct Proposal {
  Structure structure = Structure::umbilical_notch;
  PointsIn<CtFrame> points;                  ///< K x 3, ordered
  std::vector<Eigen::Matrix3d> covariances;  ///< one a point, m2; 95 % within kEllipsoid95
  std::vector<Source> sources;               ///< one a point
  PointsIn<CtFrame> area;                    ///< areas: points of the contact; else none
  int members = 0;                           ///< livers behind the statistics
  std::string origin;                        ///< of the statistics: an atlas' name
  Decision decision = Decision::proposed;

  /// Root of the mean over points of the covariances' traces, metres.
  double deviation() const;
  /// statistics, image or both; of most of its points.
  Source source() const;
};

/// An atlas laid on a patient's liver, and what it proposes there. CT frame.
struct Transfer {
  std::string atlas;                               ///< its name
  PointsIn<CtFrame> surface;                       ///< the atlas' mean on the patient's liver, metres
  double mean_distance = 0.0, max_distance = 0.0;  ///< metres, between it and the liver
  Eigen::VectorXd modes;                           ///< coefficients over their deviations
  double unusual = 0.0;                            ///< over what is usual: above 1 the ellipsoids grow by it
  std::vector<std::string> doubts;                 ///< "atlas.unusual_shape 1.6", ...: codes with values
  std::vector<Proposal> proposals;
};

/// What the patient's own image shows of the structures; absent: it does not.
struct Evidence {
  std::map<Structure, PointsIn<CtFrame>> found;  ///< as in Member
  PointsIn<CtFrame> ridge;  ///< the known part of the anterior margin, ordered; may be empty
  /// What a person has placed: it beats what was found. Of a contact fewer than three points say nothing.
  std::map<Structure, PointsIn<CtFrame>> placed = {};
  std::vector<VesselTree> portal_vein = {};  ///< its trees; none: nothing is known of its branches
};
/// Of a model: contacts, the portal vein's entrance and its trees, and the detected ridge.
Evidence evidence_of(const PatientModel& model);

/// Puts the atlas on a patient's liver (README: "Transfer"). Empty: cancelled.
/// @throws InputError no liver, implausible size, a liver that is plainly mirrored
///   (of real ones nearly all are recognised; README: "Correspondence").
Cancellable<Transfer> transfer(const Atlas& atlas, const TriangleMesh& liver, const Evidence& evidence,
                               const RunContext& context);

}  // namespace glisson::atlas
