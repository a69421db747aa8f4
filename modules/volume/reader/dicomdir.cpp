// SPDX-License-Identifier: GPL-3.0-or-later
#include "dicomdir.h"

#include <gdcmReader.h>
#include <gdcmSequenceOfItems.h>

#include <algorithm>
#include <set>

#include "dicom_objects.h"

namespace glisson::reader {
namespace {

/// "DICOM\\ST000\\IM000" -> "DICOM/ST000/IM000"; empty: it names no file below the folder.
std::string path_of(const std::string& id) {
  std::string path, part;
  const auto take = [&] {
    while (!part.empty() && part.front() == ' ') part.erase(part.begin());
    while (!part.empty() && part.back() == ' ') part.pop_back();
    const bool good = !part.empty() && part != "." && part != ".." && part.find('/') == std::string::npos &&
                      std::none_of(part.begin(), part.end(), [](char c) { return c < 0x20 || c > 0x7e; });
    path += (path.empty() ? "" : "/") + part;
    part.clear();
    return good;
  };
  for (const char letter : id) {
    if (letter != '\\')
      part += letter;
    else if (!take())
      return {};
  }
  return take() ? path : std::string();
}

}  // namespace

std::vector<std::string> files_of_dicomdir(const Request& request) {
  const gdcm::Tag records(0x0004, 0x1220), file_id(0x0004, 0x1500);
  gdcm::Reader reader;
  reader.SetFileName(request.path.c_str());
  if (!reader.CanRead() || !reader.Read() || !reader.GetFile().GetDataSet().FindDataElement(records))
    refuse(request, "", "is named as a DICOM directory, but is none or is damaged",
           "Name the folder that holds the series");
  std::vector<std::string> files;
  std::set<std::string> known;
  const auto sequence = reader.GetFile().GetDataSet().GetDataElement(records).GetValueAsSQ();
  for (gdcm::SequenceOfItems::SizeType n = 1; sequence != nullptr && n <= sequence->GetNumberOfItems(); ++n) {
    const std::string path = path_of(text_of(sequence->GetItem(n).GetNestedDataSet(), file_id));
    if (!path.empty() && known.insert(path).second) files.push_back(path);
  }
  return files;
}

}  // namespace glisson::reader
