// For the leak sanitizer of the debug preset: what librsvg's libraries keep for good is
// not ours to free.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libfontconfig\nleak:libxml2\nleak:libcairo\n";
}
