#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "field/heights_file.h"
#include "field/solid.h"

namespace cydonia {

// What other programs open: a solid to print, the scene, or the heights.
struct GltfFormat {};
using ExportFormat = std::variant<MeshFormat, GltfFormat, HeightFormat>;

struct ExportRequest {
    ExportFormat format = MeshFormat::kStl;
    SolidOptions solid = {};          // of a solid, but for its samples
    std::optional<int> samples = {};  // at most, along the longer side; none: format's
};

// "png16", as the command line names it.
std::string_view name_of(const ExportFormat& format);
const std::map<std::string, ExportFormat>& export_formats();

}  // namespace cydonia
