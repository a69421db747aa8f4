// SPDX-License-Identifier: GPL-3.0-or-later
#include "entries.h"

namespace glisson::fuzz {

const std::vector<Named>& all_entries() {
  static const std::vector<Named> all = {{"vtk_xml", vtk_xml},
                                         {"legacy_vtk", legacy_vtk},
                                         {"msh", msh},
                                         {"ply", ply},
                                         {"stl", stl},
                                         {"obj", obj},
                                         {"node_list", node_list},
                                         {"nifti_header", nifti_header},
                                         {"nrrd_header", nrrd_header},
                                         {"meta_header", meta_header},
                                         {"archive", archive},
                                         {"zip_archive", zip_archive},
                                         {"onnx_input", onnx_input},
                                         {"label_sheet", label_sheet},
                                         {"mask_sheet", mask_sheet},
                                         {"messages", messages},
                                         {"picture_header", picture_header},
                                         {"cloud", cloud},
                                         {"label_codes", label_codes},
                                         {"seeds", seeds},
                                         {"edits", edits},
                                         {"tree_edits", tree_edits},
                                         {"regions", regions},
                                         {"source", source},
                                         {"calibration", calibration},
                                         {"load", load},
                                         {"overlay_record", overlay_record},
                                         {"corrections", corrections},
                                         {"start", start},
                                         {"surface_list", surface_list},
                                         {"atlas_sheet", atlas_sheet},
                                         {"picture", picture},
                                         {"video", video},
                                         {"landmarks", landmarks},
                                         {"vessels", vessels},
                                         {"moment", moment},
                                         {"case_json", case_json}};
  return all;
}

}  // namespace glisson::fuzz
