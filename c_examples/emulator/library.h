/* The library, loaded by the program itself: its functions are lib.sins_create and so on. */
#pragma once
#include <cstring>
#include <string>

#include "../sins_loader.h"

extern sins_loader lib;

/* The sentence of the last failed call on a simulator; NULL: of this thread. */
std::string last_error(const sins_sim *sim = NULL);

/* A text of the library of any length. */
template <typename Call> std::string whole_text(Call call)
{
    size_t size = 0;
    std::string text;
    if (call((char *)NULL, (size_t)0, &size) >= 0 || size > 0) {
        text.resize(size);
        call(&text[0], size, &size);
        text.resize(strlen(text.c_str()));
    }
    return text;
}

/* A handle that destroys itself. */
template <typename T> class Handle {
public:
    explicit Handle(T *handle = NULL) : handle_(handle) {}
    Handle(Handle &&other) : handle_(other.handle_) { other.handle_ = NULL; }
    Handle &operator=(Handle &&other)
    {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~Handle()
    {
        if (handle_ != NULL) {
            destroy(handle_);
        }
    }
    operator T *() const { return handle_; }
    T **operator&() /* for sins_..._create(): what it held is destroyed */
    {
        *this = Handle();
        return &handle_;
    }

private:
    static void destroy(sins_sim *handle) { lib.sins_destroy(handle); }
    static void destroy(sins_flight *handle) { lib.sins_flight_destroy(handle); }
    static void destroy(sins_scene *handle) { lib.sins_scene_destroy(handle); }
    static void destroy(sins_log *handle) { lib.sins_log_destroy(handle); }
    T *handle_;
};
