// SPDX-License-Identifier: GPL-3.0-or-later
#include "case_files.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "case_manifest.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/json_file.h"
#include "glisson/core/patient_range.h"
#include "glisson/engine/case_io.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/vtk_xml_file.h"
#include "glisson/patient/label_map.h"

namespace glisson::engine {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

constexpr double kMillimetre = 1e-3;

vtkNew<vtkIntArray> int_array(const char* name) {
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  return array;
}

vtkNew<vtkPolyData> vessels_to_vtk(const std::vector<VesselTree>& trees) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("radius_mm");
  auto tree_of_point = int_array("tree"), structures = int_array("structures"), roots = int_array("roots");
  for (std::size_t i = 0; i < trees.size(); ++i) {
    const VesselTree& tree = trees[i];
    const vtkIdType first = points->GetNumberOfPoints();
    for (Eigen::Index k = 0; k < tree.nodes.rows(); ++k) {
      const Eigen::Vector3d p = tree.nodes.row(k).transpose() / kMillimetre;
      points->InsertNextPoint(p.data());
      radii->InsertNextValue(tree.radii[static_cast<std::size_t>(k)] / kMillimetre);
      tree_of_point->InsertNextValue(static_cast<int>(i));
    }
    for (const auto& beam : tree.beams) {
      const vtkIdType ends[2] = {first + beam[0], first + beam[1]};
      lines->InsertNextCell(2, ends);
    }
    structures->InsertNextValue(tree.structure);
    roots->InsertNextValue(tree.root);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  data->GetPointData()->AddArray(radii);
  data->GetPointData()->AddArray(tree_of_point);
  data->GetFieldData()->AddArray(structures);
  data->GetFieldData()->AddArray(roots);
  return data;
}

}  // namespace

void write_vessels(const fs::path& path, const std::vector<VesselTree>& trees) {
  // In memory first: VTK's XML writers crash on a disk that fills up.
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(vessels_to_vtk(trees));
  writer->SetWriteToOutputString(true);
  writer->Write();
  write_file_atomically(path, writer->GetOutputString());
}

namespace {

/// A column of numbers in one of the file's tables. @throws InputError it is missing or of another width.
Eigen::VectorXd column(const fs::path& path, const NamedArrays& arrays, const char* name) {
  const auto found = arrays.find(name);
  if (found == arrays.end() || found->second.cols() != 1)
    throw InputError(path.string(), name, "is missing, or has several columns", "Build the model anew");
  return found->second.col(0);
}

}  // namespace

std::vector<VesselTree> read_vessels(const fs::path& path) {
  const VtkXmlFile file = read_vtk_xml(path);
  const Eigen::VectorXd structures = column(path, file.field_data, "structures"),
                        roots = column(path, file.field_data, "roots");
  if (roots.size() != structures.size())
    throw InputError(path.string(), "roots", "are not as many as the trees", "Build the model anew");
  const Eigen::Index count = file.points.rows();
  const Eigen::VectorXd none;
  const Eigen::VectorXd radii = count > 0 ? column(path, file.point_data, "radius_mm") : none,
                        tree_of_point = count > 0 ? column(path, file.point_data, "tree") : none;
  if (!file.points.allFinite() || !radii.allFinite())
    throw InputError(path.string(), "points", "hold a number that is not finite", "Build the model anew");
  std::vector<VesselTree> trees(static_cast<std::size_t>(structures.size()));
  for (std::size_t i = 0; i < trees.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    if (!(structures[k] >= 0.0 && structures[k] <= 65535.0) ||
        !(roots[k] >= -1.0 && roots[k] <= static_cast<double>(count)))
      throw InputError(path.string(), "structures, roots", "hold what is no label or no node",
                       "Build the model anew");
    trees[i].structure = static_cast<Label>(structures[k]);
    trees[i].root = static_cast<int>(roots[k]);
  }
  std::vector<int> local(static_cast<std::size_t>(count));
  std::vector<int> sizes(trees.size(), 0);
  const auto tree_at = [&](long point) {
    const double tree = tree_of_point[point];
    if (!(tree >= 0.0 && tree < static_cast<double>(trees.size())))
      throw InputError(path.string(), "tree", "names a tree that is not there", "Build the model anew");
    return static_cast<std::size_t>(tree);
  };
  for (Eigen::Index p = 0; p < count; ++p) {
    local[static_cast<std::size_t>(p)] = sizes[tree_at(p)]++;
    trees[tree_at(p)].radii.push_back(radii[p] * kMillimetre);
  }
  for (std::size_t i = 0; i < trees.size(); ++i) {
    if (trees[i].root >= std::max(1, sizes[i]))
      throw InputError(path.string(), "roots", "hold a node that is not there", "Build the model anew");
    trees[i].nodes.resize(sizes[i], 3);
  }
  for (Eigen::Index p = 0; p < count; ++p)
    trees[tree_at(p)].nodes.row(local[static_cast<std::size_t>(p)]) = kMillimetre * file.points.row(p);
  for (const std::vector<long>& ends : file.cells) {
    if (ends.size() != 2 || tree_at(ends[0]) != tree_at(ends[1]))
      throw InputError(path.string(), "lines", "a beam does not join two nodes of one tree",
                       "Build the model anew");
    trees[tree_at(ends[0])].beams.push_back(
        {local[static_cast<std::size_t>(ends[0])], local[static_cast<std::size_t>(ends[1])]});
  }
  return trees;
}

json points_to_json(const Points& points) {
  json array = json::array();
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    array.push_back({points(i, 0) / kMillimetre, points(i, 1) / kMillimetre, points(i, 2) / kMillimetre});
  return array;
}

Points points_from_json(const json& array, const std::string& file, const std::string& field) {
  const auto refuse = [&](const std::string& problem) {
    throw InputError(file, field, problem, "Write it as a list of [x, y, z] in millimetres (LPS)");
  };
  if (!array.is_array()) refuse("is not a list");
  Points points(static_cast<Eigen::Index>(array.size()), 3);
  for (std::size_t i = 0; i < array.size(); ++i) {
    const json& triple = array[i];
    if (!triple.is_array() || triple.size() != 3) refuse("entry " + std::to_string(i) + " is not a triple");
    for (std::size_t k = 0; k < 3; ++k) {
      if (!triple[k].is_number())
        refuse("entry " + std::to_string(i) + " holds something that is not a number");
      if (!(kMillimetre * std::abs(triple[k].get<double>()) <= kPatientRange))
        refuse("entry " + std::to_string(i) + " is nowhere near a patient");
      points(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
          triple[k].get<double>() * kMillimetre;
    }
  }
  return points;
}

bool same_points(const Points& a, const Points& b) {
  constexpr double kMicrometre = 1e-6;
  return a.rows() == b.rows() && (a.rows() == 0 || (a - b).cwiseAbs().maxCoeff() < kMicrometre);
}

namespace {

double deviation_in(const json& value, const std::string& file, const char* field) {
  if (!value.is_number() || !(value.get<double>() >= 0.0) || !std::isfinite(value.get<double>()))
    throw InputError(file, field, "is no deviation", "Give millimetres from 0, or leave the field out");
  return 1e-3 * value.get<double>();
}

/// Files of before have none: all was a person's.
void take_deviations(const json& document, const std::string& file, Landmarks& landmarks) {
  if (document.contains("umbilical_notch_deviation_mm"))
    landmarks.notch_deviation =
        deviation_in(document["umbilical_notch_deviation_mm"], file, "umbilical_notch_deviation_mm");
  if (!document.contains("anterior_margin_deviation_mm")) return;
  const json& list = document["anterior_margin_deviation_mm"];
  if (!list.is_array() || static_cast<Eigen::Index>(list.size()) != landmarks.anterior_margin.rows())
    throw InputError(file, "anterior_margin_deviation_mm", "are not as many as points",
                     "Give one a point of the margin, or leave the field out");
  landmarks.margin_deviation.resize(static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i)
    landmarks.margin_deviation[static_cast<Eigen::Index>(i)] =
        deviation_in(list[i], file, "anterior_margin_deviation_mm");
}

}  // namespace

Landmarks read_landmarks(const fs::path& path) {
  const json document = read_json(path);
  const std::string file = path.string();
  if (!document.is_object())
    throw InputError(file, "", "is not a JSON object", "Give anterior_margin, umbilical_notch or vena_cava");
  const auto other = [&](const char* key, const char* than) {
    return document.contains(key) && document[key] != than;
  };
  if (other("frame", "LPS") || other("unit", "mm"))
    throw InputError(file, "frame, unit", "landmarks are read in LPS millimetres only",
                     "Convert them, or correct the two fields");
  Landmarks landmarks;
  const auto take = [&](const char* field, Points& into) {
    if (document.contains(field)) into = points_from_json(document[field], file, field);
  };
  take("anterior_margin", landmarks.anterior_margin);
  take("umbilical_notch", landmarks.umbilical_notch);
  take("vena_cava", landmarks.vena_cava);
  take_deviations(document, file, landmarks);
  if (landmarks.empty() && landmarks.vena_cava.rows() == 0)
    throw InputError(file, "", "holds no landmark", "Give anterior_margin, umbilical_notch or vena_cava");
  return landmarks;
}

void write_landmarks(const fs::path& path, const Landmarks& landmarks) {
  json document = {{"frame", "LPS"}, {"unit", "mm"}};
  if (landmarks.anterior_margin.rows() > 0)
    document["anterior_margin"] = points_to_json(landmarks.anterior_margin);
  if (landmarks.umbilical_notch.rows() > 0)
    document["umbilical_notch"] = points_to_json(landmarks.umbilical_notch);
  if (landmarks.margin_deviation.size() > 0) {
    json list = json::array();
    for (const double deviation : landmarks.margin_deviation) list.push_back(1e3 * deviation);
    document["anterior_margin_deviation_mm"] = list;
  }
  if (landmarks.notch_deviation > 0.0)
    document["umbilical_notch_deviation_mm"] = 1e3 * landmarks.notch_deviation;
  if (landmarks.vena_cava.rows() > 0) document["vena_cava"] = points_to_json(landmarks.vena_cava);
  write_json(path, document);
}

bool or_lost(const CaseFolder& folder, const char* code, const std::function<void()>& read) {
  try {
    try {
      read();
      return true;
    } catch (const json::exception& failure) {
      throw InputError((folder.path / kCaseFile).string(), code,
                       std::string("is malformed (") + failure.what() + ")", "Restore the case from a copy");
    }
  } catch (const Error& failure) {
    if (folder.lost == nullptr) throw;
    folder.lost->push_back(std::string(code) + ' ' + failure.what());
    return false;
  }
}

}  // namespace glisson::engine
