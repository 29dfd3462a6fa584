#include "core/valve/valve.h"

#include <algorithm>

namespace coapt {

std::array<double, 2> prestretch(const Tissue& tissue) {
  switch (tissue.reference) {
    case TissueReference::Excised:
      return {1.0, 1.0};
    case TissueReference::InVivo:
      return {tissue.circumferential_prestretch, tissue.radial_prestretch};
  }
  return {1.0, 1.0};
}

const char* to_string(TissueReference reference) {
  switch (reference) {
    case TissueReference::Excised:
      return "excised";
    case TissueReference::InVivo:
      return "in_vivo";
  }
  return "";
}

const char* to_string(Segment segment) {
  switch (segment) {
    case Segment::A1:
      return "A1";
    case Segment::A2:
      return "A2";
    case Segment::A3:
      return "A3";
    case Segment::P1:
      return "P1";
    case Segment::P2:
      return "P2";
    case Segment::P3:
      return "P3";
    case Segment::AC:
      return "AC";
    case Segment::PC:
      return "PC";
  }
  assert(false);
  return "";
}

const char* to_string(Leaflet leaflet) {
  switch (leaflet) {
    case Leaflet::Anterior:
      return "anterior";
    case Leaflet::Posterior:
      return "posterior";
  }
  assert(false);
  return "";
}

const char* to_string(Side side) {
  switch (side) {
    case Side::Anterolateral:
      return "anterolateral";
    case Side::Posteromedial:
      return "posteromedial";
  }
  assert(false);
  return "";
}

const char* to_string(ChordaKind kind) {
  switch (kind) {
    case ChordaKind::Marginal:
      return "marginal";
    case ChordaKind::Strut:
      return "strut";
    case ChordaKind::Basal:
      return "basal";
    case ChordaKind::Neochorda:
      return "neochorda";
  }
  assert(false);
  return "";
}

Vec3 papillary_tip_mm(const Valve& valve, Side side) {
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (const PapillaryHead& head : valve.heads) {
    if (head.side != side) continue;
    sum += head.tip_mm;
    ++count;
  }
  assert(count > 0);
  return sum / count;
}

Vec3 position(const Insertion& insertion, const Faces& faces, const Points& points) {
  Vec3 sum = Vec3::Zero();
  for (int corner = 0; corner < 3; ++corner) {
    const Vec3 vertex = points.row(faces(insertion.face, corner));
    sum += insertion.weights[corner] * vertex;
  }
  return sum;
}

Vec3 annulus_position_mm(const Valve& valve, int vertex) {
  const auto found = std::find(valve.annulus.begin(), valve.annulus.end(), vertex);
  assert(found != valve.annulus.end());
  return valve.annulus_mm.row(found - valve.annulus.begin());
}

}  // namespace coapt
