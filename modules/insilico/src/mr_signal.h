// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ct_scene.h"
#include "glisson/insilico/mr_patient.h"

namespace glisson::insilico {

/// The signals of tissues at 1.5 T, 1 being all protons of water.
/// T1 and T2 of liver, spleen, pancreas, kidney, muscle, marrow and fat: de Bazelaire et al. 2004 (Radiology
/// 230:652); of blood: Stanisz et al. 2005 (Magn Reson Med 54:507). Contrast medium: R1 = 1/T1 + r1 c with
/// r1 = 4.1 /(mM s) (gadopentetate in plasma, Rohrer et al. 2005), c = 1.2 mM in plasma 70 s after 0.1
/// mmol/kg, times each tissue's share of plasma and interstitium. T1: spoiled gradient echo (Ernst and
/// Anderson 1966), S = m sin a (1 - E) / (1 - E cos a), E = exp(-TR R1), TR 4.5 ms, a = 12 degrees, of fat a
/// tenth is left. T2: S = m (1 - exp(-TR / T1)) exp(-TE / T2), TR 3 s, TE 80 ms.
SignalOf signals_of(MrOptions::Sequence sequence);

}  // namespace glisson::insilico
