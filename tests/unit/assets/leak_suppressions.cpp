// Leaks of libraries that are not ours to mend, told to LeakSanitizer.
#ifdef __SANITIZE_ADDRESS__

// OpenImageIO 2.4's PngReadCallback passes a std::string's text to png_error(), which jumps over its
// destructor: about 30 bytes for each truncated PNG.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:ImageInput::geterror";
}

#endif
