// SPDX-License-Identifier: GPL-3.0-or-later
#include <unordered_map>

#include "glisson/core/error.h"
#include "mesh_bytes.h"
#include "mesh_io_formats.h"
#include "text_scanner.h"

namespace glisson::formats {
namespace {

/// Gmsh's element types (manual, "MSH file format"): dimension and corners of the ones that we may meet.
constexpr int kTetrahedron = 4;
bool is_other_volume(long type) {
  switch (type) {
    case 5:
    case 6:
    case 7:
    case 11:
    case 12:
    case 13:
    case 14:
    case 17:
    case 18:
    case 19:
    case 29:
    case 30:
    case 31:
      return true;
    default:
      return false;
  }
}

/// One file as it is parsed. Nodes are found by tag; tags may have holes.
class MshParser {
 public:
  MshParser(const std::string& content, std::string name) : scan_(content, name), name_(std::move(name)) {}

  TetFile parse() {
    std::string_view line;
    while (scan_.next_line(line)) {
      if (line == "$MeshFormat") read_format();
      if (line == "$Entities") read_entities();
      if (line == "$Nodes") read_nodes();
      if (line == "$Elements") read_elements();
    }
    if (version_ == 0.0)
      throw InputError(name_, "", "is not a gmsh mesh (no $MeshFormat)", "Choose another file");
    return result();
  }

 private:
  void read_format() {
    version_ = scan_.number();
    if (scan_.integer() != 0) scan_.fail("is a binary gmsh file; save it as ascii");
    if (!(version_ >= 2.0 && version_ < 3.0) && !(version_ >= 4.0 && version_ < 5.0))
      scan_.fail("is of gmsh format " + std::to_string(version_) + "; save it in version 2 or 4");
  }

  /// Version 4 says the physical group of a tetrahedron by the volume that it fills.
  void read_entities() {
    if (version_ < 4.0) return;
    long counts[4];
    for (long& count : counts) count = scan_.count(2);
    for (int dimension = 0; dimension < 4; ++dimension) {
      for (long i = 0; i < counts[dimension]; ++i) {
        const long tag = scan_.integer();
        const int box = dimension == 0 && version_ >= 4.1 ? 3 : 6;
        for (int k = 0; k < box; ++k) scan_.number();
        const long physical = scan_.count(2);
        for (long k = 0; k < physical; ++k) {
          const long group = scan_.integer();
          if (dimension == 3 && k == 0) group_of_volume_[tag] = static_cast<int>(group);
        }
        if (dimension == 0) continue;
        const long bounding = scan_.count(2);
        for (long k = 0; k < bounding; ++k) scan_.integer();
      }
    }
  }

  void add_node(long tag) {
    index_of_tag_.emplace(tag, static_cast<int>(coordinates_.size() / 3));
    for (int k = 0; k < 3; ++k) coordinates_.push_back(scan_.number());
  }

  /// What stands before the blocks of nodes or elements: their number, that of all in them, and since 4.1 the
  /// range of tags.
  long count_of_blocks() {
    const long blocks = scan_.count(2);
    scan_.count(2);
    if (version_ >= 4.1) {
      scan_.integer();
      scan_.integer();
    }
    return blocks;
  }

  void read_nodes() {
    if (version_ < 4.0) {
      const long count = scan_.count(8);
      for (long i = 0; i < count; ++i) add_node(scan_.integer());
      return;
    }
    const long blocks = count_of_blocks();
    for (long b = 0; b < blocks; ++b) {
      const long first = scan_.integer(), second = scan_.integer();
      const long dimension = version_ >= 4.1 ? first : second;
      const long parameters = scan_.integer() != 0 ? dimension : 0, count = scan_.count(6);
      std::vector<long> tags(version_ >= 4.1 ? static_cast<std::size_t>(count) : 0);
      for (long& tag : tags) tag = scan_.integer();
      for (long i = 0; i < count; ++i) {
        add_node(tags.empty() ? scan_.integer() : tags[static_cast<std::size_t>(i)]);
        for (long k = 0; k < parameters; ++k) scan_.number();
      }
    }
  }

  void read_tetrahedron(int group) {
    for (int k = 0; k < 4; ++k) {
      const auto found = index_of_tag_.find(scan_.integer());
      if (found == index_of_tag_.end()) scan_.fail("a tetrahedron names a node that is not there");
      corners_.push_back(found->second);
    }
    groups_.push_back(group);
  }

  void refuse_other_volumes(long type) const {
    if (is_other_volume(type))
      scan_.fail("holds volume elements of gmsh type " + std::to_string(type) +
                 "; save linear tetrahedra only");
  }

  void read_elements() {
    std::string_view rest;
    if (version_ < 4.0) {
      const long count = scan_.count(6);
      for (long i = 0; i < count; ++i) {
        scan_.integer();
        const long type = scan_.integer(), tags = scan_.count(2);
        refuse_other_volumes(type);
        int group = 0;
        for (long k = 0; k < tags; ++k) {
          const long tag = scan_.integer();
          if (k == 0) group = static_cast<int>(tag);
        }
        if (type == kTetrahedron) read_tetrahedron(group);
        scan_.next_line(rest);
      }
      return;
    }
    const long blocks = count_of_blocks();
    for (long b = 0; b < blocks; ++b) {
      const long first = scan_.integer(), second = scan_.integer();
      const long entity = version_ >= 4.1 ? second : first, type = scan_.integer(), count = scan_.count(4);
      refuse_other_volumes(type);
      const auto group = group_of_volume_.find(entity);
      scan_.next_line(rest);
      for (long i = 0; i < count; ++i) {
        if (type == kTetrahedron) {
          scan_.integer();
          read_tetrahedron(group == group_of_volume_.end() ? 0 : group->second);
        }
        scan_.next_line(rest);
      }
    }
  }

  TetFile result() const {
    TetFile file;
    file.mesh.vertices =
        Eigen::Map<const Points>(coordinates_.data(), static_cast<Eigen::Index>(coordinates_.size() / 3), 3);
    file.mesh.tetrahedra =
        Eigen::Map<const Tetrahedra>(corners_.data(), static_cast<Eigen::Index>(corners_.size() / 4), 4);
    for (const int group : groups_)
      if (group != 0) file.mesh.labels = groups_;
    return file;
  }

  TextScanner scan_;
  std::string name_;
  double version_ = 0.0;
  std::unordered_map<long, int> index_of_tag_;
  std::unordered_map<long, int> group_of_volume_;
  std::vector<double> coordinates_;
  std::vector<int> corners_, groups_;
};

}  // namespace

TetFile read_msh(const std::filesystem::path& path) {
  const std::string content = mesh_bytes(path);
  return MshParser(content, path.string()).parse();
}

}  // namespace glisson::formats
