// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <mutex>

#include "registration_proof.h"
#include "registration_stage.h"

namespace glisson::experiments {

/// One registration, judged with the truth at hand. Lengths in metres.
struct RegistrationTrial {
  std::string patient;
  ProofSet set = ProofSet::development;
  std::string handling;
  double share = 0.0;
  RegistrationFault fault = RegistrationFault::none;
  double mean = 0.0;             ///< error of the nodes; infinite: the cloud does not show the organ
  std::vector<double> lesions;   ///< errors of the lesions, likewise
  std::vector<double> expected;  ///< what the registration itself expects of them; empty: it does not say
  std::vector<char> covered;     ///< whether the lesion's 95 % ellipsoid holds the truth
  /// Left by the best rigid alignment of true correspondences; of the paper's method. Not a number: not
  /// tried.
  double rigid_mean = std::numeric_limits<double>::quiet_NaN();
  double paper_mean = std::numeric_limits<double>::quiet_NaN();
  double seconds = 0.0;
  bool refused = false;
  std::vector<std::string> doubts;
  Figures figures;  ///< evidence

  double worst_lesion() const;
  void cover();  ///< `covered` from the figures
  bool doubted() const { return refused || !doubts.empty(); }
};

/// What was tried so far, in a file. Thread-safe.
class TrialLog {
 public:
  /// @param former begins with what that file holds, where it is there; empty: with nothing. @throws
  /// FileError when it cannot be read; as trials_of.
  explicit TrialLog(std::filesystem::path csv, const std::filesystem::path& former = {});
  /// Whether a trial of the same patient, handling, share and fault is there.
  bool has(const RegistrationTrial& trial) const;
  /// @throws FileError when it cannot be written.
  void add(RegistrationTrial trial);
  std::vector<RegistrationTrial> trials() const;

 private:
  std::filesystem::path csv_;
  mutable std::mutex mutex_;
  std::vector<RegistrationTrial> trials_;
};

/// All trials of one patient that the log does not hold yet. @param number of it. Cut short when cancelled.
void run_trials(const RegistrationStage& stage, const RegistrationStage& other,
                const RegistrationProofOptions& options, std::size_t number, TrialLog& log,
                const RunContext& context);

std::string csv_of(const std::vector<RegistrationTrial>& trials);
/// What csv_of() wrote. @throws InputError naming the file and the line that is no registration.
std::vector<RegistrationTrial> trials_of(const std::string& csv, const std::filesystem::path& file);
/// Adds one set's figures and table.
void sum_up(const std::vector<RegistrationTrial>& trials, ProofSet set, RegistrationProof& proof);

}  // namespace glisson::experiments
