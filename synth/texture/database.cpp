#include "synth/texture/database.h"

namespace cydonia::texture {

std::uint64_t Database::cells() const { return 0; }

std::shared_ptr<const Database> database_of(const Options&, const std::filesystem::path&,
                                            Progress&) {
    return nullptr;
}

}  // namespace cydonia::texture
