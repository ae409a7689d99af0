//! Empty: the build script compares the C headers of the library with its sources.
