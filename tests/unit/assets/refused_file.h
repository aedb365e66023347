// What reading a damaged file must say.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "lanthorn/core/error.h"

namespace lanthorn {

// `read` throws an InputError of one line that begins with the file's name and holds `part`.
inline void expect_refused_as(const std::string& name, const std::function<void()>& read,
                              const std::string& part) {
    try {
        read();
        ADD_FAILURE() << "read, expected " << part;
    } catch (const InputError& error) {
        const std::string line = error.what();
        EXPECT_NE(line.find(part), std::string::npos) << line;
        EXPECT_TRUE(line.starts_with(name + ": ")) << line;
        EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    }
}

}  // namespace lanthorn
