// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/atlas/transfer.h"
#include "glisson/engine/case_state.h"

namespace glisson::engine {

namespace part {
/// Where the atlas says that the structures lie on this patient's liver, and what a person made of it. The
/// accepted ones are landmarks; nothing else is ever used of it.
extern const PartOf<atlas::Transfer> proposals;
}  // namespace part

/// Null: nothing is proposed for it.
const atlas::Proposal* proposal_of(const CaseState& state, atlas::Structure structure);
/// What a person has placed or accepted of a structure on this model, CT frame, metres; none: nothing, or of
/// a former model.
PointsIn<CtFrame> placed_points(const CaseState& state, atlas::Structure structure);
/// How far these may lie from where they are, as Landmarks has it, metres: one each of the margin, one of the
/// notch; none: not known of the structure, or nothing is placed.
Eigen::VectorXd placed_deviations(const CaseState& state, atlas::Structure structure);
/// How far the review of the landmarks that registration knows (notch, margin, vena cava) has come.
struct LandmarkReview {
  bool is_open = false;          ///< of one nobody has said whether it lies there
  bool from_statistics = false;  ///< of one that is used no image shows some points, and nobody placed them
};
LandmarkReview landmark_review(const CaseState& state);
/// The notes of a registration about its landmarks: "atlas.cava_from_statistics 9.1" (mm) when the vena cava
/// that it holds on to comes from statistics alone, "atlas.margin_from_statistics 12" (%) of the margin that
/// it uses, "landmarks.no_vena_cava" when there is none, "landmarks.not_reviewed umbilical_notch" when it is
/// proposed and nobody has said anything.
std::vector<std::string> landmark_notes(const CaseState& state);

}  // namespace glisson::engine
