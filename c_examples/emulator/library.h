/* The library, loaded by the program itself: its functions are lib.sins_create and so on. */
#pragma once
#include "../sins_loader.h"
#include "text.h"

extern sins_loader lib;

/* Why the last call on a simulator failed, or with NULL the last of this thread, in the user's language. */
std::wstring last_error(const sins_sim *sim = NULL);

/* After a call: its error is thrown. */
inline sins_status check(sins_status status, const sins_sim *sim = NULL)
{
    if (status < 0) {
        throw Refusal{last_error(sim)};
    }
    return status;
}

/* A structure of the library, its size filled in. */
template <typename T> T sized()
{
    T value;
    SINS_INIT(value);
    return value;
}

/* A text of the library of any length. */
template <typename Call> std::string whole_text(Call call)
{
    size_t size = 0;
    call((char *)NULL, (size_t)0, &size);
    std::string text(size, '\0');
    call(text.data(), size, &size);
    return text.c_str();
}

/* A handle that destroys itself. */
template <typename T> class Handle {
public:
    Handle() = default;
    Handle(Handle &&other) { *this = std::move(other); }
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
    T *handle_ = NULL;
};
