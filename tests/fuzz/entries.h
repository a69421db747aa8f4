// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// @file
/// What reads foreign bytes, one function a reader, for libFuzzer (target.cpp), for the corpus of found
/// faults (faults_test.cpp) and for the seeds (seeds.cpp). A function returns when the bytes were read or
/// refused by an Error with its remedy; anything else that is thrown, and what was read but cannot be, is a
/// fault.

namespace glisson::fuzz {

void vtk_xml(std::string_view bytes);     ///< .vtu, .vtp
void legacy_vtk(std::string_view bytes);  ///< .vtk
void msh(std::string_view bytes);
void ply(std::string_view bytes);
void stl(std::string_view bytes);
void obj(std::string_view bytes);
void node_list(std::string_view bytes);

void nifti_header(std::string_view bytes);
void nrrd_header(std::string_view bytes);
void meta_header(std::string_view bytes);
void archive(std::string_view bytes);
void zip_archive(std::string_view bytes);

void onnx_input(std::string_view bytes);   ///< what a network's file says of its input
void label_sheet(std::string_view bytes);  ///< its MODEL.json
void mask_sheet(std::string_view bytes);   ///< of a network for pictures

void messages(std::string_view bytes);        ///< what comes by OpenIGTLink
void picture_header(std::string_view bytes);  ///< what is read of a picture before it is decoded

void cloud(std::string_view bytes);
void label_codes(std::string_view bytes);
void seeds(std::string_view bytes);
void edits(std::string_view bytes);
void tree_edits(std::string_view bytes);
void regions(std::string_view bytes);
void source(std::string_view bytes);
void calibration(std::string_view bytes);

void load(std::string_view bytes);            ///< of a simulation
void overlay_record(std::string_view bytes);  ///< frames.jsonl
void corrections(std::string_view bytes);     ///< by hand, of a track
void start(std::string_view bytes);           ///< a matrix in which a registration begins
void surface_list(std::string_view bytes);
void atlas_sheet(std::string_view bytes);

void landmarks(std::string_view bytes);
void vessels(std::string_view bytes);
void moment(std::string_view bytes);  ///< its description in a case
void case_json(std::string_view bytes);

// Decoded by a program of its own, into which libFuzzer does not see: not among its targets.
void picture(std::string_view bytes);
void video(std::string_view bytes);  ///< its first frames

using Entry = void (*)(std::string_view);
struct Named {
  const char* name;
  Entry entry;
};
/// Every one of them.
const std::vector<Named>& all_entries();

/// Whole files to begin with, made by our own writers, a list for each entry's name.
std::vector<std::pair<std::string, std::string>> seed_files(const std::string& entry);

}  // namespace glisson::fuzz
