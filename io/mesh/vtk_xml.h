// The container of VTK's XML formats: elements with attributes, and arrays whose numbers stand in place or behind all
// elements (VTK file formats, "XML file formats" and "appended data").
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/valve/types.h"
#include "io/mesh/vtk_xml_bytes.h"

namespace coapt {

struct XmlElement {
  std::string name;  ///< "/Piece" ends one
  std::map<std::string, std::string, std::less<>> attributes;
  std::string_view text;                               ///< up to the next element
  std::string attribute(std::string_view name) const;  ///< empty if there is none
};

struct VtkXml {
  std::vector<XmlElement> elements;  ///< in the order of the file, up to AppendedData
  std::string_view appended;         ///< behind its underscore
  bool appended_raw = false;         ///< else base64
  bool wide_header = false;          ///< counts have 8 bytes, else 4
  std::string compressor;            ///< "" or VTK's name of its class
};

/// The elements of a file of this type ("UnstructuredGrid").
Expected<VtkXml> read_vtk_xml(std::string_view bytes, std::string_view type);

/// The numbers of a DataArray, which are taken off the budget of the file. Errors have `path`.
Expected<std::vector<double>> read_data_array(const VtkXml& file, const XmlElement& array,
                                              const std::string& path, UnpackBudget& budget);

}  // namespace coapt
