#include "core/repair/describe.h"

#include <gtest/gtest.h>

#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

std::string line(const RepairStep& step) { return describe(small_valve(), {{step}}).at(0); }

TEST(Describe, SpeaksOfRings) {
  EXPECT_EQ(line(Annuloplasty{CatalogueRing{"generic-classic", 30.0}}),
            "annuloplasty: generic-classic ring, size 30 mm");
  EXPECT_EQ(
      line(Annuloplasty{OwnRing{2}}),
      "annuloplasty: ring in the annulus's own shape, undersized by 2 sizes (transverse 36.0 to "
      "32.0 mm)");
}

TEST(Describe, NamesSegments) {
  EXPECT_EQ(line(Neochorda{"AL1", {Leaflet::Posterior, 0.45, 1.0}, 21.0}),
            "neochorda 21 mm from AL1 to the free edge of P2");
  EXPECT_EQ(line(ChordalTransfer{"PM1-A2-strut-1", {Leaflet::Anterior, 0.4, 0.7}}),
            "transfer chorda PM1-A2-strut-1 to A2 at 70 % of its height");
}

TEST(Describe, SpeaksOfSuturesAndChordae) {
  EXPECT_EQ(line(PapillaryApproximation{.side = Side::Posteromedial, .suture_length_mm = 31.5}),
            "papillary relocation: posteromedial muscle to its trigone, suture 31.5 mm");
  EXPECT_EQ(
      line(PapillaryApproximation{
          .side = Side::Anterolateral, .anchor = Anchor::SaddlePeak, .suture_length_mm = 30.0}),
      "papillary relocation: anterolateral muscle to the saddle peak, suture 30 mm");
  EXPECT_EQ(line(ChordalLengthChange{"AL1-P1-marginal-1", -2.0}),
            "shorten chorda AL1-P1-marginal-1 by 2 mm");
  EXPECT_EQ(line(ChordalExcision{"PM1-A2-strut-1"}), "excise chorda PM1-A2-strut-1");
}

TEST(Describe, SpeaksOfResectionsAndEdges) {
  EXPECT_EQ(line(LeafletResection{}),
            "triangular resection at the free edge of P2, 10 mm wide, over 70 % of the height");
  EXPECT_EQ(line(LeafletResection{.shape = ResectionShape::Quadrangular, .width_mm = 12.0}),
            "quadrangular resection at the free edge of P2, 12 mm wide, with sliding plasty");
  EXPECT_EQ(
      line(EdgeToEdge{EdgeDevice::Clip, 0.5, 6.0}),
      "edge-to-edge clip, 6 mm wide, the free edge of A2 to the free edge of P2, 5 mm of each "
      "leaflet grasped, annulus reduced by 11 %");
}

}  // namespace
}  // namespace coapt
