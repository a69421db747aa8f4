// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli.h"
#include "commands.h"

namespace glisson::app {

const std::vector<SubCommand>& sub_commands() {
  static const std::vector<SubCommand> kCommands = {
      {"demo", run_demo, true,
       QT_TRANSLATE_NOOP("cli", "From CT to overlay video on the built-in synthetic patient, or another")},
      {"import", run_import, false, QT_TRANSLATE_NOOP("cli", "Read a CT into a case")},
      {"segment", run_segment, false,
       QT_TRANSLATE_NOOP("cli", "Segment liver, vessels and lesions from seeds")},
      {"edit", run_edit, false,
       QT_TRANSLATE_NOOP("cli", "Edit the labels by a script of the window's tools")},
      {"model", run_model, false, QT_TRANSLATE_NOOP("cli", "Build the biomechanical model")},
      {"atlas", run_atlas, false,
       QT_TRANSLATE_NOOP("cli", "Landmarks that the CT does not show: build, show and transfer an atlas")},
      {"calibrate", run_calibrate, false,
       QT_TRANSLATE_NOOP("cli", "Calibrate a stereo laparoscope from pictures of a board")},
      {"check", run_check, false, QT_TRANSLATE_NOOP("cli", "Look through a stereo video for faults")},
      {"reconstruct", run_reconstruct, false, QT_TRANSLATE_NOOP("cli", "Stereo pair to labelled cloud")},
      {"register", run_register, false, QT_TRANSLATE_NOOP("cli", "Register the model to a cloud")},
      {"track", run_track, false, QT_TRANSLATE_NOOP("cli", "Follow a stereo video or a series of clouds")},
      {"render", run_render, true, QT_TRANSLATE_NOOP("cli", "Draw one frame with its overlay")},
      {"overlay", run_overlay, true, QT_TRANSLATE_NOOP("cli", "Record the overlay video")},
      {"moments", run_moments, true,
       QT_TRANSLATE_NOOP("cli", "List and write the moments of the live view that a case keeps")},
      {"prove", run_prove, true, QT_TRANSLATE_NOOP("cli", "Measure the proofs' figures again")},
      {"figure", run_figure, true, QT_TRANSLATE_NOOP("cli", "Measure a figure of the paper again")},
      {"simulate", run_simulate, false,
       QT_TRANSLATE_NOOP("cli", "Plain mechanics: gravity, pressure, springs, fixed nodes")},
      {"doctor", run_doctor, true,
       QT_TRANSLATE_NOOP("cli", "Tell what this machine has and lacks for the program")},
      {"soak", run_soak, true,
       QT_TRANSLATE_NOOP("cli",
                         "Work for long and look whether memory, files and threads stay what they are")},
  };
  return kCommands;
}

}  // namespace glisson::app
