// For the leak sanitizer of the debug preset: memory that librsvg's libraries keep until
// the end is not a leak of ours.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libfontconfig\nleak:libxml2\nleak:libcairo\n";
}
