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

/// Points of a proposal that lie where they do because of where another structure is known to lie.
struct Followed {
  Structure on = Structure::umbilical_notch;
  Source source = Source::person;  ///< how that one is known: by a person, the image, or both
  int points = 0;                  ///< how many follow it
  bool operator==(const Followed&) const = default;
};

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
  std::vector<Followed> follows;  ///< most points first; none: it stands by itself

  /// Root of the mean over points of the covariances' traces, metres.
  double deviation() const;
  /// statistics, image or both; of most of its points.
  Source source() const;
};

/// A Dependence carried to a patient's liver. CT frame, metres.
struct CarriedDependence {
  Structure of = Structure::umbilical_notch, on = Structure::umbilical_notch;
  int point = 0;                             ///< of `on`
  std::vector<Eigen::Matrix3d> gains;        ///< one a point of `of`
  std::vector<Eigen::Matrix3d> covariances;  ///< of these once that point is known exactly, m2
};

/// What an atlas says of a liver before anything else is known: proposals are made of it again whenever more
/// becomes known. Nothing in transfers of former editions.
struct TransferBasis {
  std::vector<Proposal> foretold;  ///< by statistics alone
  std::vector<CarriedDependence> dependences;
  Eigen::Matrix3d upright = Eigen::Matrix3d::Identity();  ///< CT's axes into the atlas'
  bool sides_known = false;                               ///< it is a whole liver, and left is left
  std::vector<std::string> doubts;                        ///< that no review settles
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
  TransferBasis basis;
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
/// The same without contacts and entrance: what propose_again() reads.
Evidence courses_of(const PatientModel& model);

/// Puts the atlas on a patient's liver (README: "Transfer"). Empty: cancelled.
/// @throws InputError no liver, implausible size, a liver that is plainly mirrored
///   (of real ones nearly all are recognised; README: "Correspondence").
Cancellable<Transfer> transfer(const Atlas& atlas, const TriangleMesh& liver, const Evidence& evidence,
                               const RunContext& context);

/// What the same atlas proposes on the same liver when more is known of it. @param bare transfer() without
/// any evidence.
Transfer told(const Transfer& bare, const TriangleMesh& liver, const Evidence& evidence);

/// Makes the proposals again that nobody has accepted or moved, and neither image nor person shows: they
/// follow the others as far as these tell where they lie (README: "What follows"); then come the image's
/// courses. The order in which those became known does not matter. A transfer without basis stays as it is.
/// @param evidence the ridge and the portal vein's trees; nothing else is read.
void propose_again(Transfer& transfer, const TriangleMesh& liver, const Evidence& evidence);

}  // namespace glisson::atlas
