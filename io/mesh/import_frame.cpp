#include "io/mesh/import_frame.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <set>
#include <utility>

#include "core/valve/contour.h"
#include "core/valve/number_text.h"
#include "core/valve/principal_axes.h"
#include "core/valve/problem_list.h"
#include "io/mesh/given_landmarks.h"
#include "io/mesh/import_sheets.h"
#include "io/mesh/source_units.h"

namespace coapt {
namespace {

constexpr double kLeastSaddle_mm = 0.5;  // half its height, of annuli that orient a closed valve
constexpr double kLeastNamed_mm = 3.0;   // to the side of the annulus, of chambers and muscles
constexpr Eigen::Index kMinAnnulus = 12;
constexpr std::size_t kMaxChordae = 2000;
constexpr Range kTipDepthMm = {3.0, 100.0};
constexpr double kSamePoint_mm = 1e-6;
constexpr double kFurthestOrigin_mm = 1e4;

std::string at(const std::string& path, std::ptrdiff_t index) {
  return path + '/' + std::to_string(index);
}

void check_annulus(const Points& annulus, ProblemList& problems) {
  if (annulus.rows() < kMinAnnulus || !annulus.allFinite()) {
    problems.add(ErrorCode::OutOfRange, "/annulus_mm",
                 "has " + std::to_string(annulus.rows()) +
                     " points, must be a closed loop of at least 12, all finite");
    return;
  }
  const double length = ArcLength(annulus).total_mm();
  if (is_circumference_mm(length)) return;
  const char* unit = length == 0.0   ? ": all points are the same;"
                     : length < 1.0  ? ", which looks like metres;"
                     : length < 20.0 ? ", which looks like centimetres;"
                                     : ",";
  problems.add(
      ErrorCode::BadGeometry, "/annulus_mm",
      "has a circumference of " + shown(length) + " mm" + unit + " must be from 30 to 400 mm");
}

/// Of a source whose chordae are drawn.
void check_tips(const ImportSource& source, ProblemList& problems) {
  bool lateral = false, medial = false;
  for (std::size_t i = 0; i < source.tips.size(); ++i) {
    (source.tips[i].side == Side::Anterolateral ? lateral : medial) = true;
    if (!source.tips[i].position_mm.allFinite())
      problems.add(ErrorCode::OutOfRange, at("/tips", static_cast<std::ptrdiff_t>(i)),
                   "must have finite coordinates");
  }
  if (!source.chordae.empty())
    problems.add(ErrorCode::OutOfRange, "/chordae", "must be empty if chordae are synthesised");
  if (lateral != medial)
    problems.add(ErrorCode::MissingField, "/tips",
                 "must hold a tip of each papillary muscle, or none");
  if (source.tips.empty() && source.leaflets.size() == 1)
    problems.add(ErrorCode::MissingField, "/tips",
                 "is empty; the orientation of a single skirt is ambiguous, so provide the "
                 "papillary tips, or an anterior and a posterior sheet");
}

void check_chordae(const std::vector<ImportedChorda>& chordae, ProblemList& problems) {
  if (chordae.empty()) {
    problems.add(
        ErrorCode::MissingField, "/chordae",
        "is empty; chordae that were not imaged can be synthesised (--chordae synthesise)");
    return;
  }
  if (chordae.size() > kMaxChordae) {
    problems.add(ErrorCode::OutOfRange, "/chordae", "has more than 2000 chordae");
    return;
  }
  std::set<std::string> ids;
  bool lateral = false, medial = false;
  for (std::size_t i = 0; i < chordae.size(); ++i) {
    const ImportedChorda& chorda = chordae[i];
    const std::string path = at("/chordae", static_cast<std::ptrdiff_t>(i));
    (chorda.side == Side::Anterolateral ? lateral : medial) = true;
    if (chorda.id.empty() || !ids.insert(chorda.id).second) {
      problems.add(ErrorCode::BadReference, path + "/id", "is empty or that of an earlier chorda");
    }
    if (!chorda.insertion_mm.allFinite() || !chorda.tip_mm.allFinite()) {
      problems.add(ErrorCode::OutOfRange, path, "must have finite coordinates");
    }
    if (chorda.kind == ChordaKind::Neochorda) {
      problems.add(ErrorCode::OutOfRange, path + "/kind", "must be marginal, strut or basal");
    }
  }
  if (!lateral || !medial) {
    problems.add(ErrorCode::MissingField, "/chordae",
                 "must start at both papillary muscles: the tips orient the valve");
  }
}

/// The points that are not where the next one is.
std::vector<Eigen::Index> without_repeats(const Points& loop) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < loop.rows(); ++i) {
    const Eigen::Index next = (i + 1) % loop.rows();
    if ((loop.row(next) - loop.row(i)).norm() > kSamePoint_mm) kept.push_back(i);
  }
  return kept;
}

void check_pressed(const ImportSource& source, ProblemList& problems) {
  const Points& pressed = source.pressed_annulus_mm;
  if (pressed.rows() == 0 || (pressed.rows() == source.annulus_mm.rows() && pressed.allFinite()))
    return;
  problems.add(ErrorCode::OutOfRange, "/pressed_annulus_mm",
               "has " + std::to_string(pressed.rows()) +
                   " points, must have as many as the annulus, " +
                   std::to_string(source.annulus_mm.rows()) + ", all finite");
}

Vec3 mean_by_arc(const Points& loop) {
  Vec3 sum = Vec3::Zero();
  double total = 0.0;
  for (Eigen::Index i = 0; i < loop.rows(); ++i) {
    const Vec3 a = loop.row(i), b = loop.row((i + 1) % loop.rows());
    sum += (b - a).norm() * 0.5 * (a + b);
    total += (b - a).norm();
  }
  return sum / total;
}

/// Tips that chordae start at, or that were seen alone.
std::vector<ImportedTip> all_tips(const ImportSource& source) {
  std::vector<ImportedTip> tips = source.tips;
  for (const ImportedChorda& chorda : source.chordae) tips.push_back({chorda.side, chorda.tip_mm});
  return tips;
}

Vec3 mean_tip(const std::vector<ImportedTip>& tips, Side side) {
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (const ImportedTip& tip : tips) {
    if (tip.side != side) continue;
    sum += tip.position_mm;
    ++count;
  }
  return sum / count;
}

/// Weighted by area; zero without any.
Vec3 centroid(const TriangleMesh& mesh) {
  Vec3 sum = Vec3::Zero();
  double total = 0.0;
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f) {
    const Vec3 a = mesh.vertices_mm.row(mesh.faces(f, 0)),
               b = mesh.vertices_mm.row(mesh.faces(f, 1)),
               c = mesh.vertices_mm.row(mesh.faces(f, 2));
    const double area = (b - a).cross(c - a).norm();
    sum += area * (a + b + c) / 3.0;
    total += area;
  }
  return total > 0.0 ? Vec3(sum / total) : sum;
}

struct Frame {
  Vec3 origin_mm;
  Eigen::Matrix3d axes;        // columns x, y, z
  ImportDecision atrium = {};  // which side of the annulus it is on; empty: the tips tell
  Vec3 into(const Vec3& point_mm) const { return axes.transpose() * (point_mm - origin_mm); }
  Points into(const Points& points_mm) const {
    return (points_mm.rowwise() - origin_mm.transpose()) * axes;
  }
};

/// x of a valve whose tips nobody has seen: its sheets say what is in front.
Vec3 across_sheets(const std::vector<TriangleMesh>& leaflets, const Vec3& z) {
  const Vec3 forwards = centroid(leaflets[0]) - centroid(leaflets[1]);
  return (forwards - z.dot(forwards) * z).cross(z);
}

/// Twice how far the annulus's front and back stand to the side of z, over its sides: half a saddle's height.
double saddle_towards(const Vec3& z, const Vec3& x, const Points& centred) {
  const Eigen::VectorXd across = centred * x, along = centred * z.cross(x), height = centred * z;
  const Eigen::ArrayXd distance2 = across.array().square() + along.array().square();
  const Eigen::ArrayXd cosine = (along.array().square() - across.array().square()) / distance2;
  return 2.0 * (height.array() * cosine).mean();
}

/// How far what is named as of the atrium lies to the side of z, and as of the ventricle to the other one, in the mean; 0 where that
/// tells no side.
double named_towards(const Vec3& z, const Vec3& origin,
                     const std::vector<ImportedWitness>& witnesses) {
  double sum = 0.0;
  for (const ImportedWitness& witness : witnesses)
    sum += (witness.side == AnnulusSide::Atrium ? 1.0 : -1.0) * z.dot(witness.position_mm - origin);
  const double mean = sum / std::max(1.0, static_cast<double>(witnesses.size()));
  return std::abs(mean) < kLeastNamed_mm ? 0.0 : mean;
}

Expected<Frame> find_frame(const Points& annulus, const ImportSource& source,
                           const FrameOptions& options) {
  const bool closed = options.closed;
  const Vec3 origin = mean_by_arc(annulus);
  const Points centred = annulus.rowwise() - origin.transpose();
  const Eigen::Matrix3d axes = principal_axes(centred);
  const std::vector<ImportedTip> tips = all_tips(source);
  Vec3 z = axes.col(0), x;
  Frame frame{origin, {}, {}};
  if (tips.empty()) {
    const Vec3 middle = 0.5 * (centroid(source.leaflets[0]) + centroid(source.leaflets[1]));
    double hanging_mm = -z.dot(middle - origin);
    if (hanging_mm < 0.0) z = -z;
    hanging_mm = std::abs(hanging_mm);
    x = across_sheets(source.leaflets, z);
    if (!(x.norm() > 1.0))
      return Error{ErrorCode::BadGeometry, "/leaflets",
                   "coincide; an anterior and a posterior sheet are needed to orient the valve"};
    const double saddle_mm = saddle_towards(z, x.normalized(), centred),
                 named_mm = named_towards(z, origin, source.witnesses);
    const bool saddle_tells = std::abs(saddle_mm) > kLeastSaddle_mm, names_tell = named_mm != 0.0;
    // Closed leaflets hang below the annulus or billow above it; of open ones others are asked where they hardly hang.
    const bool hanging_tells = !closed && hanging_mm >= kLeastHanging_mm;
    if (!hanging_tells && !saddle_tells && !names_tell)
      return Error{
          ErrorCode::MissingField, "/tips",
          "is missing: " +
              std::string(closed ? "with closed leaflets in such a flat annulus"
                                 : "with leaflets that hang " + significant(hanging_mm, 2) +
                                       " mm on average below such a flat annulus") +
              " only papillary tips can distinguish the atrium from the ventricle"};
    const double towards = hanging_tells ? 1.0 : names_tell ? named_mm : saddle_mm;
    const bool agree = saddle_mm > 0.0 || !saddle_tells;
    const bool named_elsewhere = towards * named_mm < 0.0,
               saddle_elsewhere = names_tell && saddle_tells && towards * saddle_mm < 0.0;
    if (towards < 0.0) {
      z = -z;
      x = -x;
    }
    frame.atrium = {
        "atrium",
        std::string("on the side that ") + (hanging_tells ? "the leaflets hang away from"
                                            : names_tell
                                                ? "labels of chambers or papillary muscles say"
                                                : "the annulus's saddle rises to"),
        "they hang " + significant(hanging_mm, 2) + " mm on average, and the saddle rises " +
            significant(2.0 * std::abs(saddle_mm), 2) + " mm" +
            (agree ? (saddle_tells ? " to the same side" : "") : " to the other side") +
            (hanging_tells && names_tell
                 ? std::string("; labels of chambers or papillary muscles say ") +
                       (named_elsewhere ? "the other side" : "this side, too")
                 : ""),
        named_elsewhere || saddle_elsewhere ||
            (!agree && (hanging_tells || hanging_mm >= kLeastHanging_mm)),
        agree && !named_elsewhere ? 1.0 : 0.7};
    if (options.flip) {
      z = -z;
      x = -x;
      const bool contrary = (hanging_tells && saddle_tells && agree && !named_elsewhere) ||
                            (names_tell && !named_elsewhere);
      frame.atrium = {"atrium", "opposite to the side suggested by the shape, as given",
                      frame.atrium.reason, contrary, contrary ? 0.5 : 1.0};
    }
  } else {
    if (options.flip)
      return Error{
          ErrorCode::UnknownField, "/flip",
          "cannot be combined with papillary tips, which already determine the ventricular side"};
    const Vec3 lateral = mean_tip(tips, Side::Anterolateral);
    const Vec3 medial = mean_tip(tips, Side::Posteromedial);
    if (z.dot(0.5 * (lateral + medial) - origin) > 0.0) z = -z;
    x = medial - lateral - z.dot(medial - lateral) * z;
    if (!(x.norm() > 1.0))
      return Error{ErrorCode::BadGeometry, source.chordae.empty() ? "/tips" : "/chordae",
                   "has both papillary tips within 1 mm of each other; must be farther apart to "
                   "orient the valve"};
    const double hanging_mm = -z.dot(centroid(joined(source.leaflets)) - origin);
    if (!closed && hanging_mm < -kLeastHanging_mm)
      frame.atrium = {
          "atrium", "on the side opposite to the papillary tips",
          "the leaflets hang " + significant(-hanging_mm, 2) + " mm to the other side on average",
          true, 0.6};
    else if (named_towards(z, origin, source.witnesses) < 0.0)
      frame.atrium = {"atrium", "on the side opposite to the papillary tips",
                      "labels of chambers or papillary muscles say the other side", true, 0.6};
  }
  frame.axes << x.normalized(), z.cross(x.normalized()), z;
  return frame;
}

void check_framed(const FramedSource& framed, ProblemList& problems) {
  bool told = false;  // one place will do
  for (Eigen::Index i = 0; i < framed.annulus_mm.rows(); ++i) {
    const Vec3 a = framed.annulus_mm.row(i),
               b = framed.annulus_mm.row((i + 1) % framed.annulus_mm.rows());
    if (a.x() * b.y() - a.y() * b.x() > 0.0) continue;
    if (std::exchange(told, true)) continue;
    problems.add(ErrorCode::BadGeometry, at("/annulus_mm", i),
                 "must lead counter-clockwise around the annulus axis like the points before it; "
                 "an annulus that turns back on itself cannot be cut by half-planes");
  }
  for (std::size_t i = 0; i < framed.chordae.size(); ++i) {
    check_range(problems, at("/chordae", static_cast<std::ptrdiff_t>(i)) + "/tip_mm",
                -framed.chordae[i].tip_mm.z(), kTipDepthMm, " mm");
  }
  if (framed.leaflets.size() == 2 &&
      centroid(framed.leaflets[0]).y() <= centroid(framed.leaflets[1]).y()) {
    problems.add(ErrorCode::BadGeometry, "/leaflets/0",
                 "lies behind the other sheet in the orientation given by the papillary muscles; "
                 "the anterior sheet must come first, the sides of the muscles must be correct, "
                 "and the coordinates must be right-handed");
  }
}

}  // namespace

Expected<FramedSource> into_import_frame(const ImportSource& source, const FrameOptions& options) {
  ProblemList problems;
  check_leaflets(source.leaflets, problems);
  check_annulus(source.annulus_mm, problems);
  check_pressed(source, problems);
  if (options.draws_chordae)
    check_tips(source, problems);
  else
    check_chordae(source.chordae, problems);
  if (!problems.empty()) return std::move(problems).take();
  if (Errors mixed = mixed_units(source); !mixed.empty()) return mixed;
  const std::vector<Eigen::Index> kept = without_repeats(source.annulus_mm);
  const Points loop = source.annulus_mm(kept, Eigen::all);
  const Expected<Frame> frame = find_frame(loop, source, options);
  if (!frame) return frame.errors();
  if (const double away_mm = frame->origin_mm.norm(); !(away_mm <= kFurthestOrigin_mm))
    return Error{ErrorCode::OutOfRange, "/annulus_mm",
                 "lies " + significant(0.001 * away_mm, 3) +
                     " m from the origin of the files' coordinates; must lie within 10 m of it, so "
                     "check the units and the origin"};
  FramedSource framed;
  framed.annulus_mm = frame->into(loop);
  framed.annulus_band_mm = source.annulus_band_mm;
  if (source.pressed_annulus_mm.rows() > 0)
    framed.pressed_annulus_mm = frame->into(Points(source.pressed_annulus_mm(kept, Eigen::all)));
  double area = 0.0;
  for (Eigen::Index i = 0; i < loop.rows(); ++i) {
    const Vec3 a = framed.annulus_mm.row(i), b = framed.annulus_mm.row((i + 1) % loop.rows());
    area += a.x() * b.y() - a.y() * b.x();
  }
  if (area < 0.0) {
    framed.annulus_mm = framed.annulus_mm.colwise().reverse().eval();
    framed.pressed_annulus_mm = framed.pressed_annulus_mm.colwise().reverse().eval();
  }
  for (const TriangleMesh& mesh : source.leaflets) {
    framed.leaflets.push_back({frame->into(mesh.vertices_mm), mesh.faces});
  }
  framed.chordae = source.chordae;
  for (ImportedChorda& chorda : framed.chordae) {
    chorda.insertion_mm = frame->into(chorda.insertion_mm);
    chorda.tip_mm = frame->into(chorda.tip_mm);
    if (chorda.pressed_tip_mm) chorda.pressed_tip_mm = frame->into(*chorda.pressed_tip_mm);
    for (ImportedSegment& segment : chorda.segments) segment.end_mm = frame->into(segment.end_mm);
  }
  for (const ImportedTip& tip : source.tips)
    framed.tips.push_back({tip.side, frame->into(tip.position_mm)});
  for (const ImportedTie& tie : source.ties)
    framed.ties.push_back({tie.id, frame->into(tie.anterior_mm), frame->into(tie.posterior_mm)});
  framed.landmarks = source.landmarks;
  for_each_given(framed.landmarks, [&](const Vec3& place) { return frame->into(place); });
  check_framed(framed, problems);
  check_given(framed, problems);
  if (!problems.empty()) return std::move(problems).take();
  const double turned = Eigen::AngleAxisd(frame->axes).angle() * 180.0 / std::numbers::pi;
  framed.patient = {frame->axes, frame->origin_mm};
  framed.atrium = frame->atrium;
  framed.change = {
      "frame",
      "moved by " + significant(frame->origin_mm.norm(), 3) + " mm and rotated by " +
          significant(turned, 3) + " degrees",
      "origin annulus centroid, " +
          (source.chordae.empty() && source.tips.empty()
               ? std::string("y from the posterior to the anterior sheet, z ") +
                     (options.closed ? "to the side to which the saddle of the annulus rises"
                                     : "away from the leaflets")
               : std::string("x from the anterolateral to the posteromedial papillary tip within "
                             "the annulus plane, z away from the tips"))};
  return framed;
}

}  // namespace coapt
