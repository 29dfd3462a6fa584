// NIfTI-1 and -2 (nifti.nimh.nih.gov, nifti1.h and nifti2.h): a header of 348 or 540 bytes in the byte order of the machine
// that wrote it, then, from vox_offset on, the voxels. Frames lead to RAS, so x and y change their signs.

#include "io/image/nifti.h"

#include <array>
#include <cmath>
#include <cstring>
#include <optional>

#include "core/valve/number_text.h"
#include "core/valve/problem_list.h"
#include "io/image/image_geometry.h"
#include "io/image/label_map.h"
#include "io/image/label_phases.h"
#include "io/image/voxel_stream.h"
#include "io/mesh/byte_scan.h"

namespace coapt {
namespace {

constexpr std::size_t kHeader1 = 348, kHeader2 = 540;
constexpr double kSameEdge = 0.02;        // share by which the edges of a voxel may differ
constexpr double kSamePlace = 0.5;        // of a voxel, between sform and qform
constexpr double kMostOffset = 16 << 20;  // extensions that lie before the voxels

/// Where the fields of a header begin.
struct Places {
  std::size_t dim, datatype, pixdim, vox_offset, slope, inter, units, qform, sform, quatern, offset,
      rows;
};
constexpr Places kPlaces1 = {40, 70, 76, 108, 112, 116, 123, 252, 254, 256, 268, 280};
constexpr Places kPlaces2 = {16, 12, 104, 168, 176, 184, 500, 344, 348, 352, 376, 400};

/// A header of either version, as numbers.
class HeaderFields {
 public:
  HeaderFields(std::string_view bytes, std::endian order)
      : bytes_(bytes),
        order_(order),
        second_(bytes.size() == kHeader2),
        at_(second_ ? kPlaces2 : kPlaces1) {}

  double dim(std::size_t i) const {
    return second_ ? number<std::int64_t>(at_.dim + 8 * i) : number<std::int16_t>(at_.dim + 2 * i);
  }
  int datatype() const { return static_cast<int>(number<std::int16_t>(at_.datatype)); }
  double pixdim(std::size_t i) const { return real(at_.pixdim, i); }
  double vox_offset() const {
    return second_ ? number<std::int64_t>(at_.vox_offset) : number<float>(at_.vox_offset);
  }
  double slope() const { return real(at_.slope, 0); }
  double inter() const { return real(at_.inter, 0); }
  int units() const {
    return (second_ ? static_cast<int>(number<std::int32_t>(at_.units)) : bytes_[at_.units]) & 7;
  }
  double qform_code() const { return code(at_.qform); }
  double sform_code() const { return code(at_.sform); }
  double quatern(std::size_t i) const { return real(at_.quatern, i); }
  double offset(std::size_t i) const { return real(at_.offset, i); }
  double row(std::size_t i) const { return real(at_.rows, i); }

 private:
  template <class T>
  double number(std::size_t at) const {
    std::string_view rest = bytes_.substr(at);
    return static_cast<double>(*take_binary<T>(rest, order_));
  }
  double real(std::size_t at, std::size_t i) const {
    return second_ ? number<double>(at + 8 * i) : number<float>(at + 4 * i);
  }
  double code(std::size_t at) const {
    return second_ ? number<std::int32_t>(at) : number<std::int16_t>(at);
  }

  std::string_view bytes_;
  std::endian order_;
  bool second_;
  Places at_;
};

std::optional<VoxelType> type_of(int datatype) {
  switch (datatype) {  // nifti1.h, NIFTI_TYPE_
    case 2:
      return VoxelType::Uint8;
    case 4:
      return VoxelType::Int16;
    case 8:
      return VoxelType::Int32;
    case 16:
      return VoxelType::Float32;
    case 64:
      return VoxelType::Float64;
    case 256:
      return VoxelType::Int8;
    case 512:
      return VoxelType::Uint16;
    case 768:
      return VoxelType::Uint32;
    case 1024:
      return VoxelType::Int64;
    case 1280:
      return VoxelType::Uint64;
    default:
      return {};
  }
}

/// Method 2 of nifti1.h: a quaternion, voxel sizes and the direction of the slices.
Eigen::Matrix4d qform(const HeaderFields& header) {
  const double b = header.quatern(0), c = header.quatern(1), d = header.quatern(2);
  const double a = std::sqrt(std::max(0.0, 1.0 - b * b - c * c - d * d));
  const double face = header.pixdim(0) < 0.0 ? -1.0 : 1.0;
  Eigen::Matrix4d frame = Eigen::Matrix4d::Identity();
  frame.topLeftCorner<3, 3>() =
      Eigen::Quaterniond(a, b, c, d).normalized().toRotationMatrix() *
      Vec3(header.pixdim(1), header.pixdim(2), face * header.pixdim(3)).asDiagonal();
  for (std::size_t i = 0; i < 3; ++i) frame(static_cast<Index>(i), 3) = header.offset(i);
  return frame;
}

Eigen::Matrix4d sform(const HeaderFields& header) {
  Eigen::Matrix4d frame = Eigen::Matrix4d::Identity();
  for (std::size_t i = 0; i < 12; ++i)
    frame(static_cast<Index>(i / 4), static_cast<Index>(i % 4)) = header.row(i);
  return frame;
}

/// Edges of a voxel in words: "1 x 1 x 0.7".
std::string edges_text(const Vec3& edges) {
  return significant(edges[0], 3) + " x " + significant(edges[1], 3) + " x " +
         significant(edges[2], 3);
}

/// Whether the rows of the sform hold another voxel than pixdim: then the qform is taken, if there is one.
bool rows_contradict(const HeaderFields& header, LabelMap& map, ProblemList& problems) {
  const Eigen::Matrix4d rows = sform(header);
  const Vec3 edges = rows.topLeftCorner<3, 3>().colwise().norm();
  if (!(edges.minCoeff() > 0.0)) return false;  // check_voxel_steps() says so
  const Vec3 said = {header.pixdim(1), header.pixdim(2), header.pixdim(3)};
  const bool other =
      !((edges - said.cwiseAbs()).array().abs() <= kSameEdge * said.array().abs()).all();
  const bool quaternion = header.qform_code() > 0.0;
  if (other && said.allFinite() && said.cwiseAbs().minCoeff() > 0.0) {
    const std::string what = "the sform has voxels of " + edges_text(edges) + ", pixdim has " +
                             edges_text(said.cwiseAbs());
    if (quaternion)
      map.frame_doubt = "the qform is used: " + what;
    else
      problems.add(ErrorCode::BadGeometry, "/srow",
                   "contradicts pixdim: " + what + "; correct one of them");
    return true;
  }
  if (const auto off_deg = off_a_right_angle_deg(rows.topLeftCorner<3, 3>())) {
    map.frame_doubt = "the sform is used although it is sheared: its axes are " +
                      significant(*off_deg, 2) + " degrees off a right angle";
  } else if (quaternion) {
    const Eigen::Vector4d far(header.dim(1) - 1.0, header.dim(2) - 1.0, header.dim(3) - 1.0, 1.0);
    const Eigen::Matrix4d apart = rows - qform(header);
    const double away = std::max(apart.col(3).head<3>().norm(), (apart * far).head<3>().norm());
    if (away > kSamePlace * edges.minCoeff())
      map.frame_doubt =
          "the sform is used; the qform differs by up to " + significant(away, 2) + " mm";
  }
  return false;
}

void read_frame(const HeaderFields& header, LabelMap& map, ProblemList& problems) {
  const bool quaternion = header.qform_code() > 0.0;
  bool rows = header.sform_code() > 0.0;
  map.placed = rows || quaternion;
  if (rows && rows_contradict(header, map, problems)) rows = false;
  if (rows) {
    map.to_lps_mm = sform(header);
  } else if (quaternion) {
    map.to_lps_mm = qform(header);
  } else {
    for (Index i = 0; i < 3; ++i)
      map.to_lps_mm(i, i) = std::abs(header.pixdim(static_cast<std::size_t>(i) + 1));
  }
  if (map.placed) map.to_lps_mm.topRows<2>() *= -1.0;
  const double unit = header.units() == 1 ? 1000.0 : header.units() == 3 ? 0.001 : 1.0;
  map.to_lps_mm.topRows<3>() *= unit;
  check_voxel_steps(map.to_lps_mm, rows ? "/srow" : quaternion ? "/quatern" : "/pixdim", problems);
}

void read_size(const HeaderFields& header, Index most_voxels, LabelMap& map,
               ProblemList& problems) {
  const double count = header.dim(0);
  bool good = count >= 3.0 && count <= 7.0;
  Index voxels = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const double size = header.dim(i + 1);
    good = good && size >= 1.0 && size <= static_cast<double>(most_voxels / voxels);
    if (!good) break;
    map.size[i] = static_cast<Index>(size);
    voxels *= map.size[i];
  }
  for (std::size_t i = 4; good && i <= static_cast<std::size_t>(count); ++i) {
    // Phases along the fourth axis, or masks along the fifth, which is for vectors.
    const bool several = (i == 4 || (i == 5 && map.phases == 1)) && header.dim(i) > 1.0 &&
                         header.dim(i) <= kMostPhases;
    good = header.dim(i) == 1.0 || several;
    if (several) map.phases = static_cast<int>(header.dim(i));
  }
  if (!good)
    problems.add(ErrorCode::OutOfRange, "/dim",
                 "must be one volume of at most " + std::to_string(most_voxels) +
                     " voxels, or up to 1000 of them as phases or masks");
}

void check_numbers(const HeaderFields& header, ProblemList& problems) {
  const double slope = header.slope(), inter = header.inter();
  const bool scaled = (std::isfinite(slope) && slope != 0.0 && slope != 1.0) ||
                      (std::isfinite(inter) && inter != 0.0 && slope != 0.0);
  if (scaled)
    problems.add(ErrorCode::Unsupported, "/scl_slope",
                 "scales the values, as for intensities; must be 0 or 1, and scl_inter 0");
  if (!type_of(header.datatype()))
    problems.add(ErrorCode::Unsupported, "/datatype",
                 "is " + std::to_string(header.datatype()) +
                     ", must be whole numbers (2, 4, 8, 256, 512, 768, 1024, 1280), float or "
                     "double (16, 64)");
  if (!(header.vox_offset() <= kMostOffset))
    problems.add(ErrorCode::OutOfRange, "/vox_offset", "must be at most 16 MiB");
}

}  // namespace

Expected<LabelMap> read_nifti(std::string_view bytes, Index most_voxels, int phase) {
  ByteStream stream(bytes, packing_of(bytes));
  std::array<char, kHeader2> head{};
  const Error none = {ErrorCode::Unsupported, "", "is not a NIfTI file, or is truncated"};
  if (!stream.read(head.data(), kHeader1)) return none;
  std::endian order = std::endian::little;
  std::size_t size = 0;
  for (const std::endian tried : {std::endian::little, std::endian::big}) {
    std::string_view start(head.data(), 4);
    const auto length = *take_binary<std::int32_t>(start, tried);
    if (length != kHeader1 && length != kHeader2) continue;
    order = tried;
    size = static_cast<std::size_t>(length);
  }
  const std::string_view magic = size == kHeader2 ? std::string_view(head.data() + 4, 4)
                                                  : std::string_view(head.data() + 344, 4);
  using namespace std::string_view_literals;
  if (size != 0 && (magic == "ni1\0"sv || magic == "ni2\0"sv))
    return Error{ErrorCode::Unsupported, "",
                 "has its voxels in another file; must be a single file, .nii"};
  if (magic != (size == kHeader2 ? "n+2\0"sv : "n+1\0"sv) || size == 0) return none;
  if (size > kHeader1 && !stream.read(head.data() + kHeader1, size - kHeader1)) return none;
  const HeaderFields header({head.data(), size}, order);
  LabelMap map;
  ProblemList problems;
  read_size(header, most_voxels, map, problems);
  check_numbers(header, problems);
  read_frame(header, map, problems);
  if (!problems.empty()) return std::move(problems).take();
  const double offset = header.vox_offset();
  if (offset > static_cast<double>(size) && !stream.skip(static_cast<std::uint64_t>(offset) - size))
    return Error{ErrorCode::InputOutput, "/data", "is truncated or damaged"};
  VoxelLayout layout;
  layout.type = *type_of(header.datatype());
  layout.order = order;
  layout.count = static_cast<std::size_t>(map.size[0] * map.size[1] * map.size[2]);
  if (Errors errors = read_phase(stream, layout, phase, most_voxels, map); !errors.empty())
    return errors;
  if (header.dim(0) >= 5.0 && header.dim(5) > 1.0 && map.masks == 0)
    return Error{ErrorCode::OutOfRange, "/dim",
                 "has several numbers for each voxel; they must be masks of 0 and 1, one for each "
                 "label"};
  return map;
}

}  // namespace coapt
