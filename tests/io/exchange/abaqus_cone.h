// The input file of a valve of two leaflets, by hand.
#pragma once

#include <cmath>
#include <numbers>
#include <string>

namespace coapt {

/// A cone of eight columns and two rows: nodes 1 to 8 on the annulus (radius 15 mm), 9 to 16, 17 to
/// 24 at the free edge; two leaflets of four columns. Node 100 is a papillary point, 101 half way to
/// the branch point 102, from where trusses lead to the nodes 17 and 18. Normals point inwards and
/// down: to the ventricle.
inline std::string abaqus_cone(const std::string& more = "") {
  std::string text = "*PART, NAME=Leaflet\n** a comment\n*NODE, NSET=All\n";
  for (int ring = 0; ring < 3; ++ring)
    for (int i = 0; i < 8; ++i) {
      const double angle = 0.25 * std::numbers::pi * i, r = 15.0 - 3.0 * ring;
      text += std::to_string(8 * ring + i + 1) + ", " + std::to_string(r * std::cos(angle)) + ", " +
              std::to_string(r * std::sin(angle)) + ", " + std::to_string(-4.0 * ring) + " \n";
    }
  text += "100, 0., 0., -30.\n101, 3., 1., -24.\n102, 6., 2., -18.\n";
  for (int half = 0; half < 2; ++half) {
    text += std::string("*element, type=S4R, elset=") + (half ? "B" : "A") + "_Leaflet_Elements\n";
    for (int ring = 0; ring < 2; ++ring)
      for (int i = 4 * half; i < 4 * half + 4; ++i) {
        const int a = 8 * ring + i + 1, b = 8 * ring + (i + 1) % 8 + 1;
        text += std::to_string(8 * ring + i + 1) + "," + std::to_string(a) + "," +
                std::to_string(a + 8) + "," + std::to_string(b + 8) + "," + std::to_string(b) +
                "\n";
      }
  }
  text +=
      "*ELEMENT, TYPE=T3D2, ELSET=Chordae\n50,100,101\n51,101,102\n52,102,17\n53,102,18\n"
      "*NSET, NSET=Annulus, GENERATE\n1,8,1\n"
      "*DISTRIBUTION, NAME=Axes, LOCATION=ELEMENT, TABLE=T\n,1.,0.,0.,0.,1.,0.\n"
      "1,0.,1.,0.,0.,0.,1.\n"
      "*ORIENTATION, NAME=Ori, SYSTEM=RECTANGULAR\nAxes\n3, 0.\n"
      "*SHELL SECTION, ELSET=A_Leaflet_Elements, ORIENTATION=Ori, MATERIAL=VUANISO_ISO_A\n.65,5\n"
      "*SHELL SECTION, ELSET=B_Leaflet_Elements, MATERIAL=VUANISO_ISO_B\n.5,5\n"
      "*SOLID SECTION, ELSET=Chordae, MATERIAL=Cord\n0.3,\n*END PART\n"
      "*SURFACE, TYPE=ELEMENT, NAME=Face, MAXRATIO=0.05\n"
      "Instance.A_Leaflet_Elements, SPOS\nInstance.B_Leaflet_Elements, SPOS\n"
      "*MATERIAL, NAME=Cord\n*DENSITY\n1e-9\n*HYPERELASTIC, OGDEN, N=2\n10., 50., 5., 20., 0., 0.\n"
      "*MATERIAL, NAME=VUANISO_ISO_A\n*DENSITY\n1e-9,\n"
      "*ANISOTROPIC HYPERELASTIC, USER, FORMULATION=INVARIANT, PROPERTIES=4\n"
      "0.001, 20., 0.000124, 4.5\n"
      "*MATERIAL, NAME=VUANISO_ISO_B\n*DENSITY\n1e-9,\n"
      "*ANISOTROPIC HYPERELASTIC, USER, FORMULATION=INVARIANT, PROPERTIES=4\n"
      "0.002, 20., 0.000188, 14.8\n"
      "*STEP, NAME=One\n*BOUNDARY\nAnnulus,3,3,0.5\nInstance.1,1,1,-0.25\nInstance.100,1,3\n"
      "*DSLOAD\nFace, P, 0.003\n" +
      more + "*END STEP\n";
  return text;
}

}  // namespace coapt
