#pragma once

namespace cydonia {

// The deleter of a std::unique_ptr to an object of a C library, which the library's own
// function releases.
template <auto kRelease>
struct Released {
    template <class T>
    void operator()(T* thing) const {
        kRelease(thing);
    }
};

}  // namespace cydonia
