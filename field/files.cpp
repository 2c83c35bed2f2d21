#include "field/files.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "field/error.h"

namespace cydonia {
namespace fs = std::filesystem;
namespace {

// The name of this machine, since several may write to one disk.
std::size_t machine() {
    char name[256] = {};
    gethostname(name, sizeof name - 1);
    return std::hash<std::string_view>{}(name)&0xffffff;
}

// The temporary name. It is hidden, in the same folder so that the rename stays on one
// disk, and has the same extension because writers choose their format by it.
fs::path temporary_beside(const fs::path& path) {
    return path.parent_path() / fmt::format(".{}.tmp{:x}-{}{}", path.stem().string(),
                                            machine(), getpid(),
                                            path.extension().string());
}

// A rename would replace a device or a symbolic link. Only regular files may be replaced.
void expect_replaceable(const fs::path& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (fs::is_directory(status))
        throw failure("cannot write {}: a folder has that name", path.string());
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw failure("cannot write {}: it is not a regular file", path.string());
}

std::string reason_of(int error) {
    return error == 0 ? "unknown reason" : std::strerror(error);
}

void write_bytes(const fs::path& temporary, const fs::path& path,
                 std::string_view bytes) {
    errno = 0;
    std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();  // a full disk may show only here
    if (!out) throw failure("cannot write {}: {}", path.string(), reason_of(errno));
}

}  // namespace

void write_atomically(const fs::path& path,
                      const std::function<void(const fs::path&)>& write) {
    expect_replaceable(path);
    const fs::path temporary = temporary_beside(path);
    std::error_code ignored;
    try {
        write(temporary);
        fs::rename(temporary, path);
    } catch (const Error&) {
        fs::remove(temporary, ignored);
        throw;
    } catch (const fs::filesystem_error& error) {
        fs::remove(temporary, ignored);
        throw failure("cannot write {}: {}", path.string(), error.code().message());
    } catch (const std::exception& error) {
        fs::remove(temporary, ignored);
        throw failure("cannot write {}: {}", path.string(), error.what());
    } catch (...) {  // an interruption is not ours to translate
        fs::remove(temporary, ignored);
        throw;
    }
}

void write_text(const fs::path& path, std::string_view text) {
    write_atomically(
        path, [&](const fs::path& temporary) { write_bytes(temporary, path, text); });
}

std::string read_text(const fs::path& path, std::size_t max_bytes) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
        throw bad_request("cannot read {}: it is a folder", path.string());
    errno = 0;
    std::ifstream in(path, std::ios::binary);
    if (!in) throw bad_request("cannot open {}: {}", path.string(), reason_of(errno));
    std::string text;
    char block[1 << 16];
    while (in.read(block, sizeof block), in.gcount() > 0) {
        text.append(block, static_cast<std::size_t>(in.gcount()));
        if (text.size() > max_bytes)
            throw bad_request("{} is larger than {} bytes", path.string(), max_bytes);
    }
    if (in.bad())
        throw bad_request("cannot read {}: {}", path.string(), reason_of(errno));
    return text;
}

void make_folder(const fs::path& path) {
    std::error_code error;
    fs::create_directories(path, error);
    if (fs::is_directory(path)) return;

    // What is in the way is the nearest parent that exists and is no folder.
    for (fs::path in_the_way = path; in_the_way.has_relative_path();
         in_the_way = in_the_way.parent_path()) {
        std::error_code ignored;
        const fs::file_status status = fs::status(in_the_way, ignored);
        if (fs::exists(status) && !fs::is_directory(status))
            throw failure("cannot make the folder {}: {} is a file", path.string(),
                          in_the_way.string());
    }
    throw failure("cannot make the folder {}: {}", path.string(), error.message());
}

}  // namespace cydonia
