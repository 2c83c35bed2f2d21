#include "field/data.h"
#include "field/error.h"
namespace cydonia {
std::filesystem::path data_file(std::string_view) { throw failure("not built yet"); }
}  // namespace cydonia
