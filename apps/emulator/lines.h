/* Lines of text in a temporary file, because they may not fit into memory. */
#pragma once
#include "text.h"

class Lines {
public:
    explicit Lines(const std::string &head) {
        WCHAR path[MAX_PATH] = L"";
        GetTempFileNameW(fs::temp_directory_path().c_str(), L"sns", 0, path);
        path_ = path;
        file_.open(path_, std::ios::in | std::ios::out | std::ios::trunc | std::ios::binary);
        add(head);
    }

    ~Lines() {
        std::error_code none;
        file_.close();
        fs::remove(path_, none);
    }

    void add(const std::string &line) {
        if (!(file_ << line << "\n"))
            throw Refusal(text("cannot_write", {text("temporary_file"), path_}));
    }

    std::streamoff size() { return file_.tellp(); } /* bytes */

    void cut(std::streamoff size) {
        file_.flush();
        fs::resize_file(path_, size);
        file_.seekp(size);
    }

    void copy(const fs::path &path) {
        file_.flush();
        write_file(path, [this](const fs::path &to) { return CopyFileW(path_.c_str(), to.c_str(), FALSE) != 0; });
    }

private:
    std::fstream file_;
    fs::path path_;
};
