// What a program must say of arguments or files that it cannot use.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/unit/tools/run_program.h"

namespace lanthorn::testing_tools {

// That exit code, and one line on standard error, which has `part`. `arguments`: printed.
inline void expect_refusal(const Outcome& result, const std::string& part,
                           const std::vector<std::string>& arguments = {}, int code = 2) {
    EXPECT_EQ(result.code, code) << testing::PrintToString(arguments) << "\n" << result.err;
    EXPECT_EQ(result.error_lines(), 1) << testing::PrintToString(arguments) << "\n" << result.err;
    EXPECT_NE(result.err.find(part), std::string::npos) << part << "\n" << result.err;
}

}  // namespace lanthorn::testing_tools
