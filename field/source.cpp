#include "field/source.h"
#include "field/error.h"
namespace cydonia {
Source open_source(const std::filesystem::path&) { throw failure("not built yet"); }
}  // namespace cydonia
