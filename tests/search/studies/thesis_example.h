// A study in which everything is as the thesis says.
#pragma once

#include "search/studies/thesis_study.h"

namespace coapt {

/// Figure 4.5 as in the thesis, with the square of the dilation up to 10 %, flattening by 25 % shrinking
/// the orifice by 7 %.
AnnulusStudy annulus_of_the_thesis();
/// Table 4.1 at 6 mm, in between by powers of 1.5 along each axis.
PapillaryStudy papillary_of_the_thesis();
/// Table 4.2 at the largest displacement, less below; without a ring the orifice levels off there.
RingStudy ring_of_the_thesis();
/// Two configurations of each class to each anchor, the trigone the better one in all.
ApproximationStudy anchors_of_the_thesis(Protocol protocol = Protocol::LookupClamped);

ThesisStudy study_of_the_thesis();

}  // namespace coapt
