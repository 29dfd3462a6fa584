// NRRD ("Nearly raw raster data", teem.sourceforge.net/nrrd/format.html): lines "field: value" and "key:=value" up to an
// empty line, then the data. Of the keys only those are kept that name Slicer's segments.

#include "io/image/nrrd.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <map>
#include <optional>

#include "core/valve/number_text.h"
#include "core/valve/problem_list.h"
#include "io/image/image_geometry.h"
#include "io/image/label_map.h"
#include "io/image/voxel_stream.h"
#include "io/mesh/source_units.h"
#include "io/mesh/text_scan.h"

namespace coapt {
namespace {

constexpr int kMostLines = 100'000;
constexpr Index kMostLayers = 64;
constexpr int kMostSegments = 1000;

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

struct Header {
  std::map<std::string, std::string, std::less<>> fields;  ///< names in lower case
  std::map<std::string, std::string, std::less<>> keys;
  std::string_view data;  ///< behind the empty line
  std::string_view field(std::string_view name, std::string_view other = "") const {
    auto found = fields.find(name);
    if (found == fields.end()) found = fields.find(other);
    return found == fields.end() ? std::string_view() : found->second;
  }
};

Expected<Header> header_of(std::string_view bytes) {
  if (!bytes.starts_with("NRRD000"))
    return Error{ErrorCode::Unsupported, "", "is not an NRRD file: it must begin with NRRD000"};
  Header header;
  LineScanner lines(bytes);
  for (auto line = lines.next(); line; line = lines.next()) {
    const std::string_view text = trimmed(line->text);
    if (text.empty()) {
      header.data = lines.rest();
      return header;
    }
    if (line->number > kMostLines) break;
    if (line->number == 1 || text.starts_with('#')) continue;
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) continue;
    if (text.substr(colon).starts_with(":=")) {
      header.keys[std::string(text.substr(0, colon))] = trimmed(text.substr(colon + 2));
    } else {
      header.fields[lower(text.substr(0, colon))] = trimmed(text.substr(colon + 1));
    }
  }
  return Error{ErrorCode::InputOutput, "",
               "has no empty line after its header, so it is truncated"};
}

std::optional<VoxelType> type_of(const std::string& name) {
  static const std::map<std::string_view, VoxelType> kTypes = {
      {"signed char", VoxelType::Int8},
      {"int8", VoxelType::Int8},
      {"int8_t", VoxelType::Int8},
      {"uchar", VoxelType::Uint8},
      {"unsigned char", VoxelType::Uint8},
      {"uint8", VoxelType::Uint8},
      {"uint8_t", VoxelType::Uint8},
      {"short", VoxelType::Int16},
      {"short int", VoxelType::Int16},
      {"signed short", VoxelType::Int16},
      {"signed short int", VoxelType::Int16},
      {"int16", VoxelType::Int16},
      {"int16_t", VoxelType::Int16},
      {"ushort", VoxelType::Uint16},
      {"unsigned short", VoxelType::Uint16},
      {"unsigned short int", VoxelType::Uint16},
      {"uint16", VoxelType::Uint16},
      {"uint16_t", VoxelType::Uint16},
      {"int", VoxelType::Int32},
      {"signed int", VoxelType::Int32},
      {"int32", VoxelType::Int32},
      {"int32_t", VoxelType::Int32},
      {"uint", VoxelType::Uint32},
      {"unsigned int", VoxelType::Uint32},
      {"uint32", VoxelType::Uint32},
      {"uint32_t", VoxelType::Uint32},
      {"longlong", VoxelType::Int64},
      {"long long", VoxelType::Int64},
      {"int64", VoxelType::Int64},
      {"int64_t", VoxelType::Int64},
      {"ulonglong", VoxelType::Uint64},
      {"unsigned long long", VoxelType::Uint64},
      {"uint64", VoxelType::Uint64},
      {"uint64_t", VoxelType::Uint64},
      {"float", VoxelType::Float32},
      {"double", VoxelType::Float64}};
  const auto found = kTypes.find(name);
  if (found == kTypes.end()) return {};
  return found->second;
}

/// "(1,0,0) none (0,0,1)": a vector or none for each.
Expected<std::vector<std::optional<Vec3>>> vectors(std::string_view text, const std::string& path) {
  const Error wrong = {ErrorCode::WrongType, path,
                       "must be vectors of three numbers, (x,y,z), or none for an axis of layers"};
  std::vector<std::optional<Vec3>> list;
  for (text = trimmed(text); !text.empty() && list.size() < 8; text = trimmed(text)) {
    if (text.starts_with("none")) {
      list.emplace_back();
      text.remove_prefix(4);
      continue;
    }
    const std::size_t end = text.find(')');
    if (text.front() != '(' || end == std::string_view::npos) return wrong;
    const auto numbers = fields(text.substr(1, end - 1));
    if (numbers.size() != 3) return wrong;
    Vec3 vector;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto number = to_number(numbers[i]);
      if (!number) return wrong;
      vector[static_cast<Index>(i)] = *number;
    }
    list.emplace_back(vector);
    text.remove_prefix(end + 1);
  }
  return list;
}

/// Signs of x and y that lead to LPS, and whether the field says where the patient is.
struct Space {
  double x = 1.0, y = 1.0;
  bool placed = true;
};

std::optional<Space> space_of(const std::string& name) {
  if (name == "left-posterior-superior" || name == "lps") return Space{};
  if (name == "right-anterior-superior" || name == "ras") return Space{-1.0, -1.0};
  if (name == "left-anterior-superior" || name == "las") return Space{1.0, -1.0};
  if (name.empty() || name == "scanner-xyz" || name == "3d-right-handed")
    return Space{1.0, 1.0, false};
  return {};
}

struct Axes {
  std::vector<Index> sizes;
  int list = -1;      ///< the axis of layers or phases, or -1
  bool time = false;  ///< it is of phases
  Index layers() const { return list < 0 ? 1 : sizes[static_cast<std::size_t>(list)]; }
};

class NrrdReader {
 public:
  NrrdReader(Header header, Index most_voxels, int phase)
      : header_(std::move(header)), most_voxels_(most_voxels), phase_(phase) {}

  Expected<LabelMap> read() {
    check_attached();
    const Axes axes = read_axes();
    if (problems_.empty()) read_geometry(axes);
    if (!problems_.empty()) return std::move(problems_).take();
    if (Errors errors = read_voxels(axes); !errors.empty()) return errors;
    if (axes.time)
      if (Errors errors = choose_phase(); !errors.empty()) return errors;
    read_names();
    return std::move(map_);
  }

 private:
  void check_attached() {
    if (header_.fields.contains("data file") || header_.fields.contains("datafile"))
      problems_.add(ErrorCode::Unsupported, "/data file",
                    "names another file; provide it together with this one, or save as .nrrd");
  }

  Axes read_axes() {
    Axes axes;
    for (const std::string_view word : words(header_.field("sizes")))
      axes.sizes.push_back(to_integer(word).value_or(0));
    const auto count = axes.sizes.size();
    if (to_integer(header_.field("dimension")).value_or(0) != std::ssize(axes.sizes) || count < 3 ||
        count > 4) {
      problems_.add(ErrorCode::OutOfRange, "/sizes",
                    "must match dimension: 3, or 4 with an axis of layers");
      return axes;
    }
    Index voxels = 1;
    for (const Index size : axes.sizes) {
      if (size < 1 || size > most_voxels_ / voxels) {
        problems_.add(
            ErrorCode::OutOfRange, "/sizes",
            "must be from 1 on, and at most " + std::to_string(most_voxels_) + " voxels in all");
        return axes;
      }
      voxels *= size;
    }
    if (count == 4) axes.list = list_axis();
    axes.time = axes.list >= 0 && is_time(axes.list);
    if (count == 4 && axes.list < 0)
      problems_.add(ErrorCode::Unsupported, "/kinds",
                    "must mark one of the four axes as layers (list) or phases (time), with space "
                    "direction none");
    else if (axes.time && axes.layers() > kMostPhases)
      problems_.add(ErrorCode::OutOfRange, "/sizes", "has more than the 1000 phases accepted");
    else if (!axes.time && axes.layers() > kMostLayers)
      problems_.add(ErrorCode::OutOfRange, "/sizes", "has more than the 64 layers accepted");
    return axes;
  }

  /// The one axis that is not one of space.
  int list_axis() const {
    const std::string kinds_text = lower(header_.field("kinds"));
    const auto kinds = words(kinds_text);
    int found = -1, count = 0;
    for (std::size_t i = 0; i < kinds.size() && i < 4; ++i) {
      if (kinds[i] == "domain" || kinds[i] == "space") continue;
      if (kinds[i] == "list" || kinds[i] == "vector" || kinds[i] == "time")
        found = static_cast<int>(i);
      ++count;
    }
    return kinds.size() == 4 && count == 1 ? found : -1;
  }

  /// By its kind, or of a list as Slicer's sequences say it, or because a phase is asked for where no segment names a layer.
  bool is_time(int axis) const {
    const std::string kinds_text = lower(header_.field("kinds"));
    if (words(kinds_text)[static_cast<std::size_t>(axis)] == "time") return true;
    if (phase_ > 0 && !header_.keys.contains("Segment0_Name")) return true;
    const auto key = header_.keys.find("axis " + std::to_string(axis) + " index type");
    return key != header_.keys.end() && key->second == "time";
  }

  /// Of the layers that were read as phases.
  Errors choose_phase() {
    map_.phases = map_.layers;
    map_.layers = 1;
    if (phase_ > map_.phases)
      return {Error{ErrorCode::OutOfRange, "/phase",
                    "is " + std::to_string(phase_) + ", must be from 1 to " +
                        std::to_string(map_.phases) + ", the number of phases in the file"}};
    const auto volume = static_cast<std::ptrdiff_t>(map_.size[0] * map_.size[1] * map_.size[2]);
    const auto begin_of = [&](int phase) { return map_.voxels.begin() + (phase - 1) * volume; };
    map_.phase = std::max(1, phase_);
    if (phase_ == 0) {
      const auto first = std::find_if(map_.voxels.begin(), map_.voxels.end(),
                                      [](std::uint16_t label) { return label != 0; });
      if (first != map_.voxels.end())
        map_.phase = 1 + static_cast<int>((first - map_.voxels.begin()) / volume);
    }
    map_.voxels = std::vector<std::uint16_t>(begin_of(map_.phase), begin_of(map_.phase) + volume);
    return {};
  }

  void read_geometry(const Axes& axes) {
    std::size_t k = 0;
    for (std::size_t i = 0; i < axes.sizes.size(); ++i)
      if (static_cast<int>(i) != axes.list) map_.size[k++] = axes.sizes[i];
    map_.layers = static_cast<int>(axes.layers());
    const std::optional<Space> space = space_of(lower(header_.field("space")));
    if (!space)
      return problems_.add(ErrorCode::Unsupported, "/space",
                           "must be left-posterior-superior, right-anterior-superior, "
                           "left-anterior-superior, scanner-xyz or left out");
    const auto directions = vectors(header_.field("space directions"), "/space directions");
    const auto origin = vectors(header_.field("space origin"), "/space origin");
    for (const auto* list : {&directions, &origin})
      if (!*list)
        problems_.add(list->errors()[0].code, list->errors()[0].path, list->errors()[0].message);
    if (!problems_.empty()) return;
    std::vector<Vec3> steps;
    for (const auto& direction : *directions)
      if (direction) steps.push_back(*direction);
    if (directions->empty()) {
      steps = spacings(axes);
    } else if (directions->size() != axes.sizes.size() || steps.size() != 3) {
      problems_.add(ErrorCode::OutOfRange, "/space directions", "must be three vectors");
      return;
    }
    map_.placed = space->placed && !directions->empty();
    if (steps.size() != 3) return;
    for (Index axis = 0; axis < 3; ++axis)
      map_.to_lps_mm.block<3, 1>(0, axis) = steps[static_cast<std::size_t>(axis)];
    if (!origin->empty() && origin->front()) map_.to_lps_mm.block<3, 1>(0, 3) = *origin->front();
    const auto to_mm =
        directions->empty() ? units_mm("units", axes.list) : units_mm("space units", -1);
    for (Index axis = 0; axis < 3; ++axis)
      map_.to_lps_mm.row(axis) *= to_mm[static_cast<std::size_t>(axis)];
    map_.to_lps_mm.row(0) *= space->x;
    map_.to_lps_mm.row(1) *= space->y;
    doubt_sheared();
    check_voxel_steps(map_.to_lps_mm, "/space directions", problems_);
  }

  /// How many millimetres the quoted units of a field are, but for that at `passed_over`; 1 where it states none.
  std::array<double, 3> units_mm(const std::string& field, int passed_over) {
    constexpr double kMicrometre_mm = 0.001;
    std::array<double, 3> all = {1.0, 1.0, 1.0};
    const std::string text = lower(header_.field(field));
    std::size_t axis = 0, close = 0;
    for (std::size_t open = text.find('"'), i = 0; open != std::string::npos && axis < 3;
         open = text.find('"', std::min(close + 1, text.size())), ++i) {
      close = std::min(text.find('"', open + 1), text.size());
      if (static_cast<int>(i) == passed_over) continue;
      const std::string unit = text.substr(open + 1, close - open - 1);
      if (const auto named = unit_named(unit))
        all[axis] = in_mm(*named);
      else if (unit == "um")
        all[axis] = kMicrometre_mm;
      else if (!unit.empty())
        problems_.add(ErrorCode::Unsupported, '/' + field,
                      "must be \"mm\", \"cm\", \"m\", \"um\" or \"in\", or left out");
      ++axis;
    }
    return all;
  }

  void doubt_sheared() {
    if (const auto off_deg = off_a_right_angle_deg(map_.to_lps_mm.topLeftCorner<3, 3>()))
      map_.frame_doubt = "the space directions are sheared: two axes are " +
                         significant(*off_deg, 2) + " degrees off a right angle";
  }

  std::vector<Vec3> spacings(const Axes& axes) {
    const auto numbers = words(header_.field("spacings"));
    std::vector<Vec3> steps;
    for (std::size_t i = 0; i < numbers.size() && i < axes.sizes.size(); ++i) {
      if (static_cast<int>(i) == axes.list) continue;
      Vec3 step = Vec3::Zero();
      if (steps.size() < 3) step[std::ssize(steps)] = to_number(numbers[i]).value_or(0.0);
      steps.push_back(step);
    }
    if (steps.size() != 3)
      problems_.add(ErrorCode::MissingField, "/space directions",
                    "is missing, as are three spacings, so the voxel size is unknown");
    return steps;
  }

  Errors read_voxels(const Axes& axes) {
    const std::optional<VoxelType> type = type_of(lower(header_.field("type")));
    const std::string encoding = lower(header_.field("encoding"));
    const Packing packing = encoding == "gzip" || encoding == "gz"     ? Packing::Zlib
                            : encoding == "bzip2" || encoding == "bz2" ? Packing::Bzip2
                                                                       : Packing::None;
    const bool words = encoding == "ascii" || encoding == "text" || encoding == "txt";
    if (!type)
      return {Error{ErrorCode::Unsupported, "/type",
                    "must be a type of whole numbers (uchar to ulonglong), float or double"}};
    if (packing == Packing::None && !words && encoding != "raw")
      return {Error{ErrorCode::Unsupported, "/encoding", "must be raw, gzip, bzip2 or ascii"}};
    const std::string endian = lower(header_.field("endian"));
    if (!words && bytes_of(*type) > 1 && endian != "little" && endian != "big")
      return {Error{ErrorCode::MissingField, "/endian", "must be little or big"}};
    VoxelLayout layout;
    layout.type = *type;
    layout.order = endian == "big" ? std::endian::big : std::endian::little;
    layout.count = static_cast<std::size_t>(map_.size[0] * map_.size[1] * map_.size[2] *
                                            static_cast<Index>(map_.layers));
    std::string_view data = header_.data;
    if (Errors errors = skip(data, encoding == "raw", layout); !errors.empty()) return errors;
    ByteStream stream(data, packing);
    Expected<std::vector<std::uint16_t>> labels =
        words ? read_label_words(data, layout.count) : read_labels(stream, layout);
    if (!labels) return labels.errors();
    if (!words)
      if (Errors errors = check_end(stream); !errors.empty()) return errors;
    map_.voxels = layers_last(*std::move(labels), axes);
    return {};
  }

  /// "line skip" and "byte skip", -1: what a raw file ends with.
  Errors skip(std::string_view& data, bool raw, const VoxelLayout& layout) const {
    const auto number = [&](std::string_view name, std::string_view other) {
      const std::string_view text = header_.field(name, other);
      return text.empty() ? std::optional<long long>(0) : to_integer(text);
    };
    const auto line_count = number("line skip", "lineskip");
    const auto byte_count = number("byte skip", "byteskip");
    const std::size_t needed = layout.count * bytes_of(layout.type);
    if (line_count && byte_count && *byte_count == -1 && raw && data.size() >= needed) {
      data.remove_prefix(data.size() - needed);
      return {};
    }
    if (!line_count || !byte_count || *line_count < 0 || *byte_count < 0 ||
        (*byte_count > 0 && !raw) || *line_count > kMostLines ||
        *byte_count > static_cast<long long>(data.size()))
      return {Error{ErrorCode::OutOfRange, "/byte skip",
                    "and line skip must lie within the file; byte skip with raw data only"}};
    LineScanner lines(data);
    for (long long i = 0; i < *line_count; ++i) (void)lines.next();
    data = lines.rest();
    data.remove_prefix(std::min(data.size(), static_cast<std::size_t>(*byte_count)));
    return {};
  }

  /// From the order of the file, in which layers may be any of four axes, to that of LabelMap.
  std::vector<std::uint16_t> layers_last(std::vector<std::uint16_t> labels,
                                         const Axes& axes) const {
    if (axes.list < 0 || axes.list == 3) return labels;
    std::size_t below = 1;
    for (int i = 0; i < axes.list; ++i)
      below *= static_cast<std::size_t>(axes.sizes[static_cast<std::size_t>(i)]);
    const auto layers = static_cast<std::size_t>(axes.layers());
    const std::size_t above = labels.size() / (below * layers);
    std::vector<std::uint16_t> sorted(labels.size());
    for (std::size_t high = 0; high < above; ++high)
      for (std::size_t layer = 0; layer < layers; ++layer)
        for (std::size_t low = 0; low < below; ++low)
          sorted[(layer * above + high) * below + low] =
              labels[(high * layers + layer) * below + low];
    return sorted;
  }

  /// Slicer's: Segment0_Name, Segment0_LabelValue, Segment0_Layer.
  void read_names() {
    for (int i = 0; i < kMostSegments; ++i) {
      const std::string prefix = "Segment" + std::to_string(i) + '_';
      const auto name = header_.keys.find(prefix + "Name");
      if (name == header_.keys.end()) return;
      const auto number = [&](const char* key, long long otherwise) {
        const auto found = header_.keys.find(prefix + key);
        return found == header_.keys.end() ? otherwise
                                           : to_integer(found->second).value_or(otherwise);
      };
      const long long value = number("LabelValue", 1), layer = number("Layer", 0);
      if (value >= 1 && value <= 65535 && layer >= 0 && layer < map_.layers)
        map_.names.push_back({static_cast<int>(layer), static_cast<int>(value), name->second});
    }
  }

  Header header_;
  Index most_voxels_;
  int phase_;
  LabelMap map_;
  ProblemList problems_;
};

}  // namespace

Expected<LabelMap> read_nrrd(std::string_view bytes, Index most_voxels, int phase) {
  Expected<Header> header = header_of(bytes);
  if (!header) return header.errors();
  return NrrdReader(*std::move(header), most_voxels, phase).read();
}

}  // namespace coapt
