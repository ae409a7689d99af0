/* A part of sins.hpp: errors as exceptions, structs with their sizes, and the owners of handles. */

#ifndef SINS_HANDLE_HPP
#define SINS_HANDLE_HPP

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sins.h"

#if !defined(__cpp_exceptions) && !defined(__EXCEPTIONS) && !defined(_CPPUNWIND)
#error "sins.hpp throws exceptions: compile with them, or use sins.h"
#endif

namespace sins {

/* A call that failed. what() is the sentence of sins_last_error(), info() the data of sins_last_error_info(). */
class Error : public std::runtime_error {
public:
    Error(sins_status status, const std::string &sentence, const sins_error_info &info)
        : std::runtime_error(sentence), status_(status), info_(info) {}

    sins_status status() const noexcept { return status_; }
    const sins_error_info &info() const noexcept { return info_; }

private:
    sins_status status_;
    sins_error_info info_;
};

/* A struct of sins.h that is zero except for struct_size: all effects are off, all options have their defaults. */
template <typename T> T make() noexcept {
    T zeroed = T();
    zeroed.struct_size = sizeof(T);
    return zeroed;
}

/* The name of a status, such as "SINS_ERROR_TIME_ORDER". */
inline const char *status_string(sins_status status) noexcept { return sins_status_string(status); }

/* The sentence of the last failed call on sim; NULL: of the last failed call of this thread without a simulator. */
inline std::string last_error(const sins_sim *sim) {
    char sentence[1024];
    const sins_status status = sins_last_error(sim, sentence, sizeof sentence, nullptr);
    return status == SINS_OK || status == SINS_ERROR_BUFFER_TOO_SMALL ? sentence : status_string(status);
}

/* Not for hosts. */
namespace detail {

/* The error of the call that has just failed. */
inline Error error_of(sins_status status, const sins_sim *sim) {
    sins_error_info info = make<sins_error_info>();
    if (sins_last_error_info(sim, &info) == SINS_OK && info.status == status)
        return Error(status, last_error(sim), info);
    /* A call whose handle was rejected keeps no sentence. */
    info = make<sins_error_info>();
    info.status = status;
    return Error(status, status_string(status), info);
}

/* A text for a function that takes a terminated one, which a NUL would cut. */
inline const char *terminated(const std::string &text, const char *name) {
    if (text.find('\0') != std::string::npos) {
        sins_error_info info = make<sins_error_info>();
        info.status = SINS_ERROR_INVALID_ARGUMENT;
        throw Error(info.status, std::string(name) + ": must not have a NUL character", info);
    }
    return text.c_str();
}

/* True for SINS_OK, false for a positive status. Throws an error. */
inline bool done(sins_status status, const sins_sim *sim) {
    if (status < 0)
        throw error_of(status, sim);
    return status == SINS_OK;
}

/* The text that a function writes, in a buffer of the size that it asks for. */
template <class Function, class... Arguments> std::string text(Function write, Arguments... arguments) {
    std::size_t needed = 0;
    done(write(arguments..., nullptr, 0, &needed), nullptr);
    std::vector<char> buffer(needed);
    done(write(arguments..., buffer.data(), needed, &needed), nullptr);
    return std::string(buffer.data(), needed - 1);
}

/* The struct that a function fills in. */
template <class T, class Function, class... Arguments>
T filled(const sins_sim *sim, Function fill, Arguments... arguments) {
    T value = make<T>();
    done(fill(arguments..., &value), sim);
    return value;
}

/* The number, or the handle, that a function gives. */
template <class T, class Function, class... Arguments>
T given(const sins_sim *sim, Function give, Arguments... arguments) {
    T value = T();
    done(give(arguments..., &value), sim);
    return value;
}

/* The structs that a function has, by their index from 0, until there is no more. */
template <class T, class Function, class... Arguments> std::vector<T> all(T one, Function get, Arguments... arguments) {
    std::vector<T> values;
    sins_status status;
    while ((status = get(arguments..., values.size(), &one)) == SINS_OK)
        values.push_back(one);
    if (status != SINS_ERROR_INVALID_ARGUMENT)
        done(status, nullptr);
    return values;
}

/* Each header adds the handles of its C header. */
template <class T> struct Destroyer;
template <> struct Destroyer<sins_sim> {
    static void destroy(sins_sim *sim) noexcept { sins_destroy(sim); }
};

/* Owns a handle. It can be moved, but not copied. */
template <class T> class Owner {
public:
    explicit Owner(T *handle) noexcept : handle_(handle) {}

    Owner(Owner &&other) noexcept : handle_(other.handle_) { other.handle_ = nullptr; }

    Owner &operator=(Owner &&other) noexcept {
        Owner taken(std::move(other));
        std::swap(handle_, taken.handle_);
        return *this;
    }

    Owner(const Owner &) = delete;
    Owner &operator=(const Owner &) = delete;

    ~Owner() {
        if (handle_ != nullptr)
            Destroyer<T>::destroy(handle_);
    }

    /* The handle, for functions of sins.h. This object still owns it. */
    T *handle() const noexcept { return handle_; }

    /* Gives the handle up: the caller owns it. */
    T *release() noexcept {
        T *const handle = handle_;
        handle_ = nullptr;
        return handle;
    }

protected:
    T *handle_;
};

} // namespace detail

} // namespace sins

#endif /* SINS_HANDLE_HPP */
