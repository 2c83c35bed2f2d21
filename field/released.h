#pragma once

namespace cydonia {

// For std::unique_ptr of what a C library made: released by the library's own function.
template <auto kRelease>
struct Released {
    template <class T>
    void operator()(T* thing) const {
        kRelease(thing);
    }
};

}  // namespace cydonia
