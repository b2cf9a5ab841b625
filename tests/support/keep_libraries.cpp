// Replaces dlclose() in tests with a sanitizer, so that no library is unloaded. Graphics drivers keep memory
// until the end of the program; if their libraries are unloaded before, the leak checker finds blocks without
// reference.
extern "C" int dlclose(void*) noexcept { return 0; }
