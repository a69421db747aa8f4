// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glisson/core/json_file.h"

namespace glisson::experiments {

/// One table of a report: the figures whose names begin with a prefix or are listed.
struct ReportTable {
  std::string title, remark;
  std::vector<std::pair<std::string, std::string>> rows;  ///< figure key, what it is for people
  /// Of a table of words: a head a column, and its lines. Without lines it is left out.
  std::vector<std::string> heads = {};
  std::vector<std::vector<std::string>> lines = {};
};
struct ReportPicture {
  std::string file, caption;  ///< file: relative to the report
};

/// A self-contained HTML page with pictures beside it. Figures that are not there are left out; values get
/// the unit that their key's ending names. Atomic.
void write_report(const std::filesystem::path& path, const std::string& title,
                  const std::string& introduction, const std::vector<ReportTable>& tables,
                  const std::vector<ReportPicture>& pictures, const Figures& figures,
                  const std::vector<std::string>& notes);

}  // namespace glisson::experiments
