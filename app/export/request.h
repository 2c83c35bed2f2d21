#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "field/heights_file.h"
#include "field/solid.h"

namespace cydonia {

// Files for other programs: a solid to print, the scene, or the heights.
struct GltfFormat {};
using ExportFormat = std::variant<MeshFormat, GltfFormat, HeightFormat>;

struct ExportRequest {
    ExportFormat format = MeshFormat::kStl;
    SolidOptions solid = {};          // of a solid; its samples are below
    std::optional<int> samples = {};  // at most, along the longer side; none: by format
};

// The name on the command line: "png16".
std::string_view name_of(const ExportFormat& format);
const std::map<std::string, ExportFormat>& export_formats();

}  // namespace cydonia
