// SPDX-License-Identifier: GPL-3.0-or-later
#include "transfer_file.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "case_files.h"
#include "glisson/core/error.h"
#include "glisson/core/json_file.h"

namespace glisson::engine {
namespace {
namespace fs = std::filesystem;
using atlas::CarriedDependence;
using atlas::Decision;
using atlas::Followed;
using atlas::Proposal;
using atlas::Source;
using atlas::Structure;
using atlas::Transfer;
using atlas::TransferBasis;
using nlohmann::json;

constexpr double kSquareMillimetre = 1e-6;

json sheets_of(const std::vector<Eigen::Matrix3d>& covariances) {
  json list = json::array();
  for (const Eigen::Matrix3d& c : covariances)
    list.push_back({c(0, 0) / kSquareMillimetre, c(0, 1) / kSquareMillimetre, c(0, 2) / kSquareMillimetre,
                    c(1, 1) / kSquareMillimetre, c(1, 2) / kSquareMillimetre, c(2, 2) / kSquareMillimetre});
  return list;
}

json sheet_of(const Proposal& one) {
  json sources = json::array(), follows = json::array();
  for (const Followed& other : one.follows)
    follows.push_back({{"on", atlas::structure_code(other.on)},
                       {"source", atlas::source_code(other.source)},
                       {"points", other.points}});
  for (const Source source : one.sources) sources.push_back(atlas::source_code(source));
  return {{"structure", atlas::structure_code(one.structure)},
          {"points", points_to_json(one.points)},
          {"covariances_mm2", sheets_of(one.covariances)},
          {"sources", sources},
          {"area", points_to_json(one.area)},
          {"members", one.members},
          {"origin", one.origin},
          {"decision", atlas::decision_code(one.decision)},
          {"follows", follows}};
}

/// Nine numbers, row after row.
json nine(const Eigen::Matrix3d& matrix) {
  json row = json::array();
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index j = 0; j < 3; ++j) row.push_back(matrix(i, j));
  return row;
}

json sheet_of(const CarriedDependence& one) {
  json gains = json::array();
  for (const Eigen::Matrix3d& gain : one.gains) gains.push_back(nine(gain));
  return {{"of", atlas::structure_code(one.of)},
          {"on", atlas::structure_code(one.on)},
          {"point", one.point},
          {"gains", gains},
          {"covariances_mm2", sheets_of(one.covariances)}};
}

json sheet_of(const TransferBasis& basis) {
  json foretold = json::array(), dependences = json::array();
  for (const Proposal& one : basis.foretold) foretold.push_back(sheet_of(one));
  for (const CarriedDependence& one : basis.dependences) dependences.push_back(sheet_of(one));
  return {{"foretold", foretold},
          {"dependences", dependences},
          {"upright", nine(basis.upright)},
          {"sides_known", basis.sides_known},
          {"doubts", basis.doubts}};
}

[[noreturn]] void refuse(const std::string& file, const std::string& field, const std::string& problem) {
  throw InputError(file, field, problem,
                   "Remove the file's entry from case.json and transfer the atlas again");
}

template <class Code, std::size_t N>
Code code_in(const char* (*code_of)(Code), const std::array<Code, N>& all, const json& text,
             const std::string& file, const char* field) {
  for (const Code one : all)
    if (text.is_string() && text.get<std::string>() == code_of(one)) return one;
  refuse(file, field, "is unknown");
}

Eigen::Matrix3d covariance_in(const json& row, const std::string& file) {
  if (!row.is_array() || row.size() != 6) refuse(file, "covariances_mm2", "needs six numbers a point");
  std::array<double, 6> c{};
  for (std::size_t i = 0; i < 6; ++i) {
    if (!row[i].is_number()) refuse(file, "covariances_mm2", "holds something else than numbers");
    c[i] = kSquareMillimetre * row[i].get<double>();
  }
  Eigen::Matrix3d matrix;
  matrix << c[0], c[1], c[2], c[1], c[3], c[4], c[2], c[4], c[5];
  if (!(matrix.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff() > 0.0))
    refuse(file, "covariances_mm2", "holds a matrix that is no covariance");
  return matrix;
}

Eigen::Matrix3d nine_in(const json& row, const std::string& file, const char* field) {
  if (!row.is_array() || row.size() != 9) refuse(file, field, "needs nine numbers a point");
  Eigen::Matrix3d matrix;
  for (std::size_t i = 0; i < 9; ++i) {
    if (!row[i].is_number()) refuse(file, field, "holds something else than numbers");
    matrix(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)) = row[i].get<double>();
  }
  return matrix;
}

constexpr std::array kSources = {Source::statistics, Source::image, Source::both, Source::person};

Structure structure_in(const json& text, const std::string& file, const char* field) {
  return code_in(atlas::structure_code, atlas::kStructures, text, file, field);
}

std::vector<Followed> follows_in(const json& list, const std::string& file) {
  std::vector<Followed> all;
  for (const json& one : list)
    all.push_back({structure_in(one.at("on"), file, "follows"),
                   code_in(atlas::source_code, kSources, one.at("source"), file, "follows"),
                   one.at("points").get<int>()});
  return all;
}

Proposal proposal_in(const json& sheet, const std::string& file) {
  constexpr std::array kDecisions = {Decision::proposed, Decision::accepted, Decision::moved,
                                     Decision::not_visible};
  Proposal one;
  one.structure = structure_in(sheet.at("structure"), file, "structure");
  one.points = points_from_json(sheet.at("points"), file, "points");
  for (const json& row : sheet.at("covariances_mm2")) one.covariances.push_back(covariance_in(row, file));
  for (const json& row : sheet.at("sources"))
    one.sources.push_back(code_in(atlas::source_code, kSources, row, file, "sources"));
  if (one.points.rows() != atlas::point_count(one.structure))
    refuse(file, "points", "are not as many as the structure has");
  const auto count = static_cast<std::size_t>(one.points.rows());
  if (one.covariances.size() != count || one.sources.size() != count)
    refuse(file, "points", "are not as many as covariances and sources");
  if (!sheet.at("area").empty()) one.area = points_from_json(sheet.at("area"), file, "area");
  // Atlases without shares have left contacts of nothing, which could never become a landmark.
  if (one.area.rows() == 0 && atlas::is_area(one.structure)) one.area = one.points;
  one.members = sheet.at("members").get<int>();
  one.origin = sheet.at("origin").get<std::string>();
  one.decision = code_in(atlas::decision_code, kDecisions, sheet.at("decision"), file, "decision");
  if (sheet.contains("follows")) one.follows = follows_in(sheet.at("follows"), file);  // older ones have none
  return one;
}

CarriedDependence dependence_in(const json& sheet, const std::string& file) {
  CarriedDependence one{structure_in(sheet.at("of"), file, "dependences"),
                        structure_in(sheet.at("on"), file, "dependences"),
                        sheet.at("point").get<int>(),
                        {},
                        {}};
  for (const json& row : sheet.at("gains")) one.gains.push_back(nine_in(row, file, "gains"));
  for (const json& row : sheet.at("covariances_mm2")) one.covariances.push_back(covariance_in(row, file));
  const auto count = static_cast<std::size_t>(atlas::point_count(one.of));
  if (one.gains.size() != count || one.covariances.size() != count || one.point < 0 ||
      one.point >= atlas::point_count(one.on))
    refuse(file, "dependences", "are not as many as the structure has");
  return one;
}

TransferBasis basis_in(const json& sheet, const std::string& file) {
  TransferBasis basis;
  for (const json& one : sheet.at("foretold")) basis.foretold.push_back(proposal_in(one, file));
  for (const json& one : sheet.at("dependences")) basis.dependences.push_back(dependence_in(one, file));
  basis.upright = nine_in(sheet.at("upright"), file, "upright");
  basis.sides_known = sheet.at("sides_known").get<bool>();
  basis.doubts = sheet.at("doubts").get<std::vector<std::string>>();
  return basis;
}

/// But for what millimetres in text round.
bool same_number(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b)); }

bool same_matrix(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return (a - b).norm() <= 1e-9 * a.norm();
}

bool same_proposal(const Proposal& a, const Proposal& b) {
  return a.structure == b.structure && a.decision == b.decision && a.sources == b.sources &&
         a.members == b.members && a.origin == b.origin && a.follows == b.follows &&
         same_points(a.points, b.points) && same_points(a.area, b.area) &&
         std::ranges::equal(a.covariances, b.covariances, same_matrix);
}

bool same_dependence(const CarriedDependence& a, const CarriedDependence& b) {
  return a.of == b.of && a.on == b.on && a.point == b.point &&
         std::ranges::equal(a.gains, b.gains, same_matrix) &&
         std::ranges::equal(a.covariances, b.covariances, same_matrix);
}

bool same_basis(const TransferBasis& a, const TransferBasis& b) {
  return a.sides_known == b.sides_known && a.doubts == b.doubts && same_matrix(a.upright, b.upright) &&
         std::ranges::equal(a.foretold, b.foretold, same_proposal) &&
         std::ranges::equal(a.dependences, b.dependences, same_dependence);
}

}  // namespace

void write_transfer(const fs::path& path, const Transfer& transfer) {
  json proposals = json::array();
  for (const Proposal& one : transfer.proposals) proposals.push_back(sheet_of(one));
  json modes = json::array();
  for (const double b : transfer.modes) modes.push_back(b);
  json document = {{"frame", "LPS"},
                   {"unit", "mm"},
                   {"atlas", transfer.atlas},
                   {"surface", points_to_json(transfer.surface)},
                   {"mean_distance_mm", 1e3 * transfer.mean_distance},
                   {"max_distance_mm", 1e3 * transfer.max_distance},
                   {"modes", modes},
                   {"unusual", transfer.unusual},
                   {"doubts", transfer.doubts},
                   {"proposals", proposals}};
  if (!transfer.basis.foretold.empty()) document["basis"] = sheet_of(transfer.basis);
  write_json(path, document);
}

Transfer read_transfer(const fs::path& path) {
  const json sheet = read_json(path);
  const std::string file = path.string();
  Transfer transfer;
  try {
    transfer.atlas = sheet.at("atlas").get<std::string>();
    transfer.surface = points_from_json(sheet.at("surface"), file, "surface");
    transfer.mean_distance = 1e-3 * sheet.at("mean_distance_mm").get<double>();
    transfer.max_distance = 1e-3 * sheet.at("max_distance_mm").get<double>();
    const auto modes = sheet.at("modes").get<std::vector<double>>();
    transfer.modes = Eigen::Map<const Eigen::VectorXd>(modes.data(), static_cast<Eigen::Index>(modes.size()));
    transfer.unusual = sheet.at("unusual").get<double>();
    transfer.doubts = sheet.at("doubts").get<std::vector<std::string>>();
    std::set<Structure> known;
    for (const json& one : sheet.at("proposals")) {
      transfer.proposals.push_back(proposal_in(one, file));
      if (!known.insert(transfer.proposals.back().structure).second)
        refuse(file, "proposals", "name a structure twice");
    }
    if (known.empty()) refuse(file, "proposals", "are none");
    if (sheet.contains("basis")) transfer.basis = basis_in(sheet.at("basis"), file);  // older ones have none
  } catch (const json::exception& error) {
    refuse(file, "", std::string("is malformed (") + error.what() + ")");
  }
  return transfer;
}

bool same_transfer(const Transfer& a, const Transfer& b) {
  return a.atlas == b.atlas && a.doubts == b.doubts && same_points(a.surface, b.surface) &&
         same_number(a.mean_distance, b.mean_distance) && same_number(a.max_distance, b.max_distance) &&
         same_number(a.unusual, b.unusual) &&
         std::equal(a.modes.begin(), a.modes.end(), b.modes.begin(), b.modes.end(), same_number) &&
         std::equal(a.proposals.begin(), a.proposals.end(), b.proposals.begin(), b.proposals.end(),
                    same_proposal) &&
         same_basis(a.basis, b.basis);
}

}  // namespace glisson::engine
