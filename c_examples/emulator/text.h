/* Texts: UTF-16 of Windows and UTF-8 of the library, resources in the language of the user, numbers, files. */
#pragma once
#include <windows.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "resource.h"

using std::max;
using std::min;

std::wstring wide(const std::string &utf8);
std::string narrow(const std::wstring &text);

/* The language of all texts and dialogs from now on: LANG_ENGLISH or LANG_CHINESE. */
void set_language(WORD primary);
WORD language();

/* A string of the resources; with parts, cut at ";". */
std::wstring text(UINT id);
std::vector<std::wstring> parts(UINT id);
/* A string of the resources with its %1 and %2 replaced. */
std::wstring text(UINT id, const std::wstring &first, const std::wstring &second = L"");
/* A dialog or a menu in the user's language. */
const DLGTEMPLATE *dialog_template(UINT id);
HMENU menu_of(UINT id);
/* What a scene key, or one of its words, is called: by the resources, else `otherwise` of the library. */
std::wstring label(const std::string &path, const std::string &otherwise);

/* The shortest text that reads back to the bit, as the program `sins` writes it. */
std::string shortest(double value);
/* So many significant digits. */
std::wstring shown(double value, int digits);
/* Reads a whole text as a number, in any locale; false: it is none, or not finite. */
bool number_of(const std::string &text, double &value);

bool begins(const std::string &text, const char *with);
std::vector<std::string> split(const std::string &text, const std::string &by);

/* Reads a file whole; false with the system's sentence. */
bool read_file(const std::wstring &path, std::string &bytes, std::wstring &why);
/* Writes a file beside its place and renames it at the end: it is whole, or not there. */
bool write_file(const std::wstring &path, const std::string &bytes, std::wstring &why);
/* The same piece by piece, until a piece is empty. */
bool write_file(const std::wstring &path, const std::function<std::string()> &piece, std::wstring &why);
/* Whether two names lead to one file. */
bool same_file(const std::wstring &one, const std::wstring &other);
std::wstring folder_of(const std::wstring &path);
std::wstring name_of(const std::wstring &path);
std::wstring system_sentence(DWORD error);
