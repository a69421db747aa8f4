// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace glisson {

/// A file or folder that this process holds (flock(2)). The kernel lets go of it when the process ends,
/// however it ends: what nobody holds any more was left behind by one that was killed. Two claims exclude
/// each other within one process too.
class Claim {
 public:
  /// Holds nothing.
  Claim() = default;
  /// @param descriptor of an open file or folder; taken over, and closed in the end.
  explicit Claim(int descriptor) : descriptor_(descriptor) {}
  ~Claim() { release(); }
  Claim(Claim&& other) noexcept : descriptor_(other.descriptor_) { other.descriptor_ = -1; }
  Claim& operator=(Claim&& other) noexcept;
  Claim(const Claim&) = delete;
  Claim& operator=(const Claim&) = delete;

  /// A new file or folder (0700) of an unused name, held from its first moment on.
  /// @param folder in which it is made. @param ending of its name, with the dot; may be empty.
  /// @return its path; empty, with errno set, when none can be made there.
  static std::filesystem::path make_file(const std::filesystem::path& folder, const std::string& ending,
                                         Claim& claim);
  static std::filesystem::path make_folder(const std::filesystem::path& folder, Claim& claim);

  /// Whether it is held now. A file system that knows no locks: false, errno is not EWOULDBLOCK.
  bool take() const;
  /// Whether the path still names what is held.
  bool is_at(const std::filesystem::path& path) const;
  void release();
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_ = -1;
};

/// Removes what killed programs of this user left in a folder: files and folders that are named like work in
/// progress of Glisson and that nobody holds. Everything else stays; a folder that cannot be read is left.
/// @return how many were removed.
int sweep_leftovers(const std::filesystem::path& folder);

}  // namespace glisson
