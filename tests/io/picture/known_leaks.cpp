// Read by the leak sanitizer, where there is one: fontconfig never frees the patterns that cairo
// asks of it.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\n"; }
