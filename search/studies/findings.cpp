#include "search/studies/findings.h"

#include "search/studies/anchor_findings.h"
#include "search/studies/geometry_findings.h"
#include "search/studies/ring_findings.h"

namespace coapt {

std::vector<Finding> findings(const ThesisStudy& study) {
  std::vector<Finding> all;
  for (const auto& part : {annulus_findings(study.annulus), papillary_findings(study.papillary),
                           belly_findings(study.belly_shift_mm), ring_findings(study.ring)})
    all.insert(all.end(), part.begin(), part.end());
  for (const ApproximationStudy& approximation : study.anchors.approximation)
    for (const Finding& finding : anchor_findings(approximation)) all.push_back(finding);
  return all;
}

}  // namespace coapt
