/* Lines of text in a temporary file: they may be more than fit into memory. */
#pragma once
#include <fstream>

#include "text.h"

class Lines {
public:
    ~Lines()
    {
        std::error_code none;
        file_.close();
        fs::remove(path_, none);
    }

    void open(const std::string &head)
    {
        WCHAR path[MAX_PATH] = L"";
        GetTempFileNameW(fs::temp_directory_path().c_str(), L"sns", 0, path);
        path_ = path;
        file_.open(path_, std::ios::in | std::ios::out | std::ios::trunc | std::ios::binary);
        add(head);
    }

    bool is_open() const { return file_.is_open(); }

    void add(const std::string &line)
    {
        if (!(file_ << line)) {
            throw Refusal{text("cannot_write", {text("temporary_file"), path_})};
        }
    }

    std::streamoff size() { return file_.tellp(); } /* bytes */

    void cut(std::streamoff size)
    {
        file_.flush();
        fs::resize_file(path_, size);
        file_.seekp(size);
    }

    void copy(const fs::path &path)
    {
        auto write = [this](const fs::path &to) { return CopyFileW(path_.c_str(), to.c_str(), FALSE) != 0; };
        file_.flush();
        write_file(path, write);
    }

private:
    std::fstream file_;
    fs::path path_;
};
