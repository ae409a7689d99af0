/* Texts: UTF-16 of Windows and UTF-8 of the library, the language of the user, numbers, files. */
#pragma once
#include <windows.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "resource.h"

namespace fs = std::filesystem;
using std::max;
using std::min;

typedef std::vector<std::wstring> Texts;

/* Thrown: why something is not done, for the user. */
struct Refusal {
    std::wstring sentence;
};

std::wstring wide(const std::string &utf8);
std::string narrow(const std::wstring &text);

/* The language of all texts and dialogs from now on. */
void set_language(bool chinese);
bool is_chinese();
/* A text of the resources by its name, its %1, %2, ... replaced; without such a text the name itself. */
std::wstring text(const std::string &name, const Texts &values = {});
/* The same for what the library names too: scene keys, their words, effects. */
std::wstring label(const std::string &name, const std::string &otherwise);
/* A text cut at ";". */
Texts parts(const std::string &name);
/* A sentence of the library in the user's language, where it is of a common kind. */
std::wstring told(const std::string &sentence);
/* A resource in the user's language. */
const void *resource(LPCWSTR type, UINT id, DWORD *size = NULL);

/* The shortest text that reads back to the bit, as the program `sins` writes it. */
std::string shortest(double value);
/* Significant digits. */
std::wstring shown(double value, int digits);
/* Reads a whole text as a number, in any locale; false: it is none, or not finite. */
bool number_of(const std::string &text, double &value);
std::vector<std::string> split(const std::string &text, const std::string &by);

std::string read_file(const fs::path &path);
/* Writes a file beside its place and renames it at the end: it is whole, or not there. */
void write_file(const fs::path &path, const std::function<bool(const fs::path &beside)> &write);
/* Whether two names lead to one file. */
bool same_file(const fs::path &one, const fs::path &other);
