// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/segmentation/segment.h"

namespace glisson::segmentation {

/// The image as the methods read it. A CT stays as it is. Of an MRI (fat-suppressed T1 gradient echo in the
/// venous phase, which orders vessels, liver, muscle and tumours, fat and air as a venous CT does) the coils'
/// bias field is taken off, and what remains is carried linearly onto Hounsfield units by two anchors of the
/// patient's own: the liver at its seeds (or as kept) and the dark of fat and air. The image itself stays.
/// @param kept as in segment(). @throws InputError neither CT nor MRI; a liver that does not stand out from
/// the dark; vessels that are not brighter than it, or much that is far brighter: another sequence.
Cancellable<Image> on_ct_scale(const Image& image, const Seeds& seeds, const LabelMap* kept,
                               const RunContext& context);

}  // namespace glisson::segmentation
