#include "field/source.h"

#include <xxhash.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <system_error>
#include <vector>

#include "field/error.h"

namespace cydonia {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kLargestSource = std::uint64_t{4} << 30;

struct FreeState {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

void expect_readable_file(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
        throw bad_request("cannot open '{}': {}", path.string(),
                          error ? error.message() : "no such file");
    if (fs::is_directory(status))
        throw bad_request("cannot open '{}': it is a folder", path.string());
    if (!fs::is_regular_file(status))
        throw bad_request("cannot open '{}': it is not a regular file", path.string());
    if (fs::file_size(path) > kLargestSource)
        throw bad_request("'{}' is larger than 4 GiB", path.string());
}

}  // namespace

Source open_source(const fs::path& path) {
    expect_readable_file(path);
    errno = 0;
    std::ifstream in(path, std::ios::binary);
    if (!in)
        throw bad_request("cannot open '{}': {}", path.string(), std::strerror(errno));

    Source source{fs::absolute(path).lexically_normal()};
    const std::unique_ptr<XXH3_state_t, FreeState> state(XXH3_createState());
    XXH3_64bits_reset(state.get());
    std::vector<char> block(1 << 20);
    while (in.read(block.data(), std::ssize(block)), in.gcount() > 0) {
        XXH3_64bits_update(state.get(), block.data(),
                           static_cast<std::size_t>(in.gcount()));
        source.size += static_cast<std::uint64_t>(in.gcount());
    }
    if (in.bad()) throw bad_request("cannot read '{}'", path.string());
    if (source.size == 0) throw bad_request("'{}' is empty", path.string());
    source.hash = XXH3_64bits_digest(state.get());
    return source;
}

}  // namespace cydonia
